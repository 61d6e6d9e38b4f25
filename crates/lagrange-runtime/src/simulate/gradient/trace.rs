//! The steps of a run, with some of its states.

use core::cell::RefCell;
use std::vec::Vec;

use super::jump::{Cause, Jump};
use crate::integrate::{Method, Stepper};
use crate::run::room::with_room;
use crate::run::{AllEvents, Current, DeclaredEvents, Events, Found, Next, NoEvents, Origin, Replacement};
use crate::run::{Run, Sink, Turn};
use crate::scalar::Number;
use crate::simulate::sensitivity::copy;
use crate::system::{OdeSystem, ParametricSystem, Reacted, SettingError, StepFailure};
use crate::tolerance::SAME_INSTANT;

/// Error for a run that an event ends.
const STOPPED: &str = "a gradient needs a fixed end: an event stopped the motion before it";

/// The pieces of a motion between its jumps, in their order.
pub(super) type Trace<M> = Vec<SmoothPiece<M>>;

/// A smooth piece of a motion of the system M.
pub(super) struct SmoothPiece<M: OdeSystem> {
    /// Jumps at its start, in their order.
    pub(super) jumps: Vec<Jump<M>>,
    /// The system in its present modes.
    pub(super) system: M,
    pub(super) steps: Steps<M::Scalar, M::State>,
}

/// Steps: all of their times, and states at regular intervals.
///
/// The number of states is one to two times the number of steps between two of them. Backwards, the
/// states in between are computed again. Source: Griewank, Walther, *Evaluating Derivatives*, 2nd
/// ed., §12.2, there with more levels.
pub(super) struct Steps<S, Y> {
    /// Start of each step, and the end of the last one.
    pub(super) times: Vec<S>,
    /// Number of steps between states.
    pub(super) stride: usize,
    /// States at the starts of steps 0, stride, 2 stride, …
    pub(super) states: Vec<Y>,
    /// Numbers of steps before each sample.
    pub(super) samples: Vec<usize>,
}

impl<S: Copy, Y: Copy> Steps<S, Y> {
    fn new(t: S, y: Y) -> Self {
        Steps { times: std::vec![t], stride: 1, states: std::vec![y], samples: Vec::new() }
    }

    /// Returns the number of steps.
    pub(super) fn count(&self) -> usize {
        self.times.len() - 1
    }

    fn push(&mut self, t: S, y: Y) {
        self.times.push(t);
        if !self.count().is_multiple_of(self.stride) {
            return;
        }
        self.states.push(y);
        if self.states.len() > 2 * self.stride {
            self.stride *= 2;
            let mut index = 0;
            self.states.retain(|_| {
                index += 1;
                index % 2 == 1
            });
        }
    }
}

/// Follows a motion. Steps end at the times of samples, of which the last is the end.
///
/// # Errors
/// If the motion cannot be integrated, or an event stops it.
pub(super) fn trace<M, K>(
    system: &M,
    method: &K,
    (t, y): (M::Scalar, M::State),
    samples: &[M::Scalar],
    max_steps: Option<u64>,
) -> Result<Trace<M>, StepFailure<M::Scalar>>
where
    M: ParametricSystem,
    K: Method<M>,
{
    let end = *samples.last().unwrap_or(&t);
    let mut current = Current::new(system);
    current.begin::<K::Stepper>((t, &y), end, |_| Ok(None))?;
    let mut stepper = method.start(current.system(), t, &y, end)?;
    let limit = max_steps.unwrap_or(u64::MAX);
    stepper.limit_steps(limit);
    // The stepper may have brought it nearer to the constraints.
    let y = *stepper.state();
    let log = RefCell::new(Vec::new());
    let mut recorder = Recorder { pieces: Vec::new(), samples, last: (t, y), log: &log };
    recorder.begin(current.system(), (t, y), Vec::new());
    recorder.take_samples(t);
    with_room!(system, M, ROOM => {
        let declared = DeclaredEvents::<M, ROOM>::new::<K::Stepper>(current.system(), t, &y);
        let declared = declared.map(|declared| LoggedEvents { declared, start: t, log: &log });
        let events = AllEvents { declared, given: NoEvents };
        follow(Run::new(&mut current, stepper, events, (t, end), &[]), &mut recorder, limit)?;
    });
    Ok(recorder.pieces)
}

/// Follows a run to its end.
fn follow<M: ParametricSystem, T: Stepper<M>, E: Events<M>>(
    mut run: Run<'_, '_, M, T, E>,
    recorder: &mut Recorder<'_, M>,
    limit: u64,
) -> Result<(), StepFailure<M::Scalar>> {
    while !run.is_over() {
        if run.work().steps + run.work().rejections >= limit {
            return Err(StepFailure::TooManySteps { limit });
        }
        let instant = recorder.samples.first().copied();
        if let Turn::Stopped(..) = run.next(recorder, instant).map_err(|error| error.cause)? {
            return Err(StepFailure::Setting(SettingError::Invalid(STOPPED)));
        }
    }
    Ok(())
}

