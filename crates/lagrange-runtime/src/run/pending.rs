//! Pending events: the next event of several functions, kept until its turn comes.

use super::events::Replacement;
use crate::event::{Detector, Occurrence};
use crate::integrate::Stepper;
use crate::scalar::Scalar;
use crate::system::{OdeSystem, StepFailure};

/// A detector, and the next event that it found.
#[derive(Clone, Copy, Debug)]
pub struct Pending<S, Y, const K: usize> {
    detector: Detector<S, K>,
    pub(super) next: Option<Occurrence<S, Y>>,
}

impl<S: Scalar, Y: Copy, const K: usize> Pending<S, Y, K> {
    /// Creates a queue without events.
    pub fn new(detector: Detector<S, K>) -> Self {
        Pending { detector, next: None }
    }

    /// Returns the time of the next event in the last step of a run to `end`.
    ///
    /// # Errors
    /// As [`Detector::next`].
    pub fn look<M>(
        &mut self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        end: S,
        values: impl FnMut(S, &Y) -> [S; K],
    ) -> Result<Option<S>, StepFailure<S>>
    where
        M: OdeSystem<Scalar = S, State = Y>,
    {
        if self.next.is_none() {
            self.next = self.detector.next(system, stepper, values)?;
        }
        if self.next.is_none() && stepper.time() == end {
            self.next = self.detector.next_at_end(end, stepper.state());
        }
        Ok(self.time())
    }

    /// Returns the largest magnitude observed for each function.
    pub fn ranges(&self) -> [S; K] {
        self.detector.ranges()
    }

    /// Counts the zeros of these functions, which have these values, as parts of the event found.
    pub fn fire_together(&mut self, values: &[S; K], is_fired: &[bool; K]) {
        self.detector.fire_together(values, |k| is_fired[k]);
    }

    /// Returns the time of the event found.
    pub fn time(&self) -> Option<S> {
        self.next.as_ref().map(|next| next.time)
    }

    /// Removes and returns the event found.
    pub fn take(&mut self) -> Option<Occurrence<S, Y>> {
        self.next.take()
    }

    /// Continues from another state, in which the functions have these values.
    pub fn restart(&mut self, t: S, values: [S; K], by: Replacement) {
        self.next = None;
        match by {
            Replacement::Event => self.detector.restart(t, values),
            Replacement::Clock => self.detector.tick(t, values),
        }
    }

    /// Continues after the functions jumped to these values.
    pub fn jump(&mut self, values: [S; K]) {
        self.detector.jump(values);
    }
}
