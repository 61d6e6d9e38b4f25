//! Systems whose motion can be expanded in Taylor series.

mod order;
mod pieces;

pub use self::order::Order;
use self::pieces::Pieces;
use super::OdeSystem;
use crate::linalg::pivoted::{Factors, Matrix};
use crate::scalar::{Number, Scalar};

/// Maximum order of an expansion.
pub const MAX_ORDER: usize = 40;

/// A system that provides Taylor series of its motion, as emitted by `emit { taylor }`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `taylor`",
    label = "a system with Taylor series is required",
    note = "add `emit {{ taylor }}` to the declaration",
    note = "inputs from a law of `drive` have no series: `sampled` holds inputs, and `Verner98` takes laws"
)]
pub trait TaylorSystem: OdeSystem {
    /// Storage for the series of products, reused by each expansion.
    type Series: Clone + core::fmt::Debug;
    /// True if the [equations for lanes](super::LanesSystem) have series, too.
    const IN_LANES: bool = false;

    /// Creates empty storage.
    fn series() -> Self::Series;

    /// Computes the coefficients of orders 1, 2, … of the motion through the state `y` at time `t`.
    /// It fills `coefficients`, which has at most [`MAX_ORDER`] entries.
    fn expand(
        &self,
        t: Self::Scalar,
        y: &Self::State,
        series: &mut Self::Series,
        coefficients: &mut [Self::State],
    );

    /// Returns the part of the time `h` for which the last expansion in `series` is valid. It ends
    /// where an argument of a table passes a grid point.
    #[inline]
    fn reach(_series: &Self::Series, h: Self::Scalar) -> Self::Scalar {
        h
    }
}

/// Size of the largest numbers of which four groups are added up in one loop: those of a single
/// motion.
const LARGEST_TOGETHER: usize = 16;

/// Four numbers that are added and multiplied lane by lane.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
struct Four<S>([S; 4]);

impl<S: Number> Four<S> {
    const ZERO: Self = Four([S::ZERO; 4]);

    /// Computes self + a b.
    #[inline(always)]
    fn plus(self, a: &Self, b: &Self) -> Self {
        let mut sum = self;
        for lane in 0..4 {
            sum.0[lane] = a.0[lane].multiply_add(b.0[lane], self.0[lane]);
        }
        sum
    }

    #[inline(always)]
    fn sum(&self, other: &Self) -> Self {
        let mut sum = *self;
        for lane in 0..4 {
            sum.0[lane] = self.0[lane] + other.0[lane];
        }
        sum
    }
}

/// Factors of products a b of series, order by order. Products form groups of four; groups may
/// share their factors a.
#[derive(Clone, Debug)]
pub struct Products<S, const SHARED: usize, const GROUPS: usize, const ARGUMENTS: usize = 0> {
    a: [[Four<S>; SHARED]; MAX_ORDER],
    b: [[Four<S>; GROUPS]; MAX_ORDER],
    /// Factors of order zero, set once they are multiplied with the newest ones.
    first: SeriesFactors<S, SHARED, GROUPS>,
    /// Sums without the factors of order zero and without the newest ones.
    inner: [Four<S>; GROUPS],
    /// Parts of the next such sums, of numbers in lanes.
    ahead: [Four<S>; GROUPS],
    /// Arguments of tables.
    pieces: Pieces<S, ARGUMENTS>,
}

impl<S: Number, const SHARED: usize, const GROUPS: usize, const ARGUMENTS: usize> Default
    for Products<S, SHARED, GROUPS, ARGUMENTS>
{
    #[inline(always)]
    fn default() -> Self {
        Self::EMPTY
    }
}

/// Factors of one order.
pub type SeriesFactors<S, const SHARED: usize, const GROUPS: usize> = ([[S; 4]; SHARED], [[S; 4]; GROUPS]);