/// Keeps the steps of a run.
struct Recorder<'a, M: OdeSystem> {
    pieces: Trace<M>,
    /// Times of the samples ahead.
    samples: &'a [M::Scalar],
    /// Time and state that were reached.
    last: (M::Scalar, M::State),
    log: &'a RefCell<Vec<Jump<M>>>,
}

impl<M: ParametricSystem> Recorder<'_, M> {
    /// Begins a piece.
    fn begin(&mut self, system: &M, (t, y): (M::Scalar, M::State), jumps: Vec<Jump<M>>) {
        self.last = (t, y);
        self.pieces.push(SmoothPiece { jumps, system: copy(system), steps: Steps::new(t, y) });
    }

    /// Adds a step to `reached`. The time of a sample there may differ by a rounding.
    fn push(&mut self, from: M::Scalar, reached: (M::Scalar, M::State), instant: M::Scalar) {
        self.last = reached;
        if let Some(SmoothPiece { steps, .. }) = self.pieces.last_mut() {
            if steps.count() == 0 {
                // A piece may begin a few roundings after the one before it ended.
                steps.times[0] = from;
            }
            if reached.0 != from {
                steps.push(reached.0, reached.1);
            }
        }
        self.take_samples(instant);
    }

    /// Marks the samples at this time.
    fn take_samples(&mut self, time: M::Scalar) {
        let Some(SmoothPiece { steps, .. }) = self.pieces.last_mut() else { return };
        while let Some((first, ahead)) = self.samples.split_first()
            && *first == time
        {
            steps.samples.push(steps.count());
            self.samples = ahead;
        }
    }

    /// Removes the samples of the last piece that are at this time, to rounding, and returns their
    /// number.
    fn retake_samples(&mut self, time: M::Scalar) -> usize {
        let Some(SmoothPiece { steps: Steps { times, samples, .. }, .. }) = self.pieces.last_mut() else {
            return 0;
        };
        let rounding = SAME_INSTANT.part::<M::Scalar>() * time.abs();
        let before = samples.len();
        samples.retain(|sample| (time - times[*sample]).abs() > rounding);
        before - samples.len()
    }
}

impl<M: ParametricSystem> Sink<M> for Recorder<'_, M> {
    fn reach_end(&mut self, _: &M, stepper: &mut impl Stepper<M>, time: M::Scalar) -> bool {
        // Events that changed nothing.
        self.log.borrow_mut().clear();
        self.push(stepper.last_time(), (stepper.time(), *stepper.state()), time);
        true
    }

    fn reach(&mut self, _: &M, stepper: &mut impl Stepper<M>, (time, state): (M::Scalar, &M::State)) -> bool {
        self.push(stepper.last_time(), (time, *state), time);
        true
    }

    fn switch(&mut self, system: &M) {
        self.begin(system, self.last, Vec::new());
    }

    fn replace(&mut self, system: &M, (t, y): (M::Scalar, &M::State), _: bool) {
        let jumps = self.log.take();
        self.begin(system, (t, *y), jumps);
    }

    /// Samples at a tick have the state after it, as those of simulations have.
    fn exchange(&mut self, system: &M, (t, y): (M::Scalar, &M::State)) {
        let (_, state) = self.last;
        let elapsed = M::Scalar::ZERO;
        let tick = Jump { system: copy(system), cause: Cause::Tick, time: t, elapsed, state };
        let samples = self.retake_samples(t);
        self.begin(system, (t, *y), std::vec![tick]);
        if let Some(SmoothPiece { steps, .. }) = self.pieces.last_mut() {
            steps.samples.extend(core::iter::repeat_n(0, samples));
        }
    }
}

/// Declared events whose reactions are logged.
struct LoggedEvents<'a, M: OdeSystem, const C: usize> {
    declared: DeclaredEvents<M, C>,
    start: M::Scalar,
    log: &'a RefCell<Vec<Jump<M>>>,
}

impl<M: ParametricSystem, const C: usize> Events<M> for LoggedEvents<'_, M, C> {
    fn is_empty(&self) -> bool {
        self.declared.is_empty()
    }

    fn look(&mut self, system: &M, stepper: &mut impl Stepper<M>, end: M::Scalar) -> Next<M> {
        self.declared.look(system, stepper, end)
    }

    fn take(&mut self, origin: Origin) -> Option<Found<M>> {
        self.declared.take(origin)
    }

    fn react(&mut self, system: &M, origin: Origin, event: &Found<M>) -> Reacted<M> {
        self.log.borrow_mut().push(Jump {
            system: copy(system),
            cause: Cause::Events(self.declared.passed_with(system, event.event).collect()),
            time: event.time,
            elapsed: (event.time - self.start).abs(),
            state: event.state,
        });
        self.declared.react(system, origin, event)
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State, by: Replacement) {
        self.declared.restart(system, t, y, by);
    }

    fn jump(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        self.declared.jump(system, t, y);
    }
}
