//! Integration from a start to an end without keeping anything.

use super::declared::DeclaredEvents;
use super::drive::{RunEnd, drive};
use super::events::NoEvents;
use super::room::with_room;
use crate::integrate::{Method, Outcome};
use crate::system::OdeSystem;

/// Integrates from `y0` at `t0` to `t_end`, which may lie before `t0`, and returns the final state.
///
/// `observe` is called with time and state at the start and after every step. If an event of the
/// declaration replaces the state, it is called with both states. Use this for microcontrollers and
/// inner loops: it needs no heap and keeps nothing.
///
/// # Errors
/// If the method fails, with the last good state; `observe` never receives a state that is not
/// finite.
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
    observe: impl FnMut(M::Scalar, &M::State),
) -> Outcome<M, M::State>
where
    M: OdeSystem,
    K: Method<M>,
{
    arrive(system, (t0, y0), t_end, method, observe).map(|end| end.state)
}

/// Integrates as [`integrate`] does, and returns more about the end.
///
/// # Errors
/// If the method fails, with the last good state.
pub fn arrive<M, K>(
    system: &M,
    (t0, y0): (M::Scalar, M::State),
    t_end: M::Scalar,
    method: &K,
    observe: impl FnMut(M::Scalar, &M::State),
) -> Outcome<M, RunEnd<M::Scalar, M::State>>
where
    M: OdeSystem,
    K: Method<M>,
{
    if system.events().is_empty() {
        return drive(system, (t0, y0), t_end, method, |_, _| NoEvents, observe);
    }
    with_room!(system, M, ROOM => {
        let events = |system: &M, y: &M::State| DeclaredEvents::<M, ROOM>::new::<K::Stepper>(system, t0, y);
        drive(system, (t0, y0), t_end, method, events, observe)
    })
}
