//! Looking for zeros within steps.

use super::direction::Direction;
use super::locate::{ACCURACY, MOST_ROUNDS, locate};
use crate::integrate::{Cause, Stepper};
use crate::scalar::Scalar;
use crate::system::OdeSystem;

/// Into how many parts a step is cut in search of changes of sign.
const PARTS: u32 = 8;

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
    /// The last value that was not zero; zero if there was none.
    value: S,
}

/// Memory of K functions from step to step.
#[derive(Clone, Copy, Debug)]
pub struct Watch<S, const K: usize> {
    detectors: [Detector<S>; K],
    /// Up to where the last step was looked at.
    reached: S,
}

impl<S: Scalar, const K: usize> Watch<S, K> {
    /// Starts at time `t`, where the functions have these values.
    pub fn new(directions: [Direction; K], t: S, values: [S; K]) -> Self {
        let mut detectors = directions.map(|direction| Detector { direction, value: S::ZERO });
        for (detector, value) in detectors.iter_mut().zip(values) {
            detector.value = value;
        }
        Watch { detectors, reached: t }
    }

    /// The next event in the stepper's last step, after those that were returned before.
    ///
    /// To be called after each step until there is no more; `values` gives all functions at a time and state. The time
    /// returned is at most 10⁻¹³ of the step, or one unit in the last place of time, beyond the change of sign, and the
    /// value there is zero or has the sign that it changes to.
    ///
    /// # Errors
    /// If a function is NaN, or does not settle in 200 evaluations.
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
        let (from, to) = (stepper.last_time(), stepper.time());
        let is_past = |t: S, reached: S| if to < from { t >= reached } else { t <= reached };
        let accuracy = S::from_f64(ACCURACY) * (to - from).abs();
        for part in 1..=PARTS {
            let t = if part == PARTS {
                to
            } else {
                from + (to - from) * S::from_f64(f64::from(part) / f64::from(PARTS))
            };
            if is_past(t, self.reached) {
                continue;
            }
            let found = values(t, &stepper.interpolate(system, t));
            if let Some(event) = found.iter().position(|value| !(value.is_finite())) {
                return Err(Cause::EventNotFinite { event });
            }
            let earliest =
                self.earliest(t, found, accuracy, |t| values(t, &stepper.interpolate(system, t)))?;
            if let Some((event, time)) = earliest {
                self.detectors[event].value = found[event];
                self.reached = time;
                return Ok(Some(Occurrence { event, time, state: stepper.interpolate(system, time) }));
            }
            for (detector, value) in self.detectors.iter_mut().zip(found) {
                detector.value = if value == S::ZERO { detector.value } else { value };
            }
            self.reached = t;
        }
        Ok(None)
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
            let bracket = ((self.reached, detector.value), (t, found[event]));
            let time = locate(bracket.0, bracket.1, accuracy, |t| values(t)[event])
                .ok_or(Cause::EventNotLocated { event, bisections: MOST_ROUNDS })?;
            let is_earlier =
                earliest.is_none_or(|(_, other)| (time - self.reached).abs() < (other - self.reached).abs());
            if is_earlier {
                earliest = Some((event, time));
            }
        }
        Ok(earliest)
    }

    /// Goes on from time `t`, where the method was restarted from another state.
    ///
    /// A function is taken to have the sign it has now, unless it is zero.
    pub fn restart(&mut self, t: S, values: [S; K]) {
        for (detector, value) in self.detectors.iter_mut().zip(values) {
            detector.value = if value == S::ZERO { detector.value } else { value };
        }
        self.reached = t;
    }
}
