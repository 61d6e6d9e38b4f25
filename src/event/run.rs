//! From a start to an end, with reactions to events.

use super::course::Course;
use super::lookout::{Declarations, Lookout, is_forwards};
use super::watch::{Occurrence, Watch, is_at_once};
use crate::integrate::{IntegrationError, Method, Outcome, Restarts, Stepper, explained};
use crate::scalar::Scalar;
use crate::system::{Action, Direction, OdeSystem, Reacted, Response, StepFailure};

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
    react: impl FnMut(&Occurrence<M::Scalar, M::State>) -> Action<M::State>,
) -> Outcome<M, (M::Scalar, M::State)>
where
    M: OdeSystem,
    K: Method<M>,
{
    let watch = Watch::new(directions, t0, values(t0, &y0));
    let given = Given { lookout: Lookout::new(watch), values, react };
    drive(system, (t0, y0), t_end, method, given, |_, _| {})
}

/// Integrates with the events that the declaration of the system states, and shows `observe` what [`integrate`] does.
///
/// # Errors
/// What the method met, the search for events, or an event.
///
/// [`integrate`]: crate::integrate::integrate
pub(crate) fn integrate_declared<M, K>(
    system: &M,
    start: (M::Scalar, M::State),
    t_end: M::Scalar,
    method: &K,
    observe: impl FnMut(M::Scalar, &M::State),
) -> Outcome<M, M::State>
where
    M: OdeSystem,
    K: Method<M>,
{
    let none = Lookout::new(Watch::new([], start.0, []));
    let given = Given { lookout: none, values: |_, _: &_| [], react: |_: &_| Action::Continue };
    drive(system, start, t_end, method, given, observe).map(|(_, state)| state)
}

/// Events that are given beside those of the declaration.
struct Given<S, Y, V, R, const E: usize> {
    lookout: Lookout<S, Y, E>,
    values: V,
    react: R,
}

/// The loop.
fn drive<M, K, V, R, const E: usize>(
    system: &M,
    (t0, y0): (M::Scalar, M::State),
    t_end: M::Scalar,
    method: &K,
    given: Given<M::Scalar, M::State, V, R, E>,
    mut observe: impl FnMut(M::Scalar, &M::State),
) -> Outcome<M, (M::Scalar, M::State)>
where
    M: OdeSystem,
    K: Method<M>,
    V: FnMut(M::Scalar, &M::State) -> [M::Scalar; E],
    R: FnMut(&Occurrence<M::Scalar, M::State>) -> Action<M::State>,
{
    let failed = |cause: StepFailure<M::Scalar>, time, state| {
        let cause = explained(cause, system, (time, &state), t_end);
        IntegrationError { cause, time, state }
    };
    let begun = is_forwards::<M>(t0, t_end).and_then(|()| system.begin(t0, &y0));
    let mut switched = begun.map_err(|cause| failed(cause, t0, y0))?;
    let current = switched.as_ref().unwrap_or(system);
    let mut stepper = method.start(current, t0, &y0, t_end).map_err(|cause| failed(cause, t0, y0))?;
    let mut events = Events { end: t_end, declared: Declarations::new(current, t0, stepper.state()), given };
    let has_events = E > 0 || !M::EVENTS.is_empty();
    let mut restarts = Restarts::new(t0, t_end, &[]);
    observe(t0, stepper.state());
    while stepper.time() != t_end {
        let current = switched.as_ref().unwrap_or(system);
        let resumed = restarts.resume(current, &mut stepper);
        let resumed = resumed.map_err(|cause| failed(cause, stepper.time(), *stepper.state()))?;
        switched = resumed.or(switched);
        let current = switched.as_ref().unwrap_or(system);
        let stepped = restarts.step(current, &mut stepper, None, |_, _| has_events);
        stepped.map_err(|cause| failed(cause, stepper.time(), *stepper.state()))?;
        let Some((time, state, course)) = events.turn(current, &mut stepper)? else {
            observe(restarts.time(&stepper), stepper.state());
            continue;
        };
        observe(time, &state);
        let Some(resumed) = course.resume(current, time) else { return Ok((time, state)) };
        let (other, next) = resumed.map_err(|cause| failed(cause, time, state))?;
        switched = next.or(switched);
        let current = switched.as_ref().unwrap_or(system);
        let resumed = stepper.restart(current, time, &other);
        resumed.map_err(|cause| failed(explained(cause, current, (time, &other), t_end), time, state))?;
        events.restart(current, time, stepper.state());
        observe(time, stepper.state());
    }
    Ok((t_end, *stepper.state()))
}

