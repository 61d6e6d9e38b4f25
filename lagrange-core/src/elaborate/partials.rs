//! Partial derivatives in expressions.
//!
//! `partial(e, x)` is ∂e/∂x with all other names held. If x is declared by `let`, e is read again
//! with x as an independent symbol. Names that were declared in terms of x are then held, too.
//!
//! For u = 3, `partial(u^2 * y, u)` is 6 y.

use super::evaluator::Evaluator;
use super::messages::{self, partials as words};
use super::operand::Operand;
use super::scope::NameKind;
use lagrange_algebra::calculus::{partial, substitute};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Node};
use lagrange_expr::limits::MAX_NESTING;
use lagrange_language::syntax::ast::{AstId, Expression};

/// Function that evaluates an expression; `None` after an error.
type ValueOf = fn(&mut Evaluator<'_>, AstId) -> Option<Operand>;

/// Evaluates `partial(e, x)`.
pub(super) fn evaluate_partial(
    evaluator: &mut Evaluator<'_>,
    (arguments, call): (&[AstId], AstId),
    value_of: ValueOf,
) -> Option<Operand> {
    let &[of, by] = arguments else { return None };
    if evaluator.derivatives == MAX_NESTING {
        return evaluator.refuse(call, words::NESTED, words::NESTED_HELP);
    }
    evaluator.derivatives += 1;
    let value = derivative(evaluator, [of, by], value_of);
    evaluator.derivatives -= 1;
    value
}

fn derivative(evaluator: &mut Evaluator<'_>, [of, by]: [AstId; 2], value_of: ValueOf) -> Option<Operand> {
    let Expression::Name(name) = evaluator.syntax(by) else {
        value_of(evaluator, of)?;
        return evaluator.refuse(by, words::NAME_NEEDED, words::NAME_NEEDED_HELP);
    };
    let value = value_of(evaluator, by)?;
    let Operand::Scalar(meant) = value else {
        return evaluator.refuse(by, words::scalar_needed(name, value.kind()), messages::HOW_TO_GET_A_SCALAR);
    };
    let kind = evaluator.scope.find(name).map(|entry| entry.kind);
    let is_symbol = matches!(evaluator.graph.node(meant), Node::Symbol(_));
    match kind {
        Some(NameKind::Abbreviation) => by_abbreviation(evaluator, of, (name, meant), value_of),
        Some(NameKind::Unknown) if !is_symbol => by_abbreviation(evaluator, of, (name, meant), value_of),
        _ if is_symbol => {
            let value = value_of(evaluator, of)?;
            Some(value.map(|component| partial(&mut evaluator.graph, component, meant)))
        }
        _ => evaluator.refuse(by, words::is_fixed(name), words::NAME_HELP),
    }
}

/// Returns the derivative with respect to a name that stands for an expression.
fn by_abbreviation(
    evaluator: &mut Evaluator<'_>,
    of: AstId,
    (name, meant): (&str, ExprId),
    value_of: ValueOf,
) -> Option<Operand> {
    let variable = evaluator.graph.operand(name);
    let value = reread(evaluator, of, (name, variable), value_of)?;
    let back = HashMap::from_iter([(variable, meant)]);
    Some(value.map(|component| {
        let slope = partial(&mut evaluator.graph, component, variable);
        substitute(&mut evaluator.graph, slope, &back)
    }))
}

/// Returns the value of an expression in which a name stands for a symbol.
fn reread(
    evaluator: &mut Evaluator<'_>,
    of: AstId,
    (name, variable): (&str, ExprId),
    value_of: ValueOf,
) -> Option<Operand> {
    let parts = evaluator.declaration.expressions.parts(of);
    parts.iter().for_each(|part| drop(evaluator.values.remove(part)));
    let before = evaluator.scope.replace(name, Some(Operand::Scalar(variable)));
    let value = value_of(evaluator, of);
    evaluator.scope.replace(name, before);
    parts.iter().for_each(|part| drop(evaluator.values.remove(part)));
    value
}

#[cfg(test)]
mod tests;
