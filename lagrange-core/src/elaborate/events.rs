//! `event` statements: zeros to be found during a motion, and what happens there.

#[cfg(test)]
mod tests;

use super::elaborator::Elaborator;
use super::expression::value_of;
use super::messages::events as messages;
use super::messages::states;
use super::reactions::add_contact;
use super::scope::NameKind;
use super::states::state_named;
use crate::model::{Action, Assignment};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::symbol::Symbol;
use lagrange_language::syntax::ast::{self, AstId, Expression, Name};

pub(super) fn add_event(elaborator: &mut Elaborator<'_>, event: &ast::Event) {
    let (value, action) = match &event.action {
        ast::Action::Impact(restitution) => return add_contact(elaborator, event, *restitution),
        ast::Action::Stop => (event_function(elaborator, event), Some(Action::Stop)),
        ast::Action::Record => (event_function(elaborator, event), Some(Action::Record)),
        ast::Action::Assign(assignments) => {
            (event_function(elaborator, event), assigned_values(elaborator, &event.name, assignments))
        }
    };
    elaborator.declare(&event.name, NameKind::Event, None);
    if let (Some(value), Some(action)) = (value, action) {
        elaborator.push_event(event, value, action);
    }
}

/// A scalar that can pass zero.
fn event_function(elaborator: &mut Elaborator<'_>, event: &ast::Event) -> Option<ExprId> {
    let syntax = event.value;
    value_of(&mut elaborator.evaluator, syntax)?;
    let value = elaborator.evaluator.scalar(syntax, messages::EVENT_FUNCTION)?;
    let kinds = &[Dependencies::REACTION];
    elaborator.forbid(kinds, (syntax, value), messages::EVENT_FUNCTION, messages::EVENT_FUNCTION_HELP)?;
    let state = Dependencies::TIME | Dependencies::COORDINATE | Dependencies::STATE | Dependencies::VELOCITY;
    let changing = state | Dependencies::INPUT | Dependencies::ACCELERATION | Dependencies::MULTIPLIER;
    if elaborator.evaluator.graph.dependencies(value).intersects(changing) {
        return Some(value);
    }
    let origin = elaborator.evaluator.origin(syntax);
    let error = elaborator.evaluator.report.error(origin, messages::constant_event(&event.name.text));
    error.help(messages::CONSTANT_EVENT_HELP);
    None
}

fn assigned_values(
    elaborator: &mut Elaborator<'_>,
    event: &Name,
    assignments: &[ast::Assignment],
) -> Option<Action> {
    let mut assigned: Vec<(usize, Origin)> = Vec::new();
    let mut sound = Vec::new();
    for assignment in assignments {
        let index = assigned_index(elaborator, assignment.target);
        let value = elaborator.term(assignment.value, event.span, messages::ASSIGNED_VALUE);
        let Some(index) = index else { continue };
        check_assigned_once(elaborator, index, elaborator.evaluator.origin(assignment.target), &mut assigned);
        sound.extend(value.map(|value| Assignment { index, value: value.value }));
    }
    (sound.len() == assignments.len()).then_some(Action::Assign(sound))
}

fn check_assigned_once(
    elaborator: &mut Elaborator<'_>,
    index: usize,
    origin: Origin,
    assigned: &mut Vec<(usize, Origin)>,
) {
    if let Some((_, first)) = assigned.iter().find(|(other, _)| *other == index) {
        let count = elaborator.declaration.coordinates().len();
        let symbol = match index.checked_sub(count) {
            Some(velocity) => elaborator.speeds.get(velocity).map(|(speed, _)| speed.velocity),
            None => position_at(elaborator, index),
        };
        let symbol = symbol.and_then(|symbol| elaborator.evaluator.graph.symbol_of(symbol));
        let target = symbol.map(Symbol::text).unwrap_or_default();
        let error = elaborator.evaluator.report.error(origin, messages::assigned_twice(&target));
        error.related(*first, messages::ASSIGNED_HERE).help(messages::ASSIGNED_TWICE_HELP);
    }
    assigned.push((index, origin));
}

/// The position with this index, states behind all others.
fn position_at(elaborator: &Elaborator<'_>, index: usize) -> Option<ExprId> {
    match index.checked_sub(elaborator.first_state) {
        Some(state) => elaborator.states.get(state).map(|state| state.position),
        None => elaborator.coordinates.get(index).map(|(coordinate, _)| coordinate.position),
    }
}

/// The index in [q…, v…] of what is assigned to.
fn assigned_index(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<usize> {
    let (coordinate, is_velocity) = match elaborator.evaluator.syntax(syntax) {
        Expression::Call(function, arguments) if function.text == "dot" && arguments.len() == 1 => {
            (arguments[0], true)
        }
        _ => (syntax, false),
    };
    let Expression::Name(text) = elaborator.evaluator.syntax(coordinate) else {
        // What is wrong within it is said first.
        value_of(&mut elaborator.evaluator, syntax)?;
        return elaborator.evaluator.refuse(syntax, messages::NOT_ASSIGNABLE, messages::ASSIGNMENT_HELP);
    };
    if elaborator.evaluator.scope.resolve(text).is_none() {
        value_of(&mut elaborator.evaluator, coordinate);
        return None;
    }
    let found = entry_of_state(elaborator, text, is_velocity);
    if is_velocity && state_named(elaborator, text).is_some() {
        let help = states::assigned_rate_help(text);
        return elaborator.evaluator.refuse(syntax, states::assigned_rate(text), &help);
    }
    if found.is_none() {
        let name = Name::new(text.as_str(), elaborator.evaluator.origin(coordinate).start);
        elaborator.report_no_coordinate(&name, messages::ASSIGNMENT_HELP);
    }
    found
}

/// The index in [q…, v…] of a position or velocity, or of the rate of a coordinate.
fn entry_of_state(elaborator: &Elaborator<'_>, name: &str, is_rate: bool) -> Option<usize> {
    // Coordinates may be declared further down, too.
    let count = elaborator.declaration.coordinates().len();
    let velocity = || elaborator.speed_of(name).map(|index| count + index);
    let position = elaborator.coordinates.iter().position(|(known, _)| known.name == name);
    let position = position.or_else(|| state_named(elaborator, name));
    match (position, is_rate) {
        (Some(_), true) => velocity(),
        (Some(index), false) => Some(index),
        (None, is_rate) => velocity().filter(|_| !is_rate),
    }
}

/// A reduced system would need events and modes of its own.
pub(super) fn check_reduced_events(elaborator: &mut Elaborator<'_>) {
    let events = elaborator.events.iter().map(|(_, span)| *span);
    let mut declared = events.chain(elaborator.reactions.iter().map(|(_, span)| *span));
    if let (Some(span), Some(reduction)) = (declared.next(), elaborator.reductions.first()) {
        let error = elaborator.evaluator.report.error(reduction.name.span, messages::REDUCED_EVENTS);
        error.related(Origin::from(span), messages::EVENT_IS_HERE).help(messages::REDUCED_HELP);
    }
}
