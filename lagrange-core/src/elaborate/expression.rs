//! Conversion of expressions of the language to expressions of the graph.
//!
//! The traversal is iterative. A chain of `+`/`-` or of `*`/`/` is evaluated as a whole, so that a
//! sum of many terms is collected once instead of pair by pair.

use super::calls::evaluate_call;
use super::chains::{evaluate_power, evaluate_product, evaluate_sum};
use super::evaluator::{Evaluator, reads_its_arguments};
use super::function_names::is_function;
use super::messages;
use super::numbers::is_sound;
use super::operand::Operand;
use super::partials::evaluate_partial;
use super::scope::NameKind;
use super::unknown_names::{help_for_unknown, is_declared_elsewhere, is_known_unresolved, report_unknown};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Relation};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;
use lagrange_expr::units::Unit;
use lagrange_language::syntax::ast::{
    ArrayShape, AstId, BinaryOperator, Comparison, Condition, Expression, Name,
};

/// Returns the value of an expression; `None` if it contains an error, which has been reported.
pub(super) fn value_of(evaluator: &mut Evaluator<'_>, root: AstId) -> Option<Operand> {
    let mut pending = vec![root];
    while let Some(&id) = pending.last() {
        let before = pending.len();
        if !evaluator.values.contains(&id) {
            // In reverse order, so that operands are evaluated, and their errors reported, from
            // left to right.
            let operands = evaluator.operands(id).into_iter().rev();
            pending.extend(operands.filter(|operand| !evaluator.values.contains(operand)));
        }
        if pending.len() == before {
            pending.pop();
            if !evaluator.values.contains(&id) {
                let value = evaluate_node(evaluator, id).filter(|value| is_sound(evaluator, value, id));
                evaluator.values.insert(id, value);
            }
        }
    }
    evaluator.value(root)
}

fn evaluate_node(evaluator: &mut Evaluator<'_>, id: AstId) -> Option<Operand> {
    match evaluator.syntax(id) {
        Expression::Number(value) => Some(Operand::Scalar(evaluator.graph.number(value.clone()))),
        Expression::Quantity(number, unit) => evaluate_quantity(evaluator, *number, unit),
        Expression::Name(name) => evaluate_name(evaluator, name, evaluator.origin(id)),
        Expression::Binary(BinaryOperator::Power, _, base, exponent) => {
            evaluate_power(evaluator, *base, *exponent, evaluator.origin(id))
        }
        Expression::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, ..) => {
            evaluate_product(evaluator, id)
        }
        Expression::Negate(_) | Expression::Binary(..) => evaluate_sum(evaluator, id),
        Expression::Tuple(components) => evaluate_tuple(evaluator, components),
        Expression::Entry { of, indices, shape } => evaluate_entry(evaluator, *of, indices, *shape),
        Expression::Call(function, arguments) if reads_its_arguments(&function.text, arguments) => {
            evaluate_partial(evaluator, (arguments, id), value_of)
        }
        Expression::Call(function, arguments) => evaluate_call(evaluator, function, arguments, id),
        Expression::Component(of, component) => evaluate_component(evaluator, *of, component),
        Expression::If { condition, then, otherwise } => {
            evaluate_if(evaluator, *condition, *then, *otherwise)
        }
        // Arrays have been replaced by their elements.
        Expression::Array(_) | Expression::Invalid => None,
    }
}

/// Returns a vector of scalars, or a matrix with vectors as rows.
fn evaluate_tuple(evaluator: &mut Evaluator<'_>, parts: &[AstId]) -> Option<Operand> {
    let values = parts.iter().map(|&part| evaluator.value(part)).collect::<Option<Vec<_>>>()?;
    let first = values.first()?;
    if matches!(first, Operand::Vector(_)) {
        if let Some((&part, other)) = parts.iter().zip(&values).find(|(_, value)| !value.same_kind(first)) {
            let message = messages::rows_differ(first.kind(), other.kind());
            return evaluator.refuse(part, message, messages::ROWS_HELP);
        }
    } else {
        let scalars = parts.iter().map(|&part| evaluator.scalar(part, "a component")).collect::<Vec<_>>();
        scalars.into_iter().collect::<Option<Vec<_>>>()?;
    }
    let shapes = values.iter().map(Operand::shape).collect::<Vec<_>>();
    let components = values.iter().flat_map(|value| value.components().to_vec()).collect();
    Some(Operand::of(ArrayShape::stacked(&shapes)?, components))
}

