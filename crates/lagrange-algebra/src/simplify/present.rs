//! Readable formulas, and proofs that a formula vanishes.

use super::expand::{Expander, Purpose};
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;

/// Residue that rounding may leave of a zero at the test point. A larger residue settles the
/// question without a proof; a smaller one only means that the proof is tried.
const LARGEST_RESIDUE: f64 = 1e-6;

/// Returns an equal expression that is shorter when written out, or `expr` itself if none is found.
///
/// Sub-expressions are multiplied out, the rules of [`RULES`](super::RULES) applied, equal terms
/// collected, and the result regrouped by variability during the motion. Expressions with more than
/// `budget` monomials stay closed; 200 is enough for the formulas people read. The cost is bounded
/// by the budget and by the number of nodes of `expr`.
pub fn present(graph: &mut Graph, expr: ExprId, budget: usize) -> ExprId {
    present_all(graph, &[expr], budget)[0]
}

/// Presents expressions that share parts, which are expanded once. The cost is bounded as for a
/// single expression.
pub fn present_all(graph: &mut Graph, exprs: &[ExprId], budget: usize) -> Vec<ExprId> {
    let mut current = exprs.to_vec();
    let mut is_final = vec![false; exprs.len()];
    let mut expander = Expander::new(Purpose::Reading, budget);
    while is_final.contains(&false) {
        expander = expander.again();
        for (expr, is_final) in current.iter_mut().zip(&mut is_final).filter(|(_, is_final)| !**is_final) {
            let expanded = expander.expand_all(graph, *expr);
            let next = expanded.map_or(*expr, |()| expander.readable(graph, *expr));
            // The expression only becomes shorter, so the loop ends, and presenting a result again
            // changes nothing.
            *is_final = graph.written_size(next) >= graph.written_size(*expr);
            *expr = if *is_final { *expr } else { next };
        }
    }
    current
}

/// Returns equal expressions, multiplied out and regrouped within `budget` monomials, for
/// evaluation. No function is added. Differences of symbols stay closed, so that exact values are
/// not rounded. The result need not be cheaper: the caller counts.
pub fn multiply_out(graph: &mut Graph, exprs: &[ExprId], budget: usize) -> Vec<ExprId> {
    let mut expander = Expander::new(Purpose::Computing, budget);
    let mut expanded = |expr: &ExprId| {
        let form = expander.expand_all(graph, *expr).and_then(|()| expander.grouped(graph, *expr));
        form.unwrap_or(*expr)
    };
    exprs.iter().map(&mut expanded).collect()
}

/// True if the value is zero everywhere, as far as expansion within `budget` monomials shows.
///
/// Sines and cosines of sums are expanded, so that every polynomial identity between sines and
/// cosines of independent angles is found. `true` is a proof; `false` proves nothing. Nothing is
/// multiplied out if a numerical value shows that the answer is no.
pub fn proves_zero(graph: &mut Graph, expr: ExprId, budget: usize) -> bool {
    if is_plainly_not_zero(graph, expr) {
        return false;
    }
    let mut expander = Expander::new(Purpose::Comparing, budget);
    let simplified = expander.expand_all(graph, expr).and_then(|()| {
        let polynomial = expander.polynomial(graph, expr);
        expander.simplified(graph, &polynomial)
    });
    simplified.is_some_and(|polynomial| polynomial.is_zero())
}

/// True if the value at a point without symmetries differs from zero by more than rounding. This is
/// true of most expressions, and the test is much cheaper than expansion.
fn is_plainly_not_zero(graph: &Graph, expr: ExprId) -> bool {
    let value = evaluate(graph, &[expr], somewhere);
    value[0].is_finite() && value[0].abs() > LARGEST_RESIDUE
}

/// Returns a number between 1/2 and 3/2 for each symbol, at a point without symmetries.
pub fn somewhere(role: Role) -> f64 {
    let (kind, index) = match role {
        Role::Parameter(index) => (1.0, index),
        Role::Input(index) => (2.0, index),
        Role::Time => (3.0, 0),
        Role::Coordinate(index) => (4.0, index),
        Role::Velocity(index) => (5.0, index),
        Role::Acceleration(index) => (6.0, index),
        Role::Multiplier(index) => (7.0, index),
        Role::Reaction(index) => (8.0, index),
        Role::Side(index) => (9.0, index),
        Role::Placeholder(index) => (10.0, index),
        Role::State(index) => (11.0, index),
        Role::Operand(index) => (12.0, index),
        Role::Discrete(index) => (13.0, index),
        Role::Noise(index) => (14.0, index),
    };
    // Multiples of the golden ratio modulo one stay distinct for any number of symbols.
    let golden = (f64::from(index) + 0.171 * kind) * 0.618_033_988_749_895;
    0.5 + golden.fract()
}
