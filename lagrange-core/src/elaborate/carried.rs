//! Rates of quantities that states carry along, which energies must not contain.
//!
//! Virtual displacements leave states unchanged, so derivatives of an energy must not include what
//! its velocities gain from the rates of states. Let a weight be at z = h + s with ṡ = −ḣ/10. From
//! m z̈ = −m g follows 0.9 ḧ = −g. The energy m ż²/2 = 0.81 m ḣ²/2 would give 0.81 ḧ = −g instead.
//! Rates that depend on time and other states only do no harm.

use super::evaluator::Evaluator;
use super::messages;
use super::operand::Operand;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Expression};

/// Derivatives with respect to positions and velocities.
pub(super) const MOTION: Dependencies = Dependencies::COORDINATE.with(Dependencies::VELOCITY);

/// Records that a call is the rate of this value.
pub(super) fn record_rate(evaluator: &mut Evaluator<'_>, value: &Operand, call: AstId) {
    let graph = &evaluator.graph;
    let on_states = |&id: &ExprId| graph.dependencies(id).intersects(Dependencies::STATE);
    let components = value.components().iter().copied().filter(on_states).collect::<Vec<_>>();
    let is_carrier = |&id: &ExprId| {
        let is_state = matches!(graph.symbol_of(id).map(|symbol| symbol.role), Some(Role::State(_)));
        is_state && rate_of(evaluator, id).intersects(MOTION)
    };
    let states = graph.reachable(&components).into_iter().filter(is_carrier);
    if let Some(state) = states.max_by_key(|state| is_fast(evaluator, *state)) {
        evaluator.carried_calls.insert(call, state);
    }
}

/// Records that a name has the value of an expression.
pub(super) fn record_name(evaluator: &mut Evaluator<'_>, name: &str, definition: AstId) {
    let states = carried_rates(evaluator, definition).map(|(_, state)| state);
    if let Some(state) = states.max_by_key(|state| is_fast(evaluator, *state)) {
        evaluator.carried_names.insert(name.to_owned(), state);
    }
}

/// Reports the first rate in an energy that a state carries along, for states with rates of these
/// kinds. The energy is differentiated with respect to them.
pub(super) fn report_carried_rate(evaluator: &mut Evaluator<'_>, energy: AstId, kinds: Dependencies) {
    let mut rates = carried_rates(evaluator, energy);
    let Some((place, state)) = rates.find(|(_, state)| rate_of(evaluator, *state).intersects(kinds)) else {
        return;
    };
    drop(rates);
    let name = evaluator.graph.symbol_of(state).map(|symbol| symbol.name.clone()).unwrap_or_default();
    let error = evaluator.report.error(evaluator.origin(place), messages::states::carried(&name));
    error.help(messages::states::CARRIED_HELP);
}

/// True if the rate of a state depends on velocities, with respect to which every energy is
/// differentiated. One such state represents all that carry the same quantity.
fn is_fast(evaluator: &Evaluator<'_>, state: ExprId) -> bool {
    rate_of(evaluator, state).intersects(Dependencies::VELOCITY)
}

/// Returns the kinds of quantities that the rate of a state depends on.
fn rate_of(evaluator: &Evaluator<'_>, state: ExprId) -> Dependencies {
    let rate = evaluator.graph.rate_of_position(state);
    rate.map_or(Dependencies::NONE, |rate| evaluator.graph.dependencies(rate))
}

/// Returns the rates in an expression that states carry along, and these states.
fn carried_rates(evaluator: &Evaluator<'_>, root: AstId) -> impl Iterator<Item = (AstId, ExprId)> {
    let mut pending = if evaluator.carried_calls.is_empty() { Vec::new() } else { vec![root] };
    let every = std::iter::from_fn(move || {
        let id = pending.pop()?;
        pending.extend(evaluator.constituents(id));
        Some(id)
    });
    every.filter_map(|id| {
        let by_name = match evaluator.syntax(id) {
            Expression::Name(name) => evaluator.carried_names.get(name),
            _ => None,
        };
        evaluator.carried_calls.get(&id).or(by_name).map(|state| (id, *state))
    })
}
