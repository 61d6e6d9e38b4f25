//! Integration from a start to an end, with actions at events.

use super::declared::DeclaredEvents;
use super::drive::drive;
use super::events::{AllEvents, Events, Found, Next, Origin, Replacement};
use super::pending::Pending;
use super::room::with_room;
use crate::event::{Detector, Occurrence};
use crate::integrate::{Method, Outcome, Stepper};
use crate::system::{Action, Direction, OdeSystem, Reacted, Response};

/// Integrates from `y0` at `t0` towards `t_end` and calls `act` at each zero of the E functions
/// `values` that has the given direction. Returns the final time and state; the time is before
/// `t_end` if an action stopped the run.
///
/// # Errors
/// If the method or the search for events fails, with the last good state.
///
/// # Example
///
/// A ball bounces and loses half of its speed at each bounce:
///
/// ```
/// use lagrange::event::{Direction, Action, integrate_with_events};
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
///         Action::Replace([0.0, -0.5 * bounce.state[1]])
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
    act: impl FnMut(&Occurrence<M::Scalar, M::State>) -> Action<M::State>,
) -> Outcome<M, (M::Scalar, M::State)>
where
    M: OdeSystem,
    K: Method<M>,
{
    let detector = Detector::new(directions, t0, values(t0, &y0));
    let given = GivenFunctions { pending: Pending::new(detector), values, act };
    let end = with_room!(system, M, ROOM => {
        let events = |system: &M, y: &M::State| AllEvents {
            declared: DeclaredEvents::<M, ROOM>::new::<K::Stepper>(system, t0, y),
            given,
        };
        drive(system, (t0, y0), t_end, method, events, |_, _| {})
    })?;
    Ok((end.time, end.state))
}

/// E functions, and the action at their zeros.
struct GivenFunctions<S, Y, V, A, const E: usize> {
    pending: Pending<S, Y, E>,
    values: V,
    act: A,
}

impl<M, V, A, const E: usize> Events<M> for GivenFunctions<M::Scalar, M::State, V, A, E>
where
    M: OdeSystem,
    V: FnMut(M::Scalar, &M::State) -> [M::Scalar; E],
    A: FnMut(&Found<M>) -> Action<M::State>,
{
    fn is_empty(&self) -> bool {
        E == 0
    }

    fn look(&mut self, system: &M, stepper: &mut impl Stepper<M>, end: M::Scalar) -> Next<M> {
        let found = self.pending.look(system, stepper, end, &mut self.values)?;
        Ok(found.map(|time| (Origin::Given(0), time)))
    }

    fn take(&mut self, _origin: Origin) -> Option<Found<M>> {
        self.pending.take()
    }

    fn react(&mut self, _system: &M, _origin: Origin, event: &Found<M>) -> Reacted<M> {
        Ok(Response::new((self.act)(event)))
    }

    fn restart(&mut self, _system: &M, t: M::Scalar, y: &M::State, by: Replacement) {
        self.pending.restart(t, (self.values)(t, y), by);
    }

    fn jump(&mut self, _system: &M, t: M::Scalar, y: &M::State) {
        self.pending.jump((self.values)(t, y));
    }
}
