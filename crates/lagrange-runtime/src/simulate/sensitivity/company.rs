//! Contacts and friction that change their modes at the same time.
//!
//! Their outcome is a common one, from which differences do not separate those of single changes.
//! Take two balls that hit the ground at once. If only the first one is moved, its impact comes
//! earlier or later, and the second one is not there.

use std::vec::Vec;

use crate::scalar::Scalar;
use crate::system::{MAX_LOCATED, OdeSystem, SettingError, StepFailure, values_of_events};

const TOGETHER: &str = "contacts or friction change at the same time, which a variable would separate, so that there is no derivative: start where they follow each other";
/// Shifts of events that differ by this part are different.
const APART: f64 = 1e-6;

/// Events at the same time, and the rates of all event functions.
pub(super) struct Company<S> {
    events: Vec<usize>,
    rates: [S; MAX_LOCATED],
}

impl<S: Scalar> Company<S> {
    /// Finds the contacts and frictions that change their modes at the same time as this event,
    /// given the rates of all event functions. `None` if there are no others.
    pub(super) fn of<L: OdeSystem<Scalar = S>>(
        closed: &L,
        event: usize,
        (t, elapsed, y): (S, S, &L::State),
        rates: [S; MAX_LOCATED],
    ) -> Option<Self> {
        let (declared, values) = (closed.events(), values_of_events::<_, MAX_LOCATED>(closed, t, y));
        let near = S::epsilon().powf(S::from_f64(0.4)) * elapsed;
        let falls = |k: usize| rates[k] < S::ZERO && values[k].abs() <= -near * rates[k];
        let others = (0..declared.len()).filter(|k| *k != event && declared[*k].is_of_mode() && falls(*k));
        let mut events: Vec<usize> = others.collect();
        if events.is_empty() {
            return None;
        }
        events.push(event);
        Some(Company { events, rates })
    }

    /// Checks that the events shift by the same time, given the derivatives of their functions and
    /// the time that counts as one.
    ///
    /// # Errors
    /// If they do not, or derivatives are unknown.
    pub(super) fn check(&self, slopes: Option<[S; MAX_LOCATED]>, unit: S) -> Result<(), StepFailure<S>> {
        match slopes.is_some_and(|slopes| self.stays_together(&slopes, unit)) {
            true => Ok(()),
            false => Err(SettingError::Invalid(TOGETHER).into()),
        }
    }

    fn stays_together(&self, slopes: &[S; MAX_LOCATED], unit: S) -> bool {
        let (shift, part) = (|event: usize| slopes[event] / self.rates[event], S::from_f64(APART));
        let shifts = self.events.iter().map(|event| shift(*event));
        let most = shifts.clone().fold(S::ZERO, |most, shift| most.max(shift.abs()));
        let apart = part * (most + part * unit);
        { shifts }.all(|one| (one - shift(self.events[0])).abs() <= apart)
    }
}
