//! Jumps of the state, as adjoints pass them.

use std::sync::Arc;
use std::vec::Vec;

use crate::scalar::{Number, Scalar};
use crate::simulate::sensitivity::{Sensitive, Stacked, Varied};
use crate::system::{Action, MOST_LOCATED, OdeSystem, ParametricSystem, ScalarOf, SettingError, StepFailure};

const TOGETHER: &str = "contacts or friction change at the same time, in an order that depends on the variables, so that there is no gradient: start from a state in which they follow each other";
/// Shifts of events that differ by this part are different.
const APART: f64 = 1e-6;

/// A jump of a motion of the system M.
pub(super) struct Jump<M: OdeSystem> {
    /// The system before it.
    pub(super) system: M,
    pub(super) cause: Cause,
    pub(super) time: M::Scalar,
    /// Time since the start of the run.
    pub(super) elapsed: M::Scalar,
    /// The state before it.
    pub(super) state: M::State,
}

/// The cause of a jump.
pub(super) enum Cause {
    /// Declared events at the same time, by their indices.
    Events(Vec<usize>),
    /// Clocks.
    Tick,
}

impl<M, const N: usize> Jump<M>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
{
    /// Finds the contacts and frictions that change their modes at the same time as the first
    /// event. Differences do not separate them.
    pub(super) fn company(&self) -> Company<M::Scalar> {
        let mut company = Company { events: Vec::new(), rates: [Number::ZERO; MOST_LOCATED] };
        let declared = self.system.events();
        let is_of_mode = |event: usize| declared[event].is_of_mode();
        let Cause::Events(events) = &self.cause else { return company };
        let Some(first) = events.first().copied().filter(|event| is_of_mode(*event)) else { return company };
        let forwards = (Number::ONE, &self.system.rhs(self.time, &self.state));
        let Some(rates) = self.rates_of_events(forwards, None) else { return company };
        let values = event_values(&self.system, self.time, &self.state);
        let near = M::Scalar::epsilon().powf(M::Scalar::from_f64(0.4)) * self.elapsed;
        let falls = |k: usize| rates[k] < Number::ZERO && values[k].abs() <= -near * rates[k];
        let others = (0..declared.len()).filter(|k| *k != first && is_of_mode(*k) && falls(*k));
        company.events.extend(others);
        if !company.events.is_empty() {
            company.events.push(first);
        }
        Company { rates, ..company }
    }

    /// Checks that these events remain at the same time if a variable and the state change. Their
    /// outcome is a common one, from which those of single events do not follow.
    ///
    /// # Errors
    /// If they do not.
    pub(super) fn check_company(
        &self,
        Company { events, rates }: &Company<M::Scalar>,
        variable: &Varied<M::Scalar>,
        change: &M::State,
    ) -> Result<(), StepFailure<M::Scalar>> {
        if events.is_empty() {
            return Ok(());
        }
        let slopes = self.rates_of_events((Number::ZERO, change), Some(variable));
        let is_together = slopes.is_some_and(|slopes| {
            let shifts = events.iter().map(|event| slopes[*event] / rates[*event]);
            let most = shifts.clone().fold(M::Scalar::ZERO, |most, shift| most.max(shift.abs()));
            let first = slopes[events[0]] / rates[events[0]];
            let least = M::Scalar::from_f64(APART) * self.elapsed * self.part(variable, change);
            let apart = M::Scalar::from_f64(APART) * (most + least);
            shifts.into_iter().all(|shift| (shift - first).abs() <= apart)
        });
        if is_together { Ok(()) } else { Err(SettingError::Invalid(TOGETHER).into()) }
    }

    /// Returns the relative change of a variable, which is one, or of the state.
    fn part(&self, variable: &Varied<M::Scalar>, change: &M::State) -> M::Scalar {
        let largest = |x: &M::State| x.iter().fold(M::Scalar::ZERO, |most, entry| most.max(entry.abs()));
        match variable.number() {
            Some(_) => M::Scalar::ONE,
            None => largest(change) / largest(&self.state).max(M::Scalar::epsilon().powi(4)),
        }
    }

    /// Returns the derivatives of all event functions along a change of time, state and a variable.
    fn rates_of_events(
        &self,
        change: (M::Scalar, &M::State),
        variable: Option<&Varied<M::Scalar>>,
    ) -> Option<[M::Scalar; MOST_LOCATED]> {
        let sensitive = Sensitive::<M, M, N, 2>::new(copy(&self.system), Arc::default());
        let values = |system: &M, t, y: &M::State| Some(event_values(system, t, y));
        sensitive.along((self.time, &self.state), change, variable, values)
    }

    /// Returns the derivative of the state after the jump with respect to a variable. That of the
    /// state before it is `change`; both are per scale of the variable.
    ///
    /// # Errors
    /// If there is none, as at an event function of zero rate.
    pub(super) fn derivative(
        &self,
        variable: Varied<M::Scalar>,
        change: M::State,
    ) -> Result<M::State, StepFailure<M::Scalar>> {
        let mut system = Sensitive::<M, M, N, 2>::new(copy(&self.system), Arc::new([variable]));
        let mut state = Stacked::with_change(self.state, change);
        match &self.cause {
            Cause::Tick => state = system.tick(self.time, &state).unwrap_or(state),
            Cause::Events(events) => {
                for &event in events {
                    let response = system.react(event, self.time, self.elapsed, &state)?;
                    if let Action::Replace(after) = response.action {
                        state = after;
                    }
                    system = response.system.unwrap_or(system);
                }
            }
        }
        Ok(state.derivatives()[0])
    }
}

/// Events at the same time, and the rates of all event functions.
pub(super) struct Company<S> {
    events: Vec<usize>,
    rates: [S; MOST_LOCATED],
}

/// Returns the values of all event functions.
fn event_values<M: OdeSystem>(system: &M, t: M::Scalar, y: &M::State) -> [M::Scalar; MOST_LOCATED] {
    let mut values = [M::Scalar::ONE; MOST_LOCATED];
    let count = system.events().len().min(MOST_LOCATED);
    system.event_values(t, y, &mut values[..count]);
    values
}

/// Returns a copy of a system, in its present modes.
pub(super) fn copy<M: ParametricSystem>(system: &M) -> M {
    system.with_number(usize::MAX, Number::ZERO)
}
