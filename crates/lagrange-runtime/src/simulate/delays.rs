//! Systems whose signals are delayed, together with their past.

use std::boxed::Box;
use std::cell::RefCell;
use std::rc::Rc;
use std::vec::Vec;

use crate::integrate::Stepper;
use crate::scalar::{Number, Scalar};
use crate::simulate::builder::Simulation;
use crate::simulate::closed_loop::ClosedLoop;
use crate::simulate::control::{Drive, Undriven};
use crate::simulate::history::{History, unknown};
use crate::simulate::observer::{columns_of, inputs};
use crate::system::{
    DelayFault, DelayedSystem, MechanicalSystem, SettingError, StateMatrix, StateVector, StepFailure,
    Wrapper, split,
};

/// Delayed signals take their values from the past of the motion.
#[derive(Clone, Copy, Debug)]
pub struct WithHistory;

impl<'a, M: MechanicalSystem, K, E> Simulation<'a, M, K, Undriven, E> {
    /// Keeps the past of the motion, as the delays of the declaration ask for. Systems that declare
    /// [`delay`](DelayedSystem) run no other way.
    ///
    /// Before the start every signal has the value that it has there, unless the declaration states
    /// its `history`. No step is longer than the shortest delay. Starts, events and changes of
    /// inputs are noticed again after each delay, and steps end there as long as the method
    /// notices. Every delayed signal becomes a column, since it is an input.
    ///
    /// ```
    /// use lagrange::Simulate;
    ///
    /// lagrange::system! {
    ///     struct Decay;
    ///     state x = 1;
    ///     let past = delay(x, 1);
    ///     dot(x) = -past;
    /// }
    ///
    /// let decay = Decay::default();
    /// let motion = decay.simulate(decay.start()).until(2.0).with_history().run()?;
    /// // x = 1 − t up to 1, and 1 − t + (t − 1)²/2 up to 2.
    /// assert!((motion.last()[0] + 0.5).abs() < 1e-12);
    /// assert_eq!(motion.column("past").unwrap()[0], 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_history(mut self) -> Simulation<'a, M, K, WithHistory, E>
    where
        M: DelayedSystem,
    {
        self.plan.record_inputs(self.system, Box::new(columns_of(inputs::<M>)));
        let Simulation { system, state, plan, callbacks, method, end, .. } = self;
        Simulation { system, state, plan, callbacks, method, drive: WithHistory, end }
    }
}

impl<M: DelayedSystem> Drive<M> for WithHistory {
    type Closed = Remembering<M>;

    fn close<R>(&self, system: &M, run: impl FnOnce(&Remembering<M>) -> R) -> R {
        let unknown = unknown(system.lags());
        let plant = system.with_delayed(&unknown);
        let history = History::new(M::Scalar::ZERO, system.lags(), 1, &[]);
        let past = Past { plant: plant.with_delayed(&unknown), start: M::State::ZERO, history };
        run(&Remembering { plant, past: Rc::new(RefCell::new(past)) })
    }
}

/// Shortest delay, in spacings of times.
const SPACINGS: f64 = 1e3;
/// Maximum number of steps of the length of a delay in a run: as many as adaptive methods take by
/// default.
const MAX_STEPS: f64 = 1e8;
/// Maximum number of such steps that the past of a motion keeps.
const MAX_KEPT: f64 = 1e6;

/// Returns the reason why a run over this span does not permit the shortest of these delays. If
/// something else bounds the number of its steps, the span does not.
fn fault<S: Scalar>(
    [start, end]: [S; 2],
    lags: &[S],
    shortest: S,
    are_bounded: bool,
) -> Option<DelayFault<S>> {
    let (spacing, span) = (S::epsilon() * start.abs().max(end.abs()), end - start);
    let longest = lags.iter().copied().fold(S::ZERO, S::max).min(span);
    let times = S::from_f64(SPACINGS) * spacing;
    let steps = if are_bounded { S::ZERO } else { span / S::from_f64(MAX_STEPS) };
    let past = longest / S::from_f64(MAX_KEPT);
    let faults = [
        (times, DelayFault::Times { least: times }),
        (steps, DelayFault::Steps { least: steps }),
        (past, DelayFault::Past { least: past }),
    ];
    let largest = faults.into_iter().reduce(|one, other| if other.0 > one.0 { other } else { one });
    largest.filter(|(least, _)| shortest < *least).map(|(_, fault)| fault)
}

/// Returns the name of the delayed signal with this number. Its input is the one that changes with
/// it.
fn name_of<M: DelayedSystem>(plant: &M, number: usize) -> &'static str {
    let mut signals = plant.lags();
    let mut inputs = |value| -> M::InputVector {
        signals.as_mut().fill(M::Scalar::ZERO);
        signals.as_mut()[number] = value;
        plant.with_delayed(&signals).inputs().into()
    };
    let (without, with) = (inputs(M::Scalar::ZERO), inputs(M::Scalar::ONE));
    let mut pairs = without.as_ref().iter().zip(with.as_ref());
    let place = pairs.position(|(zero, one)| *zero == M::Scalar::ZERO && *one == M::Scalar::ONE);
    place.and_then(|place| plant.input_names().get(place)).copied().unwrap_or_default()
}

/// A system whose delayed signals have the values of its past.
pub struct Remembering<M: DelayedSystem> {
    plant: M,
    past: Rc<RefCell<Past<M>>>,
}

/// The past of a motion.
struct Past<M: DelayedSystem> {
    /// The system with its inputs before the start.
    plant: M,
    /// The state at the start.
    start: M::State,
    history: History<M::Scalar, M::Signals>,
}

impl<M: DelayedSystem> Past<M> {
    fn delayed(&self, t: M::Scalar) -> M::Signals {
        self.history.delayed(t, |then| self.before(then))
    }

