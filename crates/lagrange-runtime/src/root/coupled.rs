//! Zeros of several equations with the same number of unknowns.

use core::array::from_fn;

use super::{MAX_BEND, TOLERANCE};
use crate::scalar::{Mask, Number, spacing_at_one};

/// Minimum decrease of the square of the next correction, in units of the fraction of the step.
const LEAST_DECREASE: f64 = 0.5;
/// Minimum fraction of a step that is tried.
const SHORTEST: f64 = 1.0 / 1_073_741_824.0;
/// An unknown is certain if rounding hides at most this many units in its last place.
const CERTAIN: f64 = 1024.0;
/// Distance of the points at which the Jacobian is compared, in units of the distance hidden by
/// rounding.
const ASIDE: f64 = 4.0;

/// Residuals r, their Jacobian ∂rᵢ/∂yⱼ in rows, and the rounding error of each r, as in [`newton`].
///
/// [`newton`]: super::newton
pub type CoupledEquations<S, const N: usize> = ([S; N], [[S; N]; N], [S; N]);

/// Returns the common zero of several equations, found by Newton's method from a start within a
/// number of steps; NaN if none is found. Numbers in lanes iterate until each has its own zero,
/// which does not depend on the others.
///
/// A step is halved until the next correction with the same Jacobian is shorter than the step
/// (Deuflhard, *Newton Methods for Nonlinear Problems*, §3.3). Corrections are measured in units of
/// each unknown and its step. The search therefore depends neither on the scales of the unknowns
/// nor on those of the equations. A candidate is a point where rounding explains all residuals. It
/// is a zero if rounding hides only the last digits of each unknown. Otherwise the Jacobian must
/// have the same orientation, and not vanish, on both sides along each direction that rounding
/// hides. Residuals that are merely small relative to their terms have no zero. One more step is
/// taken from a zero.
///
/// ```
/// use lagrange::root::coupled;
///
/// // The circle y² + z² = 2 and the line y = z.
/// let [y, z] = coupled([2.0_f64, 0.5], 30, |[y, z]| {
///     let residuals = [y * y + z * z - 2.0, y - z];
///     (residuals, [[2.0 * y, 2.0 * z], [1.0, -1.0]], [3.0 * (y * y + z * z), y.abs() + z.abs()])
/// });
/// assert!((y - 1.0).abs() < 1e-15 && (z - 1.0).abs() < 1e-15);
/// ```
#[inline(always)]
pub fn coupled<S: Number, const N: usize>(
    start: [S; N],
    iterations: u32,
    equations: impl Fn([S; N]) -> CoupledEquations<S, N>,
) -> [S; N] {
    let mut search = CoupledSearch::new(start, iterations);
    while !search.is_over().all() {
        search.advance(equations(search.point));
    }
    search.certified(|point| equations(point).1)
}

/// A search for a zero, between two evaluations of the equations.
struct CoupledSearch<S: Number, const N: usize> {
    /// Next point of evaluation.
    point: [S; N],
    /// The last point that was accepted.
    base: [S; N],
    /// The Newton correction there, which is subtracted.
    step: [S; N],
    /// The inverse of the Jacobian there, with rows divided by the scales.
    inverse: [[S; N]; N],
    /// Units of the residuals there.
    scales: [S; N],
    /// Reciprocals of the units of the unknowns there.
    weights: [S; N],
    /// One for residuals with a rounding error there, and zero for exact ones.
    rounds: [S; N],
    /// The sum of the squares of the step, relative to the units of the unknowns.
    size: S,
    /// The fraction of the step that is tried.
    part: S,
    /// Number of remaining steps.
    left: S,
    is_found: S::Mask,
    has_failed: S::Mask,
    /// Residuals up to this are of rounding size, in units of the rounding error.
    noise: S,
}

impl<S: Number, const N: usize> CoupledSearch<S, N> {
    #[inline(always)]
    fn new(start: [S; N], iterations: u32) -> CoupledSearch<S, N> {
        let no = S::Mask::splat(false);
        CoupledSearch {
            point: start,
            base: start,
            step: [S::ZERO; N],
            inverse: [[S::ZERO; N]; N],
            scales: [S::ONE; N],
            weights: [S::ZERO; N],
            rounds: [S::ONE; N],
            size: S::ZERO,
            part: S::ONE,
            left: S::from_f64(f64::from(iterations)),
            is_found: no,
            has_failed: no,
            noise: S::from_f64(TOLERANCE) * spacing_at_one(),
        }
    }

