//! Equations for the rates of states, `l * dot(i) = u - r * i;`.
//!
//! While an equation is read, unknown rates are symbols. Equations that share such symbols are
//! coupled. As soon as their number equals that of the symbols, they are solved for the rates.

use std::collections::BTreeSet;
use std::mem::replace;

use super::elaborator::{DeclaredState, Elaborator, RateEquation, UNKNOWNS};
use super::expression::value_of;
use super::messages::states as words;
use lagrange_algebra::calculus::{AccelerationTerms, LinearFailure, Rates, linear_solution};
use lagrange_expr::expr::ExprId;
use lagrange_expr::limits::MAX_COUPLED;
use lagrange_language::syntax::ast::{AstId, StateKind};

/// Reads an equation for rates of states, given as the difference of its sides.
pub(super) fn add_rate_equation(elaborator: &mut Elaborator<'_>, syntax: AstId) {
    let Some(residuals) = residuals(elaborator, syntax) else {
        return give_up(elaborator, &[syntax]);
    };
    for residual in residuals {
        let unknowns = unknowns_in(elaborator, residual);
        if unknowns.is_empty() {
            return report_no_rate_left(elaborator, syntax);
        }
        elaborator.rate_equations.push(RateEquation { syntax, residual, unknowns });
    }
    // All components are collected first: one that determines a rate on its own may share it with
    // the next.
    let mut groups = Vec::new();
    while let Some(place) = elaborator.rate_equations.iter().position(|of| of.syntax == syntax) {
        let equation = elaborator.rate_equations.remove(place);
        groups.push(take_coupled(elaborator, equation));
    }
    groups.into_iter().for_each(|coupled| solve(elaborator, coupled));
}

/// Reports an equation without an unknown rate, unless the error is in another one.
fn report_no_rate_left(elaborator: &mut Elaborator<'_>, syntax: AstId) {
    let mentions = |state: &DeclaredState| elaborator.declaration.mentions_rate_of(syntax, &state.name.text);
    if elaborator.states.iter().any(|state| state.is_given_up && mentions(state)) {
        return;
    }
    let place = elaborator.evaluator.origin(syntax);
    let error = elaborator.evaluator.report.error(place, words::NO_RATE_LEFT);
    error.help(words::NO_RATE_LEFT_HELP);
}

/// Sets the rate of the state at a place.
pub(super) fn set_rate(elaborator: &mut Elaborator<'_>, syntax: AstId, place: usize, rate: ExprId) {
    let Some(symbol) = elaborator.states[place].unknown_rate else {
        return set_rates(elaborator, syntax, [(place, rate)]);
    };
    let residual = elaborator.evaluator.graph.subtract(symbol, rate);
    let coupled = take_coupled(elaborator, RateEquation { syntax, residual, unknowns: vec![place] });
    solve(elaborator, coupled);
}

