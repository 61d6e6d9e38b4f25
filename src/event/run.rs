//! From a start to an end, with reactions to events.

use super::direction::Direction;
use super::watch::{Occurrence, Watch};
use crate::integrate::{Cause, IntegrationError, Method, Outcome, Stepper};
use crate::system::OdeSystem;

/// What to do at an event.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Reaction<Y> {
    /// Go on.
    Continue,
    /// End the integration here.
    Stop,
    /// Go on from this state instead.
    Replace(Y),
}

/// Integrates from `y0` at `t0` towards `t_end` and calls `react` at each zero of the K functions `values` that has the
/// given direction; returns time and state at the end, which is earlier than `t_end` if a reaction was to stop.
///
/// # Errors
/// What the method met or the search for events, with the last good state.
///
/// # Example
///
/// A ball bounces and loses half of its speed each time:
///
/// ```
/// use lagrange::event::{Direction, Reaction, integrate_with_events};
/// use lagrange::integrate::Verner98;
///
/// lagrange::system! {
///     struct Ball;
///     param g = 9.81;
///     coord y;
///     kinetic = 1/2 * dot(y)^2;
///     potential = g * y;
/// }
///
/// let mut bounces = Vec::new();
/// integrate_with_events(
///     &Ball::default(),
///     (0.0, [1.0, 0.0]),
///     1.2,
///     &Verner98::tolerance(1e-12),
///     ([Direction::Falling], |_, y: &[f64; 2]| [y[0]]),
///     |bounce| {
///         bounces.push(bounce.time);
///         Reaction::Replace([0.0, -0.5 * bounce.state[1]])
///     },
/// )?;
/// let first = (2.0_f64 / 9.81).sqrt();
/// assert!((bounces[0] - first).abs() < 1e-12);
/// assert!((bounces[1] - 2.0 * first).abs() < 1e-12);
/// # Ok::<(), lagrange::integrate::IntegrationError<f64, [f64; 2]>>(())
/// ```
pub fn integrate_with_events<M, K, const E: usize>(
    system: &M,
    (t0, y0): (M::Scalar, M::State),
    t_end: M::Scalar,
    method: &K,
    (directions, mut values): ([Direction; E], impl FnMut(M::Scalar, &M::State) -> [M::Scalar; E]),
    mut react: impl FnMut(&Occurrence<M::Scalar, M::State>) -> Reaction<M::State>,
) -> Outcome<M, (M::Scalar, M::State)>
where
    M: OdeSystem + ?Sized,
    K: Method<M>,
{
    let failed = |cause: Cause<M::Scalar>, time, state| IntegrationError { cause, time, state };
    let mut stepper = method.start(system, t0, &y0, t_end).map_err(|cause| failed(cause, t0, y0))?;
    let mut watch = Watch::new(directions, t0, values(t0, &y0));
    while stepper.time() != t_end {
        stepper.step(system, t_end).map_err(|cause| failed(cause, stepper.time(), *stepper.state()))?;
        loop {
            let next = watch.next(system, &mut stepper, &mut values);
            let Some(event) = next.map_err(|cause| failed(cause, stepper.time(), *stepper.state()))? else {
                break;
            };
            match react(&event) {
                Reaction::Continue => {}
                Reaction::Stop => return Ok((event.time, event.state)),
                Reaction::Replace(state) => {
                    let restarted = stepper.restart(system, event.time, &state);
                    restarted.map_err(|cause| failed(cause, event.time, event.state))?;
                    watch.restart(event.time, values(event.time, &state));
                    break;
                }
            }
        }
    }
    Ok((t_end, *stepper.state()))
}
