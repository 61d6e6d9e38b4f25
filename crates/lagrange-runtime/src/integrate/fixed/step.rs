//! Steps as formulas see them.

use crate::integrate::interpolation::Place;
use crate::system::OdeSystem;

/// A step for a formula to compute.
#[derive(Debug)]
pub struct Step<'a, M: OdeSystem + ?Sized> {
    /// The system that moves.
    pub system: &'a M,
    /// The time at which the step begins.
    pub t: M::Scalar,
    /// The variables of the formula at this time, which are often the state.
    pub y: &'a M::State,
    /// The length of the step, negative backwards in time.
    pub h: M::Scalar,
}

/// A time within an accepted step.
#[derive(Debug)]
pub struct WithinStep<'a, M: OdeSystem + ?Sized> {
    /// The system that moves.
    pub system: &'a M,
    /// The time and the state at the start of the step.
    pub from: (M::Scalar, &'a M::State),
    /// The time and the state at its end.
    pub to: (M::Scalar, &'a M::State),
    /// The time between them.
    pub t: M::Scalar,
}

impl<M: OdeSystem + ?Sized> WithinStep<'_, M> {
    /// Returns the states at both ends.
    pub fn states(&self) -> [&M::State; 2] {
        [self.from.1, self.to.1]
    }

    /// Returns the fraction of the step that has passed.
    pub fn fraction(&self) -> M::Scalar {
        self.place().s
    }

    /// Returns the length of the step, and the fraction of it that has passed.
    pub(in crate::integrate) fn place(&self) -> Place<M::Scalar> {
        let h = self.to.0 - self.from.0;
        Place { h, s: (self.t - self.from.0) / h }
    }

    /// Computes the rates at both ends.
    pub(in crate::integrate) fn rates(&self) -> [M::State; 2] {
        [self.from, self.to].map(|(t, y)| self.system.rhs(t, y))
    }
}
