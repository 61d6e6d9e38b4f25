//! Proofs that values are zero everywhere, with a quick rejection of nonzero values.

use super::present::proves_zero;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;

/// Number of monomials up to which a value is expanded to prove that it vanishes; sufficient for
/// any readable formula.
const PROOF_BUDGET: usize = 200;
/// Number of expressions up to which a value is expanded at all. A missed zero only costs
/// operations or a line of documentation.
const LARGEST_EXPANDED: usize = 400;
/// Residue of a zero due to rounding, as a fraction of the largest intermediate result: a generous
/// upper bound.
pub const ROUNDING: f64 = 1e-8;

/// Marks the values that are zero everywhere, as far as this can be proved quickly.
pub fn vanishing(graph: &mut Graph, values: &[ExprId]) -> Vec<bool> {
    let differs = differ_from_zero(graph, values);
    values.iter().zip(differs).map(|(&value, differs)| !differs && vanishes(graph, value)).collect()
}

fn vanishes(graph: &mut Graph, value: ExprId) -> bool {
    if graph.as_number(value).is_some() {
        return graph.is_zero(value);
    }
    !graph.is_larger_than(value, LARGEST_EXPANDED) && proves_zero(graph, value, PROOF_BUDGET)
}

/// Marks the values that differ from zero at a fixed point by more than rounding. They need no
/// proof attempt, which matters for the many entries of a mass matrix.
fn differ_from_zero(graph: &Graph, values: &[ExprId]) -> Vec<bool> {
    let parts = graph.reachable(values);
    let at_point = evaluate(graph, &parts, somewhere);
    let largest = at_point.iter().filter(|value| value.is_finite()).fold(1.0, |a: f64, b| a.max(b.abs()));
    let at_point = parts.into_iter().zip(at_point).collect::<HashMap<_, _>>();
    let at = |value: &ExprId| at_point.get(value).copied().unwrap_or(f64::NAN);
    values.iter().map(|value| at(value).is_finite() && at(value).abs() > ROUNDING * largest).collect()
}

/// Returns a number between 1/2 and 3/2 for each symbol: multiples of the golden ratio are spread
/// evenly.
pub fn somewhere(role: Role) -> f64 {
    const GOLDEN_RATIO: f64 = 1.618_033_988_749_895;
    let (kind, index) = match role {
        Role::Parameter(i) => (0, i),
        Role::Input(i) => (1, i),
        Role::Time => (2, 0),
        Role::Coordinate(i) => (3, i),
        Role::Velocity(i) => (4, i),
        Role::Acceleration(i) => (5, i),
        Role::Multiplier(i) => (6, i),
        Role::Reaction(i) => (7, i),
        Role::Placeholder(i) => (8, i),
        Role::Side(i) => (9, i),
        Role::State(i) => (10, i),
        Role::Operand(i) => (11, i),
        Role::Discrete(i) => (12, i),
        Role::Noise(i) => (13, i),
    };
    0.5 + (f64::from(7 * index + kind + 1) * GOLDEN_RATIO).fract()
}
