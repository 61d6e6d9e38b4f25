//! The sampling times of a run.

use crate::scalar::Scalar;
use crate::system::SettingError;
use crate::tolerance::SAME_INSTANT;

/// The sampling times of a run, in addition to its start and its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Sampling<S> {
    /// The end of every step.
    EveryStep,
    /// The start plus multiples of this interval.
    Every(S),
    /// Times specified one by one.
    Times,
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

/// Maximum number of samples; more would exhaust memory.
const MAX_SAMPLES: f64 = 1e8;
/// A time within this fraction of the interval from the end counts as the end.
const SNAP: f64 = 1e-9;

impl<S: Scalar> Grid<S> {
    /// Returns the times of a run over this span.
    ///
    /// # Errors
    /// If the interval is invalid. Methods report a span that is not finite.
    pub(crate) fn new([start, end]: [S; 2], interval: S) -> Result<Self, SettingError<S>> {
        if !(interval > S::ZERO && interval.is_finite()) {
            return Err(SettingError::Invalid("the sampling interval must be positive and finite"));
        }
        // Otherwise neighbouring instants would be equal, or be treated as equal.
        let rounding = SAME_INSTANT.times(2).part::<S>() * start.abs().max(end.abs());
        if rounding.is_finite() && interval <= rounding {
            return Err(SettingError::Invalid(
                "the sampling interval is below the rounding error of the time",
            ));
        }
        Ok(Grid { start, interval: if end < start { -interval } else { interval }, end, index: 1 })
    }

    /// Returns these times if their number is not too large.
    ///
    /// # Errors
    /// If there are too many samples.
    pub(crate) fn checked(self) -> Result<Self, SettingError<S>> {
        let samples = (self.end - self.start) / self.interval;
        let most = S::from_f64(MAX_SAMPLES);
        let is_finite = self.start.is_finite() && self.end.is_finite();
        if !is_finite || samples <= most {
            return Ok(self);
        }
        Err(SettingError::TooManySamples { samples, most })
    }

    /// True if time runs backwards.
    #[cfg(feature = "ensemble")]
    pub(crate) fn is_backwards(&self) -> bool {
        self.interval < S::ZERO
    }

    /// Returns the next time, if it comes before the end.
    #[cfg(feature = "ensemble")]
    pub(crate) fn next(&mut self) -> Option<S> {
        self.up_to(self.end)
    }

    /// Returns the next time, if it comes before the end and not after `reached`.
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

    /// True if a time is the end or beyond it, up to rounding: within a small fraction of the
    /// interval, or the neighbouring number.
    fn is_end(&self, time: S) -> bool {
        let left = self.end - time;
        let middle = time + left / S::from_f64(2.0);
        self.is_after(time, self.end)
            || left.abs() <= self.interval.abs() * S::from_f64(SNAP)
            || middle == time
            || middle == self.end
    }
}
