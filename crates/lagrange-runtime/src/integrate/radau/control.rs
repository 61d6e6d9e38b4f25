//! The choice of the next step length.
//!
//! The step depends on the errors of the last two steps and on Newton's iterations: a large number
//! of them requires a shorter step. Source: Hairer, Wanner, *Solving Ordinary Differential
//! Equations II*, §IV.8, "Step size selection".

use super::newton::MAX_ITERATIONS;
use crate::scalar::Scalar;

/// Power of the step length with which the error estimate of a step grows.
pub(super) const POWER: f64 = 4.0;
/// Safety factor of step lengths.
const SAFETY: f64 = 0.9;
/// Minimum ratio of a step to the previous one.
const MAX_SHRINKING: f64 = 0.2;
/// Maximum ratio of a step to the previous one.
const MAX_GROWTH: f64 = 10.0;
/// Minimum growth of a step; for less, the length is kept so that the factors can be reused.
const WORTHWHILE: f64 = 1.2;
/// Factor of the step length if Newton's method does not converge.
const RETREAT: f64 = 0.5;
/// Minimum error that is stored.
const LEAST_ERROR: f64 = 1e-2;

/// The controller with its memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReuseControl<S> {
    /// Length of the next step to try, always positive.
    pub(super) step: S,
    /// Length and error of the last accepted step.
    last: Option<(S, S)>,
    was_rejected: bool,
}

impl<S: Scalar> ReuseControl<S> {
    pub(super) fn new(step: S) -> Self {
        ReuseControl { step, last: None, was_rejected: false }
    }

    /// True if the last step was rejected.
    pub(super) fn was_rejected(&self) -> bool {
        self.was_rejected
    }

    /// True if an error above one is doubtful: the error of a first step, or of a step after a
    /// rejection.
    pub(super) fn doubts(&self) -> bool {
        self.was_rejected || self.last.is_none()
    }

    /// Accepts a step of length `taken`, which may be shorter than requested, with this error of at
    /// most one.
    pub(super) fn accept(&mut self, taken: S, error: S, iterations: u32) {
        let mut wanted = wanted(error, iterations);
        if let Some((before, error_before)) = self.last {
            let trend = taken / before * fourth_root(error_before / error);
            wanted = if trend < S::ONE { wanted * trend } else { wanted };
        }
        let most = if self.was_rejected { S::ONE } else { S::from_f64(MAX_GROWTH) };
        let growth = if wanted < most { wanted.max(S::from_f64(MAX_SHRINKING)) } else { most };
        let is_kept = S::ONE <= growth && growth < S::from_f64(WORTHWHILE);
        let next = if is_kept { taken } else { taken * growth };
        self.step = if taken < self.step { next.max(self.step) } else { next };
        self.last = Some((taken, error.max(S::from_f64(LEAST_ERROR))));
        self.was_rejected = false;
    }

    /// Rejects a step of length `taken` with an error above one.
    pub(super) fn reject(&mut self, taken: S, error: S, iterations: u32) {
        let wanted = wanted(error, iterations);
        let shrinking =
            if error.is_finite() { wanted.max(S::from_f64(MAX_SHRINKING)) } else { S::from_f64(RETREAT) };
        self.step = taken * shrinking;
        self.was_rejected = true;
    }

    /// Retreats from a step of length `taken` that could not be computed.
    pub(super) fn retreat(&mut self, taken: S) {
        self.step = taken * S::from_f64(RETREAT);
        self.was_rejected = true;
    }
}

/// Returns the factor at which a step with this error would just meet the tolerance.
fn wanted<S: Scalar>(error: S, iterations: u32) -> S {
    let most = f64::from(MAX_ITERATIONS);
    let safety = SAFETY * (2.0 * most + 1.0) / (2.0 * most + f64::from(iterations));
    S::from_f64(safety) / fourth_root(error)
}

/// Computes the inverse of the power [`POWER`].
fn fourth_root<S: Scalar>(x: S) -> S {
    x.sqrt().sqrt()
}
