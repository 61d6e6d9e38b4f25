//! Explicit Runge–Kutta methods given by their tableaus, and the adjoint of their steps.
//!
//! A step has the rates kᵢ = f(t + cᵢ h, Yᵢ) at the points Yᵢ = y + h Σ aᵢⱼ kⱼ. It ends at y⁺ = y +
//! h Σ bᵢ kᵢ. Let λ⁺ be the derivative of a cost with respect to y⁺. Backwards through the stages,
//!
//! > k̄ᵢ = h (bᵢ λ⁺ + Σ aⱼᵢ Ȳⱼ),  Ȳᵢ = (∂f/∂y)ᵀ k̄ᵢ,  λ = λ⁺ + Σ Ȳᵢ,
//!
//! and a parameter p adds Σ k̄ᵢ · ∂f/∂p to the derivative with respect to p. This is exact for the
//! computed step, with its length held constant. Source: Hager, "Runge-Kutta methods in optimal
//! control and the transformed adjoint system", Numer. Math. 87 (2000), §2.

use crate::scalar::Number;
use crate::system::StateVector;

/// A method whose steps are explicit Runge–Kutta steps of one tableau.
///
/// [`Simulation::gradient`](crate::simulate::Simulation::gradient) traverses such steps backwards.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no explicit Runge–Kutta method",
    note = "gradients go backwards along steps of `Verner98`, the default, and of `RungeKutta4`"
)]
pub trait ExplicitRungeKutta {
    /// Rows of the stages; the first one has no weights.
    #[doc(hidden)]
    const STAGES: &'static [TableauRow];
    /// The row of the step.
    #[doc(hidden)]
    const ADVANCE: TableauRow;
}

/// A stage whose number of weights is not part of its type. All stages of numbers in lanes share
/// the same instructions; a copy for each stage would be too large.
#[derive(Clone, Copy, Debug)]
pub struct TableauRow {
    /// The fraction of the step at which the stage is evaluated.
    pub(super) node: f64,
    /// Indices of rates with their weights; other rates have zero weight.
    pub(super) weights: &'static [(usize, f64)],
}

impl TableauRow {
    /// Returns the time of the stage in a step of length `h` from `t`.
    #[inline(always)]
    pub(crate) fn time<S: Number>(&self, t: S, h: S) -> S {
        S::from_f64(self.node).multiply_add(h, t)
    }

    /// Computes y + h Σ wⱼ kⱼ.
    #[inline(always)]
    pub(crate) fn point<S: Number, Y: StateVector<S>>(&self, y: &Y, h: S, rates: &[Y]) -> Y {
        moved(weighted_in_blocks(rates, self.weights), y, h)
    }

    /// Adds h wⱼ x to the sum of each rate.
    #[cfg(feature = "std")]
    pub(crate) fn spread<S: Number, Y: StateVector<S>>(&self, h: S, x: &Y, sums: &mut [Y]) {
        for &(rate, weight) in self.weights {
            let factor = h * S::from_f64(weight);
            for (sum, x) in sums[rate].as_mut().iter_mut().zip(x.as_ref()) {
                *sum = factor.multiply_add(*x, *sum);
            }
        }
    }
}

/// Computes y + h · rate.
#[inline(always)]
pub(super) fn moved<S: Number, Y: StateVector<S>>(rate: Y, y: &Y, h: S) -> Y {
    let mut point = rate;
    for (rate, y) in point.as_mut().iter_mut().zip(y.as_ref()) {
        *rate = rate.multiply_add(h, *y);
    }
    point
}

/// Number of state components that are summed together. Each sum waits for its last product, and
/// registers cannot hold more sums.
const BLOCK: usize = 4;

/// Computes Σ wⱼ kⱼ.
#[inline(always)]
pub(super) fn weighted_in_blocks<S: Number, Y: StateVector<S>>(rates: &[Y], weights: &[(usize, f64)]) -> Y {
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

/// Computes the components of Σ wⱼ kⱼ that start at `first`.
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
