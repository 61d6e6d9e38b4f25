//! Limits of coordinates.

use crate::scalar::Scalar;

/// Limits of a coordinate.
#[derive(Clone, Copy)]
pub(super) struct Limit<S> {
    pub(super) name: &'static str,
    /// Its index among the positions.
    pub(super) position: usize,
    pub(super) lower: S,
    pub(super) upper: S,
}

impl<S: Scalar> Limit<S> {
    /// Returns the value between the limits that is nearest to this one.
    pub(super) fn nearest(&self, value: S) -> S {
        value.max(self.lower).min(self.upper)
    }

    /// True if this value is at a limit and pushed against it.
    pub(super) fn holds(&self, value: S, push: S) -> bool {
        value <= self.lower && push <= S::ZERO || value >= self.upper && push >= S::ZERO
    }

    /// True if this value is at a limit.
    pub(super) fn is_at(&self, value: S) -> bool {
        value == self.lower || value == self.upper
    }
}
