//! Time in equal steps without accumulation of rounding errors.

use super::lane_wise::take;
use crate::scalar::Number;
use crate::system::SideBySide;

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

    /// The same steps from another time.
    pub(super) fn at(&self, time: S) -> Self {
        Clock::new(time, self.step)
    }

    /// The same time with other steps.
    pub(super) fn with_step(&self, step: S) -> Self {
        Clock { step, ..*self }
    }

    /// The time now.
    #[inline]
    pub(super) fn time(&self) -> S {
        self.time
    }

    /// Goes on by one step, or to `limit` if that is not farther; returns how far that is.
    #[inline(always)]
    pub(super) fn advance(&mut self, limit: S) -> S {
        let left = (limit - self.time) - self.remainder;
        let is_last = left.abs().less_equal(self.step.abs() * S::from_f64(1.0 + STRETCH));
        let step = S::select(left.less(S::ZERO), -self.step.abs(), self.step.abs());
        let wanted = self.remainder + step;
        let before = self.time;
        let rounded = before + wanted;
        // Rounding must not end what has steps to go.
        let is_limit = rounded.less_equal(limit) & limit.less_equal(rounded);
        let time = S::select(is_limit, before, rounded);
        self.time = S::select(is_last, limit, time);
        self.remainder = S::select(is_last, S::ZERO, wanted + (before - time));
        S::select(is_last, left, step)
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
