//! Attempts at a step of an adaptive method.

use crate::constraint::UNDETERMINED;
use crate::integrate::clock::{Clock, least_step};
use crate::scalar::Scalar;
use crate::system::StepFailure;

/// The length of a step and the clock after it.
#[derive(Clone, Copy)]
pub(super) struct Attempt<S> {
    pub(super) h: S,
    pub(super) clock: Clock<S>,
}

impl<S: Scalar> Attempt<S> {
    /// A step of this length towards `limit`, or that it is lost in rounding. Only a step that
    /// reaches the limit is shorter than the least that counts in the rounding of time.
    #[inline]
    pub(super) fn new(
        clock: &Clock<S>,
        mut length: S,
        limit: S,
        longest: Option<S>,
        was_rejected: bool,
    ) -> Result<Self, StepFailure<S>> {
        let least = least_step(clock.time());
        if length < least {
            length = raised(length, least, clock.time(), longest, was_rejected)?;
        }
        let mut after = clock.with_step(length);
        let h = after.advance(limit);
        let is_step = length > S::ZERO;
        if !is_step || clock.is_stopped(&after) {
            return Err(StepFailure::StepUnderflow { step: length });
        }
        Ok(Attempt { h, clock: after })
    }
}

/// The least step instead of a shorter one, unless it was thrown away or is longer than may be.
#[cold]
fn raised<S: Scalar>(
    length: S,
    least: S,
    time: S,
    longest: Option<S>,
    was_rejected: bool,
) -> Result<S, StepFailure<S>> {
    match longest.filter(|longest| *longest < least) {
        Some(step) => Err(StepFailure::StepLost { step, time }),
        None if was_rejected => Err(StepFailure::StepUnderflow { step: length }),
        None => Ok(least),
    }
}

/// The judgement of an attempt.
pub(super) enum Judgement<S> {
    /// The step was taken.
    Taken,
    /// Its error was too large.
    Inaccurate,
    /// It could not be computed, or led where the system is not defined, or where constraints
    /// cannot be satisfied.
    Lost(StepFailure<S>),
}

/// Number of consecutive negligible steps after which constraints that are about to become
/// dependent count as blocking the motion.
const MOST_CRAWLING: u32 = 1000;

/// Watches for steps below ε^(3/4) of the time that has passed under constraints. Nothing moves
/// that fast; what asks for such steps is noise, which constraints magnify where they are about to
/// depend on each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crawling<S> {
    start: S,
    /// Number of consecutive steps that are negligible beside the time.
    steps: u32,
}

impl<S: Scalar> Crawling<S> {
    /// Starts at this time.
    pub(super) fn new(start: S) -> Self {
        Crawling { start, steps: 0 }
    }

    /// Counts a step of the length `h` to this time.
    #[inline]
    pub(super) fn look(&mut self, h: S, time: S, is_constrained: bool) {
        let root = S::epsilon().sqrt();
        let passed = (time - self.start).abs();
        let is_crawling = is_constrained && h.abs() < root * root.sqrt() * passed;
        self.steps = if is_crawling { self.steps + 1 } else { 0 };
    }

    /// Checks that the motion goes on.
    ///
    /// # Errors
    /// If it does not.
    #[inline]
    pub(super) fn check(&self) -> Result<(), StepFailure<S>> {
        if self.steps < MOST_CRAWLING { Ok(()) } else { Err(StepFailure::Stuck(UNDETERMINED)) }
    }
}