    /// Returns the signals at a time before the start, if a function of time gives them.
    fn before(&self, t: M::Scalar) -> Option<M::Signals> {
        let (q, v) = split::<M>(&self.start);
        self.plant.signals_before(t, &q, &v)
    }
}

impl<M: DelayedSystem> Remembering<M> {
    fn signals(&self, t: M::Scalar, y: &M::State) -> M::Signals {
        let (q, v) = split::<M>(y);
        self.present(t, y, |plant| plant.signals(t, &q, &v))
    }

    /// Goes on from a time, where signals jump if that `is_jump`.
    fn reach(&self, to: M::Scalar, signals: &[M::Signals], is_jump: bool) {
        self.past.borrow_mut().history.reach(to, signals, is_jump);
    }
}

impl<M: DelayedSystem> Wrapper for Remembering<M> {
    type Inner = M;
    type State = M::State;

    const KEEPS_HISTORY: bool = true;

    #[inline]
    fn inner(&self) -> &M {
        &self.plant
    }

    fn around(&self, inner: M) -> Self {
        self.with_plant(inner)
    }

    #[inline]
    fn present<R>(&self, t: M::Scalar, _y: &M::State, ask: impl FnOnce(&M) -> R) -> R {
        let delayed = self.past.borrow().delayed(t);
        ask(&self.plant.with_delayed(&delayed))
    }

    #[inline]
    fn outer_rhs(&self, t: M::Scalar, y: &M::State) -> M::State {
        self.present(t, y, |plant| plant.rhs(t, y))
    }

    /// Returns the Jacobian of the plant: within a step the past is a function of time.
    fn outer_jacobian(&self, t: M::Scalar, y: &M::State) -> Option<StateMatrix<M>> {
        self.present(t, y, |plant| plant.jacobian(t, y))
    }

    fn further_restart(&self, t: M::Scalar) -> Option<M::Scalar> {
        self.past.borrow().history.next_break(t)
    }
}

impl<M: DelayedSystem> ClosedLoop<M> for Remembering<M> {
    const HAS_HISTORY: bool = true;

    fn plant(&self) -> &M {
        &self.plant
    }

    fn with_plant(&self, plant: M) -> Self {
        Remembering { plant, past: Rc::clone(&self.past) }
    }

    fn into_plant(self) -> M {
        self.plant
    }

    #[inline]
    fn ask<R>(&self, t: M::Scalar, y: &M::State, question: impl FnOnce(&M) -> R) -> R {
        self.present(t, y, question)
    }

    #[inline]
    fn extended(&self, _t: M::Scalar, y: &M::State) -> M::State {
        *y
    }

    #[inline]
    fn state_of_plant(y: &M::State) -> M::State {
        *y
    }

    fn check(&self, [start, end]: [M::Scalar; 2], _: bool) -> Result<(), SettingError<M::Scalar>> {
        match end < start {
            true => Err(SettingError::Invalid("delayed signals run forwards in time only")),
            false => Ok(()),
        }
    }

    /// Spans that are not finite are left to the method, which names their ends.
    fn check_parameters(
        &self,
        span: [M::Scalar; 2],
        are_bounded: bool,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let lags = self.plant.lags();
        let lags = lags.as_ref();
        let refusal = |number: usize, fault| {
            Err(StepFailure::Delay { signal: name_of(&self.plant, number), lag: lags[number], fault })
        };
        let is_time = |lag: &M::Scalar| lag.is_finite() && *lag > M::Scalar::ZERO;
        if let Some(number) = lags.iter().position(|lag| !is_time(lag)) {
            return refusal(number, DelayFault::NotPositive);
        }
        let is_finite = (span[1] - span[0]).is_finite();
        let Some(shortest) = lags.iter().copied().reduce(M::Scalar::min).filter(|_| is_finite) else {
            return Ok(());
        };
        let number = lags.iter().position(|lag| *lag == shortest).unwrap_or_default();
        fault(span, lags, shortest, are_bounded).map_or(Ok(()), |fault| refusal(number, fault))
    }

    /// Sets the history: before the start, signals have the values that they have there, unless a
    /// function of time gives them. One may depend on those declared before it, so that all are
    /// known after as many rounds.
    fn start_history(&self, start: (M::Scalar, &M::State), order: u32, restarts: &[M::Scalar]) {
        let lags = self.plant.lags();
        let history = History::new(start.0, lags, order, restarts);
        let mut signals = unknown(lags);
        let plant = self.plant.with_delayed(&signals);
        *self.past.borrow_mut() = Past { plant, start: *start.1, history };
        for _ in lags.as_ref() {
            signals = self.signals(start.0, start.1);
            self.past.borrow_mut().history.set_before(signals);
        }
        let mut past = self.past.borrow_mut();
        let before = past.before(start.0);
        if before.is_some_and(|before| before.as_ref() != signals.as_ref()) {
            past.history.jump_at_start();
        }
    }

    fn limit(&self) -> Option<M::Scalar> {
        self.past.borrow().history.limit()
    }

    fn keep(&self, stepper: &mut impl Stepper<Self>, to: M::Scalar) {
        let (first, last) = (stepper.last_time(), stepper.time());
        let times = self.past.borrow().history.times(to);
        let signals = times.into_iter().map(|time| {
            let time = time.max(first).min(last);
            self.signals(time, &stepper.interpolate(self, time))
        });
        let signals = signals.collect::<Vec<_>>();
        let is_jump = self.plant.next_restart(first, to + (to - first)).is_some_and(|jump| jump <= to);
        self.reach(to, &signals, is_jump);
    }

    fn jump(&self, at: M::Scalar) {
        self.reach(at, &[], true);
    }
}