/// Returns an entry of a vector or a matrix, or a row.
fn evaluate_entry(
    evaluator: &mut Evaluator<'_>,
    of: AstId,
    indices: &[AstId],
    shape: Option<ArrayShape>,
) -> Option<Operand> {
    let value = evaluator.value(of)?;
    if let Some(wanted) = shape.filter(|wanted| *wanted != value.shape()) {
        // One report for all elements of an array is enough.
        if evaluator.misshapen.insert(of) {
            let message = messages::shape_needed(wanted.describe(), value.kind());
            evaluator.refuse::<()>(of, message, messages::SHAPE_HELP);
        }
        return None;
    }
    let places = evaluator.declaration.expressions.places(indices)?;
    if let Some(entry) = value.entry(&places) {
        return Some(entry);
    }
    let written = places.iter().map(|place| format!("[{place}]")).collect::<String>();
    let wrong = (0..places.len()).find(|place| value.entry(&places[..=*place]).is_none());
    let origin = evaluator.origin(*indices.get(wrong?)?);
    let error = evaluator.report.error(origin, messages::no_entry(written, value.kind()));
    error.help(messages::indices_of(value.shape()));
    None
}

/// Converts a number to the coherent unit.
fn evaluate_quantity(evaluator: &mut Evaluator<'_>, number: AstId, unit: &Unit) -> Option<Operand> {
    let number = evaluator.scalar(number, "a number with a unit")?;
    let (scale, pi) = (evaluator.graph.number(unit.scale.number.clone()), evaluator.graph.pi());
    let factors = [(number, 1), (scale, 1), (pi, unit.scale.pi)];
    let factors = factors.map(|(factor, exponent)| (factor, Number::from(i64::from(exponent))));
    let scaled = evaluator.graph.product(factors);
    let zero = evaluator.graph.number(unit.offset.clone());
    Some(Operand::Scalar(evaluator.graph.add(scaled, zero)))
}

fn evaluate_name(evaluator: &mut Evaluator<'_>, name: &str, origin: Origin) -> Option<Operand> {
    match name {
        "t" => return Some(Operand::Scalar(evaluator.graph.symbol("t", Role::Time))),
        "pi" => return Some(Operand::Scalar(evaluator.graph.pi())),
        _ => {}
    }
    if let Some(entry) = evaluator.scope.resolve(name) {
        if entry.kind.has_value() {
            return entry.value.clone();
        }
        let kind = entry.kind;
        if kind == NameKind::Implied && belongs_to_held_pin(evaluator, name) {
            return Some(Operand::Scalar(evaluator.graph.number(0)));
        }
        if kind == NameKind::Implied && !is_first_of_joint(evaluator, name) {
            return None;
        }
        let (message, help) = match kind {
            NameKind::Implied => (messages::FORCE_OF_IMPLIED.to_owned(), messages::FORCE_OF_IMPLIED_HELP),
            kind => (messages::names::has_no_value(kind.describe(), name), messages::names::NAME_IT_WITH_LET),
        };
        evaluator.report.error(origin, message).help(help);
        return None;
    }
    if is_function(name) || evaluator.callables.contains(&name.to_owned()) {
        evaluator
            .report
            .error(origin, messages::names::function_as_value(name))
            .help(messages::FUNCTION_HELP);
        return None;
    }
    if !is_known_unresolved(evaluator, name, origin) && !is_declared_elsewhere(evaluator, name, origin) {
        let help = help_for_unknown(evaluator, name);
        report_unknown(evaluator, name, origin, help);
    }
    None
}

/// True if another component of the pin that has this constraint has a multiplier. The multiplier
/// of a constraint without gradient is arbitrary; the smallest is zero.
fn belongs_to_held_pin(evaluator: &mut Evaluator<'_>, constraint: &str) -> bool {
    let Some((pin, _)) = constraint.rsplit_once('_') else { return false };
    let held = |axis: &str| {
        let entry = evaluator.scope.resolve(&format!("{pin}_{axis}"));
        entry.is_some_and(|entry| entry.kind == NameKind::Constraint)
    };
    ["_x", "_y", "_z"].iter().any(|axis| constraint.ends_with(axis)) && ["x", "y", "z"].into_iter().any(held)
}

