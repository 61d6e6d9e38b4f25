//! Time in equal steps without accumulation of rounding errors.
//!
//! A time and its remainder are the exact sum of all steps except for the rounding of the
//! remainder. That is at most half the distance between neighbouring times. The state after a step
//! therefore matches the time of its end, to within the spacing of times. Steps shorter than this
//! distance may leave the time unchanged: [`Clock::is_stopped`] detects such steps, and methods
//! reject them.

use super::lane_wise::{is_equal, take};
use crate::scalar::{Number, Scalar, spacing_at_one};
use crate::system::{SideBySide, StepFailure};

/// A time and its rounding remainder.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clock<S> {
    time: S,
    remainder: S,
    step: S,
}

/// Maximum relative extension of a step so that it ends at its limit.
const STRETCH: f64 = 1e-9;

impl<S: Number> Clock<S> {
    /// Starts at `time` with steps of length `step`, negative for backward time.
    pub(super) fn new(time: S, step: S) -> Self {
        Clock { time, remainder: S::ZERO, step }
    }

    /// Returns a clock with the same steps that starts at another time.
    pub(super) fn at(&self, time: S) -> Self {
        Clock::new(time, self.step)
    }

    /// Returns the time and its remainder.
    pub(super) fn parts(&self) -> [S; 2] {
        [self.time, self.remainder]
    }

    /// Continues in equal steps from a time with its remainder.
    pub(super) fn with_parts(&self, [time, remainder]: [S; 2]) -> Self {
        Clock { time, remainder, step: self.step }
    }

    /// Returns a clock with the same time and another step.
    pub(super) fn with_step(&self, step: S) -> Self {
        Clock { step, ..*self }
    }

    /// Returns the present time.
    #[inline]
    pub(super) fn time(&self) -> S {
        self.time
    }

    /// Advances by one step, or to `limit` if it is not farther, to within the spacing of times.
    /// Returns the advance.
    ///
    /// A step ends at the limit if the rest would be less than a rounding error of the limit.
    /// Otherwise its end could be rounded to the limit too early, or the remaining step would
    /// consist of rounding errors.
    #[inline(always)]
    pub(super) fn advance(&mut self, limit: S) -> S {
        let (left, length) = ((limit - self.time) - self.remainder, self.step.abs());
        let epsilon = spacing_at_one::<S>();
        let stretched = length * (S::from_f64(1.0 + STRETCH) + epsilon + epsilon);
        let is_last = left.abs().less_equal(epsilon.multiply_add(limit.abs(), stretched));
        let step = S::select(limit.less(self.time), -length, length);
        let wanted = self.remainder + step;
        let before = self.time;
        let rounded = before + wanted;
        self.time = S::select(is_last, limit, rounded);
        self.remainder = S::select(is_last, S::ZERO, wanted + (before - rounded));
        S::select(is_last, left, step)
    }

    /// Returns the lanes in which steps from this clock to another one did not advance time.
    #[inline(always)]
    pub(super) fn is_stopped(&self, after: &Self) -> S::Mask {
        is_equal(self.time, after.time)
    }

    /// Selects the first clock if the mask is true, otherwise the second.
    #[inline(always)]
    pub(super) fn select(mask: S::Mask, then: &Self, otherwise: &Self) -> Self {
        Clock {
            time: S::select(mask, then.time, otherwise.time),
            remainder: S::select(mask, then.remainder, otherwise.remainder),
            step: S::select(mask, then.step, otherwise.step),
        }
    }
}

/// Returns the length of the shortest steps that advance this time despite rounding, for any
/// remainder.
#[inline(always)]
pub(super) fn least_step<S: Number>(time: S) -> S {
    let epsilon = spacing_at_one::<S>();
    (epsilon + epsilon) * time.abs()
}

/// Checks that steps of length `h` advance the time at both ends of a run, and therefore everywhere
/// in between.
///
/// # Errors
/// If times there are spaced more widely.
pub(super) fn check_step<S: Scalar>(h: S, start: S, end: S) -> Result<(), StepFailure<S>> {
    let lost = [start, end].into_iter().find(|time| is_lost(h, *time));
    lost.map_or(Ok(()), |time| Err(StepFailure::StepLost { step: h, time }))
}

/// True if a step of this length from a time, or to it, is lost in the rounding of that time.
pub(super) fn is_lost<S: Scalar>(h: S, time: S) -> bool {
    time + h == time || time - h == time
}

impl<S: SideBySide> Clock<S> {
    /// Sets the time of a lane, without changing the remainder; used for NaN only.
    #[inline(always)]
    pub(super) fn set_time(&mut self, lane: usize, time: S::Element) {
        self.time.set_lane(lane, time);
    }

    /// Copies the lane `from` of another clock into a lane of this one.
    #[inline(always)]
    pub(super) fn take<O>(&mut self, lane: usize, other: &Clock<O>, from: usize)
    where
        O: SideBySide<Element = S::Element>,
    {
        let mut numbers = [self.time, self.remainder, self.step];
        take(&mut numbers, lane, &[other.time, other.remainder, other.step], from);
        [self.time, self.remainder, self.step] = numbers;
    }
}

#[cfg(test)]
mod tests;