    /// True if the search has ended.
    #[inline(always)]
    fn is_over(&self) -> S::Mask {
        self.is_found | self.has_failed
    }

    /// Continues with the equations at the point.
    #[inline(always)]
    fn advance(&mut self, equations: CoupledEquations<S, N>) {
        let (residuals, _, rounding) = &equations;
        let (mut is_small, mut is_finite) = (S::Mask::splat(true), S::Mask::splat(true));
        for (residual, rounding) in residuals.iter().zip(rounding) {
            is_small = is_small & residual.abs().less_equal(self.noise * *rounding);
            is_finite = is_finite & rounding.less(S::from_f64(f64::INFINITY));
        }
        let wanted = self.size * (S::ONE - S::from_f64(LEAST_DECREASE) * self.part);
        let next = image(&self.inverse, &from_fn(|i| residuals[i] / self.scales[i]));
        let is_better = squares(&next, &self.weights).less_equal(wanted) | is_small;
        let is_open = !self.is_over();
        let (accepted, rejected) = (is_open & is_better & is_finite, is_open & !(is_better & is_finite));
        self.has_failed = self.has_failed | (rejected & self.part.less(S::from_f64(SHORTEST)));
        self.part = S::select(accepted, S::ONE, S::select(rejected, S::from_f64(0.5) * self.part, self.part));
        if accepted.any() {
            self.accept(accepted, is_small, equations);
        }
        self.point = after(&self.base, self.part, &self.step);
    }

    /// Accepts the point as the base of the next step.
    #[inline(always)]
    fn accept(&mut self, accepted: S::Mask, is_small: S::Mask, equations: CoupledEquations<S, N>) {
        let (residuals, jacobian, rounding) = equations;
        let is_rounded = rounding.map(|rounding| S::ZERO.less(rounding));
        let scales = from_fn(|i| S::select(is_rounded[i], rounding[i], S::ONE));
        let (inverse, _) = inverted(scaled(jacobian, &scales));
        let step = image(&inverse, &from_fn(|i| residuals[i] / scales[i]));
        let mut is_regular = S::Mask::splat(true);
        for (row, length) in inverse.iter().zip(&step) {
            let largest = magnitude(row, &[S::ONE; N]) + length.abs();
            is_regular = is_regular & largest.less(S::from_f64(f64::INFINITY));
        }
        self.left = S::select(accepted, self.left - S::ONE, self.left);
        let is_exhausted = self.left.less_equal(S::ZERO) & !is_small;
        self.is_found = self.is_found | (accepted & is_small & is_regular);
        self.has_failed = self.has_failed | (accepted & (is_exhausted | !is_regular));
        let rounds = is_rounded.map(|is_rounded| S::select(is_rounded, S::ONE, S::ZERO));
        let units: [S; N] = from_fn(|i| self.point[i].abs() + step[i].abs());
        let weights = units.map(|unit| S::select(S::ZERO.less(unit), S::ONE / unit, S::ZERO));
        self.size = S::select(accepted, squares(&step, &weights), self.size);
        self.weights = chosen(accepted, weights, self.weights);
        self.base = chosen(accepted, self.point, self.base);
        self.step = chosen(accepted, step, self.step);
        self.scales = chosen(accepted, scales, self.scales);
        self.rounds = chosen(accepted, rounds, self.rounds);
        self.inverse = from_fn(|i| chosen(accepted, inverse[i], self.inverse[i]));
    }

