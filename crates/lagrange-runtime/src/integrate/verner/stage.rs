//! One stage of an explicit Runge–Kutta method.

use crate::scalar::Number;
use crate::system::StateVector;

/// Number of rates per step.
pub(super) const STAGES: usize = 16;
/// and how many of the state belong to it, those for the interpolant included.
pub(super) const RATES: usize = 26;

/// The position of a stage within a step, and the weights of the rates that lead there.
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
        moved(self.weighted(rates), y, h)
    }

    /// Σ wⱼ kⱼ
    #[inline(always)]
    pub(super) fn weighted<S: Number, Y: StateVector<S>, const R: usize>(&self, rates: &[Y; R]) -> Y {
        if size_of::<S>() > size_of::<f64>() {
            // Opaque, or compilers write out all terms.
            return weighted_in_blocks(rates, core::hint::black_box(&self.weights));
        }
        let mut sum = rates[0].zeros();
        for (rate, weight) in self.weights {
            let weight = S::from_f64(weight);
            for (sum, rate) in sum.as_mut().iter_mut().zip(rates[rate].as_ref()) {
                *sum = rate.multiply_add(weight, *sum);
            }
        }
        sum
    }

    /// The stage as a row of a table.
    pub(super) const fn row(&'static self) -> TableauRow {
        TableauRow { node: self.node, weights: &self.weights }
    }
}

/// A stage whose number of weights is not part of its type. All stages of numbers in lanes use the
/// same instructions, of which there are many enough without a copy for each stage.
pub(super) struct TableauRow {
    node: f64,
    weights: &'static [(usize, f64)],
}

impl TableauRow {
    /// Returns the time, as for a [`Stage`].
    #[inline(always)]
    pub(super) fn time<S: Number>(&self, t: S, h: S) -> S {
        S::from_f64(self.node).multiply_add(h, t)
    }

    /// Returns the state, as for a [`Stage`].
    #[inline(always)]
    pub(super) fn point<S: Number, Y: StateVector<S>>(&self, y: &Y, h: S, rates: &[Y]) -> Y {
        moved(weighted_in_blocks(rates, self.weights), y, h)
    }
}

/// y + h · rate
#[inline(always)]
fn moved<S: Number, Y: StateVector<S>>(rate: Y, y: &Y, h: S) -> Y {
    let mut point = rate;
    for (rate, y) in point.as_mut().iter_mut().zip(y.as_ref()) {
        *rate = rate.multiply_add(h, *y);
    }
    point
}

/// Components of a state whose sums are added up together: each sum waits for its last product, and
/// registers hold no more of them.
const BLOCK: usize = 4;

/// Σ wⱼ kⱼ
#[inline(always)]
fn weighted_in_blocks<S: Number, Y: StateVector<S>>(rates: &[Y], weights: &[(usize, f64)]) -> Y {
    let mut sum = rates[0].zeros();
    let mut first = 0;
    let mut blocks = sum.as_mut().chunks_exact_mut(BLOCK);
    for block in &mut blocks {
        block.copy_from_slice(&block_of::<S, Y, BLOCK>(rates, weights, first));
        first += BLOCK;
    }
    for component in blocks.into_remainder() {
        [*component] = block_of::<S, Y, 1>(rates, weights, first);
        first += 1;
    }
    sum
}

/// Components of Σ wⱼ kⱼ from `first` on.
#[inline(always)]
fn block_of<S: Number, Y: StateVector<S>, const B: usize>(
    rates: &[Y],
    weights: &[(usize, f64)],
    first: usize,
) -> [S; B] {
    let mut sums = [S::ZERO; B];
    for (rate, weight) in weights {
        let (rate, weight) = (&rates[*rate].as_ref()[first..first + B], S::from_f64(*weight));
        for (sum, rate) in sums.iter_mut().zip(rate) {
            *sum = rate.multiply_add(weight, *sum);
        }
    }
    sums
}
