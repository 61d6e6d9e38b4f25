//! Bounds on the rounding error of an equation at its solution.

use super::adjoint::sweep;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::functions;
use lagrange_expr::number::Number;

/// Bounds the rounding error of a residual at a solution, in units of the rounding of one
/// operation. The bound is Σ |n ∂r/∂n| over the unknowns and all intermediate results n that depend
/// on them. See Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., §3.3 and chapter 25.
/// The polynomial of a table is evaluated from a value at a knot and the distance from it; both are
/// rounded as well.
pub fn rounding(graph: &mut Graph, root: ExprId, unknowns: &[ExprId]) -> ExprId {
    let one = graph.number(1);
    let mut contributions = Vec::new();
    let slopes = sweep(graph, &[(root, one)], unknowns, |graph, node, slope| {
        if node != root {
            contributions.push(contribution(graph, node, slope));
        }
        contributions.extend(contribution_of_table(graph, node, slope));
    });
    contributions.extend(
        slopes.into_iter().zip(unknowns).map(|(slope, &unknown)| contribution(graph, unknown, slope)),
    );
    graph.total(contributions)
}

/// Returns |n ∂r/∂n|, the contribution of one node to the bound.
fn contribution(graph: &mut Graph, node: ExprId, slope: ExprId) -> ExprId {
    let product = graph.multiply(slope, node);
    functions::apply(graph, Function::Abs, &[product])
}

/// Returns |∂r/∂n| (|f| + Σ |k ∂f/∂x|) for the value n of a table. Here f is its largest value and
/// k the largest knot along each argument.
fn contribution_of_table(graph: &mut Graph, node: ExprId, slope: ExprId) -> Option<ExprId> {
    let Node::Opaque(function, arguments) = graph.node(node).clone() else { return None };
    let table = function.table()?;
    let mut roundings = vec![graph.number(power_above(table.largest_value())?)];
    for (i, axis) in table.axes.iter().enumerate() {
        let knot = graph.number(power_above(axis.largest_knot())?);
        let along = graph.opaque(function.derivative(i), &arguments);
        let rounding = graph.multiply(knot, along);
        roundings.push(functions::apply(graph, Function::Abs, &[rounding]));
    }
    let rounding = graph.total(roundings);
    let steepness = functions::apply(graph, Function::Abs, &[slope]);
    Some(graph.multiply(steepness, rounding))
}

/// Returns the smallest power of two above a magnitude, or zero for zero; `None` if it is out of
/// range.
fn power_above(magnitude: f64) -> Option<Number> {
    const MANTISSA_BITS: u32 = f64::MANTISSA_DIGITS - 1;
    if magnitude == 0.0 {
        return Some(Number::ZERO);
    }
    let biased = (magnitude.to_bits() >> MANTISSA_BITS) as i32;
    Number::TWO.power(biased - (f64::MAX_EXP - 2))
}
