//! Formulas for readers, and the question whether anything is left of one.

use super::expand::{Expander, Purpose};
use super::size::Sizes;
use crate::expr::{ExprId, Graph};

/// An equal expression that is shorter when written out, or `expr` itself if none is found.
///
/// Sub-expressions are multiplied out, the rules of [`RULES`](super::RULES) applied, equal terms
/// collected, and the result regrouped by what changes during the motion. Whatever has more than
/// `budget` monomials stays closed; 200 is enough for the formulas people read. The cost is bounded by
/// the budget and by the number of nodes `expr` is made of.
pub fn present(graph: &mut Graph, expr: ExprId, budget: usize) -> ExprId {
    let mut current = expr;
    loop {
        let mut expander = Expander::new(Purpose::Reading, budget);
        if expander.expand_all(graph, current).is_none() {
            return current;
        }
        let next = expander.readable(graph, current);
        let mut sizes = Sizes::default();
        // Only ever shorter: so this ends, and presenting a result again changes nothing.
        if sizes.of(graph, next) >= sizes.of(graph, current) {
            return current;
        }
        current = next;
    }
}

/// Whether the value is zero everywhere, as far as multiplying out shows within `budget` monomials.
///
/// Sines and cosines of sums are expanded, so that every polynomial identity between sines and cosines
/// of independent angles is found. `true` is a proof; `false` says nothing.
pub fn proves_zero(graph: &mut Graph, expr: ExprId, budget: usize) -> bool {
    let mut expander = Expander::new(Purpose::Comparing, budget);
    let simplified = expander.expand_all(graph, expr).and_then(|()| {
        let polynomial = expander.polynomial(graph, expr);
        expander.simplified(graph, &polynomial)
    });
    simplified.is_some_and(|polynomial| polynomial.is_zero())
}
