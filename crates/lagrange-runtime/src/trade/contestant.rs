//! A method on a system, independent of the types of both.

use core::any::type_name;
use std::boxed::Box;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::digits::{Digits, split};
use crate::integrate::Method;
use crate::run::{RunEnd, arrive};
use crate::scalar::{Number, Scalar};
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
pub(super) type VectorEnd = RunEnd<f64, Vec<Digits>>;

/// A function from setting, start and end to the result, or to the reason for failure as text.
pub(super) type Runner<'a> = dyn Fn(f64, &[f64], f64) -> Result<VectorEnd, String> + 'a;

/// A method on a system.
pub(super) struct Contestant<'a> {
    pub(super) method: String,
    /// The type of the method, as an expression names it.
    pub(super) path: String,
    pub(super) scalar: String,
    /// Resolution of the number type.
    pub(super) epsilon: f64,
    pub(super) variant: String,
    pub(super) knob: Knob,
    /// Number of equal motions in a run.
    pub(super) motions: usize,
    pub(super) run: Box<Runner<'a>>,
}

impl<'a> Contestant<'a> {
    /// Creates the contestant for runs by methods of the type `K`.
    pub(super) fn new<M, K>(
        variant: &str,
        knob: Knob,
        motions: usize,
        run: Box<Runner<'a>>,
        name: &str,
    ) -> Self
    where
        M: OdeSystem,
        M::Scalar: Into<f64>,
    {
        let (scalar, path) = (short_name(type_name::<M::Scalar>()), short_name(type_name::<K>()));
        // The number type is inferred if it is the only argument.
        let path = path.replace(&format!("<{scalar}>"), "").replace('<', "::<");
        let (method, variant) = (name.to_string(), variant.to_string());
        Contestant { method, path, scalar, epsilon: M::Scalar::epsilon().into(), variant, knob, motions, run }
    }

    /// Returns the call on a simulation that selects the method with this setting.
    pub(super) fn line(&self, setting: f64) -> String {
        let number = match self.scalar.as_str() {
            "f32" | "f64" => format!("{setting:?}"),
            // The setting of the run is this double, not its decimals.
            wide => format!("{wide}::from({setting:?})"),
        };
        match self.knob {
            Knob::Tolerance => format!(".method({}::tolerance({number}))", self.path),
            Knob::Step => format!(".method({} {{ step: {number} }})", self.path),
        }
    }
}

/// Returns the name of a type without the modules of its parts, and numbers without defaults.
fn short_name(name: &str) -> String {
    let mut short = String::new();
    for part in name.split_inclusive(['<', ',', ' ', '>']) {
        short += part.rsplit("::").next().unwrap_or(part);
    }
    short.replace("Portable<f64>", "Portable")
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
    expand: impl Fn(&M::State) -> Vec<M::Scalar> + 'a,
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
        let state = expand(&end.state).into_iter().chain([end.time]).map(split).collect();
        Ok(RunEnd { time: end.time.into(), state, work: end.work })
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
pub(super) fn components<M: OdeSystem>(y: &M::State) -> Vec<M::Scalar> {
    y.as_ref().to_vec()
}
