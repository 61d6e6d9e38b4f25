//! Expressions that never vanish, according to their signs.

use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;

/// Maximum depth of the search in sums. A pivot is a sum of products of sums; a miss costs a guard,
/// but never causes a wrong result.
const DEEPEST: usize = 4;

/// True if an expression is known to vanish in no configuration, assuming that parameters are
/// positive.
pub fn never_vanishes(graph: &Graph, id: ExprId) -> bool {
    stays(graph, id, DEEPEST)
}

/// True if an expression is known to be always positive or always negative, wherever it is defined,
/// for all values of its symbols.
pub fn has_one_sign(graph: &Graph, id: ExprId) -> bool {
    is_above(graph, id, false, DEEPEST) || is_above(graph, id, true, DEEPEST)
}

/// True if an expression, or its opposite, is known to be positive.
fn is_above(graph: &Graph, id: ExprId, opposite: bool, depth: usize) -> bool {
    let is_wanted = |number: &Number| number.is_negative() == opposite;
    match graph.node(id) {
        Node::Number(value) => !value.is_zero() && is_wanted(value),
        Node::Pi | Node::Call(Function::Exp | Function::Cosh, _) => !opposite,
        Node::Sum { constant, terms } if depth > 0 => {
            let positive = |(term, weight): &(ExprId, Number)| {
                is_above(graph, *term, opposite != weight.is_negative(), depth - 1)
            };
            let nonnegative = |term: &(ExprId, Number)| {
                is_wanted(&term.1) && graph.is_nonnegative(term.0) || positive(term)
            };
            let is_kept = constant.is_zero() || is_wanted(constant);
            let is_apart = !constant.is_zero() || terms.iter().any(positive);
            is_kept && is_apart && terms.iter().all(nonnegative)
        }
        Node::Product(factors) if depth > 0 => {
            !opposite && factors.iter().all(|(base, _)| is_above(graph, *base, false, depth - 1))
        }
        _ => false,
    }
}

fn stays(graph: &Graph, id: ExprId, depth: usize) -> bool {
    if graph.dependencies(id).is_constant_in_motion() {
        return !graph.is_zero(id);
    }
    match graph.node(id) {
        Node::Product(factors) if depth > 0 => factors.iter().all(|(base, _)| stays(graph, *base, depth - 1)),
        Node::Sum { constant, terms } if depth > 0 => {
            let is_added = |(term, coefficient): &(ExprId, Number)| {
                !coefficient.is_negative() && (is_square(graph, *term) || stays(graph, *term, depth - 1))
            };
            let has_constant =
                !constant.is_zero() || terms.iter().any(|(term, _)| stays(graph, *term, depth - 1));
            !constant.is_negative() && has_constant && terms.iter().all(is_added)
        }
        _ => false,
    }
}

/// True if an expression is never negative, assuming that parameters are positive.
fn is_square(graph: &Graph, id: ExprId) -> bool {
    let is_fixed = |id: ExprId| graph.dependencies(id).is_constant_in_motion();
    match graph.node(id) {
        Node::Product(factors) => {
            factors.iter().all(|(base, exponent)| exponent.is_even() || is_fixed(*base))
        }
        _ => graph.is_nonnegative(id),
    }
}
