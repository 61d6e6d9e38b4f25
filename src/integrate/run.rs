//! From a start to an end without keeping anything.

use crate::event::integrate_declared;
use crate::integrate::error::{IntegrationError, Outcome};
use crate::integrate::method::{Method, Stepper};
use crate::integrate::restarts::Restarts;
use crate::integrate::undefined::explained;
use crate::system::{OdeSystem, StepFailure};

/// Integrates from `y0` at `t0` to `t_end`, which may lie before `t0`, and returns the state there.
///
/// `observe` is called with time and state at the start and after every step; where an event of the declaration replaced the
/// state, before and after it. This is the loop for microcontrollers
/// and inner loops: no heap, nothing kept.
///
/// # Errors
/// What the method met, with the last good state; `observe` never sees one that is not finite.
///
/// # Example
///
/// ```
/// use lagrange::integrate::{RungeKutta4, integrate};
/// use lagrange::system::OdeSystem;
///
/// /// ẍ = −x
/// struct Oscillator;
///
/// impl OdeSystem for Oscillator {
///     type Scalar = f64;
///     type State = [f64; 2];
///
///     fn rhs(&self, _t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
///         [*v, -x]
///     }
/// }
///
/// let mut largest = 0.0_f64;
/// let method = RungeKutta4 { step: 2e-3 };
/// let [x, v] = integrate(&Oscillator, 0.0, [1.0, 0.0], 2.0, &method, |_, [_, v]| largest = largest.max(v.abs()))?;
/// assert!((x - 2.0_f64.cos()).abs() < 1e-12);
/// assert!((v + 2.0_f64.sin()).abs() < 1e-12);
/// assert!((largest - 1.0).abs() < 1e-6);
/// # Ok::<(), lagrange::integrate::IntegrationError<f64, [f64; 2]>>(())
/// ```
pub fn integrate<M, K>(
    system: &M,
    t0: M::Scalar,
    y0: M::State,
    t_end: M::Scalar,
    method: &K,
    mut observe: impl FnMut(M::Scalar, &M::State),
) -> Outcome<M, M::State>
where
    M: OdeSystem,
    K: Method<M>,
{
    if !M::EVENTS.is_empty() {
        return integrate_declared(system, (t0, y0), t_end, method, observe);
    }
    let failed = |cause: StepFailure<M::Scalar>, time, state| {
        let cause = explained(cause, system, (time, &state), t_end);
        IntegrationError { cause, time, state }
    };
    let mut stepper = method.start(system, t0, &y0, t_end).map_err(|cause| failed(cause, t0, y0))?;
    let mut restarts = Restarts::new(t0, t_end, &[]);
    let mut switched = None;
    observe(t0, stepper.state());
    while stepper.time() != t_end {
        let current = switched.as_ref().unwrap_or(system);
        let resumed = restarts.resume(current, &mut stepper);
        let resumed = resumed.map_err(|cause| failed(cause, stepper.time(), *stepper.state()))?;
        switched = resumed.or(switched);
        let stepped = restarts.step(switched.as_ref().unwrap_or(system), &mut stepper, None, |_, _| false);
        stepped.map_err(|cause| failed(cause, stepper.time(), *stepper.state()))?;
        observe(restarts.time(&stepper), stepper.state());
    }
    Ok(*stepper.state())
}
