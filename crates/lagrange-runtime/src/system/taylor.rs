//! Systems whose motion can be expanded in Taylor series.

mod order;
mod pieces;
mod solver;
#[cfg(feature = "std")]
mod stored;

pub use self::order::Order;
use self::pieces::TablePiece;
pub use self::solver::{SeriesSolver, negative_inverse, negative_inverse_of_definite};
#[cfg(feature = "std")]
pub use self::stored::StoredProducts;
use super::OdeSystem;
use crate::scalar::{Number, Scalar, product_sum};

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
    /// It fills `coefficients`, which has at most [`MAX_ORDER`] entries. Products and sums may be
    /// [fused](Number::fused_multiply_add) if FUSED.
    fn expand<const FUSED: bool>(
        &self,
        t: Self::Scalar,
        y: &Self::State,
        series: &mut Self::Series,
        coefficients: &mut [Self::State],
    );

    /// Returns the number of groups of four products that an order sums up, which influences the
    /// cheapest order.
    #[inline]
    fn product_groups(&self) -> usize {
        0
    }

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

/// Maximum number of groups whose newest factors are likely still in registers. Those of more
/// groups are loaded.
const MAX_IN_REGISTERS: usize = 8;

/// Four numbers that are added and multiplied lane by lane.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
struct Four<S>([S; 4]);

impl<S: Number> Four<S> {
    const ZERO: Self = Four([S::ZERO; 4]);