    /// Returns the point one step further; NaN if it is not a zero.
    #[inline(always)]
    fn certified(&self, jacobian: impl Fn([S; N]) -> [[S; N]; N]) -> [S; N] {
        let root = after(&self.base, S::ONE, &self.step);
        let mut is_zero = self.is_found;
        for (row, value) in self.inverse.iter().zip(&root) {
            let hidden = self.noise * magnitude(row, &self.rounds);
            let certain = S::from_f64(CERTAIN) * spacing_at_one::<S>() * value.abs();
            let is_doubtful = is_zero & !hidden.less_equal(certain);
            if is_doubtful.any() {
                let width = S::from_f64(ASIDE) * self.noise;
                let signed = |i: usize| S::select(row[i].less(S::ZERO), -self.rounds[i], self.rounds[i]);
                let aside = image(&self.inverse, &from_fn(signed));
                for width in [width, -width] {
                    let beside = jacobian(after(&root, width, &aside));
                    is_zero = is_zero & (self.is_oriented_alike(beside) | !is_doubtful);
                }
            }
        }
        root.map(|value| S::select(is_zero, value, S::NAN))
    }

    /// True if a Jacobian has the same orientation as at the last point, and a similar volume.
    #[inline(always)]
    fn is_oriented_alike(&self, jacobian: [[S; N]; N]) -> S::Mask {
        let beside = scaled(jacobian, &self.scales);
        let column = |j: usize| image(&self.inverse, &from_fn(|i| beside[i][j]));
        let (_, orientation) = inverted(from_fn(column));
        let bend = S::from_f64(MAX_BEND);
        orientation.less(bend) & S::ONE.less(bend * orientation)
    }
}

/// Computes Σ (a b)².
#[inline(always)]
fn squares<S: Number, const N: usize>(a: &[S; N], b: &[S; N]) -> S {
    a.iter().zip(b).fold(S::ZERO, |sum, (&a, &b)| sum + (a * b) * (a * b))
}

/// Computes Σ |a b|.
#[inline(always)]
fn magnitude<S: Number, const N: usize>(a: &[S; N], b: &[S; N]) -> S {
    a.iter().zip(b).fold(S::ZERO, |sum, (&a, &b)| sum + (a * b).abs())
}

/// Computes A v.
#[inline(always)]
fn image<S: Number, const N: usize>(rows: &[[S; N]; N], vector: &[S; N]) -> [S; N] {
    from_fn(|i| rows[i].iter().zip(vector).fold(S::ZERO, |sum, (&entry, &value)| sum + entry * value))
}

/// Returns the rows, each divided by its scale.
#[inline(always)]
fn scaled<S: Number, const N: usize>(rows: [[S; N]; N], scales: &[S; N]) -> [[S; N]; N] {
    from_fn(|i| rows[i].map(|entry| entry / scales[i]))
}

/// Computes x − part · step.
#[inline(always)]
fn after<S: Number, const N: usize>(x: &[S; N], part: S, step: &[S; N]) -> [S; N] {
    from_fn(|i| x[i] - part * step[i])
}

#[inline(always)]
fn chosen<S: Number, const N: usize>(mask: S::Mask, then: [S; N], otherwise: [S; N]) -> [S; N] {
    from_fn(|i| S::select(mask, then[i], otherwise[i]))
}

/// Computes the inverse of a matrix, by elimination with the largest pivot of each column, and its
/// determinant. For a singular matrix, entries are not finite.
#[inline(always)]
fn inverted<S: Number, const N: usize>(matrix: [[S; N]; N]) -> ([[S; N]; N], S) {
    let unit = |i: usize, j: usize| if i == j { S::ONE } else { S::ZERO };
    let mut rows: [[[S; N]; 2]; N] = from_fn(|i| [matrix[i], from_fn(|j| unit(i, j))]);
    let mut determinant = S::ONE;
    for k in 0..N {
        for i in k + 1..N {
            let (upper, lower) = (rows[k], rows[i]);
            let is_larger = upper[0][k].abs().less(lower[0][k].abs());
            rows[k] = from_fn(|half| chosen(is_larger, lower[half], upper[half]));
            rows[i] = from_fn(|half| chosen(is_larger, upper[half], lower[half]));
            determinant = S::select(is_larger, -determinant, determinant);
        }
        let pivot = rows[k][0][k];
        determinant = determinant * pivot;
        let of_pivot = rows[k].map(|half| half.map(|entry| entry / pivot));
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = row[0][k];
            *row = match i == k {
                true => of_pivot,
                false => from_fn(|half| after(&row[half], factor, &of_pivot[half])),
            };
        }
    }
    (rows.map(|[_, inverse]| inverse), determinant)
}
