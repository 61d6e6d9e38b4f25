//! Constraints as statements: their residuals, and their conditions on the velocities.

use super::elaborator::Elaborator;
use super::loads::forbid_states;
use super::messages;
use super::operand::Operand;
use super::scope::NameKind;
use crate::model::Constraint;
use lagrange_algebra::calculus::{Degree, Degrees};
use lagrange_algebra::formula::text;
use lagrange_algebra::simplify::vanishing;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Name};

pub(super) fn add_constraint(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId) {
    let term = elaborator.term(syntax, name.span, "a constraint");
    if elaborator.evaluator.scope.find(&name.text).is_some() {
        // If the name is already taken, the rest is not checked.
        elaborator.declare(name, NameKind::Constraint, None);
        return;
    }
    if let Some(term) = &term
        && is_implied(elaborator, name, term.value)
    {
        elaborator.implied.push(name.text.clone());
        elaborator.declare(name, NameKind::Implied, None);
        return;
    }
    let index = elaborator.constraints.len() as u32;
    let multiplier = elaborator.evaluator.graph.symbol(&name.text, Role::Multiplier(index));
    let velocity =
        term.and_then(|term| Some((term.value, constrained_velocity(elaborator, name, syntax, term.value)?)));
    elaborator.declare(name, NameKind::Constraint, Some(Operand::Scalar(multiplier)));
    let Some((value, velocity)) = velocity else { return };
    report_repeated(elaborator, name, (value, velocity));
    let is_holonomic = !elaborator.evaluator.graph.dependencies(value).intersects(Dependencies::VELOCITY);
    let constraint = Constraint { name: name.text.clone(), value, velocity, is_holonomic, multiplier };
    elaborator.constraints.push((constraint, name.span));
}

/// True if this is the constraint of a joint that the coordinates fulfil identically.
fn is_implied(elaborator: &mut Elaborator<'_>, name: &Name, value: ExprId) -> bool {
    let is_of_joint = elaborator.joints.iter().any(|joint| joint.text == name.text);
    is_of_joint && vanishing(&mut elaborator.evaluator.graph, &[value]) == [true]
}

/// Returns the expression of the velocities that a constraint makes zero; `None` if the constraint
/// is invalid, which has been reported.
fn constrained_velocity(
    elaborator: &mut Elaborator<'_>,
    name: &Name,
    syntax: AstId,
    value: ExprId,
) -> Option<ExprId> {
    forbid_states(elaborator, syntax, value, messages::states::CONSTRAINT)?;
    let dependencies = elaborator.evaluator.graph.dependencies(value);
    let origin = elaborator.evaluator.origin(syntax);
    if !dependencies.intersects(Dependencies::COORDINATE | Dependencies::VELOCITY) {
        let number = elaborator.evaluator.graph.as_number(value).filter(|number| !number.is_zero());
        let message = match number {
            Some(number) => messages::impossible_constraint(&name.text, number.to_string()),
            None => messages::constrains_nothing(&name.text),
        };
        let error = elaborator.evaluator.report.error(origin, message);
        error.help(messages::CONSTRAINS_NOTHING_HELP);
        return None;
    }
    // The rate, and for accelerations also its rate, must be known.
    let Operand::Scalar(rate) = elaborator.evaluator.rate(&Operand::Scalar(value), syntax)? else {
        return None;
    };
    if !dependencies.intersects(Dependencies::VELOCITY) {
        return Some(rate);
    }
    let mut degrees = Degrees::default();
    degrees.classify(&elaborator.evaluator.graph, &[value]);
    if degrees.of(&elaborator.evaluator.graph, value) == Degree::Nonlinear {
        let (place, _) = elaborator.evaluator.blame(syntax, Dependencies::VELOCITY);
        let error = elaborator.evaluator.report.error(place, messages::nonlinear_constraint(&name.text));
        error.help(messages::NONLINEAR_CONSTRAINT_HELP);
        return None;
    }
    Some(value)
}

