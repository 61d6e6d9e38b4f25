//! Checks of laws in random states.

use core::fmt::{self, Display, Formatter, LowerExp};
use std::vec::Vec;

use super::check;
use super::report::Report;
use crate::scalar::{Number, Scalar};
use crate::spread::spread;
use crate::system::LagrangianSystem;

/// Number of states.
const STATES: usize = 24;
/// Maximum number of states drawn to find them.
const MAX_DRAWN: usize = 20 * STATES;

/// The reason why a check fails.
#[derive(Clone, PartialEq, Debug)]
pub enum Broken<S> {
    /// A law does not hold.
    State {
        /// Time.
        time: S,
        /// Entries of the state.
        state: Vec<S>,
        /// All laws in this state.
        report: Report<S>,
    },
    /// No state around the start could be judged.
    NothingJudged,
}

impl<S: Scalar + Display + LowerExp> Display for Broken<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Broken::State { time, state, report } => {
                writeln!(f, "a law is broken at t = {time} in the state {state:?}")?;
                report.fmt(f)
            }
            Broken::NothingJudged => {
                f.write_str("no state near the start can be judged: it is not finite or not smooth there")
            }
        }
    }
}

impl<S: Scalar + Display + LowerExp> core::error::Error for Broken<S> {}

/// Checks the laws in 24 states around `start`, the same in every run. Each entry deviates by up to
/// its magnitude, or its nominal value if that is larger, within its range. States are moved onto
/// the constraints.
///
/// # Errors
/// If a law is broken, with the first such state, or if no state can be judged.
pub fn verify<M: LagrangianSystem>(system: &M, start: &M::State) -> Result<(), Broken<M::Scalar>> {
    let mut judged = 0;
    for index in 0..MAX_DRAWN {
        let (time, mut state) = (spread::<M::Scalar>(index, 0), sample(system, start, index));
        let is_found = system.restore(time, &mut state).is_ok() && is_finite(system, time, &state);
        if !is_found {
            continue;
        }
        let report = check(system, time, &state);
        if !report.holds() {
            return Err(Broken::State { time, state: state.as_ref().to_vec(), report });
        }
        judged += usize::from(report.is_judged());
        if judged == STATES {
            return Ok(());
        }
    }
    if judged == 0 { Err(Broken::NothingJudged) } else { Ok(()) }
}

fn is_finite<M: LagrangianSystem>(system: &M, t: M::Scalar, y: &M::State) -> bool {
    let rates = system.rhs(t, y);
    y.as_ref().iter().chain(rates.as_ref()).all(|entry| entry.is_finite())
}

fn sample<M: LagrangianSystem>(system: &M, start: &M::State, index: usize) -> M::State {
    let (mut state, domain) = (*start, system.domain());
    for (place, entry) in state.as_mut().iter_mut().enumerate() {
        let middle = domain.nearest(place, *entry);
        let reach = middle.abs().max(M::Scalar::from_f64(domain.nominal(place)));
        let part = spread::<M::Scalar>(index, place + 1);
        let end = domain.nearest(place, middle + reach * part.sign());
        *entry = (end - middle).multiply_add(part.abs(), middle);
    }
    state
}
