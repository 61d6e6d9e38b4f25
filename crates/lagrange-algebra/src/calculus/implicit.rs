//! Derivatives of algebraic unknowns.
//!
//! The solution y(x₁, …) of 0 = r(x₁, …, y) has the derivatives ∂y/∂xᵢ = −(∂r/∂xᵢ)/(∂r/∂y). Each of
//! them is a formula in the arguments and y, so second derivatives follow by the chain rule.

use crate::calculus::{partial, substitute};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{AlgebraicUnknown, ExprId, Graph, Node};

/// ∂y/∂xᵢ for each argument of a call of an algebraic unknown, whose value is `call`.
pub(super) fn slopes(
    graph: &mut Graph,
    unknown: &AlgebraicUnknown,
    arguments: &[ExprId],
    call: ExprId,
) -> Vec<ExprId> {
    let slopes = own_slopes(graph, unknown);
    at(graph, unknown, (arguments, call), slopes)
}

/// ∂²y/∂xᵢ∂xⱼ for i ≤ j, each with i and j.
pub(super) fn second_slopes(
    graph: &mut Graph,
    unknown: &AlgebraicUnknown,
    arguments: &[ExprId],
    call: ExprId,
) -> Vec<((usize, usize), ExprId)> {
    let slopes = own_slopes(graph, unknown);
    let (mut places, mut second) = (Vec::new(), Vec::new());
    for (i, &slope) in slopes.iter().enumerate() {
        let by_value = partial(graph, slope, unknown.value);
        for (j, &other) in slopes.iter().enumerate().skip(i) {
            let direct = partial(graph, slope, unknown.arguments[j]);
            let through_value = graph.multiply(by_value, other);
            places.push((i, j));
            second.push(graph.add(direct, through_value));
        }
    }
    let second = at(graph, unknown, (arguments, call), second);
    places.into_iter().zip(second).collect()
}

/// The slopes in the symbols of the equation.
fn own_slopes(graph: &mut Graph, unknown: &AlgebraicUnknown) -> Vec<ExprId> {
    let by_value = partial(graph, unknown.residual, unknown.value);
    let slope = |&argument: &ExprId| {
        let by_argument = partial(graph, unknown.residual, argument);
        let quotient = graph.divide(by_argument, by_value);
        graph.negate(quotient)
    };
    unknown.arguments.iter().map(slope).collect()
}

/// Expressions in the symbols of the equation, for the arguments and the value of a call.
fn at(
    graph: &mut Graph,
    unknown: &AlgebraicUnknown,
    (arguments, call): (&[ExprId], ExprId),
    expressions: Vec<ExprId>,
) -> Vec<ExprId> {
    let symbols = unknown.arguments.iter().copied().chain([unknown.value]);
    let values = arguments.iter().copied().chain([call]);
    let replacements = symbols.zip(values).collect::<HashMap<_, _>>();
    expressions.into_iter().map(|expression| substitute(graph, expression, &replacements)).collect()
}

/// Returns the residual of an algebraic unknown's call; `None` for other calls.
pub fn residual(graph: &mut Graph, call: ExprId) -> Option<ExprId> {
    let Node::Opaque(function, arguments) = graph.node(call).clone() else { return None };
    let unknown = graph.unknown(&function).cloned()?;
    at(graph, &unknown, (&arguments, call), vec![unknown.residual]).pop()
}
