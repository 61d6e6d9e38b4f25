//! Time in equal steps without accumulation of rounding errors.

use crate::scalar::Scalar;

/// A time and the part of it that rounding cut off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clock<S> {
    time: S,
    remainder: S,
    step: S,
}

/// A step is stretched by up to this part of itself to end at its limit.
const STRETCH: f64 = 1e-9;

impl<S: Scalar> Clock<S> {
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
    #[inline]
    pub(super) fn advance(&mut self, limit: S) -> S {
        let left = (limit - self.time) - self.remainder;
        if left.abs() <= self.step.abs() * S::from_f64(1.0 + STRETCH) {
            self.time = limit;
            self.remainder = S::ZERO;
            return left;
        }
        let step = if left < S::ZERO { -self.step.abs() } else { self.step.abs() };
        let wanted = self.remainder + step;
        let before = self.time;
        let rounded = before + wanted;
        // Rounding must not end what has steps to go.
        self.time = if rounded == limit { before } else { rounded };
        self.remainder = wanted + (before - self.time);
        step
    }
}