/// All events of a run.
struct Events<M: OdeSystem, V, R, const E: usize> {
    end: M::Scalar,
    declared: Declarations<M>,
    given: Given<M::Scalar, M::State, V, R, E>,
}

/// A time and a state at which the motion does not just go on, and how it does.
type Turn<M> = (<M as OdeSystem>::Scalar, <M as OdeSystem>::State, Course<M>);

/// An event of the declaration, or else a given one.
#[derive(Clone, Copy)]
enum Kind {
    Declared,
    Given,
}

/// Which event comes next, and when.
type Next<M> = Result<Option<(Kind, <M as OdeSystem>::Scalar)>, StepFailure<<M as OdeSystem>::Scalar>>;

impl<M, V, R, const E: usize> Events<M, V, R, E>
where
    M: OdeSystem,
    V: FnMut(M::Scalar, &M::State) -> [M::Scalar; E],
    R: FnMut(&Occurrence<M::Scalar, M::State>) -> Action<M::State>,
{
    /// Reacts to the events of the last step up to one after which the motion does not just go on.
    fn turn(&mut self, system: &M, stepper: &mut impl Stepper<M>) -> Outcome<M, Option<Turn<M>>> {
        loop {
            let found = self.look(system, stepper);
            let found = found.map_err(|cause| {
                let time = stepper.last_time();
                IntegrationError { cause, time, state: stepper.interpolate(system, time) }
            })?;
            let Some((kind, time)) = found else { return Ok(None) };
            let Some(event) = self.take(kind) else { return Ok(None) };
            let state = event.state;
            let course = self.follow(system, stepper, (kind, event));
            let course = course.map_err(|cause| IntegrationError { cause, time, state })?;
            if !course.goes_on() {
                return Ok(Some((time, state, course)));
            }
        }
    }

    /// What comes of an event and of those at the same time, which follow each other, each from the state that the last one
    /// left.
    fn follow(
        &mut self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        (kind, event): (Kind, Occurrence<M::Scalar, M::State>),
    ) -> Result<Course<M>, StepFailure<M::Scalar>> {
        let mut course = Course::new();
        course.add(self.answer(system, kind, &event)?, event.state);
        if course.goes_on() {
            return Ok(course);
        }
        let (from, to) = (stepper.last_time(), stepper.time());
        loop {
            self.declared.drop_switch();
            let next = self.look(system, stepper)?;
            let Some((kind, _)) = next.filter(|(_, time)| is_at_once(event.time, *time, from, to)) else {
                return Ok(course);
            };
            let Some(next) = self.take(kind) else { return Ok(course) };
            if let Kind::Declared = kind
                && M::EVENTS[next.event].is_switch
            {
                continue;
            }
            let state = course.state().unwrap_or(next.state);
            let event = Occurrence { time: event.time, state, ..next };
            let answer = self.answer(course.system.as_ref().unwrap_or(system), kind, &event)?;
            course.add(answer, state);
        }
    }

    fn answer(&mut self, system: &M, kind: Kind, event: &Occurrence<M::Scalar, M::State>) -> Reacted<M> {
        match kind {
            Kind::Declared => system.react(event.event, event.time, &event.state),
            Kind::Given => Ok(Response::new((self.given.react)(event))),
        }
    }

    /// The next event in the last step: which it is, and when.
    fn look(&mut self, system: &M, stepper: &mut impl Stepper<M>) -> Next<M> {
        let from = stepper.last_time();
        let declared = self.declared.look(system, stepper, self.end)?;
        let given = self.given.lookout.look(system, stepper, self.end, &mut self.given.values)?;
        Ok(match (declared, given) {
            (Some(one), Some(other)) if (other - from).abs() < (one - from).abs() => {
                Some((Kind::Given, other))
            }
            (Some(time), _) => Some((Kind::Declared, time)),
            (None, given) => given.map(|time| (Kind::Given, time)),
        })
    }

    fn take(&mut self, kind: Kind) -> Option<Occurrence<M::Scalar, M::State>> {
        match kind {
            Kind::Declared => self.declared.take(),
            Kind::Given => self.given.lookout.take(),
        }
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        self.declared.restart(system, t, y);
        self.given.lookout.restart(t, (self.given.values)(t, y));
    }
}
