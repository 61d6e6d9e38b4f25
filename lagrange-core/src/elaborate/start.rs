//! Initial values of the state: in declarations of coordinates and states, and of any entry in
//! `start` statements.

use super::assigned::DeclaredLimits;
use super::elaborator::Elaborator;
use super::entries::{assigned_index, spelling_of};
use super::limits::set_limits;
use super::messages::start as messages;
use super::states::state_named;
use crate::model::Assignment;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{Dependencies, ExprId, evaluate};
use lagrange_language::syntax::ast::{self, AstId, Definition};
use lagrange_language::syntax::print;

/// Adds `start x = e;` or `start dot(x) = e;`.
pub(super) fn add_start(elaborator: &mut Elaborator<'_>, assignment: &ast::Assignment) {
    let index = assigned_index(elaborator, assignment.target, messages::START_HELP);
    let origin = elaborator.evaluator.origin(assignment.target);
    set_start(elaborator, index, origin, assignment.value);
}

/// Adds the value, the range and the nominal value of `coord x in 0..1 = e;` or `state a = e;`
/// after the name has been declared.
pub(super) fn add_declared_entry(elaborator: &mut Elaborator<'_>, definition: &Definition) {
    let name = definition.name.text.as_str();
    let position = elaborator.coordinates.iter().position(|(known, _)| known.name == name);
    let index = position.or_else(|| state_named(elaborator, name));
    let origin = definition.name.span.into();
    if definition.is_limited() {
        set_limits(elaborator, index, origin, (definition.range, definition.nominal));
    }
    if let Some(value) = definition.value {
        set_start(elaborator, index, origin, value);
    }
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
    if elaborator.declaration.has_start() {
        check_ranges(elaborator);
    }
}

/// Checks that initial values that are known are in the ranges of their entries.
fn check_ranges(elaborator: &mut Elaborator<'_>) {
    let state = initial_state(elaborator);
    for DeclaredLimits { index, origin, range, limits } in elaborator.limits.clone() {
        let Some(&start) = state.get(index) else { continue };
        if elaborator.evaluator.graph.dependencies(start) != Dependencies::NONE {
            continue;
        }
        let value = evaluate(&elaborator.evaluator.graph, &[start], |_| f64::NAN)[0];
        if limits.contains(value) {
            continue;
        }
        let range = print::range(&elaborator.declaration.expressions, &range);
        let name = spelling_of(elaborator, index);
        let assigned = elaborator.start.assigned.first(index);
        let message = match assigned {
            Some(_) => messages::start_outside(name, range),
            None => messages::zero_outside(name, range),
        };
        let error = elaborator.evaluator.report.error(assigned.unwrap_or(origin), message);
        error.help(messages::START_OUTSIDE_HELP);
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