impl<S: Number, const SHARED: usize, const GROUPS: usize, const ARGUMENTS: usize>
    Products<S, SHARED, GROUPS, ARGUMENTS>
{
    /// No factors.
    pub const EMPTY: Self = Products {
        a: [[Four::ZERO; SHARED]; MAX_ORDER],
        b: [[Four::ZERO; GROUPS]; MAX_ORDER],
        first: Self::NONE,
        inner: [Four::ZERO; GROUPS],
        ahead: [Four::ZERO; GROUPS],
        pieces: Pieces {
            start: [S::ZERO; ARGUMENTS],
            ends: [[S::ZERO; 2]; ARGUMENTS],
            coefficients: [[S::ZERO; ARGUMENTS]; MAX_ORDER],
            orders: 0,
        },
    };
    /// Factors of an order before the first one.
    pub const NONE: SeriesFactors<S, SHARED, GROUPS> = ([[S::ZERO; 4]; SHARED], [[S::ZERO; 4]; GROUPS]);

    /// Begins another expansion.
    #[inline(always)]
    pub fn begin(&mut self) {
        self.first = Self::NONE;
    }

    /// Computes Σ_{0<j<k−1} aⱼ bₖ₋₁₋ⱼ for N groups starting at `group`, whose factors a are at the
    /// indices `shared`. It does not depend on results of step k − 1, so it need not wait for that
    /// step.
    #[inline(always)]
    pub fn add_up<const N: usize>(&mut self, k: usize, group: usize, shared: [usize; N]) {
        if size_of::<S>() > LARGEST_TOGETHER {
            let (pairs, last) = shared.as_chunks::<2>();
            for (pair, shared) in pairs.iter().enumerate() {
                self.add_up_in_lanes(k, group + 2 * pair, *shared);
            }
            if let [shared] = last {
                self.add_up_in_lanes(k, group + N - 1, [*shared]);
            }
            return;
        }
        // Two sums, so that no product waits for the previous one.
        let (mut even, mut odd) = ([Four::ZERO; N], [Four::ZERO; N]);
        let inner = 1..k.saturating_sub(1);
        if let (Some(a), Some(b)) = (self.a.get(inner.clone()), self.b.get(inner)) {
            let accumulate = |sums: &mut [Four<S>; N], a: &[Four<S>; SHARED], b: &[Four<S>; GROUPS]| {
                for place in 0..N {
                    sums[place] = sums[place].plus(&a[shared[place]], &b[group + place]);
                }
            };
            let (pairs_of_a, last_of_a) = a.as_chunks::<2>();
            let (last_of_b, pairs_of_b) = b.as_rchunks::<2>();
            for ([a0, a1], [b1, b0]) in pairs_of_a.iter().zip(pairs_of_b.iter().rev()) {
                accumulate(&mut even, a0, b0);
                accumulate(&mut odd, a1, b1);
            }
            if let ([a], [b]) = (last_of_a, last_of_b) {
                accumulate(&mut even, a, b);
            }
        }
        for place in 0..N {
            self.inner[group + place] = even[place].sum(&odd[place]);
        }
    }

    /// Computes the sums of groups of products of numbers in lanes, which fill the registers.
    ///
    /// Loads of factors take most of the time. In every other step, the same factors also serve the
    /// sums of the next one, from which two terms are then missing.
    #[inline(always)]
    fn add_up_in_lanes<const N: usize>(&mut self, k: usize, group: usize, shared: [usize; N]) {
        for lane in 0..4 {
            let (mut sums, mut next, mut last) = ([S::ZERO; N], [S::ZERO; N], [S::ZERO; N]);
            let inner = 1..k.saturating_sub(1).max(1);
            if k.is_multiple_of(2) {
                let (a, b) = (&self.a[inner.clone()], &self.b[inner]);
                for (a, b) in a.iter().zip(b.iter().rev()) {
                    for place in 0..N {
                        let (a, b) = (a[shared[place]].0[lane], b[group + place].0[lane]);
                        sums[place] = a.multiply_add(b, sums[place]);
                        next[place] = a.multiply_add(last[place], next[place]);
                        last[place] = b;
                    }
                }
            } else {
                let ends = [(1, k.saturating_sub(2)), (k.saturating_sub(2), 1)];
                let terms = k.saturating_sub(2).min(2);
                for place in 0..N {
                    sums[place] = self.ahead[group + place].0[lane];
                    for (j, other) in ends.into_iter().take(terms) {
                        let (a, b) = (&self.a[j][shared[place]], &self.b[other][group + place]);
                        sums[place] = a.0[lane].multiply_add(b.0[lane], sums[place]);
                    }
                }
            }
            for place in 0..N {
                self.inner[group + place].0[lane] = sums[place];
                self.ahead[group + place].0[lane] = next[place];
            }
        }
    }

    /// Computes Σ_{0≤j<k} aⱼ bₖ₋₁₋ⱼ for all groups, after [`add_up`](Self::add_up) for each. The
    /// newest factors, with j = k − 1, are arguments: waiting until they are stored would double
    /// the time.
    #[inline(always)]
    pub fn sums(
        &mut self,
        shared: [usize; GROUPS],
        (newest_a, newest_b): &SeriesFactors<S, SHARED, GROUPS>,
    ) -> [[S; 4]; GROUPS] {
        // Sums pass through memory. Otherwise the optimiser would propagate the lane order of later
        // code into the loops, as permutations for each term.
        core::hint::black_box(&mut self.inner);
        let (first_a, first_b) = &self.first;
        let mut sums = [[S::ZERO; 4]; GROUPS];
        for (group, (sums, a)) in sums.iter_mut().zip(shared).enumerate() {
            for (lane, sum) in sums.iter_mut().enumerate() {
                let inner = self.inner[group].0[lane];
                let first = first_a[a][lane].multiply_add(newest_b[group][lane], inner);
                *sum = newest_a[a][lane].multiply_add(first_b[group][lane], first);
            }
        }
        sums
    }

    /// Stores the factors found in step k.
    #[inline(always)]
    pub fn keep(&mut self, k: usize, (a, b): &SeriesFactors<S, SHARED, GROUPS>) {
        match k {
            0 => self.first.0 = *a,
            // The product of both factors of order zero occurs only once.
            1 => {
                for (first, b) in self.first.1.iter_mut().zip(&self.b[0]) {
                    *first = b.0;
                }
            }
            _ => {}
        }
        for (kept, a) in self.a[k].iter_mut().zip(a) {
            *kept = Four(*a);
        }
        for (kept, b) in self.b[k].iter_mut().zip(b) {
            *kept = Four(*b);
        }
    }

    /// Begins to track arguments of tables from these values, in pieces with these ends.
    #[inline(always)]
    pub fn follow(&mut self, start: [S; ARGUMENTS], ends: [[S; 2]; ARGUMENTS]) {
        (self.pieces.start, self.pieces.ends, self.pieces.orders) = (start, ends, 0);
    }

    /// Stores the coefficients of arguments found in step k.
    #[inline(always)]
    pub fn keep_arguments(&mut self, k: usize, coefficients: [S; ARGUMENTS]) {
        self.pieces.coefficients[k] = coefficients;
        self.pieces.orders = k + 1;
    }
}

