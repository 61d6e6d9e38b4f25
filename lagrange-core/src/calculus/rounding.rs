//! What rounding leaves of an equation where it is solved.

use super::adjoint::sweep;
use crate::expr::{AlgebraicUnknown, ExprId, Function, Graph};
use crate::functions;

/// Bound of what rounding leaves of an equation where it is solved, in units of the rounding of one operation: Σ |n ∂r/∂n| over the value
/// and all that is computed of it on the way to r (Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., §3.3 and chapter 25).
pub fn rounding(graph: &mut Graph, unknown: &AlgebraicUnknown) -> ExprId {
    let (root, one) = (unknown.residual, graph.number(1));
    let mut shares = Vec::new();
    let slopes = sweep(graph, &[(root, one)], &[unknown.value], |graph, node, slope| {
        if node != root {
            shares.push(share(graph, node, slope));
        }
    });
    shares.extend(slopes.into_iter().map(|slope| share(graph, unknown.value, slope)));
    graph.total(shares)
}

/// |n ∂r/∂n|
fn share(graph: &mut Graph, node: ExprId, slope: ExprId) -> ExprId {
    let product = graph.multiply(slope, node);
    functions::apply(graph, Function::Abs, &[product])
}