/// Reports a constraint that repeats the condition of another one on the velocities, or contradicts
/// it.
fn report_repeated(elaborator: &mut Elaborator<'_>, name: &Name, (value, velocity): (ExprId, ExprId)) {
    let graph = &mut elaborator.evaluator.graph;
    let (scale, rate, core) = normalised(graph, velocity);
    let index = elaborator.constraints.len();
    let first = *elaborator.constrained.get_or_insert_with(core, || index);
    let Some((other, span)) = elaborator.constraints.get(first) else { return };
    let (other_scale, other_rate, _) = normalised(graph, other.velocity);
    let gap = match rate == other_rate {
        true => gap(graph, (value, &scale), (other.value, &other_scale)),
        false => Gap::Certain,
    };
    let (message, help) = match gap {
        Gap::Certain => {
            (messages::contradicting_constraint(&name.text, &other.name), messages::CONTRADICTING_HELP)
        }
        Gap::Unless(text) => {
            (messages::nearly_repeated(&name.text, &other.name, &text), messages::CONTRADICTING_HELP)
        }
        Gap::None if elaborator.joints.iter().any(|joint| joint.text == name.text) => {
            (messages::REPEATED_JOINT.to_owned(), messages::REPEATED_CONSTRAINT_HELP)
        }
        Gap::None => {
            (messages::repeated_constraint(&name.text, &other.name), messages::REPEATED_CONSTRAINT_HELP)
        }
    };
    let error = elaborator.evaluator.report.error(name.span, message).help(help);
    error.related(Origin::from(*span), messages::OTHER_CONSTRAINT_IS_HERE);
}

/// Returns numbers a and b and an expression x without either, such that a velocity is a (x + b).
fn normalised(graph: &mut Graph, velocity: ExprId) -> (Number, Number, ExprId) {
    let Node::Sum { constant, terms } = graph.node(velocity).clone() else {
        return (Number::ONE, Number::ZERO, velocity);
    };
    let scale = terms.first().map_or(Number::ONE, |(_, weight)| weight.clone());
    let over = scale.reciprocal().unwrap_or(Number::ONE);
    let terms = terms.into_iter().map(|(term, weight)| (term, &weight * &over)).collect::<Vec<_>>();
    let core = graph.sum(Number::ZERO, terms);
    (scale, &constant * &over, core)
}

/// The difference between two constraints on the same motion.
enum Gap {
    None,
    /// A number.
    Certain,
    /// An expression of parameters, which may be zero.
    Unless(String),
}

/// Returns the difference between the residuals of two constraints, each without its factor.
fn gap(graph: &mut Graph, first: (ExprId, &Number), second: (ExprId, &Number)) -> Gap {
    let [first, second] = [first, second].map(|(value, scale)| {
        let over = scale.reciprocal().unwrap_or(Number::ONE);
        match graph.node(value).clone() {
            Node::Sum { constant, terms } => {
                let terms = terms.into_iter().map(|(term, weight)| (term, &weight * &over));
                graph.sum(&constant * &over, terms.collect::<Vec<_>>())
            }
            _ => graph.sum(Number::ZERO, [(value, over)]),
        }
    });
    let difference = graph.subtract(first, second);
    match graph.as_number(difference) {
        Some(number) if number.is_zero() => Gap::None,
        Some(_) => Gap::Certain,
        None if graph.dependencies(difference) == Dependencies::PARAMETER => {
            Gap::Unless(text::text(graph, difference))
        }
        None => Gap::None,
    }
}

/// Reports constraints in declarations with `reduce`: a reduced system would need constraints of
/// its own.
pub(super) fn check_reduced_constraints(elaborator: &mut Elaborator<'_>) {
    if let (Some((_, span)), Some(reduction)) =
        (elaborator.constraints.first(), elaborator.reductions.first())
    {
        let error = elaborator.evaluator.report.error(reduction.name.span, messages::REDUCED_CONSTRAINTS);
        error.related(Origin::from(*span), messages::CONSTRAINT_IS_HERE);
        error.help(messages::REDUCED_CONSTRAINTS_HELP);
    }
}

/// True if a constraint contains this velocity.
pub(super) fn is_constrained(elaborator: &Elaborator<'_>, velocity: ExprId) -> bool {
    let rates = elaborator.constraints.iter().map(|(constraint, _)| constraint.velocity).collect::<Vec<_>>();
    elaborator.evaluator.graph.reachable(&rates).contains(&velocity)
}
