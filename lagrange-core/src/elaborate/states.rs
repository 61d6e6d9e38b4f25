//! First-order states, and the equations that state their rates.

use super::elaborator::{DeclaredState, Elaborator, UNKNOWNS};
use super::expression::value_of;
use super::messages::states as words;
use super::operand::Operand;
use super::scope::NameKind;
use super::unknown_names::{is_declared_elsewhere, is_known_unresolved, report_unknown};
use crate::model::Coordinate;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Name};

/// States stand behind all other positions, be these declared further down.
pub(super) fn define_state(elaborator: &mut Elaborator<'_>, name: &Name) {
    let index = elaborator.first_state + elaborator.states.len();
    let position = elaborator.evaluator.graph.symbol(&name.text, Role::State(index as u32));
    elaborator.states.push(DeclaredState { name: name.clone(), position, equation: None });
    elaborator.declare(name, NameKind::State, Some(Operand::Scalar(position)));
}

/// Index among the positions of the state of this name.
pub(super) fn state_named(elaborator: &Elaborator<'_>, name: &str) -> Option<usize> {
    let entry = elaborator.evaluator.scope.find(name).filter(|entry| entry.kind == NameKind::State)?;
    let Some(Operand::Scalar(position)) = entry.value else { return None };
    match elaborator.evaluator.graph.symbol_of(position)?.role {
        Role::State(index) => Some(index as usize),
        _ => None,
    }
}

/// `dot(a) = e;`
pub(super) fn add_state_rate(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId) {
    let rate = rate_value(elaborator, syntax);
    let Some(position) = state_named(elaborator, &name.text) else {
        return report_no_state(elaborator, name);
    };
    let state = &mut elaborator.states[position - elaborator.first_state];
    let (position, first) = (state.position, state.equation.replace(name.span));
    if let Some(first) = first {
        let error = elaborator.evaluator.report.error(name.span, words::stated_twice(&name.text));
        error.related(Origin::from(first), words::STATED_HERE).help(words::STATED_TWICE_HELP);
        return;
    }
    // Where the equation is wrong, another one keeps what mentions the rate from being reported,
    // too.
    let graph = &mut elaborator.evaluator.graph;
    let rate = rate.unwrap_or_else(|| graph.number(0));
    graph.set_rate(position, rate);
}

/// A function of time, positions, velocities, states and inputs.
fn rate_value(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<ExprId> {
    value_of(&mut elaborator.evaluator, syntax)?;
    let value = elaborator.evaluator.scalar(syntax, words::RATE)?;
    elaborator.forbid(UNKNOWNS, (syntax, value), words::RATE, words::RATE_HELP)?;
    Some(value)
}

/// Reports a name that should be that of a state.
fn report_no_state(elaborator: &mut Elaborator<'_>, name: &Name) {
    let (text, origin, evaluator) = (&name.text, name.span.into(), &mut elaborator.evaluator);
    let Some(kind) = evaluator.scope.resolve(text).map(|entry| entry.kind) else {
        if !is_known_unresolved(evaluator, text, origin) && !is_declared_elsewhere(evaluator, text, origin) {
            report_unknown(evaluator, text, origin, words::declare(text));
        }
        return;
    };
    let (message, help) = match kind {
        NameKind::Coordinate => (words::rate_of_coordinate(text), words::RATE_OF_COORDINATE_HELP.to_owned()),
        kind => (words::no_state(kind.describe(), text), words::declare("a")),
    };
    evaluator.report.error(name.span, message).help(help);
}

/// Checks that need all states and all that mentions them.
pub(super) fn check_states(elaborator: &mut Elaborator<'_>) {
    let declaration = elaborator.declaration;
    let scope = &elaborator.evaluator.scope;
    let is_unclear = !declaration.unreadable_words.is_empty();
    for state in elaborator.states.iter().filter(|state| !is_unclear && state.equation.is_none()) {
        let text = &state.name.text;
        let is_ambiguous = scope.find(text).is_some_and(|entry| entry.is_ambiguous);
        if !is_ambiguous && !declaration.states_rate_of(text) {
            let error = elaborator.evaluator.report.error(state.name.span, words::without_equation(text));
            error.help(words::equation_of(text));
        }
    }
}

/// Reports energies in which states multiply velocities.
pub(super) fn report_states_in_momenta(elaborator: &mut Elaborator<'_>) {
    for term in elaborator.kinetic.iter().chain(&elaborator.lagrangian) {
        if elaborator.evaluator.graph.dependencies(term.value).intersects(Dependencies::STATE) {
            let (place, name) = elaborator.evaluator.blame(term.syntax, Dependencies::STATE);
            let error = elaborator.evaluator.report.error(place, words::in_kinetic(&name));
            error.help(words::IN_KINETIC_HELP);
        }
    }
}

/// The states as positions, with their rates.
pub(super) fn positions_of_states(elaborator: &Elaborator<'_>) -> Vec<Coordinate> {
    let graph = &elaborator.evaluator.graph;
    let positions = elaborator.states.iter().map(|DeclaredState { name, position, .. }| {
        let rate = graph.rate_of_position(*position).unwrap_or(*position);
        Coordinate { name: name.text.clone(), position: *position, rate, is_state: true }
    });
    positions.collect()
}
