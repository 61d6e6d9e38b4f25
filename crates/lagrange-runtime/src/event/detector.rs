//! Search for zeros within steps.

mod earliest;

use super::function::EventFunction;
use super::instant::{accuracy, is_at_once, unresolved};
use super::piece::{EventValues, Piece};
use super::polynomial::{POINTS, points};
use super::rounding::{is_rounding, rounded};
use super::search::Search;
use crate::integrate::EventSource::Given;
use crate::integrate::Stepper;
use crate::scalar::Scalar;
use crate::system::{DeclaredEvent, Direction, OdeSystem, StepFailure};
use crate::tolerance::{SAME_EVENT, SAME_INSTANT};
use earliest::First;

/// Part of a step after which the state differs from its replacement.
const SHORTLY: f64 = 1e-10;
/// Number of events at the same time that counts as infinitely many.
const MAX_REPETITIONS: u32 = 50;

/// An occurrence of an event.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Occurrence<S, Y> {
    /// Index of the function that crossed zero, counted from zero.
    pub event: usize,
    /// Time of the event.
    pub time: S,
    /// State at that time.
    pub state: Y,
}

/// The search state of K functions from step to step.
#[derive(Clone, Copy, Debug)]
pub struct Detector<S, const K: usize> {
    functions: [EventFunction<S>; K],
    /// Time up to which the last step was searched.
    reached: S,
    /// The current step and its division into pieces.
    search: Search<S>,
    /// Time at which the functions were started, or last restarted.
    started: S,
    /// True if the state was replaced at that time.
    is_replaced: bool,
    /// Number of repetitions, each within rounding of the previous event, and that event.
    repetitions: u32,
    last: usize,
    /// True if the last event came before its function had moved away from zero by more than
    /// rounding.
    is_noise: bool,
    /// True if one of these functions had an event since the last restart.
    has_fired: bool,
    /// True if the event that led to the last restart was of one of these functions, not of another
    /// detector.
    was_fired: bool,
}

/// The function that has an event, and its time.
type Suspect<S> = (usize, S);

impl<S: Scalar, const K: usize> Detector<S, K> {
    /// Starts at time `t`, where the functions have these values.
    pub fn new(directions: [Direction; K], t: S, values: [S; K]) -> Self {
        let functions = core::array::from_fn(|k| EventFunction::new(directions[k], values[k]));
        Detector {
            functions,
            reached: t,
            search: Search::new(t, t),
            started: t,
            is_replaced: false,
            repetitions: 0,
            last: 0,
            is_noise: false,
            has_fired: false,
            was_fired: false,
        }
    }

    /// Adds functions that [switch](crate::event::DeclaredEvent::is_switch) the first modes of a
    /// system.
    pub(crate) fn with_switches(mut self, declared: &[DeclaredEvent]) -> Self {
        for (function, event) in self.functions.iter_mut().zip(declared) {
            function.is_switch = event.is_switch;
            function.begin(self.started, function.here);
        }
        self
    }

    /// Returns the largest magnitude observed for each function.
    pub(crate) fn ranges(&self) -> [S; K] {
        self.functions.map(|function| function.range)
    }

    /// Returns the next event in the stepper's last step, after those already returned.
    ///
    /// Call it after each step until it returns `None`, and after [`Stepper::confirm`]; `values`
    /// gives all functions at a time and state. The time returned is at most 10⁻¹³ of the step, or
    /// one unit in the last place of time, beyond the change of sign. The value there is zero or
    /// has the sign that it changes to.
    ///
    /// # Errors
    /// If any of these holds:
    /// - a function is NaN or infinite, or does not settle in 200 evaluations;
    /// - times are too far apart to locate its zero;
    /// - states were replaced many times at times that rounding cannot distinguish.
    pub fn next<M>(
        &mut self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        mut values: impl FnMut(S, &M::State) -> [S; K],
    ) -> Result<Option<Occurrence<S, M::State>>, StepFailure<S>>
    where
        M: OdeSystem<Scalar = S> + ?Sized,
    {
        if K == 0 {
            return Ok(None);
        }
        self.check_known()?;
        let (from, to) = (stepper.last_time(), stepper.time());
        if core::mem::take(&mut self.is_replaced) {
            let shortly = shortly(from, to);
            self.learn_shortly(values(shortly, &stepper.interpolate(system, shortly)))?;
            self.check_repetitions()?;
        }
        let (last, is_first) = (self.last, self.repetitions > 0 && self.started == from);
        let found = self.search_step((from, to), &mut |t, is_rounded| {
            let state = stepper.interpolate(system, t);
            values(t, &if is_rounded { rounded(&state) } else { state })
        })?;
        if let Some((event, time)) = found {
            let middle = from + S::from_f64(0.5) * (time - from);
            let state = stepper.interpolate(system, middle);
            let mut value = |state: &M::State| values(middle, state)[event];
            let may_be_noise = is_first && event == last && !self.functions[event].is_kept;
            self.is_noise = may_be_noise && is_rounding(&state, &mut value);
        }
        let Some((event, time)) = found else { return Ok(None) };
        Ok(Some(Occurrence { event, time, state: stepper.interpolate(system, time) }))
    }