    /// Computes self + a b.
    #[inline(always)]
    fn plus<const FUSED: bool>(self, a: &Self, b: &Self) -> Self {
        let mut sum = self;
        for lane in 0..4 {
            sum.0[lane] = product_sum::<FUSED, S>(a.0[lane], b.0[lane], self.0[lane]);
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

/// Computes Σ aⱼ bₖ₋ⱼ for N groups starting at `group`, whose factors a are at the indices
/// `shared`. There are two sums, so that no product waits for the previous one.
#[inline(always)]
fn inner_sums<const FUSED: bool, S: Number, A: AsRef<[Four<S>]>, B: AsRef<[Four<S>]>, const N: usize>(
    a: &[A],
    b: &[B],
    shared: [usize; N],
    group: usize,
) -> [Four<S>; N] {
    let (mut even, mut odd) = ([Four::ZERO; N], [Four::ZERO; N]);
    let (last_of_a, pairs_of_a) = a.as_rchunks::<2>();
    let (pairs_of_b, last_of_b) = b.as_chunks::<2>();
    for ([a1, a0], [b0, b1]) in pairs_of_a.iter().rev().zip(pairs_of_b) {
        add_terms::<FUSED, S, N>(&mut even, a0.as_ref(), b0.as_ref(), shared, group);
        add_terms::<FUSED, S, N>(&mut odd, a1.as_ref(), b1.as_ref(), shared, group);
    }
    if let ([a], [b]) = (last_of_a, last_of_b) {
        add_terms::<FUSED, S, N>(&mut even, a.as_ref(), b.as_ref(), shared, group);
    }
    for place in 0..N {
        even[place] = even[place].sum(&odd[place]);
    }
    even
}

/// Adds a term to each sum. A closure would be compiled without the instructions of its caller.
#[inline(always)]
fn add_terms<const FUSED: bool, S: Number, const N: usize>(
    sums: &mut [Four<S>; N],
    a: &[Four<S>],
    b: &[Four<S>],
    shared: [usize; N],
    group: usize,
) {
    for place in 0..N {
        sums[place] = sums[place].plus::<FUSED>(&a[shared[place]], &b[group + place]);
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
    /// Sums without the factors of order zero and without the newest ones, except in large systems.
    inner: [Four<S>; GROUPS],
    /// Parts of the next such sums, of numbers in lanes.
    ahead: [Four<S>; GROUPS],
    /// Arguments of tables.
    pieces: [TablePiece<S>; ARGUMENTS],
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
        pieces: [TablePiece::EMPTY; ARGUMENTS],
        ahead: [Four::ZERO; GROUPS],
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
    /// step. In large systems, the remaining products are added, since groups do not wait for each
    /// other.
    #[inline(always)]
    pub fn add_up<const FUSED: bool, const N: usize>(&mut self, k: usize, group: usize, shared: [usize; N]) {
        if size_of::<S>() > LARGEST_TOGETHER {
            let (pairs, last) = shared.as_chunks::<2>();
            for (pair, shared) in pairs.iter().enumerate() {
                self.add_up_in_lanes(k, group + 2 * pair, *shared);
            }
            if let [shared] = last {
                self.add_up_in_lanes(k, group + N - 1, [*shared]);
            }
        } else {
            let inner = 1..k.saturating_sub(1);
            let (a, b) = (self.a.get(inner.clone()), self.b.get(inner));
            let (a, b) = (a.unwrap_or_default(), b.unwrap_or_default());
            let sums = inner_sums::<FUSED, _, _, _, N>(a, b, shared, group);
            self.inner[group..group + N].copy_from_slice(&sums);
        }
        if GROUPS > MAX_IN_REGISTERS && k > 0 {
            for (place, a) in shared.into_iter().enumerate() {
                self.add_newest::<FUSED>(k - 1, group + place, a);
            }
        }
    }

    /// Adds the products with the factors of step `last`, the newest ones, to the sum of a group.
    #[inline(always)]
    fn add_newest<const FUSED: bool>(&mut self, last: usize, group: usize, a: usize) {
        // The product of both factors of order zero occurs only once.
        let first = if last == 0 { &Four::ZERO } else { &self.b[0][group] };
        let early = self.inner[group].plus::<FUSED>(&self.a[last][a], first);
        self.inner[group] = early.plus::<FUSED>(&self.a[0][a], &self.b[last][group]);
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
    pub fn sums<const FUSED: bool>(
        &mut self,
        shared: [usize; GROUPS],
        (newest_a, newest_b): &SeriesFactors<S, SHARED, GROUPS>,
    ) -> [[S; 4]; GROUPS] {
        // Sums pass through memory. Otherwise the optimiser would propagate the lane order of later
        // code into the loops, as permutations for each term.
        core::hint::black_box(&mut self.inner);
        if GROUPS > MAX_IN_REGISTERS {
            return self.loaded();
        }
        let (first_a, first_b) = &self.first;
        let mut sums = [[S::ZERO; 4]; GROUPS];
        for group in 0..GROUPS {
            let a = shared[group];
            for lane in 0..4 {
                let inner = self.inner[group].0[lane];
                let early = product_sum::<FUSED, S>(newest_a[a][lane], first_b[group][lane], inner);
                sums[group][lane] = product_sum::<FUSED, S>(first_a[a][lane], newest_b[group][lane], early);
            }
        }
        sums
    }

    /// Returns the sums as they are. A closure would be compiled without the instructions of its
    /// caller.
    #[inline(always)]
    fn loaded(&self) -> [[S; 4]; GROUPS] {
        let mut sums = [[S::ZERO; 4]; GROUPS];
        for (sum, inner) in sums.iter_mut().zip(&self.inner) {
            *sum = inner.0;
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
        for (piece, (start, ends)) in self.pieces.iter_mut().zip(start.into_iter().zip(ends)) {
            piece.follow(start, ends);
        }
    }

    /// Stores the coefficients of arguments found in step k.
    #[inline(always)]
    pub fn keep_arguments(&mut self, k: usize, coefficients: [S; ARGUMENTS]) {
        for (piece, coefficient) in self.pieces.iter_mut().zip(coefficients) {
            piece.keep(k, coefficient);
        }
    }
}

impl<S: Scalar, const SHARED: usize, const GROUPS: usize, const ARGUMENTS: usize>
    Products<S, SHARED, GROUPS, ARGUMENTS>
{
    /// Returns the time within `h` for which no argument of a table leaves its piece.
    #[must_use]
    pub fn reach(&self, h: S) -> S {
        pieces::reach(&self.pieces, h)
    }
}