/// True if a joint without forces has not been reported yet; one of its constraints has this name.
fn is_first_of_joint(evaluator: &mut Evaluator<'_>, constraint: &str) -> bool {
    let joint = constraint.rsplit_once('_').map_or(constraint, |(joint, _)| joint);
    evaluator.forceless_joints.insert(joint.to_owned())
}

fn evaluate_component(evaluator: &mut Evaluator<'_>, of: AstId, component: &Name) -> Option<Operand> {
    let value = evaluator.value(of)?;
    let index = ["x", "y", "z"].iter().position(|name| *name == component.text);
    if let (Operand::Vector(components), Some(index)) = (&value, index)
        && let Some(&found) = components.get(index)
    {
        return Some(Operand::Scalar(found));
    }
    if is_function(&component.text) {
        let error = evaluator.report.error(component.span, messages::names::method_as_value(&component.text));
        error.help(messages::FUNCTION_HELP);
        return None;
    }
    if evaluator.obliged_vectors.contains(&of) {
        return None;
    }
    let message = messages::no_component(&component.text, value.kind());
    let is_transpose = ["T", "transpose", "H"].contains(&component.text.as_str());
    let help = if is_transpose { messages::TRANSPOSE_HELP } else { messages::COMPONENTS };
    evaluator.report.error(component.span, message).help(help);
    None
}

fn evaluate_if(
    evaluator: &mut Evaluator<'_>,
    condition: Condition,
    then: AstId,
    otherwise: AstId,
) -> Option<Operand> {
    let left = evaluator.scalar(condition.left, "a compared value");
    let right = evaluator.scalar(condition.right, "a compared value");
    let (a, b) = (evaluator.value(then)?, evaluator.value(otherwise)?);
    if !a.same_kind(&b) {
        let message = messages::kinds_differ("choose between", a.kind(), b.kind());
        return evaluator.refuse(otherwise, message, messages::KINDS_HELP);
    }
    let (left, right) = (left?, right?);
    check_equality(evaluator, condition, left, right)?;
    let chosen = a.components().iter().zip(b.components());
    let chosen =
        chosen.map(|(&a, &b)| choose(&mut evaluator.graph, condition.relation, [left, right], [a, b]));
    let chosen = chosen.collect();
    Some(Operand::of(a.shape(), chosen))
}

/// Rejects equality conditions on moving quantities, which hold for an instant at most.
fn check_equality(
    evaluator: &mut Evaluator<'_>,
    condition: Condition,
    left: ExprId,
    right: ExprId,
) -> Option<()> {
    let stays = |id| {
        let fixed = Dependencies::PARAMETER | Dependencies::DISCRETE;
        evaluator.graph.dependencies(id).is_within(fixed)
    };
    let is_equality = matches!(condition.relation, Comparison::Equal | Comparison::Unequal);
    if !is_equality || stays(left) && stays(right) {
        return Some(());
    }
    let moving = if stays(left) { condition.right } else { condition.left };
    evaluator.refuse(moving, messages::EQUALITY, messages::EQUALITY_HELP)
}

/// Returns the first of two values where the comparison holds, otherwise the second.
fn choose(
    graph: &mut Graph,
    comparison: Comparison,
    [left, right]: [ExprId; 2],
    [then, otherwise]: [ExprId; 2],
) -> ExprId {
    let relation = match comparison {
        Comparison::Less => Relation::Less,
        Comparison::LessEqual => Relation::LessEqual,
        Comparison::Greater => Relation::Greater,
        Comparison::GreaterEqual => Relation::GreaterEqual,
        Comparison::Equal => {
            let within = graph.choose(Relation::LessEqual, left, right, then, otherwise);
            return graph.choose(Relation::GreaterEqual, left, right, within, otherwise);
        }
        Comparison::Unequal => {
            return choose(graph, Comparison::Equal, [left, right], [otherwise, then]);
        }
    };
    graph.choose(relation, left, right, then, otherwise)
}
