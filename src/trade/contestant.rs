//! A method on a system, whatever the types of both.

use std::boxed::Box;
use std::format;
use std::string::String;
use std::vec::Vec;

use crate::integrate::{Method, Stepper, Work};
use crate::scalar::Scalar;
use crate::system::{OdeSystem, StateVector};

/// What a method is told.
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

/// How many components a state of the system has.
pub(super) fn length<M: OdeSystem>() -> usize {
    M::State::ZERO.as_ref().len()
}

/// Runs of a system from the time zero.
pub(super) fn run<'a, M, K>(
    system: &'a M,
    method: impl Fn(M::Scalar) -> K + 'a,
) -> impl Fn(f64, &[f64], f64) -> Result<Run, String> + 'a
where
    M: OdeSystem,
    M::Scalar: Into<f64>,
    K: Method<M>,
{
    move |setting, start, end| {
        let mut y = M::State::ZERO;
        for (component, start) in y.as_mut().iter_mut().zip(start) {
            *component = M::Scalar::from_f64(*start);
        }
        let end = M::Scalar::from_f64(end);
        let method = method(M::Scalar::from_f64(setting));
        let mut stepper =
            method.start(system, M::Scalar::ZERO, &y, end).map_err(|cause| format!("{cause}"))?;
        while stepper.time() != end {
            stepper.step(system, end).map_err(|cause| format!("{cause}"))?;
        }
        let state = stepper.state().as_ref().iter().map(|component| (*component).into()).collect();
        Ok(Run { state, work: stepper.work() })
    }
}
