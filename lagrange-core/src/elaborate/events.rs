//! `event` statements: zeros to be found during a motion, and the actions at them.

#[cfg(test)]
mod tests;

use proc_macro2::Span;

use super::assigned::Assigned;
use super::elaborator::Elaborator;
use super::entries::{assigned_index, spelling_of};
use super::expression::value_of;
use super::messages::events as messages;
use super::reactions::add_contact;
use super::scope::NameKind;
use crate::model::{Action, Assignment, Clock};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_language::syntax::ast;

pub(super) fn add_event(elaborator: &mut Elaborator<'_>, event: &ast::Event) {
    let (value, action) = match &event.action {
        ast::Action::Impact(restitution) => return add_contact(elaborator, event, *restitution),
        ast::Action::Stop => (event_function(elaborator, event), Some(Action::Stop)),
        ast::Action::Record => (event_function(elaborator, event), Some(Action::Record)),
        ast::Action::Assign(assignments) => {
            let assigned = assigned_values(elaborator, event.name.span, assignments);
            (event_function(elaborator, event), assigned.map(Action::Assign))
        }
    };
    elaborator.declare(&event.name, NameKind::Event, None);
    if let (Some(value), Some(action)) = (value, action) {
        elaborator.push_event(event, value, action);
    }
}

/// Adds a clock, `every period => { a = e; }`.
pub(super) fn add_clock(elaborator: &mut Elaborator<'_>, clock: &ast::Clock, keyword: Span) {
    let period = elaborator.constant_in_motion(clock.period, messages::PERIOD);
    if let Some(number) = period.and_then(|period| elaborator.numeric(period)).filter(|&number| number <= 0.0)
    {
        let message = messages::period_is_not_positive(number);
        elaborator.evaluator.refuse::<()>(clock.period, message, messages::PERIOD_HELP);
    }
    let assignments = assigned_values(elaborator, keyword, &clock.assignments);
    let clock = period.zip(assignments).map(|(period, assignments)| Clock { period, assignments });
    elaborator.clocks.extend(clock.map(|clock| (clock, keyword)));
}

/// Evaluates a scalar that can cross zero.
fn event_function(elaborator: &mut Elaborator<'_>, event: &ast::Event) -> Option<ExprId> {
    let syntax = event.value;
    value_of(&mut elaborator.evaluator, syntax)?;
    let value = elaborator.evaluator.scalar(syntax, messages::EVENT_FUNCTION)?;
    let kinds = &[Dependencies::REACTION];
    elaborator.forbid(kinds, (syntax, value), messages::EVENT_FUNCTION, messages::EVENT_FUNCTION_HELP)?;
    let state = Dependencies::TIME | Dependencies::COORDINATE | Dependencies::STATE | Dependencies::VELOCITY;
    let changing = state
        | Dependencies::INPUT
        | Dependencies::NOISE
        | Dependencies::ACCELERATION
        | Dependencies::MULTIPLIER;
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
    span: Span,
    assignments: &[ast::Assignment],
) -> Option<Vec<Assignment>> {
    let mut assigned = Assigned::default();
    let mut sound = Vec::new();
    for assignment in assignments {
        let index = assigned_index(elaborator, assignment.target, messages::ASSIGNMENT_HELP);
        let value = elaborator.term(assignment.value, span, messages::ASSIGNED_VALUE);
        let Some(index) = index else { continue };
        check_assigned_once(elaborator, index, elaborator.evaluator.origin(assignment.target), &mut assigned);
        sound.extend(value.map(|value| Assignment { index, value: value.value }));
    }
    (sound.len() == assignments.len()).then_some(sound)
}

fn check_assigned_once(
    elaborator: &mut Elaborator<'_>,
    index: usize,
    origin: Origin,
    assigned: &mut Assigned,
) {
    if let Some(first) = assigned.note(index, origin) {
        let message = messages::assigned_twice(spelling_of(elaborator, index));
        let error = elaborator.evaluator.report.error(origin, message);
        error.related(first, messages::ASSIGNED_HERE).help(messages::ASSIGNED_TWICE_HELP);
    }
}

/// Reports events of reduced systems, which would need separate events and modes.
pub(super) fn check_reduced_events(elaborator: &mut Elaborator<'_>) {
    let events = elaborator.events.iter().map(|(_, span)| *span);
    let events = events.chain(elaborator.clocks.iter().map(|(_, span)| *span));
    let mut declared = events.chain(elaborator.reactions.iter().map(|(_, span)| *span));
    if let (Some(span), Some(reduction)) = (declared.next(), elaborator.reductions.first()) {
        let error = elaborator.evaluator.report.error(reduction.name.span, messages::REDUCED_EVENTS);
        error.related(Origin::from(span), messages::EVENT_IS_HERE).help(messages::REDUCED_HELP);
    }
}
