//! First-order states, and the equations for their rates.

use super::elaborator::{DeclaredState, Elaborator};
use super::messages::states as words;
use super::operand::Operand;
use super::rate_equations::{report_frozen_coupled_states, report_undetermined_rates, set_rate};
use super::scope::NameKind;
use super::unknown_names::{is_declared_elsewhere, is_known_unresolved, report_unknown};
use crate::model::{Action, Coordinate, EntryLimits};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Mode, Name, StateKind};

/// Defines a state. States come after all other positions, even if these are declared further down.
pub(super) fn define_state(elaborator: &mut Elaborator<'_>, name: &Name, kind: StateKind) {
    let index = (elaborator.first_state + elaborator.states.len()) as u32;
    let (role, name_kind) = match kind {
        StateKind::FirstOrder => (Role::State(index), NameKind::State),
        StateKind::Discrete => (Role::Discrete(index), NameKind::Discrete),
    };
    let graph = &mut elaborator.evaluator.graph;
    let position = graph.symbol(&name.text, role);
    if kind == StateKind::Discrete {
        let rate = graph.number(0);
        graph.set_rate(position, rate);
    }
    elaborator.states.push(DeclaredState {
        name: name.clone(),
        position,
        kind,
        equation: None,
        unknown_rate: None,
        is_given_up: false,
        is_coupled: false,
    });
    elaborator.declare(name, name_kind, Some(Operand::Scalar(position)));
}

/// Defines `mode clutch = open | closed;`: a discrete state, and the numbers of its values. Modes
/// may share a value if it has the same number in both.
pub(super) fn define_mode(elaborator: &mut Elaborator<'_>, mode: &Mode) {
    define_state(elaborator, &mode.name, StateKind::Discrete);
    for (number, name) in (0..).zip(&mode.values) {
        let value = Operand::Scalar(elaborator.evaluator.graph.number(number));
        let known = elaborator.evaluator.scope.find(&name.text);
        let of_mode = known.filter(|known| known.kind == NameKind::ModeValue);
        let is_own = mode.values[..number as usize].iter().any(|before| before.text == name.text);
        match of_mode.map(|known| (known.value == Some(value.clone()), known.span)) {
            Some((true, _)) => {}
            Some((false, first)) if !is_own => {
                let message = words::other_number(&name.text);
                let error = elaborator.evaluator.report.error(name.span, message);
                error.related(Origin::from(first), words::FIRST_NUMBER).help(words::OTHER_NUMBER_HELP);
            }
            _ => elaborator.declare(name, NameKind::ModeValue, Some(value)),
        }
    }
}

/// Returns the index among the positions of the state with this name.
pub(super) fn state_named(elaborator: &Elaborator<'_>, name: &str) -> Option<usize> {
    let entry = elaborator.evaluator.scope.find(name)?;
    let Some(Operand::Scalar(position)) = entry.value else { return None };
    match elaborator.evaluator.graph.symbol_of(position)?.role {
        Role::State(index) | Role::Discrete(index) => Some(index as usize),
        _ => None,
    }
}

/// Adds `dot(a) = e;`.
pub(super) fn add_state_rate(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId) {
    let rate = elaborator.known_scalar(syntax, words::RATE, words::RATE_HELP);
    let Some(position) = state_named(elaborator, &name.text) else {
        return report_no_state(elaborator, name);
    };
    let place = position - elaborator.first_state;
    let state = &mut elaborator.states[place];
    if state.kind == StateKind::Discrete {
        let error = elaborator.evaluator.report.error(name.span, words::discrete_rate(&name.text));
        error.help(words::discrete_rate_help(&name.text));
        return;
    }
    if let Some(first) = state.equation.replace(name.span) {
        let error = elaborator.evaluator.report.error(name.span, words::stated_twice(&name.text));
        error.related(Origin::from(first), words::STATED_HERE).help(words::STATED_TWICE_HELP);
        return;
    }
    // If the equation is invalid, a substitute avoids further reports wherever the rate is used.
    let graph = &mut elaborator.evaluator.graph;
    let rate = rate.unwrap_or_else(|| graph.number(0));
    set_rate(elaborator, syntax, place, rate);
}

/// Reports a name that is not a state.
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

/// Performs the checks that need all states and everything that refers to them.
pub(super) fn check_states(elaborator: &mut Elaborator<'_>) {
    report_undetermined_rates(elaborator);
    report_frozen_coupled_states(elaborator);
    let declaration = elaborator.declaration;
    let scope = &elaborator.evaluator.scope;
    let is_unclear = !declaration.unreadable_words.is_empty();
    let lacks_equation =
        |state: &&DeclaredState| state.kind == StateKind::FirstOrder && state.equation.is_none();
    for state in elaborator.states.iter().filter(lacks_equation).filter(|_| !is_unclear) {
        let text = &state.name.text;
        let is_ambiguous = scope.find(text).is_some_and(|entry| entry.is_ambiguous);
        if !is_ambiguous && !declaration.states_rate_of(text) {
            let error = elaborator.evaluator.report.error(state.name.span, words::without_equation(text));
            error.help(words::equation_of(text));
        }
    }
}

/// Warns about discrete states that nothing changes.
pub(super) fn warn_of_constant_states(elaborator: &mut Elaborator<'_>) {
    let assignments = elaborator.events.iter().flat_map(|(event, _)| match &event.action {
        Action::Assign(assignments) => &assignments[..],
        _ => &[],
    });
    let by_clocks = elaborator.clocks.iter().flat_map(|(clock, _)| &clock.assignments);
    let assigned = assignments.chain(by_clocks).map(|assignment| assignment.index).collect::<Vec<_>>();
    for (index, state) in (elaborator.first_state..).zip(&elaborator.states) {
        let text = &state.name.text;
        if state.kind == StateKind::Discrete && !assigned.contains(&index) && !text.starts_with('_') {
            let warning = elaborator.evaluator.report.doubtful(state.name.span, words::never_assigned(text));
            warning.help(words::never_assigned_help(text));
        }
    }
}

/// Returns the states as positions, with their rates.
pub(super) fn positions_of_states(elaborator: &Elaborator<'_>) -> Vec<Coordinate> {
    let graph = &elaborator.evaluator.graph;
    let positions = elaborator.states.iter().map(|DeclaredState { name, position, .. }| {
        let rate = graph.rate_of_position(*position).unwrap_or(*position);
        Coordinate {
            name: name.text.clone(),
            position: *position,
            rate,
            is_state: true,
            limits: EntryLimits::default(),
        }
    });
    positions.collect()
}
