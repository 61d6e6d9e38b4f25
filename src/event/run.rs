//! From a start to an end, with reactions to events.

use super::direction::Direction;
use super::watch::{Occurrence, Watch};
use crate::integrate::{Cause, IntegrationError, Method, Outcome, Stepper};
use crate::scalar::Scalar;
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
            let (time, state) = (event.time, event.state);
            let mut others = || watch.next_at_once(time, system, &mut stepper, &mut values);
            match answer(event, &mut react, &mut others).map_err(|cause| failed(cause, time, state))? {
                Reaction::Continue => {}
                Reaction::Stop => return Ok((time, state)),
                Reaction::Replace(other) => {
                    stepper.restart(system, time, &other).map_err(|cause| failed(cause, time, state))?;
                    watch.restart(time, values(time, &other));
                    break;
                }
            }
        }
    }
    Ok((t_end, *stepper.state()))
}

/// What comes of an event and of those at the same time, which follow each other, each from the state that the last one
/// left. To stop prevails.
fn answer<S: Scalar, Y: Copy>(
    first: Occurrence<S, Y>,
    react: &mut impl FnMut(&Occurrence<S, Y>) -> Reaction<Y>,
    others: &mut impl FnMut() -> Result<Option<Occurrence<S, Y>>, Cause<S>>,
) -> Result<Reaction<Y>, Cause<S>> {
    let (mut event, mut answer) = (first, Reaction::Continue);
    loop {
        answer = match (react(&event), answer) {
            (Reaction::Continue, earlier) | (_, earlier @ Reaction::Stop) => earlier,
            (later, _) => later,
        };
        if let Reaction::Continue = answer {
            return Ok(answer);
        }
        let Some(next) = others()? else { return Ok(answer) };
        let state = if let Reaction::Replace(state) = answer { state } else { next.state };
        event = Occurrence { time: first.time, state, ..next };
    }
}
