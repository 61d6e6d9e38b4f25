//! Sums, products and powers. Chains of `+` and `-` and of `*` and `/` become one n-ary node each.

use super::evaluator::{ChainLink, Evaluator};
use super::messages;
use super::operand::{Operand, product};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{ExprId, Function, Node};
use lagrange_expr::functions;
use lagrange_expr::number::Number;
use lagrange_language::syntax::ast::{AstId, BinaryOperator, Expression};

pub(super) fn evaluate_sum(evaluator: &mut Evaluator<'_>, id: AstId) -> Option<Operand> {
    let links = evaluator.chain(id);
    let first = first_value(evaluator, &links)?;
    let mut terms: Vec<Vec<(ExprId, Number)>> = vec![Vec::new(); first.components().len()];
    let mut sound = true;
    for link in &links {
        let Some(value) = evaluator.value(link.operand) else {
            sound = false;
            continue;
        };
        if !value.same_kind(&first) {
            let message = messages::kinds_differ("add", first.kind(), value.kind());
            let help = messages::KINDS_HELP;
            evaluator.report.error(evaluator.origin(link.operand), message).help(help);
            sound = false;
            continue;
        }
        let sign = if link.inverted { Number::MINUS_ONE } else { Number::ONE };
        let is_product = is_matrix_product(evaluator, link.operand);
        for (terms, &component) in terms.iter_mut().zip(value.components()) {
            match evaluator.graph.node(component) {
                // Products of entries become terms of the sum, as if they were written out.
                Node::Sum { constant, terms: inner } if is_product && constant.is_zero() => {
                    terms.extend(inner.iter().map(|(term, factor)| (*term, factor * &sign)));
                }
                _ => terms.push((component, sign.clone())),
            }
        }
    }
    let sums = terms.into_iter().map(|terms| evaluator.graph.sum(Number::ZERO, terms)).collect::<Vec<_>>();
    sound.then(|| Operand::of(first.shape(), sums))
}

/// True for a product of matrices and vectors without scalar factors.
fn is_matrix_product(evaluator: &Evaluator<'_>, id: AstId) -> bool {
    let is_whole = |link: &ChainLink| {
        let value = evaluator.value(link.operand);
        value.is_some_and(|value| !matches!(value, Operand::Scalar(_)))
    };
    let is_product = matches!(evaluator.syntax(id), Expression::Binary(BinaryOperator::Multiply, ..));
    is_product && evaluator.chain(id).iter().all(is_whole)
}

fn first_value(evaluator: &Evaluator<'_>, links: &[ChainLink]) -> Option<Operand> {
    links.iter().find_map(|link| evaluator.value(link.operand))
}

pub(super) fn evaluate_product(evaluator: &mut Evaluator<'_>, id: AstId) -> Option<Operand> {
    let mut factors = Vec::new();
    let mut whole: Option<Operand> = None;
    let mut sound = true;
    for ChainLink { operand, inverted } in evaluator.chain(id) {
        match (evaluator.value(operand), inverted) {
            (None, _) => sound = false,
            (Some(Operand::Scalar(divisor)), true) if evaluator.graph.is_zero(divisor) => {
                evaluator.refuse::<()>(operand, messages::DIVISION_BY_ZERO, messages::DIVISION_HELP);
                sound = false;
            }
            (Some(Operand::Scalar(factor)), _) => {
                factors.push((factor, if inverted { Number::MINUS_ONE } else { Number::ONE }));
            }
            (Some(_), true) => {
                evaluator.refuse::<()>(operand, messages::DIVISION_BY_VECTOR, messages::HOW_TO_GET_A_SCALAR);
                sound = false;
            }
            (Some(value), false) => {
                let (before, multiplied) = match whole {
                    Some(before) => (Some(before.clone()), product(&mut evaluator.graph, &before, &value)),
                    None => (None, Some(value.clone())),
                };
                if let (Some(before), None) = (&before, &multiplied) {
                    report_no_product(evaluator, operand, before, &value);
                    return None;
                }
                whole = multiplied.or(before);
            }
        }
    }
    if !sound {
        return None;
    }
    let factor = Operand::Scalar(evaluator.graph.product(factors));
    match whole {
        None => Some(factor),
        Some(whole) => product(&mut evaluator.graph, &factor, &whole),
    }
}

/// Reports two vectors or matrices that cannot be multiplied.
fn report_no_product(evaluator: &mut Evaluator<'_>, right: AstId, left: &Operand, value: &Operand) {
    let (message, help) = match (left, value) {
        (Operand::Vector(_), Operand::Vector(_)) => {
            (messages::PRODUCT_OF_VECTORS.to_owned(), messages::INNER_OR_CROSS)
        }
        (Operand::Vector(_), _) => {
            (messages::kinds_differ("multiply", left.kind(), value.kind()), messages::ROW_TIMES_MATRIX)
        }
        _ => (messages::kinds_differ("multiply", left.kind(), value.kind()), messages::PRODUCT_HELP),
    };
    evaluator.refuse::<()>(right, message, help);
}

pub(super) fn evaluate_power(
    evaluator: &mut Evaluator<'_>,
    base: AstId,
    exponent: AstId,
    origin: Origin,
) -> Option<Operand> {
    let value = match evaluator.value(base) {
        Some(of @ (Operand::Vector(_) | Operand::Matrix(..))) => {
            let message = messages::scalar_needed("the base of a power", of.kind());
            evaluator.refuse(base, message, messages::POWER_HELP)
        }
        _ => evaluator.scalar(base, "the base of a power"),
    };
    let index = evaluator.scalar(exponent, "an exponent");
    power(evaluator, value?, index?, origin).map(Operand::Scalar)
}

/// Returns base ^ exponent; reports an error if the result is not a real number.
pub(super) fn power(
    evaluator: &mut Evaluator<'_>,
    base: ExprId,
    exponent: ExprId,
    origin: Origin,
) -> Option<ExprId> {
    if let (Some(b), Some(e)) = (evaluator.graph.as_number(base), evaluator.graph.as_number(exponent)) {
        if b.is_negative() && !e.is_integer() {
            let message = messages::root_of_negative(&b.to_string(), &e.to_string());
            evaluator.report.error(origin, message).help(messages::NEGATIVE_BASE_HELP);
            return None;
        }
        if b.is_zero() && e.is_negative() {
            evaluator.report.error(origin, messages::DIVISION_BY_ZERO).help(messages::ZERO_BASE_HELP);
            return None;
        }
    } else if let Some(b) = evaluator.graph.as_number(base)
        && b.is_negative()
    {
        let message = messages::varying_power_of_negative(b.to_string());
        evaluator.report.error(origin, message).help(messages::NEGATIVE_BASE_HELP);
        return None;
    }
    Some(functions::apply(&mut evaluator.graph, Function::Power, &[base, exponent]))
}
