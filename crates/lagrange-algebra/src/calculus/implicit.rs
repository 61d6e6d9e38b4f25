//! Derivatives of algebraic unknowns.
//!
//! The solution y(x₁, …) of 0 = r(x₁, …, y) has the derivatives ∂y/∂xᵢ = −J⁻¹ ∂r/∂xᵢ, where J =
//! ∂r/∂y. Each of them is a formula in the arguments and y, so second derivatives follow by the
//! chain rule. J⁻¹ is computed by Cramer's rule: the only divisor is the determinant, so the
//! formula holds wherever J is regular.

use super::minors::Minors;
use crate::calculus::{partial, substitute};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{AlgebraicUnknowns, ExprId, Graph, Node};

/// Returns ∂y/∂xᵢ for each argument of a call of an algebraic unknown; `call` is its value y.
pub(super) fn slopes(
    graph: &mut Graph,
    unknowns: &AlgebraicUnknowns,
    arguments: &[ExprId],
    call: ExprId,
) -> Vec<ExprId> {
    let slopes = own_slopes(graph, unknowns, &[place(graph, call)]).remove(0);
    at(graph, unknowns, arguments, slopes)
}

/// Returns ∂²y/∂xᵢ∂xⱼ for i ≤ j, each with i and j.
pub(super) fn second_slopes(
    graph: &mut Graph,
    unknowns: &AlgebraicUnknowns,
    arguments: &[ExprId],
    call: ExprId,
) -> Vec<((usize, usize), ExprId)> {
    let all = (0..unknowns.values.len()).collect::<Vec<_>>();
    let of_each = own_slopes(graph, unknowns, &all);
    let slopes = &of_each[place(graph, call)];
    let (mut places, mut second) = (Vec::new(), Vec::new());
    for (i, &slope) in slopes.iter().enumerate() {
        let by_values = unknowns.values.iter().map(|&value| partial(graph, slope, value));
        let by_values = by_values.collect::<Vec<_>>();
        for j in i..slopes.len() {
            let mut terms = vec![partial(graph, slope, unknowns.arguments[j])];
            for (&by_value, others) in by_values.iter().zip(&of_each) {
                terms.push(graph.multiply(by_value, others[j]));
            }
            places.push((i, j));
            second.push(graph.total(terms));
        }
    }
    let second = at(graph, unknowns, arguments, second);
    places.into_iter().zip(second).collect()
}

/// Returns the place of a call among the unknowns of its equations.
fn place(graph: &Graph, call: ExprId) -> usize {
    match graph.node(call) {
        Node::Opaque(function, _) => function.place(),
        _ => 0,
    }
}

/// Returns the slopes of the unknowns at these places, in the symbols of the equations.
fn own_slopes(graph: &mut Graph, unknowns: &AlgebraicUnknowns, places: &[usize]) -> Vec<Vec<ExprId>> {
    let by = |graph: &mut Graph, residual: ExprId, symbols: &[ExprId]| -> Vec<ExprId> {
        symbols.iter().map(|&symbol| partial(graph, residual, symbol)).collect()
    };
    let (mut jacobian, mut loads) = (Vec::new(), Vec::new());
    for &residual in &unknowns.residuals {
        jacobian.push(by(graph, residual, &unknowns.values));
        loads.push(by(graph, residual, &unknowns.arguments));
    }
    let mut minors = Minors::new(&jacobian);
    let of_argument = |argument: usize| loads.iter().map(|row| row[argument]).collect::<Vec<_>>();
    let loads = (0..unknowns.arguments.len()).map(of_argument).collect::<Vec<_>>();
    let mut slope = |&place: &usize, load: &[ExprId]| minors.root(graph, load, place);
    places.iter().map(|place| loads.iter().map(|load| slope(place, load)).collect()).collect()
}

/// Rewrites expressions in the symbols of the equations for the arguments of a call and its values.
fn at(
    graph: &mut Graph,
    unknowns: &AlgebraicUnknowns,
    arguments: &[ExprId],
    expressions: Vec<ExprId>,
) -> Vec<ExprId> {
    let calls = unknowns.functions.iter().map(|function| graph.opaque(function.clone(), arguments));
    let calls = calls.collect::<Vec<_>>();
    let symbols = unknowns.arguments.iter().chain(&unknowns.values).copied();
    let replacements = symbols.zip(arguments.iter().copied().chain(calls)).collect::<HashMap<_, _>>();
    expressions.into_iter().map(|expression| substitute(graph, expression, &replacements)).collect()
}

/// Returns the residuals of the equations that define a call of an algebraic unknown; none for
/// other calls.
pub fn residuals(graph: &mut Graph, call: ExprId) -> Vec<ExprId> {
    let Node::Opaque(function, arguments) = graph.node(call).clone() else { return Vec::new() };
    match graph.equations_of(&function).cloned() {
        Some(unknowns) => {
            let residuals = unknowns.residuals.clone();
            at(graph, &unknowns, &arguments, residuals)
        }
        None => Vec::new(),
    }
}
