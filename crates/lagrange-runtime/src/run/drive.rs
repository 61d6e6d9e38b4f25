//! Runs that keep nothing.

use super::current::Current;
use super::events::Events;
use super::steps::{Run, Sink, Turn};
use crate::integrate::{IntegrationError, Method, Outcome, Stepper, Work, explained};
use crate::system::OdeSystem;

/// The end of a run that keeps nothing else.
#[derive(Clone, Copy, Debug)]
pub struct RunEnd<S, Y> {
    /// Time of the end, or of the event that stopped the run.
    pub time: S,
    /// State at that time.
    pub state: Y,
    /// Work of the run.
    pub work: Work,
}

/// Integrates from a start to the end, or until an event stops the run.
///
/// `observe` receives the start, the end of every step, and both states of an event that replaces
/// the state.
pub(super) fn drive<M, K, E>(
    system: &M,
    (t0, y0): (M::Scalar, M::State),
    t_end: M::Scalar,
    method: &K,
    events: impl FnOnce(&M, &M::State) -> E,
    mut observe: impl FnMut(M::Scalar, &M::State),
) -> Outcome<M, RunEnd<M::Scalar, M::State>>
where
    M: OdeSystem,
    K: Method<M>,
    E: Events<M>,
{
    let explain = |error: IntegrationError<M::Scalar, M::State>, system: &M| IntegrationError {
        cause: explained(error.cause, system, (error.time, &error.state), t_end),
        ..error
    };
    let mut current = Current::new(system);
    let started = current.begin::<K::Stepper>((t0, &y0), t_end, |_| Ok(None));
    let started = started.and_then(|()| method.start(current.system(), t0, &y0, t_end));
    let stepper = started
        .map_err(|cause| explain(IntegrationError { cause, time: t0, state: y0 }, current.system()))?;
    let events = events(current.system(), stepper.state());
    observe(t0, stepper.state());
    let mut sink = ObservingSink(observe);
    let mut run = Run::new(&mut current, stepper, events, (t0, t_end), &[]);
    while !run.is_over() {
        match run.next(&mut sink, None) {
            Ok(Turn::Stopped(time, state)) => return Ok(RunEnd { time, state, work: run.work() }),
            Ok(Turn::GoesOn | Turn::Cancelled) => {}
            Err(error) => return Err(explain(error, run.system())),
        }
    }
    Ok(RunEnd { time: t_end, state: *run.state(), work: run.work() })
}

/// A function that receives times and states.
struct ObservingSink<F>(F);

impl<M: OdeSystem, F: FnMut(M::Scalar, &M::State)> Sink<M> for ObservingSink<F> {
    #[inline]
    fn reach_end(&mut self, _: &M, stepper: &mut impl Stepper<M>, time: M::Scalar) -> bool {
        (self.0)(time, stepper.state());
        true
    }

    fn reach(&mut self, _: &M, _: &mut impl Stepper<M>, (t, y): (M::Scalar, &M::State)) -> bool {
        (self.0)(t, y);
        true
    }

    fn replace(&mut self, _: &M, (t, y): (M::Scalar, &M::State), _: bool) {
        (self.0)(t, y);
    }
}
