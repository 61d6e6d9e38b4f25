//! The choice of the next step length per lane: the controller of `control` in logarithms, with
//! powers computed to three digits.

use super::control::{LEAST_SHRINKING, MAX_GROWTH, MAX_SHRINKING, MEMORY, POWER, RETREAT};
use crate::integrate::corrected::is_finite;
use crate::integrate::lane_wise::{larger, smaller, take};
use crate::scalar::Scalar;
use crate::system::SideBySide;

/// Errors below this permit the maximum growth of steps.
const NEGLIGIBLE: f64 = 1e-10;
/// The binary logarithm of `LEAST_ERROR` of `control`, which constant expressions cannot compute.
const LOG_LEAST_ERROR: f64 = -13.287_712_379_549_449;
/// The binary logarithm of `SAFETY`.
const LOG_SAFETY: f64 = -0.321_928_094_887_362_3;

/// The controllers with their memories.
#[derive(Clone, Copy, Debug)]
pub(super) struct LanesControl<S> {
    /// Lengths of the next steps to try, always positive.
    pub(super) step: S,
    /// The binary logarithm of the last error.
    error: S,
    /// Maximum growth of the next step.
    most_growth: S,
}

impl<S> LanesControl<S>
where
    S: SideBySide<Element: Scalar>,
{
    #[inline(always)]
    pub(super) fn new(step: S) -> Self {
        let error = S::from_f64(LOG_LEAST_ERROR);
        LanesControl { step, error, most_growth: S::from_f64(MAX_GROWTH) }
    }

    /// Updates after steps of these lengths, which may be shorter than requested, with these
    /// errors. They were accepted if the mask is true. Errors that are not finite belong to steps
    /// that led to NaN or infinity.
    #[inline(always)]
    pub(super) fn follow(&mut self, length: S, error: S, is_taken: S::Mask) {
        let safety = S::from_f64(LOG_SAFETY);
        let log_error = larger(error, S::from_f64(NEGLIGIBLE)).each(Scalar::rough_log2);
        let power = S::from_f64(-(1.0 / POWER - 0.75 * MEMORY));
        let log_wanted = safety + S::from_f64(MEMORY) * self.error + power * log_error;
        let wanted = log_wanted.each(Scalar::rough_exp2);
        let growth = smaller(larger(wanted, S::from_f64(MAX_SHRINKING)), self.most_growth);
        let next = length * growth;
        let next = S::select(length.less(self.step), larger(next, self.step), next);

        self.step = S::select(is_taken, next, length * shrinking(error, log_error));
        let remembered = larger(log_error, S::from_f64(LOG_LEAST_ERROR));
        self.error = S::select(is_taken, remembered, self.error);
        self.most_growth = S::select(is_taken, S::from_f64(MAX_GROWTH), S::ONE);
    }

    /// Reverts accepted steps of these lengths if the mask is true, with these errors.
    pub(super) fn take_back(&mut self, length: S, error: S, are_taken_back: S::Mask) {
        let log_error = larger(error, S::from_f64(NEGLIGIBLE)).each(Scalar::rough_log2);
        self.step = S::select(are_taken_back, length * shrinking(error, log_error), self.step);
        self.most_growth = S::select(are_taken_back, S::ONE, self.most_growth);
    }

    /// Copies the lane `from` of other controllers into a lane of these.
    #[inline(always)]
    pub(super) fn take<O>(&mut self, lane: usize, other: &LanesControl<O>, from: usize)
    where
        O: SideBySide<Element = S::Element>,
    {
        let mut numbers = [self.step, self.error, self.most_growth];
        take(&mut numbers, lane, &[other.step, other.error, other.most_growth], from);
        [self.step, self.error, self.most_growth] = numbers;
    }
}

/// Returns the factor of a step after a rejection with this error, whose binary logarithm is also
/// given.
#[inline(always)]
fn shrinking<S: SideBySide<Element: Scalar>>(error: S, log_error: S) -> S {
    let wanted = (S::from_f64(LOG_SAFETY) - log_error / S::from_f64(POWER)).each(Scalar::rough_exp2);
    let shrinking = smaller(larger(wanted, S::from_f64(MAX_SHRINKING)), S::from_f64(LEAST_SHRINKING));
    S::select(is_finite(error), shrinking, S::from_f64(RETREAT))
}

#[cfg(test)]
mod tests {
    use super::super::control::{LEAST_ERROR, SAFETY};
    use super::{LOG_LEAST_ERROR, LOG_SAFETY};

    #[test]
    fn logarithms_are_those_of_the_controller() {
        let expected = [LEAST_ERROR, SAFETY].map(libm::log2);
        for (found, expected) in [LOG_LEAST_ERROR, LOG_SAFETY].into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }
}
