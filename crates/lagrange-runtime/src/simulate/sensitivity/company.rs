//! Contacts and friction that change their modes at the same time.
//!
//! Their outcome is a common one, from which differences do not separate those of single changes.
//! Take two balls that hit the ground at once. If only the first one is moved, its impact comes
//! earlier or later, and the second one is not there.

use std::vec::Vec;

use super::stacked::Stacked;
use super::system::{Sensitive, Varied};
use crate::scalar::{Number, Scalar};
use crate::simulate::closed_loop::ClosedLoop;
use crate::system::{MOST_LOCATED, OdeSystem, ParametricSystem, ScalarOf, SettingError, StepFailure};

const TOGETHER: &str = "contacts or friction change at the same time, in an order that depends on the variables, so that there is no derivative: start from a state in which they follow each other";
/// Shifts of events that differ by this part are different.
const APART: f64 = 1e-6;

/// Events at the same time, and the rates of all event functions.
struct Company<S> {
    events: Vec<usize>,
    rates: [S; MOST_LOCATED],
}

impl<M, L, const N: usize, const R: usize> Sensitive<M, L, N, R>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    L: ClosedLoop<M> + OdeSystem<Scalar = ScalarOf<M>, State = [ScalarOf<M>; N]>,
{
    /// Checks that modes which change at the same time as an event do so for all values of the
    /// variables.
    ///
    /// # Errors
    /// If they do not.
    pub(super) fn check_company(
        &self,
        event: usize,
        (t, elapsed): (M::Scalar, M::Scalar),
        y: &Stacked<M::Scalar, N, R>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let state = &y.rows[0];
        let Some(company) = self.company(event, (t, elapsed), state) else { return Ok(()) };
        let pairs = self.variables.iter().zip(y.derivatives());
        let mut are_together = pairs.map(|(variable, change)| {
            let least = M::Scalar::from_f64(APART) * elapsed * part(variable, change, state);
            let still = (Number::ZERO, change);
            let slopes = self.along((t, state), still, Some(variable), event_values);
            slopes.is_some_and(|slopes| company.stays_together(&slopes, least))
        });
        if are_together.all(|is_together| is_together) {
            return Ok(());
        }
        Err(SettingError::Invalid(TOGETHER).into())
    }

    /// Finds the contacts and frictions that change their modes at the same time as this event.
    fn company(
        &self,
        event: usize,
        (t, elapsed): (M::Scalar, M::Scalar),
        y: &M::State,
    ) -> Option<Company<M::Scalar>> {
        let declared = self.closed.events();
        if !declared[event].is_of_mode() {
            return None;
        }
        let forwards = (Number::ONE, &self.closed.rhs(t, y));
        let rates = self.along((t, y), forwards, None, event_values)?;
        let values = event_values(&self.closed, t, y)?;
        let near = M::Scalar::epsilon().powf(M::Scalar::from_f64(0.4)) * elapsed;
        let falls = |k: usize| rates[k] < Number::ZERO && values[k].abs() <= -near * rates[k];
        let others = (0..declared.len()).filter(|k| *k != event && declared[*k].is_of_mode() && falls(*k));
        let mut events: Vec<usize> = others.collect();
        if events.is_empty() {
            return None;
        }
        events.push(event);
        Some(Company { events, rates })
    }
}

impl<S: Scalar> Company<S> {
    /// True if the events shift by the same time, given the derivatives of their functions. Times
    /// that differ by less than `least` of the largest part are the same.
    fn stays_together(&self, slopes: &[S; MOST_LOCATED], least: S) -> bool {
        let shift = |event: usize| slopes[event] / self.rates[event];
        let shifts = self.events.iter().map(|event| shift(*event));
        let most = shifts.clone().fold(S::ZERO, |most, shift| most.max(shift.abs()));
        let apart = S::from_f64(APART) * most + S::from_f64(APART) * least;
        { shifts }.all(|one| (one - shift(self.events[0])).abs() <= apart)
    }
}

/// Returns the relative change of a variable, which is one, or of the state.
fn part<S: Scalar, const N: usize>(variable: &Varied<S>, change: &[S; N], state: &[S; N]) -> S {
    let largest = |x: &[S; N]| x.iter().fold(S::ZERO, |most, entry| most.max(entry.abs()));
    match variable.number() {
        Some(_) => S::ONE,
        None => largest(change) / largest(state).max(S::epsilon().powi(4)),
    }
}

/// Returns the values of all event functions.
fn event_values<L: OdeSystem>(closed: &L, t: L::Scalar, y: &L::State) -> Option<[L::Scalar; MOST_LOCATED]> {
    let mut values = [Number::ONE; MOST_LOCATED];
    let count = closed.events().len().min(MOST_LOCATED);
    closed.event_values(t, y, &mut values[..count]);
    Some(values)
}
