//! The state before the start of a motion, as functions of time. Delayed signals see it.

use super::elaborator::{CHANGING, Elaborator};
use super::entries::{assigned_index, components_of, position_at, spelling_of};
use super::expression::value_of;
use super::messages::history as messages;
use crate::model::{Assignment, Orientation};
use lagrange_algebra::calculus::{AccelerationTerms, Rates, substitute};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{self, AstId, Expression};

/// Adds `history x = e;`.
pub(super) fn add_history(elaborator: &mut Elaborator<'_>, assignment: &ast::Assignment) {
    let value = function_of_time(elaborator, assignment.value);
    let target = assignment.target;
    if let Some(orientation) = orientation_at(elaborator, target) {
        return refuse(elaborator, target, orientation);
    }
    let Some(index) = assigned_index(elaborator, target, messages::HISTORY_HELP) else { return };
    let name = spelling_of(elaborator, index);
    if !can_have_history(elaborator, index) {
        return refuse(elaborator, target, name);
    }
    let origin = elaborator.evaluator.origin(target);
    if let Some(first) = elaborator.history.assigned.note(index, origin) {
        let error = elaborator.evaluator.report.error(origin, messages::two_histories(name));
        error.related(first, messages::HISTORY_HERE).help(messages::TWO_HISTORIES_HELP);
    }
    elaborator.history.values.extend(value.map(|value| Assignment { index, value }));
}

/// Reports the history of an entry that has none of its own.
fn refuse(elaborator: &mut Elaborator<'_>, target: AstId, name: String) {
    elaborator.evaluator.refuse::<()>(target, messages::no_history(name), messages::NO_HISTORY_HELP);
}

/// Returns the name of the whole orientation that this expression is, if it is one.
fn orientation_at(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<String> {
    let Expression::Name(text) = elaborator.evaluator.syntax(syntax) else { return None };
    let text = text.to_string();
    let is_unknown = elaborator.evaluator.scope.resolve(&text).is_none();
    (is_unknown && components_of(elaborator, syntax, &text).is_some()).then_some(text)
}

fn function_of_time(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<ExprId> {
    value_of(&mut elaborator.evaluator, syntax)?;
    let value = elaborator.evaluator.scalar(syntax, messages::HISTORY)?;
    let changing = CHANGING.into_iter().filter(|kind| *kind != Dependencies::TIME).collect::<Vec<_>>();
    elaborator.forbid(&changing, (syntax, value), messages::HISTORY, messages::HISTORY_HELP)?;
    Some(value)
}

/// True for coordinates and states. Velocities follow, and orientations have no such formula.
fn can_have_history(elaborator: &Elaborator<'_>, index: usize) -> bool {
    let is_part =
        |orientation: &Orientation| (orientation.position..orientation.position + 4).contains(&index);
    position_at(elaborator, index).is_some() && !elaborator.orientations.iter().any(is_part)
}

/// Reports a history without delayed signals.
pub(super) fn check_history(elaborator: &mut Elaborator<'_>) {
    let Some(&Assignment { index, .. }) = elaborator.history.values.first() else { return };
    let Some(place) = elaborator.history.assigned.first(index) else { return };
    if elaborator.delays.is_empty() {
        elaborator.evaluator.report.error(place, messages::NO_DELAYS).help(messages::NO_DELAYS_HELP);
    }
}

/// Sets the signals before the start. A signal that is delayed itself is seen as it was even
/// earlier.
pub(super) fn set_past_signals(elaborator: &mut Elaborator<'_>) {
    if elaborator.history.values.is_empty() {
        return;
    }
    let mut past = past_state(elaborator);
    let graph = &mut elaborator.evaluator.graph;
    let time = graph.symbol("t", Role::Time);
    for (delay, _) in &mut elaborator.delays {
        let before = substitute(graph, delay.signal, &past);
        let then = graph.subtract(time, delay.lag);
        let late = substitute(graph, before, &HashMap::from_iter([(time, then)]));
        past.insert(elaborator.inputs[delay.input].symbol, late);
        delay.before = Some(before);
    }
}

/// Returns the functions of time that take the places of positions and velocities.
fn past_state(elaborator: &mut Elaborator<'_>) -> HashMap<ExprId, ExprId> {
    let mut past = HashMap::default();
    let mut rates = Rates::new(AccelerationTerms::Kept);
    for Assignment { index, value } in elaborator.history.values.clone() {
        if let Some(position) = position_at(elaborator, index) {
            past.insert(position, value);
        }
        let speed = elaborator.speeds.iter().find(|(speed, _)| speed.coordinate == Some(index));
        if let Some((speed, _)) = speed {
            past.insert(speed.velocity, rates.of(&mut elaborator.evaluator.graph, value));
        }
    }
    past
}
