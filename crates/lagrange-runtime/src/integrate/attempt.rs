//! Attempts at a step of an adaptive method.

use crate::constraint::UNDETERMINED;
use crate::integrate::clock::{Clock, least_step};
use crate::scalar::Scalar;
use crate::system::StepFailure;

/// Implements [`Method`](super::Method) for settings with a field `longest_step`, except for the
/// order and the check. The arguments are the name of the method and its stepper.
macro_rules! adaptive_steps {
    ($name:expr, $Stepper:ident) => {
        type Stepper = $Stepper<M>;

        fn name(&self) -> &'static str {
            $name
        }

        fn start(
            &self,
            system: &M,
            t: M::Scalar,
            y: &M::State,
            end: M::Scalar,
        ) -> Result<Self::Stepper, $crate::system::StepFailure<M::Scalar>> {
            $crate::integrate::Method::<M>::check(self)?;
            $Stepper::start(*self, system, t, y, end)
        }

        fn with_longest_step(
            self,
            longest: M::Scalar,
        ) -> Result<Self, $crate::system::SettingError<M::Scalar>> {
            Ok(Self { longest_step: Some(longest), ..self })
        }
    };
}
pub(super) use adaptive_steps;

/// The length of a step and the clock after it.
#[derive(Clone, Copy)]
pub(super) struct Attempt<S> {
    pub(super) h: S,
    pub(super) clock: Clock<S>,
}

impl<S: Scalar> Attempt<S> {
    /// Creates a step of this length towards `limit`; an error if it is lost in rounding. Steps
    /// shorter than the least step at this time are only used to reach the limit.
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

/// Returns the least step instead of a shorter one, unless the latter follows a rejection or the
/// least step exceeds the maximum.
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
    /// It could not be computed, or it led to a state where the system is undefined or constraints
    /// cannot be satisfied.
    Lost(StepFailure<S>),
}

/// Number of consecutive negligible steps after which nearly dependent constraints count as
/// blocking the motion.
const MAX_CRAWLING: u32 = 1000;

/// Monitors steps below ε^(3/4) of the elapsed time under constraints. No motion is that fast:
/// noise causes such steps, magnified by nearly dependent constraints.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crawling<S> {
    start: S,
    /// Number of consecutive steps that are negligible relative to the elapsed time.
    steps: u32,
}

impl<S: Scalar> Crawling<S> {
    /// Starts at this time.
    pub(super) fn new(start: S) -> Self {
        Crawling { start, steps: 0 }
    }

    /// Counts a step of length `h` that ends at this time.
    #[inline]
    pub(super) fn look(&mut self, h: S, time: S, is_constrained: bool) {
        let root = S::epsilon().sqrt();
        let passed = (time - self.start).abs();
        let is_crawling = is_constrained && h.abs() < root * root.sqrt() * passed;
        self.steps = if is_crawling { self.steps + 1 } else { 0 };
    }

    /// Checks that the motion makes progress.
    ///
    /// # Errors
    /// If it does not.
    #[inline]
    pub(super) fn check(&self) -> Result<(), StepFailure<S>> {
        if self.steps < MAX_CRAWLING { Ok(()) } else { Err(StepFailure::Stuck(UNDETERMINED)) }
    }
}
