//! Initial values of the state: in declarations of coordinates and states, and of any entry in
//! `start` statements.

use super::elaborator::Elaborator;
use super::entries::{assigned_index, spelling_of};
use super::messages::start as messages;
use super::states::state_named;
use crate::model::Assignment;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::ExprId;
use lagrange_language::syntax::ast::{self, AstId, Definition};

/// Adds `start x = e;` or `start dot(x) = e;`.
pub(super) fn add_start(elaborator: &mut Elaborator<'_>, assignment: &ast::Assignment) {
    let index = assigned_index(elaborator, assignment.target, messages::START_HELP);
    let origin = elaborator.evaluator.origin(assignment.target);
    set_start(elaborator, index, origin, assignment.value);
}

/// Adds the value of `coord x = e;` or `state a = e;` after the name has been declared.
pub(super) fn add_declared_start(elaborator: &mut Elaborator<'_>, definition: &Definition) {
    let Some(value) = definition.value else { return };
    let name = definition.name.text.as_str();
    let position = elaborator.coordinates.iter().position(|(known, _)| known.name == name);
    let index = position.or_else(|| state_named(elaborator, name));
    set_start(elaborator, index, definition.name.span.into(), value);
}

fn set_start(elaborator: &mut Elaborator<'_>, index: Option<usize>, origin: Origin, syntax: AstId) {
    let value = elaborator.constant_in_motion(syntax, messages::INITIAL_VALUE);
    let Some(index) = index else { return };
    if let Some(first) = elaborator.start.assigned.note(index, origin) {
        let message = messages::started_twice(spelling_of(elaborator, index));
        let error = elaborator.evaluator.report.error(origin, message);
        error.related(first, messages::STARTED_HERE).help(messages::STARTED_TWICE_HELP);
    }
    elaborator.start.values.extend(value.map(|value| Assignment { index, value }));
}

/// Checks that the initial value of a unit quaternion is complete: only some of its components
/// would give a different orientation.
pub(super) fn check_starts(elaborator: &mut Elaborator<'_>) {
    for orientation in elaborator.orientations.clone() {
        let components = orientation.position..orientation.position + 4;
        let given = components.clone().filter_map(|index| elaborator.start.assigned.first(index));
        let given = given.collect::<Vec<_>>();
        let Some(&first) = given.first().filter(|_| given.len() < components.len()) else { continue };
        let first_part = orientation.position;
        let name = |part: usize| elaborator.coordinates[first_part + part].0.name.as_str();
        let help = messages::whole_quaternion([0, 1, 2, 3].map(name));
        elaborator.evaluator.report.error(first, messages::PART_OF_QUATERNION).help(help);
    }
}

/// Returns the whole initial state. Undeclared entries are zero, and undeclared orientations the
/// identity. The result is empty if nothing is declared.
pub(super) fn initial_state(elaborator: &mut Elaborator<'_>) -> Vec<ExprId> {
    if !elaborator.declaration.has_start() {
        return Vec::new();
    }
    let graph = &mut elaborator.evaluator.graph;
    let (zero, one) = (graph.number(0), graph.number(1));
    let positions = elaborator.coordinates.len() + elaborator.states.len();
    let mut state = vec![zero; positions + elaborator.speeds.len()];
    elaborator.orientations.iter().for_each(|orientation| state[orientation.position] = one);
    for Assignment { index, value } in &elaborator.start.values {
        state.get_mut(*index).into_iter().for_each(|entry| *entry = *value);
    }
    state
}
