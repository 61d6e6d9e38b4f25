//! One stage of an explicit Runge–Kutta method.

use crate::integrate::explicit::{TableauRow, moved, weighted_in_blocks};
use crate::scalar::Number;
use crate::system::StateVector;

/// Number of rates per step.
pub(super) const STAGES: usize = 16;
/// Number of rates per step including those for the interpolant.
pub(super) const RATES: usize = 26;

/// The position of a stage within a step, and the weights of the rates in its state.
pub(super) struct Stage<const N: usize> {
    /// The fraction of the step at which the stage is evaluated.
    pub(super) node: f64,
    /// Indices of rates with their weights; other rates have zero weight.
    pub(super) weights: [(usize, f64); N],
}

impl<const N: usize> Stage<N> {
    /// Returns the time of the stage in a step of length `h` from `t`.
    #[inline(always)]
    pub(super) fn time<S: Number>(&self, t: S, h: S) -> S {
        S::from_f64(self.node).multiply_add(h, t)
    }

    /// Computes y + h Σ wⱼ kⱼ.
    #[inline(always)]
    pub(super) fn point<S: Number, Y: StateVector<S>, const R: usize>(
        &self,
        y: &Y,
        h: S,
        rates: &[Y; R],
    ) -> Y {
        moved(self.weighted(rates), y, h)
    }

    /// Computes Σ wⱼ kⱼ.
    #[inline(always)]
    pub(super) fn weighted<S: Number, Y: StateVector<S>, const R: usize>(&self, rates: &[Y; R]) -> Y {
        if size_of::<S>() > size_of::<f64>() {
            // Opaque, since compilers would otherwise unroll all terms.
            return weighted_in_blocks(rates, core::hint::black_box(&self.weights));
        }
        let mut sum = rates[0].zeros();
        for (rate, weight) in self.weights {
            let weight = S::from_f64(weight);
            for (sum, rate) in sum.padded_mut().iter_mut().zip(rates[rate].padded()) {
                *sum = rate.multiply_add(weight, *sum);
            }
        }
        sum
    }

    /// Returns the stage as a row of a table.
    pub(super) const fn row(&'static self) -> TableauRow {
        TableauRow { node: self.node, weights: &self.weights }
    }
}
