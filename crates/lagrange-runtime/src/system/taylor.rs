//! Systems whose motion can be expanded in Taylor series.

use super::OdeSystem;
use crate::linalg::pivoted::{Factors, Matrix};
use crate::scalar::{Number, Scalar};

/// The highest order of an expansion.
pub const MAX_ORDER: usize = 40;

/// A system with Taylor series of its motion, as `emit { taylor }` makes them.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `taylor`",
    label = "a system with Taylor series is required",
    note = "add `emit {{ taylor }}` to the declaration"
)]
pub trait TaylorSystem: OdeSystem {
    /// Storage for the series of products, to be used again for each expansion.
    type Series: Clone + core::fmt::Debug;

    /// Creates empty storage.
    fn series() -> Self::Series;

    /// Computes the coefficients of the orders 1, 2, … of the motion through the state `y` at time
    /// `t`. It fills `coefficients`, up to [`MAX_ORDER`].
    fn expand(
        &self,
        t: Self::Scalar,
        y: &Self::State,
        series: &mut Self::Series,
        coefficients: &mut [Self::State],
    );
}

/// Factors of products of series, order by order, four products in each group.
#[derive(Clone, Debug)]
pub struct Products<S, const GROUPS: usize>([[[[S; 4]; MAX_ORDER]; 2]; GROUPS]);

impl<S: Number, const GROUPS: usize> Products<S, GROUPS> {
    /// Without factors.
    pub const EMPTY: Self = Products([[[[S::ZERO; 4]; MAX_ORDER]; 2]; GROUPS]);

    /// Computes Σ_{0≤j<k} aⱼ bₖ₋₁₋ⱼ for the factors of four products. The newest factors, with j =
    /// k − 1, are arguments: a sum that waited until they are stored would take twice as long.
    #[inline(always)]
    pub fn sums(&self, group: usize, k: usize, [newest_a, newest_b]: &[[S; 4]; 2]) -> [S; 4] {
        let [a, b] = &self.0[group];
        if k < 2 {
            let sum = accumulated([S::ZERO; 4], newest_a, newest_b);
            return if k == 0 { [S::ZERO; 4] } else { sum };
        }
        let (Some(inner_a), Some(inner_b)) = (a.get(1..k - 1), b.get(1..k - 1)) else { return [S::NAN; 4] };
        // Two sums, so that no product waits for the one before.
        let (mut even, mut odd) = ([S::ZERO; 4], [S::ZERO; 4]);
        let (pairs_of_a, last_of_a) = inner_a.as_chunks::<2>();
        let (last_of_b, pairs_of_b) = inner_b.as_rchunks::<2>();
        for ([a0, a1], [b1, b0]) in pairs_of_a.iter().zip(pairs_of_b.iter().rev()) {
            even = accumulated(even, a0, b0);
            odd = accumulated(odd, a1, b1);
        }
        if let ([a], [b]) = (last_of_a, last_of_b) {
            even = accumulated(even, a, b);
        }
        let (even, odd) = (accumulated(even, &a[0], newest_b), accumulated(odd, newest_a, &b[0]));
        core::array::from_fn(|lane| even[lane] + odd[lane])
    }

    /// Keeps the factors that step k has found.
    #[inline(always)]
    pub fn keep(&mut self, group: usize, k: usize, [a, b]: [[S; 4]; 2]) {
        let [of_a, of_b] = &mut self.0[group];
        (of_a[k], of_b[k]) = (a, b);
    }
}

/// sum + a b, lane by lane.
#[inline(always)]
fn accumulated<S: Number>(sum: [S; 4], a: &[S; 4], b: &[S; 4]) -> [S; 4] {
    [
        a[0].multiply_add(b[0], sum[0]),
        a[1].multiply_add(b[1], sum[1]),
        a[2].multiply_add(b[2], sum[2]),
        a[3].multiply_add(b[3], sum[3]),
    ]
}

/// The inverse of the matrix of accelerations and multipliers in the residuals, for every order.
#[derive(Clone, Copy, Debug)]
pub struct SeriesSolver<S, const N: usize>([[S; N]; N]);

impl<S: Scalar, const N: usize> SeriesSolver<S, N> {
    /// Inverts a matrix, given row by row; the inverse of a singular one is NaN.
    pub fn new<const ENTRIES: usize>(entries: [S; ENTRIES]) -> Self {
        let factors = Factors::new(Matrix::<S, [S; N]>::of(|i, j| entries[i * N + j]));
        let column = |j: usize| {
            let mut unit = [S::ZERO; N];
            unit[j] = S::ONE;
            factors.as_ref().map_or([S::NAN; N], |factors| factors.solve(&unit))
        };
        SeriesSolver(core::array::from_fn(column))
    }

    /// Computes (a, λ) = −M⁻¹ r.
    #[inline(always)]
    pub fn accelerations(&self, residuals: &[S]) -> [S; N] {
        let mut accelerations = [S::ZERO; N];
        for (column, residual) in self.0.iter().zip(residuals) {
            for (acceleration, entry) in accelerations.iter_mut().zip(column) {
                *acceleration = entry.multiply_add(-*residual, *acceleration);
            }
        }
        accelerations
    }
}