    /// Returns the next function that is exactly zero at the end of a run, with this state. It
    /// would have an event there if the run continued. Call it after the last step, when there are
    /// no other events left.
    pub fn next_at_end<Y: Copy>(&mut self, time: S, state: &Y) -> Option<Occurrence<S, Y>> {
        let event = self.functions.iter_mut().position(EventFunction::ends_on_zero)?;
        Some(Occurrence { event, time, state: *state })
    }

    /// Searches this step for the next event; returns its function and time.
    fn search_step(
        &mut self,
        (from, to): (S, S),
        at: &mut EventValues<'_, S, K>,
    ) -> Result<Option<Suspect<S>>, StepFailure<S>> {
        if !self.search.is_of(from, to) {
            self.search = Search::new(from, to);
        }
        let is_past = |t: S, reached: S| if to < from { t >= reached } else { t <= reached };
        while !is_past(to, self.reached) {
            let (start, end) = (self.reached, self.search.end(self.reached));
            let piece = self.sample((start, end), at);
            let is_shortest = self.search.is_shortest();
            if let Some(bad) = piece.values.iter().find(|values| check(**values).is_err())
                && is_shortest
            {
                check(*bad)?;
            }
            let (first, is_noise) = self.earliest(&piece, accuracy(from, to), at)?;
            match first {
                First::Unclear => self.search.shorten(),
                First::Passing(event) => self.functions[event].go_on(),
                First::At(event, time) => {
                    self.measure(&piece, |t| is_past(t, time));
                    let range = self.functions[event].range;
                    if let Some(spacing) = unresolved((from, to), time, range, &mut |t| at(t, false)[event]) {
                        return Err(StepFailure::EventUnresolved { event: Given(event), time, spacing });
                    }
                    // A value at the start is already known: evaluating noise again would yield
                    // another one.
                    let there = if time == start { piece.values[0] } else { at(time, false) };
                    self.search.pause();
                    self.fire(event, time, there)?;
                    return Ok(Some((event, time)));
                }
                First::None => {
                    self.measure(&piece, |_| true);
                    for (k, function) in self.functions.iter_mut().enumerate() {
                        let value = piece.values[POINTS - 1][k];
                        if is_noise[k] { function.ignore(value) } else { function.learn(value) }
                    }
                    self.reached = end;
                    self.search.go_on();
                }
            }
        }
        Ok(None)
    }

    /// Evaluates the functions between two times; at the first they are already known.
    fn sample(&self, (start, end): (S, S), at: &mut EventValues<'_, S, K>) -> Piece<S, K> {
        let mut times = points::<S>().map(|part| start + part * (end - start));
        times[POINTS - 1] = end;
        let here = self.functions.map(|function| function.here);
        let values = core::array::from_fn(|j| if j == 0 { here } else { at(times[j], false) });
        Piece { times, values }
    }

    /// Updates the largest magnitudes of functions in the part of a piece that is passed.
    fn measure(&mut self, piece: &Piece<S, K>, is_passed: impl Fn(S) -> bool) {
        let passed = piece.times.into_iter().zip(&piece.values).filter(|(t, _)| is_passed(*t));
        for (_, values) in passed {
            self.functions.iter_mut().zip(values).for_each(|(function, value)| function.measure(*value));
        }
    }

    /// Records the event of a function at `time`, with these values.
    fn fire(&mut self, event: usize, time: S, values: [S; K]) -> Result<(), StepFailure<S>> {
        check(values)?;
        for (k, (function, value)) in self.functions.iter_mut().zip(values).enumerate() {
            if k == event { function.fire(time, value) } else { function.pass(value) }
        }
        (self.reached, self.last, self.has_fired) = (time, event, true);
        Ok(())
    }

    /// Counts the zeros of these functions, which have these values, as events at the time of the
    /// last one.
    pub(crate) fn fire_together(&mut self, values: &[S; K], is_fired: impl Fn(usize) -> bool) {
        for (k, function) in self.functions.iter_mut().enumerate().filter(|(k, _)| is_fired(*k)) {
            function.fire(self.reached, values[k]);
        }
    }

