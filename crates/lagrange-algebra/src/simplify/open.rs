//! Expansion of sums among the factors of products, one at a time.

use super::expand::is_difference;
use super::monomial::{Monomial, Term};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Maximum number of terms after expansion, which is the maximum of
/// [`contract`](super::contract()).
const MAX_TERMS: usize = 64;

/// Expands the sums among the factors of terms that satisfy `is_chosen`; `None` if there would be
/// too many terms. Roots and denominators stay closed.
pub fn open(
    graph: &mut Graph,
    terms: &[(ExprId, Number)],
    is_chosen: impl Fn(&Graph, ExprId) -> bool,
) -> Option<Vec<(ExprId, Number)>> {
    let mut pending = terms.iter().map(|(id, c)| Term::of(graph, *id, c)).collect::<Vec<_>>();
    let mut opened = Vec::new();
    while let Some(term) = pending.pop() {
        let factor = sums_of(graph, &term.monomial).find(|factor| is_chosen(graph, *factor));
        match factor {
            Some(factor) => pending.extend(distributed(graph, &term, factor)),
            None => opened.push((term.monomial.build(graph), term.coefficient)),
        }
        if pending.len() + opened.len() > MAX_TERMS {
            return None;
        }
    }
    Some(opened)
}

/// Counts the terms of an expression if everything is expanded and nothing is combined.
pub fn count_opened(graph: &Graph, id: ExprId) -> usize {
    let mut counts: HashMap<ExprId, usize> = HashMap::default();
    for id in graph.reachable(&[id]) {
        let of = |id: &ExprId| counts.get(id).copied().unwrap_or(1);
        let power = |exponent: &Number| exponent.to_i32().and_then(|e| u32::try_from(e).ok()).unwrap_or(0);
        let count = match graph.node(id) {
            Node::Sum { constant, terms } => {
                let terms = terms.iter().map(|(term, _)| of(term));
                terms.fold(usize::from(!constant.is_zero()), usize::saturating_add)
            }
            Node::Product(factors) => {
                let powers = factors.iter().map(|(base, exponent)| of(base).saturating_pow(power(exponent)));
                powers.fold(1, usize::saturating_mul)
            }
            _ => 1,
        };
        counts.insert(id, count);
    }
    counts.get(&id).copied().unwrap_or(1)
}

/// Returns the sums among the factors of terms, each once.
pub fn factors_to_open(graph: &Graph, terms: &[(ExprId, Number)]) -> Vec<ExprId> {
    let mut found = Vec::new();
    for (id, coefficient) in terms {
        let term = Term::of(graph, *id, coefficient);
        found.extend(sums_of(graph, &term.monomial));
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// True if a sum can be expanded with others without losing the accuracy of a difference of close
/// numbers.
pub fn is_no_difference(graph: &Graph, id: ExprId) -> bool {
    match graph.node(id) {
        Node::Sum { constant, terms } => constant.is_zero() && !is_difference(graph, terms),
        _ => true,
    }
}

fn sums_of<'a>(graph: &'a Graph, monomial: &'a Monomial) -> impl Iterator<Item = ExprId> + 'a {
    let sums = monomial.factors().iter().filter(|(base, exponent)| {
        exponent.to_i32().is_some_and(|power| power > 0) && matches!(graph.node(*base), Node::Sum { .. })
    });
    sums.map(|(base, _)| *base)
}

/// Distributes one power of a sum over the rest of a product.
fn distributed(graph: &Graph, term: &Term, factor: ExprId) -> Vec<Term> {
    let Node::Sum { constant, terms } = graph.node(factor) else { return Vec::new() };
    let rest = term.monomial.times_power(factor, -1);
    let mut parts = Vec::with_capacity(terms.len() + 1);
    if !constant.is_zero() {
        parts.push(Term { coefficient: &term.coefficient * constant, monomial: rest.clone() });
    }
    parts.extend(terms.iter().map(|(id, c)| {
        let inner = Term::of(graph, *id, c);
        let coefficient = &term.coefficient * &inner.coefficient;
        Term { coefficient, monomial: rest.times(&inner.monomial) }
    }));
    parts
}
