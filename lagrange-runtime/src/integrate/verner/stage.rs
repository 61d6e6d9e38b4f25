//! One stage of an explicit Runge–Kutta method.

use crate::scalar::Number;
use crate::system::StateVector;

/// How many rates a step needs,
pub(super) const STAGES: usize = 16;
/// and how many of the state belong to it, those for the interpolant included.
pub(super) const RATES: usize = 26;

/// Where a stage lies in a step, and the weights of the rates that lead there.
pub(super) struct Stage<const N: usize> {
    /// The part of the step that is past.
    pub(super) node: f64,
    /// Indices of rates with their weights; others have none.
    pub(super) weights: [(usize, f64); N],
}

impl<const N: usize> Stage<N> {
    /// The time of the stage in a step of the length `h` from `t`.
    #[inline(always)]
    pub(super) fn time<S: Number>(&self, t: S, h: S) -> S {
        S::from_f64(self.node).multiply_add(h, t)
    }

    /// y + h Σ wⱼ kⱼ
    #[inline(always)]
    pub(super) fn point<S: Number, Y: StateVector<S>, const R: usize>(
        &self,
        y: &Y,
        h: S,
        rates: &[Y; R],
    ) -> Y {
        let mut point = self.weighted(rates);
        for (sum, y) in point.as_mut().iter_mut().zip(y.as_ref()) {
            *sum = sum.multiply_add(h, *y);
        }
        point
    }

    /// Σ wⱼ kⱼ
    #[inline(always)]
    pub(super) fn weighted<S: Number, Y: StateVector<S>, const R: usize>(&self, rates: &[Y; R]) -> Y {
        weighted(rates, self.weights.map(|(rate, weight)| (rate, S::from_f64(weight))))
    }
}

/// Applies a method of a [`Stage`] to the one with this index, or to the last one.
macro_rules! at_stage {
    ($index:expr, $method:ident $arguments:tt, [$($number:literal: $stage:ident),*], $last:ident) => {
        match $index {
            $($number => $stage.$method $arguments,)*
            _ => $last.$method $arguments,
        }
    };
}

pub(super) use at_stage;

/// Σ wⱼ kⱼ
#[inline(always)]
fn weighted<S: Number, Y: StateVector<S>, const N: usize, const R: usize>(
    rates: &[Y; R],
    weights: [(usize, S); N],
) -> Y {
    let mut sum = Y::ZERO;
    if size_of::<S>() > size_of::<f64>() {
        for (component, sum) in sum.as_mut().iter_mut().enumerate() {
            // Opaque, or compilers exchange the loops over components and over lanes, and go across the lanes.
            let sum = core::hint::black_box(sum);
            let terms = weights.iter().map(|(rate, weight)| (rates[*rate].as_ref()[component], *weight));
            *sum = terms.fold(S::ZERO, |sum, (rate, weight)| rate.multiply_add(weight, sum));
        }
        return sum;
    }
    for (rate, weight) in weights {
        for (sum, rate) in sum.as_mut().iter_mut().zip(rates[rate].as_ref()) {
            *sum = rate.multiply_add(weight, *sum);
        }
    }
    sum
}
