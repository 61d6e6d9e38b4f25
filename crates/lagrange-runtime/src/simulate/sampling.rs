//! The sampling times of a run.

use crate::scalar::Scalar;
use crate::system::{StepFailure, Undefined};
use crate::tolerance::SAME_INSTANT;

/// The sampling times of a run, beside its start and its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Sampling<S> {
    /// The end of every step.
    EveryStep,
    /// The start plus multiples of this interval.
    Every(S),
    /// None.
    Ends,
}

/// The times start + k dt, each computed from k, so that rounding errors do not add up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid<S> {
    start: S,
    /// Signed: negative if time runs backwards.
    interval: S,
    end: S,
    index: u64,
}

/// No more samples than this are kept: beyond it a run would fill any memory.
const MOST_SAMPLES: f64 = 1e8;
/// A time this part of the interval away from the end is the end.
const SNAP: f64 = 1e-9;

impl<S: Scalar> Grid<S> {
    pub(crate) fn new(start: S, end: S, interval: S) -> Result<Self, StepFailure<S>> {
        if !(interval > S::ZERO && interval.is_finite()) {
            return Err(StepFailure::Setting("the interval of sampling must be positive and finite"));
        }
        let interval = if end < start { -interval } else { interval };
        if !end.is_finite() {
            return Err(StepFailure::Undefined(Undefined::EndTime { value: end }));
        }
        // Otherwise instants next to each other would be the same, or taken to be.
        let rounding = SAME_INSTANT.times(2).part::<S>() * start.abs().max(end.abs());
        if interval.abs() <= rounding {
            return Err(StepFailure::Setting("the interval of sampling is lost in the rounding of time"));
        }
        Ok(Grid { start, interval, end, index: 1 })
    }

    /// Returns the sampling if its times fit into memory.
    pub(crate) fn that_can_be_kept(self) -> Result<Self, StepFailure<S>> {
        let samples = (self.end - self.start) / self.interval;
        let most = S::from_f64(MOST_SAMPLES);
        if samples.is_finite() && samples <= most {
            return Ok(self);
        }
        Err(StepFailure::TooManySamples { samples, most })
    }

    /// True if time runs backwards.
    #[cfg(feature = "ensemble")]
    pub(crate) fn is_backwards(&self) -> bool {
        self.interval < S::ZERO
    }

    /// The next time, if it comes before the end.
    #[cfg(feature = "ensemble")]
    pub(crate) fn next(&mut self) -> Option<S> {
        self.up_to(self.end)
    }

    /// The next time, if it comes before the end and not after `reached`.
    pub(super) fn up_to(&mut self, reached: S) -> Option<S> {
        let time = self.start + S::from_f64(self.index as f64) * self.interval;
        if self.is_after(time, reached) || self.is_end(time) {
            return None;
        }
        self.index += 1;
        Some(time)
    }

    fn is_after(&self, time: S, other: S) -> bool {
        if self.interval > S::ZERO { time > other } else { time < other }
    }

    /// True if a time is the end or beyond it, but for rounding: closer than a part of the
    /// interval, or its neighbour among the numbers.
    fn is_end(&self, time: S) -> bool {
        let left = self.end - time;
        let middle = time + left / S::from_f64(2.0);
        self.is_after(time, self.end)
            || left.abs() <= self.interval.abs() * S::from_f64(SNAP)
            || middle == time
            || middle == self.end
    }
}
