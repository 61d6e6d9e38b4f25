//! Time in equal steps without accumulation of rounding errors.
//!
//! A time and its remainder are the exact sum of all steps except for the rounding of the
//! remainder. That is at most half the distance between neighbouring times. The state of a step
//! therefore belongs to the time of its end, to within the spacing of times. Steps that are shorter
//! than that distance may leave the time unchanged: [`Clock::is_stopped`] finds such steps, and
//! methods refuse them.

use super::lane_wise::{is_equal, take};
use crate::scalar::{Number, Scalar, spacing_at_one};
use crate::system::{SideBySide, StepFailure};

/// A time and the part of it that rounding cut off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clock<S> {
    time: S,
    remainder: S,
    step: S,
}

/// A step is stretched by up to this part of itself to end at its limit.
const STRETCH: f64 = 1e-9;

impl<S: Number> Clock<S> {
    /// Starts at `time` with steps of the length `step`, negative for backward time.
    pub(super) fn new(time: S, step: S) -> Self {
        Clock { time, remainder: S::ZERO, step }
    }

    /// Starts the same steps at another time.
    pub(super) fn at(&self, time: S) -> Self {
        Clock::new(time, self.step)
    }

    /// The time and its remainder.
    pub(super) fn parts(&self) -> [S; 2] {
        [self.time, self.remainder]
    }

    /// Goes on in equal steps from a time with its remainder.
    pub(super) fn with_parts(&self, [time, remainder]: [S; 2]) -> Self {
        Clock { time, remainder, step: self.step }
    }

    /// Keeps the time and changes the step.
    pub(super) fn with_step(&self, step: S) -> Self {
        Clock { step, ..*self }
    }

    /// The time now.
    #[inline]
    pub(super) fn time(&self) -> S {
        self.time
    }

    /// Goes on by one step, or to `limit` if that is not farther, as well as times are spaced;
    /// returns how far that is.
    ///
    /// If less than a rounding of the limit would remain behind it, a step ends there. Otherwise
    /// its end might be rounded to the limit too early, or a step might remain that is nothing but
    /// rounding.
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

    /// The first clock where the mask is true, the second elsewhere.
    #[inline(always)]
    pub(super) fn select(mask: S::Mask, then: &Self, otherwise: &Self) -> Self {
        Clock {
            time: S::select(mask, then.time, otherwise.time),
            remainder: S::select(mask, then.remainder, otherwise.remainder),
            step: S::select(mask, then.step, otherwise.step),
        }
    }
}

/// The length of the shortest steps that count in the rounding of this time, whatever the remainder
/// is.
#[inline(always)]
pub(super) fn least_step<S: Number>(time: S) -> S {
    let epsilon = spacing_at_one::<S>();
    (epsilon + epsilon) * time.abs()
}

/// Checks that steps of the length `h` lead on from both ends of a run, and so from everywhere in
/// between.
///
/// # Errors
/// If times there are farther apart.
pub(super) fn check_step<S: Scalar>(h: S, start: S, end: S) -> Result<(), StepFailure<S>> {
    let lost = [start, end].into_iter().find(|time| is_lost(h, *time));
    lost.map_or(Ok(()), |time| Err(StepFailure::StepLost { step: h, time }))
}

/// True if a step of this length from a time, or to it, is lost in the rounding of that time.
pub(super) fn is_lost<S: Scalar>(h: S, time: S) -> bool {
    time + h == time || time - h == time
}

impl<S: SideBySide> Clock<S> {
    /// Puts another time into a lane, without a remainder of its own: NaN, that is.
    #[inline(always)]
    pub(super) fn set_time(&mut self, lane: usize, time: S::Element) {
        self.time.set_lane(lane, time);
    }

    /// Puts what is in the lane `from` of another clock into a lane of this one.
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