    /// Returns the next event if it is located at the time of the one just returned. Call it before
    /// the stepper is restarted, or the others are lost.
    ///
    /// # Errors
    /// As [`next`](Self::next).
    pub fn next_at_once<M>(
        &mut self,
        time: S,
        system: &M,
        stepper: &mut impl Stepper<M>,
        values: impl FnMut(S, &M::State) -> [S; K],
    ) -> Result<Option<Occurrence<S, M::State>>, StepFailure<S>>
    where
        M: OdeSystem<Scalar = S> + ?Sized,
    {
        let before = *self;
        let (from, to) = (stepper.last_time(), stepper.time());
        let next = self.next(system, stepper, values)?.filter(|next| is_at_once(time, next.time, from, to));
        if next.is_none() {
            *self = before;
        }
        Ok(next)
    }

    /// Records the signs of these values, computed right after the state was replaced. Switches
    /// wait for a value that exceeds rounding.
    fn learn_shortly(&mut self, values: [S; K]) -> Result<(), StepFailure<S>> {
        check(values)?;
        for (function, value) in self.functions.iter_mut().zip(values) {
            // A function that has jumped across zero since then is found first.
            let has_jumped = function.direction.counts(function.sign, function.here);
            if !function.is_armed() && value != S::ZERO && !has_jumped && !function.is_kept {
                function.sign = value;
                if function.here * value < S::ZERO {
                    // Rounding put its start beyond zero.
                    function.here = value;
                }
            }
        }
        Ok(())
    }

    /// Continues from time `t`, where the method was restarted from another state with these values
    /// of the functions.
    ///
    /// From now on, the signs shortly after `t` count: a ball that bounced off the ground is above
    /// it.
    pub fn restart(&mut self, t: S, values: [S; K]) {
        let distance = (t - self.started).abs();
        let is_at_once = distance <= SAME_EVENT.part::<S>() * t.abs();
        let is_noise = core::mem::take(&mut self.is_noise);
        let is_same = self.repetitions > 0 && (is_at_once || is_noise);
        self.repetitions = if is_same { self.repetitions + 1 } else { 1 };
        self.was_fired = core::mem::take(&mut self.has_fired);
        for (function, value) in self.functions.iter_mut().zip(values) {
            function.begin(t, value);
        }
        (self.reached, self.started, self.is_replaced) = (t, t, true);
        self.search = Search::new(t, t);
    }

    /// Goes on from time `t`, where a clock replaced the state by one in which the functions have
    /// these values. Those that did not change go on as if nothing had happened. A zero at the time
    /// of the tick is therefore an event.
    pub(crate) fn tick(&mut self, t: S, values: [S; K]) {
        let before = *self;
        self.restart(t, values);
        // Ticks do not count as repetitions of events.
        (self.was_fired, self.has_fired) = (before.was_fired, before.has_fired);
        self.repetitions = if before.started == t { before.repetitions } else { 0 };
        for (function, before) in self.functions.iter_mut().zip(before.functions) {
            if function.here == before.here {
                *function = before;
                function.is_kept = true;
            }
        }
    }

    /// Continues from the time reached, where the functions jumped to these values. Zeros crossed
    /// by the jump are events at that time.
    pub(crate) fn jump(&mut self, values: [S; K]) {
        self.functions.iter_mut().zip(values).for_each(|(function, value)| function.pass(value));
    }

    /// Checks the values at the end of the last search.
    fn check_known(&self) -> Result<(), StepFailure<S>> {
        check(self.functions.map(|function| function.here))
    }

    fn check_repetitions(&self) -> Result<(), StepFailure<S>> {
        if self.repetitions < MAX_REPETITIONS || !self.was_fired {
            return Ok(());
        }
        Err(StepFailure::EventsAccumulate { events: self.repetitions, event: Given(self.last) })
    }
}

/// Returns a time right after the start of a step that can be distinguished from it.
fn shortly<S: Scalar>(from: S, to: S) -> S {
    let (way, rounding) = (to - from, SAME_INSTANT.part::<S>() * from.abs());
    let part = (S::from_f64(SHORTLY) * way.abs()).max(rounding);
    if part < way.abs() { from + way.sign() * part } else { to }
}

fn check<S: Scalar, const K: usize>(values: [S; K]) -> Result<(), StepFailure<S>> {
    match values.iter().position(|value| !value.is_finite()) {
        Some(event) => Err(StepFailure::EventNotFinite { event: Given(event) }),
        None => Ok(()),
    }
}
