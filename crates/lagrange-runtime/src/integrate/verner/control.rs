//! The choice of the next step length.
//!
//! A proportional–integral controller: the step depends on the errors of the last two steps, which
//! avoids oscillation. Source: Gustafsson 1991; Hairer, Wanner, *Solving Ordinary Differential
//! Equations II*, §IV.2.

use crate::scalar::Scalar;

/// Power of the step length with which the error of a step grows.
pub(super) const POWER: f64 = 9.0;
/// Weight of the previous error in the choice.
pub(super) const MEMORY: f64 = 0.02;
/// Safety factor of step lengths.
pub(super) const SAFETY: f64 = 0.8;
/// Minimum ratio of a step to the previous one.
pub(super) const MAX_SHRINKING: f64 = 0.2;
/// Maximum ratio of a step after a rejection to the rejected one.
pub(super) const LEAST_SHRINKING: f64 = 0.9;
/// Maximum ratio of a step to the previous one.
pub(super) const MAX_GROWTH: f64 = 6.0;
/// Factor of the next step length after a step that led to NaN or infinity.
pub(super) const RETREAT: f64 = 0.1;

/// Minimum error that is stored.
pub(super) const LEAST_ERROR: f64 = 1e-4;

/// The controller with its memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Control<S> {
    /// Length of the next step to try, always positive.
    pub(super) step: S,
    error: S,
    was_rejected: bool,
}

impl<S: Scalar> Control<S> {
    pub(super) fn new(step: S) -> Self {
        Control { step, error: S::from_f64(LEAST_ERROR), was_rejected: false }
    }

    /// True if the last step was rejected.
    pub(super) fn was_rejected(&self) -> bool {
        self.was_rejected
    }

    /// Accepts a step of length `taken`, which may be shorter than requested, with this error of at
    /// most one.
    pub(super) fn accept(&mut self, taken: S, error: S) {
        let power = S::from_f64(1.0 / POWER - 0.75 * MEMORY);
        let memory = S::from_f64(MEMORY);
        let wanted = S::from_f64(SAFETY) * self.error.powf(memory) / error.powf(power);
        let most = if self.was_rejected { S::ONE } else { S::from_f64(MAX_GROWTH) };
        let growth = if wanted < most { wanted.max(S::from_f64(MAX_SHRINKING)) } else { most };
        let next = taken * growth;
        self.step = if taken < self.step { next.max(self.step) } else { next };
        self.error = error.max(S::from_f64(LEAST_ERROR));
        self.was_rejected = false;
    }

    /// Rejects a step of length `taken` with an error above one, or with an error that is not
    /// finite after NaN or infinity.
    pub(super) fn reject(&mut self, taken: S, error: S) {
        let wanted = S::from_f64(SAFETY) / error.powf(S::from_f64(1.0 / POWER));
        let shrinking = if error.is_finite() {
            wanted.max(S::from_f64(MAX_SHRINKING)).min(S::from_f64(LEAST_SHRINKING))
        } else {
            S::from_f64(RETREAT)
        };
        self.step = taken * shrinking;
        self.was_rejected = true;
    }
}