impl<S: Scalar, const SHARED: usize, const GROUPS: usize, const ARGUMENTS: usize>
    Products<S, SHARED, GROUPS, ARGUMENTS>
{
    /// Returns the time within `h` for which no argument of a table leaves its piece.
    #[must_use]
    pub fn reach(&self, h: S) -> S {
        self.pieces.reach(h)
    }
}

/// The negative inverse of the matrix of accelerations and multipliers in the residuals, in
/// columns, for every order.
#[derive(Clone, Copy, Debug)]
pub struct SeriesSolver<S, const N: usize>([[S; N]; N]);

impl<S: Scalar, const N: usize> SeriesSolver<S, N> {
    /// Inverts a matrix, given row by row; the inverse of a singular one is NaN.
    pub fn new<const ENTRIES: usize>(entries: [S; ENTRIES]) -> Self {
        let factors = Factors::new(Matrix::<S, [S; N]>::of(|i, j| entries[i * N + j]));
        let column = |j: usize| {
            let mut unit = [S::ZERO; N];
            unit[j] = -S::ONE;
            factors.as_ref().map_or([S::NAN; N], |factors| factors.solve(&unit))
        };
        SeriesSolver(core::array::from_fn(column))
    }
}

impl<S: Number, const N: usize> SeriesSolver<S, N> {
    /// Inverts a positive definite matrix, which needs no pivoting.
    ///
    /// Gauss–Jordan elimination in place: Peters and Wilkinson, "On the stability of Gauss–Jordan
    /// elimination with pivoting", *Communications of the ACM* 18 (1975) 20–24. For the rows (2, 1)
    /// and (1, 1), the pivot 2 leads to (1/2, 1/2) and (−1/2, 1/2). The pivot 1/2 then leads to the
    /// inverse, (1, −1) and (−1, 2).
    #[inline(always)]
    pub fn definite<const ENTRIES: usize>(entries: [S; ENTRIES]) -> Self {
        let mut rows = [[S::ZERO; N]; N];
        for (row, entries) in rows.iter_mut().zip(entries.chunks_exact(N)) {
            row.copy_from_slice(entries);
        }
        for pivot in 0..N {
            let (mut scaled, reciprocal) = (rows[pivot], S::ONE / rows[pivot][pivot]);
            scaled[pivot] = S::ONE;
            for entry in &mut scaled {
                *entry = *entry * reciprocal;
            }
            for row in &mut rows {
                let factor = -row[pivot];
                row[pivot] = S::ZERO;
                for (entry, scaled) in row.iter_mut().zip(scaled) {
                    *entry = scaled.multiply_add(factor, *entry);
                }
            }
            rows[pivot] = scaled;
        }
        let mut columns = [[S::ZERO; N]; N];
        for (i, row) in rows.iter().enumerate() {
            for (column, entry) in columns.iter_mut().zip(row) {
                column[i] = -*entry;
            }
        }
        SeriesSolver(columns)
    }

    /// Computes (a, λ) = −M⁻¹ r.
    #[inline(always)]
    pub fn accelerations(&self, residuals: &[S]) -> [S; N] {
        let mut sums = [S::ZERO; N];
        for (j, (column, residual)) in self.0.iter().zip(residuals).enumerate() {
            for (sum, entry) in sums.iter_mut().zip(column) {
                *sum = if j == 0 { *entry * *residual } else { entry.multiply_add(*residual, *sum) };
            }
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::SeriesSolver;

    #[test]
    fn a_definite_matrix_has_the_same_inverse_either_way() {
        let entries = [4.0, 1.0, -0.5, 1.0, 3.0, 0.25, -0.5, 0.25, 2.0];
        let [pivoted, definite] = [SeriesSolver::<f64, 3>::new(entries), SeriesSolver::definite(entries)];
        let residual = [0.3, -0.7, 1.1];
        let [found, wanted] = [definite, pivoted].map(|solver| solver.accelerations(&residual));
        for (row, (found, wanted)) in found.iter().zip(wanted).enumerate() {
            assert!((found - wanted).abs() < 1e-15, "{row}");
            let product =
                (0..3).map(|j| entries[3 * row + j] * definite.accelerations(&residual)[j]).sum::<f64>();
            assert!((product + residual[row]).abs() < 1e-15, "{row}");
        }
    }
}
