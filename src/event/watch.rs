//! Looking for zeros within steps.

use super::declared::DeclaredEvent;
use super::direction::Direction;
use super::locate::{ACCURACY, MOST_ROUNDS, Sample, locate};
use crate::integrate::{Cause, Stepper};
use crate::scalar::Scalar;
use crate::system::OdeSystem;

/// Into how many parts a step is cut in search of changes of sign.
const PARTS: u32 = 8;
/// The part of a step after which the state has left what it was replaced by.
const SHORTLY: f64 = 1e-10;
/// A step is halved so often in search of a hop that is shorter.
const MOST_HALVINGS: u32 = 60;
/// Times that differ by fewer roundings than this are taken for the same,
const ROUNDINGS: f64 = 64.0;
/// and so many events at the same time for infinitely many.
const MOST_REPETITIONS: u32 = 50;

/// An event that happened.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Occurrence<S, Y> {
    /// Which of the functions passed zero, counted from zero.
    pub event: usize,
    /// When.
    pub time: S,
    /// The state then.
    pub state: Y,
}

/// What is remembered of one function.
#[derive(Clone, Copy, Debug)]
struct Detector<S> {
    direction: Direction,
    /// Whether the function counts as positive from where it was started or restarted: that of a contact or friction.
    is_switch: bool,
    /// The last value that was not zero; zero if there was none.
    value: S,
    /// Whether the function counts as positive without having been found so since the last start.
    is_armed: bool,
}

impl<S: Scalar> Detector<S> {
    /// Remembers the value at a start.
    fn begin(&mut self, value: S) {
        self.is_armed = self.is_switch && value.is_finite();
        self.value = if self.is_armed { S::ONE } else { value };
    }

    /// Remembers the sign of a value; zero has none.
    fn learn(&mut self, value: S) {
        if value != S::ZERO {
            (self.value, self.is_armed) = (value, false);
        }
    }
}

/// Memory of K functions from step to step.
#[derive(Clone, Copy, Debug)]
pub struct Watch<S, const K: usize> {
    detectors: [Detector<S>; K],
    /// Up to where the last step was looked at.
    reached: S,
    /// Where the functions were started, or last restarted.
    started: S,
    /// Whether the state was replaced there.
    is_replaced: bool,
    /// How often it was, each time no later than rounding can tell.
    repetitions: u32,
}

impl<S: Scalar, const K: usize> Watch<S, K> {
    /// Starts at time `t`, where the functions have these values.
    pub fn new(directions: [Direction; K], t: S, values: [S; K]) -> Self {
        let mut detectors = directions.map(|direction| Detector {
            direction,
            is_switch: false,
            value: S::ZERO,
            is_armed: false,
        });
        for (detector, value) in detectors.iter_mut().zip(values) {
            detector.value = value;
        }
        Watch { detectors, reached: t, started: t, is_replaced: false, repetitions: 0 }
    }

    /// The same with functions that [switch](crate::event::DeclaredEvent::is_switch) the first modes of a system.
    pub(crate) fn with_switches(mut self, declared: &[DeclaredEvent]) -> Self {
        for (detector, event) in self.detectors.iter_mut().zip(declared) {
            detector.is_switch = event.is_switch;
            detector.begin(detector.value);
        }
        self
    }

    /// The next event in the stepper's last step, after those that were returned before.
    ///
    /// To be called after each step until there is no more; `values` gives all functions at a time and state. The time
    /// returned is at most 10⁻¹³ of the step, or one unit in the last place of time, beyond the change of sign, and the
    /// value there is zero or has the sign that it changes to.
    ///
    /// # Errors
    /// If a function is NaN or infinite, or does not settle in 200 evaluations, or if states were replaced many times at
    /// times that rounding cannot tell apart.
    pub fn next<M>(
        &mut self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        mut values: impl FnMut(S, &M::State) -> [S; K],
    ) -> Result<Option<Occurrence<S, M::State>>, Cause<S>>
    where
        M: OdeSystem<Scalar = S> + ?Sized,
    {
        if K == 0 {
            return Ok(None);
        }
        check(self.detectors.map(|detector| detector.value))?;
        let (from, to) = (stepper.last_time(), stepper.time());
        if core::mem::take(&mut self.is_replaced) {
            let shortly = from + S::from_f64(SHORTLY) * (to - from);
            self.learn_shortly(values(shortly, &stepper.interpolate(system, shortly)))?;
            self.check_repetitions()?;
        }
        let is_past = |t: S, reached: S| if to < from { t >= reached } else { t <= reached };
        for part in 1..=PARTS {
            let s = S::from_f64(f64::from(part) / f64::from(PARTS));
            let t = if part == PARTS { to } else { from + (to - from) * s };
            if is_past(t, self.reached) {
                continue;
            }
            let found = values(t, &stepper.interpolate(system, t));
            check(found)?;
            let earliest =
                self.earliest(t, found, accuracy(from, to), |t| values(t, &stepper.interpolate(system, t)))?;
            if let Some(first) = earliest {
                // What has changed its sign twice by then shows at the zeros between.
                let values = |t| values(t, &stepper.interpolate(system, t));
                let (event, time, after) = self.first_of_all((first, found), accuracy(from, to), values)?;
                self.detectors[event].learn(after);
                self.reached = time;
                return Ok(Some(Occurrence { event, time, state: stepper.interpolate(system, time) }));
            }
            self.learn(found)?;
            self.reached = t;
        }
        Ok(None)
    }

