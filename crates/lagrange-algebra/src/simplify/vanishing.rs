//! Proofs that values are zero everywhere, with a quick rejection of nonzero values.

use super::present::{proves_zero, somewhere};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Graph};

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
