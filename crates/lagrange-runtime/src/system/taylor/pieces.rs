//! The part of a step in which tables equal the polynomials used by an expansion.

use super::MAX_ORDER;
use crate::scalar::{Number, Scalar};

/// Number of rounding errors by which a step passes the end of a piece, so that the next one begins
/// in the adjacent piece.
const ROUNDINGS: f64 = 16.0;
/// Maximum number of steps of a search. Each step doubles the number of correct digits unless two
/// zeros are close.
const MAX_ITERATIONS: usize = 64;

/// An argument of a table along an expansion, and the ends of its initial piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct TablePiece<S> {
    start: S,
    ends: [S; 2],
    /// Coefficients of the orders 1, 2, …
    coefficients: [S; MAX_ORDER],
    orders: usize,
}

/// Returns the time within `h` after which the first argument leaves its piece; `h` if none does.
pub(super) fn reach<S: Scalar>(pieces: &[TablePiece<S>], h: S) -> S {
    pieces.iter().fold(S::ONE, |part, piece| part.min(piece.part(h))) * h
}

impl<S: Number> TablePiece<S> {
    /// No piece.
    pub(super) const EMPTY: Self =
        TablePiece { start: S::ZERO, ends: [S::ZERO; 2], coefficients: [S::ZERO; MAX_ORDER], orders: 0 };

    /// Begins another expansion from this argument, in a piece with these ends.
    #[inline(always)]
    pub(super) fn follow(&mut self, start: S, ends: [S; 2]) {
        (self.start, self.ends, self.orders) = (start, ends, 0);
    }

    /// Stores the coefficient found in step k.
    #[inline(always)]
    pub(super) fn keep(&mut self, k: usize, coefficient: S) {
        self.coefficients[k] = coefficient;
        self.orders = k + 1;
    }
}

impl<S: Scalar> TablePiece<S> {
    fn part(&self, h: S) -> S {
        let (mut path, mut power) = ([S::ZERO; MAX_ORDER], S::ONE);
        for (term, coefficient) in path.iter_mut().zip(&self.coefficients).take(self.orders) {
            power = power * h;
            *term = *coefficient * power;
        }
        let (start, [lower, upper]) = (self.start, self.ends);
        let above = first_beyond(&path, upper - start, upper.abs().max(start.abs()));
        path.iter_mut().for_each(|term| *term = -*term);
        above.min(first_beyond(&path, start - lower, lower.abs().max(start.abs())))
    }
}

/// Returns the first place in the unit interval at which Σ cₖ xᵏ with k ≥ 1 exceeds a distance; one
/// if there is none.
///
/// At each place, a parabola that is nowhere below the polynomial bounds the range in which the
/// polynomial stays within the distance.
fn first_beyond<S: Scalar>(path: &[S; MAX_ORDER], distance: S, size: S) -> S {
    let (mut farthest, mut bend, mut order) = (S::ZERO, S::ZERO, S::ONE);
    for term in path {
        farthest = farthest + term.abs();
        bend = (order * (order - S::ONE)).multiply_add(term.abs(), bend);
        order = order + S::ONE;
    }
    let margin = S::from_f64(ROUNDINGS) * S::epsilon() * size.max(farthest);
    let distance = distance + margin;
    let is_possible = farthest.is_finite() && bend.is_finite() && farthest > distance;
    let mut x = S::ZERO;
    for _ in 0..if is_possible { MAX_ITERATIONS } else { 0 } {
        let (value, slope) = value_and_slope(path, x);
        let left = distance - value;
        if left + left <= margin {
            return x;
        }
        let root = slope.multiply_add(slope, (bend + bend) * left).sqrt();
        x = x + if slope > S::ZERO { (left + left) / (slope + root) } else { (root - slope) / bend };
        if x >= S::ONE || !x.is_finite() {
            return S::ONE;
        }
    }
    if is_possible { x } else { S::ONE }
}

/// Computes Σ cₖ xᵏ with k ≥ 1, and its slope.
fn value_and_slope<S: Scalar>(path: &[S; MAX_ORDER], x: S) -> (S, S) {
    let (value, slope) = path.iter().rev().fold((S::ZERO, S::ZERO), |(value, slope), term| {
        (value.multiply_add(x, *term), slope.multiply_add(x, value))
    });
    (value * x, slope.multiply_add(x, value))
}

#[cfg(test)]
mod tests {
    use super::TablePiece;

    fn reach(start: f64, ends: [f64; 2], coefficients: &[f64], h: f64) -> f64 {
        let mut piece = TablePiece::EMPTY;
        piece.follow(start, ends);
        coefficients.iter().enumerate().for_each(|(k, coefficient)| piece.keep(k, *coefficient));
        super::reach(&[piece], h)
    }

    #[test]
    fn the_first_end_that_is_met_counts() {
        let inf = f64::INFINITY;
        // 1 + 3 t − 2 t² turns back at 17/8, and is 2 at 1/2 and at 1, and 0 at (3 + √17)/4.
        let thrown = [3.0, -2.0];
        let near = |found: f64, wanted: f64| assert!((found - wanted).abs() < 1e-13, "{found} for {wanted}");
        near(reach(1.0, [0.0, 2.0], &thrown, 2.5), 0.5);
        near(reach(1.0, [0.0, 2.2], &thrown, 2.5), 0.25 * (3.0 + 17.0_f64.sqrt()));
        near(reach(1.0, [-inf, 2.2], &thrown, 2.5), 2.5);
        near(reach(1.0, [0.0, inf], &thrown, -2.5), 0.25 * (3.0 - 17.0_f64.sqrt()));
        near(reach(1.0, [0.0, inf], &thrown, 1.7), 1.7);
        // At the end of its piece: inwards and, within rounding, outwards.
        near(reach(1.0, [1.0, 9.0], &thrown, 1.4), 1.4);
        let outwards = reach(1.0, [0.0, 1.0], &thrown, 1.4);
        assert!((1e-16..1e-14).contains(&outwards), "{outwards:e}");
    }

    #[test]
    fn an_end_that_is_touched_is_not_passed() {
        // 2 t − t² touches 1 at 1.
        assert_eq!(reach(0.0, [-1.0, 1.0 + 1e-9], &[2.0, -1.0], 1.9), 1.9);
        let touched = reach(0.0, [-1.0, 1.0 - 1e-9], &[2.0, -1.0], 1.9);
        assert!((touched - (1.0 - 1e-9_f64.sqrt())).abs() < 1e-9, "{touched}");
    }

    #[test]
    fn rest_and_nan_reach_as_far_as_they_are_asked() {
        assert_eq!(reach(1.0, [1.0, 2.0], &[0.0, 0.0], 3.0), 3.0);
        assert_eq!(reach(1.0, [1.0, 2.0], &[f64::NAN], 3.0), 3.0);
        assert_eq!(reach(f64::NAN, [f64::NAN; 2], &[1.0], 3.0), 3.0);
    }
}
