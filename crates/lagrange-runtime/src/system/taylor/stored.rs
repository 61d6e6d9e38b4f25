//! Products of series whose number is known at run time.

use std::vec::Vec;

use super::pieces::{self, TablePiece};
use super::{Four, MAX_ORDER, inner_sums};
use crate::scalar::{Number, Scalar};

/// The coefficients of four series.
type FourSeries<S> = [Four<S>; MAX_ORDER];

/// Factors of products a b of series, as in [`Products`](super::Products), in numbers known at run
/// time. Sums have the same bits.
#[derive(Clone, Debug)]
pub struct StoredProducts<S> {
    a: Vec<FourSeries<S>>,
    b: Vec<FourSeries<S>>,
    pieces: Vec<TablePiece<S>>,
}

impl<S: Number> StoredProducts<S> {
    /// No factors.
    pub const EMPTY: Self = StoredProducts { a: Vec::new(), b: Vec::new(), pieces: Vec::new() };

    /// Makes room for sides of groups, for groups and for arguments of tables.
    pub fn resize(&mut self, [shared, groups, arguments]: [usize; 3]) {
        self.a.resize(shared, [Four::ZERO; MAX_ORDER]);
        self.b.resize(groups, [Four::ZERO; MAX_ORDER]);
        self.pieces.resize(arguments, TablePiece::EMPTY);
    }

    /// Computes Σ_{0≤j<k} aⱼ bₖ₋₁₋ⱼ, four for each group. `of_group` contains the sides of the
    /// groups.
    #[inline(always)]
    pub fn sums<const FUSED: bool>(&self, k: usize, of_group: &[usize], sums: &mut [S]) {
        let (sums, _) = sums.as_chunks_mut::<4>();
        let Some(last) = k.checked_sub(1) else { return sums.fill([S::ZERO; 4]) };
        let inner = 1..last.max(1);
        for ((sums, side), b) in sums.iter_mut().zip(of_group).zip(&self.b) {
            let a = &self.a[*side];
            let [of_a, of_b] = [a, b].map(|factors| factors[inner.clone()].as_chunks::<1>().0);
            let [sum] = inner_sums::<FUSED, S, _, _, 1>(of_a, of_b, [0], 0);
            // The product of both factors of order zero occurs only once.
            let first = if last == 0 { &Four::ZERO } else { &b[0] };
            *sums = sum.plus::<FUSED>(&a[last], first).plus::<FUSED>(&a[0], &b[last]).0;
        }
    }

    /// Stores the factors a, then b, found in step k.
    #[inline(always)]
    pub fn keep(&mut self, k: usize, found: &[S]) {
        let (found, _) = found.as_chunks::<4>();
        for (factors, found) in self.a.iter_mut().chain(&mut self.b).zip(found) {
            factors[k] = Four(*found);
        }
    }

    /// Begins to track an argument of a table from a value, in a piece with these ends.
    pub fn follow(&mut self, argument: usize, start: S, ends: [S; 2]) {
        self.pieces[argument].follow(start, ends);
    }

    /// Stores the coefficient of an argument found in step k.
    pub fn keep_argument(&mut self, argument: usize, k: usize, coefficient: S) {
        self.pieces[argument].keep(k, coefficient);
    }
}

impl<S: Scalar> StoredProducts<S> {
    /// Returns the time within `h` for which no argument of a table leaves its piece.
    #[must_use]
    pub fn reach(&self, h: S) -> S {
        pieces::reach(&self.pieces, h)
    }
}
