//! A method on a system, whatever the types of both.

use std::boxed::Box;
use std::format;
use std::string::String;
use std::vec::Vec;

use crate::integrate::{Method, Stepper, Work};
use crate::scalar::Number;
use crate::system::{OdeSystem, StateVector};

/// The setting of a method.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Knob {
    Tolerance,
    Step,
}

/// The end of a run and what it took.
pub(super) struct Run {
    pub(super) state: Vec<f64>,
    pub(super) work: Work,
}

/// From setting, start and end to what comes of it, or why not, in words.
pub(super) type Runner<'a> = dyn Fn(f64, &[f64], f64) -> Result<Run, String> + 'a;

/// A method on a system.
pub(super) struct Contestant<'a> {
    pub(super) method: String,
    pub(super) scalar: &'static str,
    pub(super) variant: String,
    pub(super) knob: Knob,
    pub(super) run: Box<Runner<'a>>,
}

/// Returns the number of components in a state of the system.
pub(super) fn length<M: OdeSystem>() -> usize {
    M::State::ZERO.as_ref().len()
}

/// Runs of a system from the time zero; `restrict` and `expand` lead from and to the states of the
/// whole system.
pub(super) fn run<'a, M, K>(
    system: &'a M,
    method: impl Fn(M::Scalar) -> K + 'a,
    restrict: impl Fn(&[f64]) -> M::State + 'a,
    expand: impl Fn(&M::State) -> Vec<f64> + 'a,
) -> impl Fn(f64, &[f64], f64) -> Result<Run, String> + 'a
where
    M: OdeSystem,
    M::Scalar: Into<f64>,
    K: Method<M>,
{
    move |setting, start, end| {
        let (y, end) = (restrict(start), M::Scalar::from_f64(end));
        let method = method(M::Scalar::from_f64(setting));
        let mut stepper =
            method.start(system, M::Scalar::ZERO, &y, end).map_err(|cause| format!("{cause}"))?;
        while stepper.time() != end {
            stepper.step(system, end).map_err(|cause| format!("{cause}"))?;
        }
        Ok(Run { state: expand(stepper.state()), work: stepper.work() })
    }
}

/// The state with these components, in the numbers of the system.
pub(super) fn rounded<M: OdeSystem>(components: &[f64]) -> M::State {
    let mut y = M::State::ZERO;
    for (y, component) in y.as_mut().iter_mut().zip(components) {
        *y = M::Scalar::from_f64(*component);
    }
    y
}

/// The components of a state.
pub(super) fn components<M: OdeSystem>(y: &M::State) -> Vec<f64>
where
    M::Scalar: Into<f64>,
{
    y.as_ref().iter().map(|component| (*component).into()).collect()
}
