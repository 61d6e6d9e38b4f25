//! Derivatives of one node with respect to its operands: the edges of the chain rule.

use crate::calculus::{implicit, partial, substitute};
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::functions;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// Returns `(operand, ∂node/∂operand)` for every operand with a derivative, each operand once;
/// conditions have none.
pub fn partials(graph: &mut Graph, id: ExprId) -> Vec<(ExprId, ExprId)> {
    let edges = edges(graph, id);
    let mut slopes: OrderedMap<ExprId, ExprId> = OrderedMap::default();
    for (operand, slope) in edges {
        let total = slopes.get(&operand).map_or(slope, |&earlier| graph.add(earlier, slope));
        slopes.insert(operand, total);
    }
    slopes.iter().map(|(operand, slope)| (*operand, *slope)).collect()
}

/// Returns the edges of [`partials`], one for every place of an operand, as in `pow(x, x)`.
fn edges(graph: &mut Graph, id: ExprId) -> Vec<(ExprId, ExprId)> {
    match graph.node(id).clone() {
        Node::Number(_) | Node::Pi | Node::Symbol(_) => Vec::new(),
        Node::Sum { terms, .. } => terms.iter().map(|(term, c)| (*term, graph.number(c.clone()))).collect(),
        Node::Product(factors) => {
            (0..factors.len()).map(|i| (factors[i].0, differentiate_factor(graph, &factors, i))).collect()
        }
        Node::Call(function, arguments) => {
            let partials = functions::partials(graph, function, &arguments, id);
            arguments.iter().copied().zip(partials).collect()
        }
        Node::Opaque(function, arguments) => {
            if let Some(unknowns) = graph.equations_of(&function).cloned() {
                let slopes = implicit::slopes(graph, &unknowns, &arguments, id);
                return arguments.iter().copied().zip(slopes).collect();
            }
            let slope = |(i, argument)| (argument, graph.opaque(function.derivative(i), &arguments));
            arguments.iter().copied().enumerate().map(slope).collect()
        }
        Node::Choose { relation, left, right, then, otherwise } => {
            let (zero, one) = (graph.number(0), graph.number(1));
            vec![
                (then, graph.choose(relation, left, right, one, zero)),
                (otherwise, graph.choose(relation, left, right, zero, one)),
            ]
        }
    }
}

/// Returns `(operand, operand, ∂²node/∂operand∂operand)` without vanishing ones. Each unordered
/// pair of places occurs once. If the same operand is in two places, their pair counts twice, so
/// that the entries with this operand add up to its second derivative.
pub fn second_partials(graph: &mut Graph, id: ExprId) -> Vec<(ExprId, ExprId, ExprId)> {
    let mut found = pairs_of_places(graph, id);
    for (places, (i, j, second)) in &mut found {
        if i == j && places.0 != places.1 {
            *second = graph.scale(Number::TWO, *second);
        }
    }
    found.into_iter().map(|(_, entry)| entry).collect()
}

type SecondPartial = (ExprId, ExprId, ExprId);

/// Returns second derivatives with respect to two places, i ≤ j, of operands.
fn pairs_of_places(graph: &mut Graph, id: ExprId) -> Vec<((usize, usize), SecondPartial)> {
    match graph.node(id).clone() {
        Node::Product(factors) => second_partials_of_product(graph, &factors),
        Node::Call(function, arguments) => {
            let scratch = (0..arguments.len()).map(|i| placeholder(graph, i)).collect::<Vec<_>>();
            let value = graph.call(function, &scratch);
            let first = functions::partials(graph, function, &scratch, value);
            let back = scratch.iter().copied().zip(arguments.iter().copied()).collect::<HashMap<_, _>>();
            let mut found = Vec::new();
            for (i, &slope) in first.iter().enumerate() {
                for j in i..arguments.len() {
                    let second = partial(graph, slope, scratch[j]);
                    let second = substitute(graph, second, &back);
                    if !graph.is_zero(second) {
                        found.push(((i, j), (arguments[i], arguments[j], second)));
                    }
                }
            }
            found
        }
        Node::Opaque(function, arguments) => {
            if let Some(unknowns) = graph.equations_of(&function).cloned() {
                let second = implicit::second_slopes(graph, &unknowns, &arguments, id).into_iter();
                return second.map(|((i, j), s)| ((i, j), (arguments[i], arguments[j], s))).collect();
            }
            let places = 0..arguments.len();
            let pairs = places.flat_map(|i| (i..arguments.len()).map(move |j| (i, j)));
            let second = |(i, j): (usize, usize)| {
                let second = graph.opaque(function.derivative(i).derivative(j), &arguments);
                ((i, j), (arguments[i], arguments[j], second))
            };
            pairs.map(second).collect()
        }
        _ => Vec::new(),
    }
}

/// Returns a symbol for an argument while a function is differentiated twice. Arguments themselves
/// might dissolve when the first derivative is constructed.
fn placeholder(graph: &mut Graph, index: usize) -> ExprId {
    graph.symbol("argument", Role::Placeholder(index as u32))
}

fn second_partials_of_product(
    graph: &mut Graph,
    factors: &[(ExprId, Number)],
) -> Vec<((usize, usize), SecondPartial)> {
    let mut found = Vec::new();
    for i in 0..factors.len() {
        let (lowered, scale) = lower_exponent(factors, i);
        for j in i..factors.len() {
            let (twice, second_scale) = lower_exponent(&lowered, j);
            let coefficient = &scale * &second_scale;
            if !coefficient.is_zero() {
                let product = graph.product(twice);
                let second = graph.scale(coefficient, product);
                found.push(((i, j), (factors[i].0, factors[j].0, second)));
            }
        }
    }
    found
}

fn differentiate_factor(graph: &mut Graph, factors: &[(ExprId, Number)], index: usize) -> ExprId {
    let (lowered, scale) = lower_exponent(factors, index);
    let product = graph.product(lowered);
    graph.scale(scale, product)
}

/// Applies the power rule to one factor: returns the factors with this exponent lowered by one, and
/// the old exponent.
fn lower_exponent(factors: &[(ExprId, Number)], index: usize) -> (Vec<(ExprId, Number)>, Number) {
    let mut lowered = factors.to_vec();
    let exponent = lowered[index].1.clone();
    lowered[index].1 = &exponent + &Number::MINUS_ONE;
    (lowered, exponent)
}