/// Returns the difference of the sides for each component; `None` after an error, which is
/// reported.
fn residuals(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<Vec<ExprId>> {
    let known = replace(&mut elaborator.evaluator.rates, Rates::new(AccelerationTerms::Kept));
    let graph = &mut elaborator.evaluator.graph;
    let is_missing = |kind: StateKind, rate: Option<ExprId>| kind == StateKind::FirstOrder && rate.is_none();
    let mut symbols = Vec::new();
    for state in &mut elaborator.states {
        if is_missing(state.kind, graph.rate_of_position(state.position)) {
            let symbol = *state.unknown_rate.get_or_insert_with(|| graph.operand(&state.name.text));
            graph.set_rate(state.position, symbol);
            symbols.push(state.position);
        }
    }
    let value = value_of(&mut elaborator.evaluator, syntax);
    for position in symbols {
        elaborator.evaluator.graph.remove_rate(position);
    }
    elaborator.evaluator.rates = known;
    let residuals = value?.components().to_vec();
    for &residual in &residuals {
        elaborator.forbid(UNKNOWNS, (syntax, residual), words::RATE, words::RATE_HELP)?;
    }
    Some(residuals)
}

/// Returns the places of the states whose unknown rates an expression contains.
fn unknowns_in(elaborator: &Elaborator<'_>, residual: ExprId) -> Vec<usize> {
    let reachable = elaborator.evaluator.graph.reachable(&[residual]);
    let states = elaborator.states.iter().enumerate();
    let unknown =
        states.filter(|(_, state)| state.unknown_rate.is_some_and(|symbol| reachable.contains(&symbol)));
    unknown.map(|(place, _)| place).collect()
}

/// Takes the remaining equations that share unknowns with this one, directly or through others.
fn take_coupled(elaborator: &mut Elaborator<'_>, equation: RateEquation) -> Vec<RateEquation> {
    let mut coupled = vec![equation];
    let mut next = 0;
    while next < coupled.len() {
        let unknowns = coupled[next].unknowns.clone();
        let shares = |other: &mut RateEquation| other.unknowns.iter().any(|state| unknowns.contains(state));
        coupled.extend(elaborator.rate_equations.extract_if(.., shares));
        next += 1;
    }
    coupled.sort_by_key(|equation| equation.syntax);
    coupled
}

/// Solves coupled equations for the rates, or keeps them until there are enough equations.
fn solve(elaborator: &mut Elaborator<'_>, coupled: Vec<RateEquation>) {
    let states = unknowns_of(&coupled);
    if coupled.len() < states.len() {
        elaborator.rate_equations.extend(coupled);
        return;
    }
    let symbols = states.iter().filter_map(|&state| elaborator.states[state].unknown_rate);
    let symbols = symbols.collect::<Vec<_>>();
    let residuals = coupled.iter().map(|equation| equation.residual).collect::<Vec<_>>();
    let last = coupled.len() - 1;
    if states.len() > MAX_COUPLED {
        let message = words::too_coupled(states.len(), MAX_COUPLED);
        return refuse(elaborator, &coupled, last, (message, words::TOO_COUPLED_HELP));
    }
    match linear_solution(&mut elaborator.evaluator.graph, &residuals, &symbols) {
        Ok(rates) => {
            states.iter().for_each(|&state| elaborator.states[state].is_coupled = states.len() > 1);
            set_rates(elaborator, coupled[last].syntax, states.into_iter().zip(rates));
        }
        Err(LinearFailure::Nonlinear(equation)) => {
            let message = words::nonlinear(names(elaborator, &coupled[equation].unknowns));
            refuse(elaborator, &coupled, equation, (message, words::NONLINEAR_HELP));
        }
        Err(LinearFailure::Singular) => {
            let message = words::singular(names(elaborator, &states));
            refuse(elaborator, &coupled, last, (message, words::SINGULAR_HELP));
        }
    }
}

/// Reports one of several coupled equations, and gives up all of them.
fn refuse(
    elaborator: &mut Elaborator<'_>,
    coupled: &[RateEquation],
    place: usize,
    (message, help): (String, &str),
) {
    let origin = elaborator.evaluator.origin(coupled[place].syntax);
    elaborator.evaluator.report.error(origin, message).help(help);
    give_up(elaborator, &coupled.iter().map(|equation| equation.syntax).collect::<Vec<_>>());
}

/// Returns the places of the states with unknown rates in these equations, in order.
fn unknowns_of(equations: &[RateEquation]) -> Vec<usize> {
    let unknowns = equations.iter().flat_map(|equation| equation.unknowns.iter().copied());
    unknowns.collect::<BTreeSet<_>>().into_iter().collect()
}

/// Sets the rates of states from an equation.
fn set_rates(
    elaborator: &mut Elaborator<'_>,
    syntax: AstId,
    rates: impl IntoIterator<Item = (usize, ExprId)>,
) {
    let place = elaborator.evaluator.origin(syntax).start;
    for (state, rate) in rates {
        let state = &mut elaborator.states[state];
        state.equation = Some(place);
        state.unknown_rate = None;
        elaborator.evaluator.graph.set_rate(state.position, rate);
    }
}

/// Sets the rates of states in invalid equations, so that the error is reported only once.
fn give_up(elaborator: &mut Elaborator<'_>, equations: &[AstId]) {
    let declaration = elaborator.declaration;
    let zero = elaborator.evaluator.graph.number(0);
    for &syntax in equations {
        let is_in = |name: &str| declaration.mentions_rate_of(syntax, name);
        let states = elaborator.states.iter().enumerate();
        let states = states.filter(|(_, state)| state.equation.is_none() && is_in(&state.name.text));
        let states = states.map(|(place, _)| (place, zero)).collect::<Vec<_>>();
        states.iter().for_each(|&(place, _)| elaborator.states[place].is_given_up = true);
        set_rates(elaborator, syntax, states);
    }
}

/// Reports remaining equations, which are too few for their unknowns.
pub(super) fn report_undetermined_rates(elaborator: &mut Elaborator<'_>) {
    while let Some(equation) = elaborator.rate_equations.pop() {
        let coupled = take_coupled(elaborator, equation);
        let rates = names(elaborator, &unknowns_of(&coupled));
        let message = match coupled.len() {
            1 => words::undetermined_by_one(&rates),
            count => words::undetermined(count, &rates),
        };
        refuse(elaborator, &coupled, coupled.len() - 1, (message, words::UNDETERMINED_HELP));
    }
}

/// Reports states that are frozen in a reduced type although their rates occur in the equations of
/// others, where they would continue to change.
pub(super) fn report_frozen_coupled_states(elaborator: &mut Elaborator<'_>) {
    for pinned in elaborator.reductions.iter().flat_map(|reduction| &reduction.frozen) {
        let place = pinned.coordinate.checked_sub(elaborator.first_state);
        let Some(state) = place.and_then(|place| elaborator.states.get(place)) else { continue };
        if state.is_coupled {
            let message = words::frozen_coupled(&state.name.text);
            elaborator.evaluator.report.error(pinned.span, message).help(words::FROZEN_COUPLED_HELP);
        }
    }
}

/// Returns the rates of states for messages: `dot(a)`, `dot(b)`.
fn names(elaborator: &Elaborator<'_>, states: &[usize]) -> String {
    let rates = states.iter().map(|&state| format!("`dot({})`", elaborator.states[state].name.text));
    rates.collect::<Vec<_>>().join(", ")
}
