//! A method on a system, independent of the types of both.

use std::boxed::Box;
use std::format;
use std::string::String;
use std::vec::Vec;

use crate::integrate::Method;
use crate::run::{RunEnd, arrive};
use crate::scalar::Number;
use crate::system::{OdeSystem, StateVector};

/// The setting of a method that is varied.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Knob {
    /// The tolerated error of a step.
    Tolerance,
    /// The length of steps.
    Step,
}

/// The end of a run, with the entries of the state.
pub(super) type VectorEnd = RunEnd<f64, Vec<f64>>;

/// A function from setting, start and end to the result, or to the reason for failure as text.
pub(super) type Runner<'a> = dyn Fn(f64, &[f64], f64) -> Result<VectorEnd, String> + 'a;

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

/// Returns runs of a system from time zero, with its events. `restrict` and `expand` convert from
/// and to states of the whole system. The end time follows the state, since an event may have
/// stopped the run earlier.
pub(super) fn run<'a, M, K>(
    system: &'a M,
    method: impl Fn(M::Scalar) -> K + 'a,
    restrict: impl Fn(&[f64]) -> M::State + 'a,
    expand: impl Fn(&M::State) -> Vec<f64> + 'a,
) -> impl Fn(f64, &[f64], f64) -> Result<VectorEnd, String> + 'a
where
    M: OdeSystem,
    M::Scalar: Into<f64>,
    K: Method<M>,
{
    move |setting, start, end| {
        let (y, end) = (restrict(start), M::Scalar::from_f64(end));
        let method = method(M::Scalar::from_f64(setting));
        let end = arrive(system, (M::Scalar::ZERO, y), end, &method, |_, _| {});
        let end = end.map_err(|error| format!("{}", error.cause))?;
        let time = end.time.into();
        let state = expand(&end.state).into_iter().chain([time]).collect();
        Ok(RunEnd { time, state, work: end.work })
    }
}

/// Returns the state with these components, in the number type of the system.
pub(super) fn rounded<M: OdeSystem>(components: &[f64]) -> M::State {
    let mut y = M::State::ZERO;
    for (y, component) in y.as_mut().iter_mut().zip(components) {
        *y = M::Scalar::from_f64(*component);
    }
    y
}

/// Returns the components of a state.
pub(super) fn components<M: OdeSystem>(y: &M::State) -> Vec<f64>
where
    M::Scalar: Into<f64>,
{
    y.as_ref().iter().map(|component| (*component).into()).collect()
}