    /// The next event, if it happens at the same time as one that was just returned, as far as times are located: to be
    /// asked before the stepper is restarted, or the others are lost.
    ///
    /// # Errors
    /// As [`next`](Self::next).
    pub fn next_at_once<M>(
        &mut self,
        time: S,
        system: &M,
        stepper: &mut impl Stepper<M>,
        values: impl FnMut(S, &M::State) -> [S; K],
    ) -> Result<Option<Occurrence<S, M::State>>, Cause<S>>
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

    /// The earliest zero between where the search has got and `t`, where the functions have these values.
    fn earliest(
        &self,
        t: S,
        found: [S; K],
        accuracy: S,
        mut values: impl FnMut(S) -> [S; K],
    ) -> Result<Option<(usize, S)>, Cause<S>> {
        let mut earliest: Option<(usize, S)> = None;
        for (event, detector) in self.detectors.iter().enumerate() {
            if !detector.direction.counts(detector.value, found[event]) {
                continue;
            }
            let end = (t, found[event]);
            let bracket = match detector.is_armed {
                true => self.hop(end, |t| values(t)[event]),
                false => Some(((self.reached, detector.value), end)),
            };
            let time = bracket
                .and_then(|(before, after)| locate(before, after, accuracy, |t| values(t)[event]))
                .ok_or(Cause::EventNotLocated { event, bisections: MOST_ROUNDS })?;
            let is_earlier =
                earliest.is_none_or(|(_, other)| (time - self.reached).abs() < (other - self.reached).abs());
            if is_earlier {
                earliest = Some((event, time));
            }
        }
        Ok(earliest)
    }

    /// The earliest zero, and the value after it, from one that is before `t`, where the functions have the values `found`.
    fn first_of_all(
        &self,
        ((mut event, mut time), mut found): ((usize, S), [S; K]),
        accuracy: S,
        mut values: impl FnMut(S) -> [S; K],
    ) -> Result<(usize, S, S), Cause<S>> {
        for _ in 0..K {
            let at_zero = values(time);
            let other = self.earliest(time, at_zero, accuracy, &mut values)?;
            let Some(other) = other.filter(|(_, other)| (time - *other).abs() > accuracy + accuracy) else {
                break;
            };
            ((event, time), found) = (other, at_zero);
        }
        Ok((event, time, found[event]))
    }

    /// Remembers the signs of these values.
    fn learn(&mut self, values: [S; K]) -> Result<(), Cause<S>> {
        check(values)?;
        for (detector, value) in self.detectors.iter_mut().zip(values) {
            detector.learn(value);
        }
        Ok(())
    }

    /// Remembers the signs of these values, found right after the state was replaced. Switches wait for a value that is not
    /// rounding.
    fn learn_shortly(&mut self, values: [S; K]) -> Result<(), Cause<S>> {
        check(values)?;
        for (detector, value) in self.detectors.iter_mut().zip(values) {
            if !detector.is_armed {
                detector.learn(value);
            }
        }
        Ok(())
    }

    /// Between the start and `t`, where a function that counted as positive at the start is not: the latest place at which it was
    /// found positive and the place after it, halving the time from the start. If it never was, it passed zero at the start.
    fn hop(
        &self,
        (mut t, mut found): Sample<S>,
        mut value: impl FnMut(S) -> S,
    ) -> Option<(Sample<S>, Sample<S>)> {
        for _ in 0..MOST_HALVINGS {
            let middle = self.started + S::from_f64(0.5) * (t - self.started);
            if middle == self.started || middle == t {
                break;
            }
            let at = value(middle);
            if at > S::ZERO {
                return Some(((middle, at), (t, found)));
            }
            (t, found) = (middle, at);
        }
        found.is_finite().then_some(((t, S::ONE), (t, found)))
    }

    /// Goes on from time `t`, where the method was restarted from another state in which the functions have these values.
    ///
    /// The signs that count from now on are those shortly after: a ball that was turned round on the ground is above it.
    pub fn restart(&mut self, t: S, values: [S; K]) {
        let distance = (t - self.started).abs();
        let is_same = self.repetitions > 0 && distance <= S::from_f64(ROUNDINGS) * S::epsilon() * t.abs();
        self.repetitions = if is_same { self.repetitions + 1 } else { 1 };
        for (detector, value) in self.detectors.iter_mut().zip(values) {
            detector.begin(value);
        }
        (self.reached, self.started, self.is_replaced) = (t, t, true);
    }

    fn check_repetitions(&self) -> Result<(), Cause<S>> {
        if self.repetitions < MOST_REPETITIONS {
            return Ok(());
        }
        Err(Cause::EventsAccumulate { events: self.repetitions })
    }
}

/// To which part of a step, or of time, zeros within it are located.
fn accuracy<S: Scalar>(from: S, to: S) -> S {
    S::from_f64(ACCURACY) * (to - from).abs()
}

/// Whether two times in a step cannot be told apart.
pub(crate) fn is_at_once<S: Scalar>(one: S, other: S, from: S, to: S) -> bool {
    let rounding = S::from_f64(4.0) * S::epsilon() * one.abs();
    (one - other).abs() <= accuracy(from, to) + accuracy(from, to) + rounding
}

fn check<S: Scalar, const K: usize>(values: [S; K]) -> Result<(), Cause<S>> {
    match values.iter().position(|value| !value.is_finite()) {
        Some(event) => Err(Cause::EventNotFinite { event }),
        None => Ok(()),
    }
}
