//! Eigenvalues of real matrices: balancing, reduction to Hessenberg form, and Francis's implicit
//! double shifts.
//!
//! Sources: Parlett, Reinsch, *Balancing a matrix for calculation of eigenvalues and eigenvectors*,
//! Numer. Math. 13 (1969) 293–304; Golub, Van Loan, *Matrix Computations*, 4th ed., §7.4.2, §7.5;
//! exceptional shifts: Martin, Peters, Wilkinson, *The QR algorithm for real Hessenberg matrices*,
//! Numer. Math. 14 (1970) 219–231.
//!
//! Example: H = [6 −11 6; 1 0 0; 0 1 0], the companion matrix of (λ − 1)(λ − 2)(λ − 3). Its last
//! two rows and columns have the trace s = 0 and the determinant t = 0. The first column of H² − s
//! H + t I is (25, 6, 1). The first reflection maps it onto an axis, and another one restores the
//! Hessenberg form. The entry below the diagonal that shrinks fastest is the last one.

use super::dense::DenseMatrix;
use super::singular_values::{dot, length};
use std::vec::Vec;

/// Maximum number of steps for one eigenvalue; usually two or three suffice.
const MAX_STEPS: usize = 60;
/// Number of steps between exceptional shifts.
const STEPS_OF_A_CYCLE: usize = 10;

/// The real and imaginary parts of an eigenvalue.
pub(crate) type Eigenvalue = (f64, f64);

impl DenseMatrix {
    /// Computes the real and imaginary parts of the eigenvalues. Complex ones are in pairs, with
    /// the positive imaginary part first. `None` if an entry is not finite.
    ///
    /// # Panics
    /// If the matrix is not square.
    #[must_use]
    pub fn eigenvalues(&self) -> Option<Vec<(f64, f64)>> {
        assert_eq!(self.rows(), self.columns(), "eigenvalues are those of square matrices");
        eigenvalues(self)
    }
}

/// Computes the eigenvalues of a square matrix, complex ones in pairs with the positive imaginary
/// part first. `None` if an entry is not finite, or if the iteration does not converge.
pub(crate) fn eigenvalues(a: &DenseMatrix) -> Option<Vec<Eigenvalue>> {
    let largest = a.largest();
    if !largest.is_finite() {
        return None;
    }
    // A power of two, so that scaling is exact.
    let scale = if largest == 0.0 { 1.0 } else { 2.0_f64.powi(largest.log2().floor() as i32) };
    let (mut h, _) = balanced(a.scaled(1.0 / scale));
    reduce(&mut h);
    let found = deflated(&mut h)?;
    Some(found.into_iter().map(|(real, imaginary)| (scale * real, scale * imaginary)).collect())
}

/// Scales rows and columns by powers of two until their norms are similar: D⁻¹ A D, with the
/// diagonal D.
pub(crate) fn balanced(mut a: DenseMatrix) -> (DenseMatrix, Vec<f64>) {
    let n = a.rows();
    let mut scales = std::vec![1.0; n];
    let mut is_done = false;
    while !is_done {
        is_done = true;
        for i in 0..n {
            let others = || (0..n).filter(|&j| j != i);
            let column = others().fold(0.0, |sum, j| sum + a[(j, i)].abs());
            let row = others().fold(0.0, |sum, j| sum + a[(i, j)].abs());
            if column == 0.0 || row == 0.0 {
                continue;
            }
            let factor = 2.0_f64.powi(((row / column).log2() / 2.0).round() as i32);
            if column * factor + row / factor < 0.95 * (column + row) {
                is_done = false;
                scales[i] *= factor;
                (0..n).for_each(|j| a[(i, j)] /= factor);
                (0..n).for_each(|j| a[(j, i)] *= factor);
            }
        }
    }
    (a, scales)
}

/// Reduces a matrix to Hessenberg form: zeros below the first subdiagonal.
fn reduce(a: &mut DenseMatrix) {
    let n = a.rows();
    for k in 1..n.saturating_sub(1) {
        let column = (k..n).map(|i| a[(i, k - 1)]).collect::<Vec<_>>();
        if let Some(reflection) = Reflection::onto_axis(&column) {
            reflection.apply(a, k, k - 1..n, 0..n);
        }
        (k + 1..n).for_each(|i| a[(i, k - 1)] = 0.0);
    }
}

/// The reflection I − v vᵀ, with |v|² = 2.
struct Reflection(Vec<f64>);

impl Reflection {
    /// Returns the reflection that maps x onto the first axis; `None` if x is already there.
    fn onto_axis(x: &[f64]) -> Option<Reflection> {
        if x[1..].iter().all(|entry| *entry == 0.0) {
            return None;
        }
        let mut v = x.to_vec();
        v[0] += length(x).copysign(x[0]);
        let size = length(&v) / 2.0_f64.sqrt();
        v.iter_mut().for_each(|entry| *entry /= size);
        Some(Reflection(v))
    }

    /// Applies the reflection from both sides to the rows and columns starting at `first`.
    fn apply(
        &self,
        a: &mut DenseMatrix,
        first: usize,
        columns: core::ops::Range<usize>,
        rows: core::ops::Range<usize>,
    ) {
        let mut line = std::vec![0.0; self.0.len()];
        for j in columns {
            line.iter_mut().enumerate().for_each(|(i, entry)| *entry = a[(first + i, j)]);
            let share = dot(&self.0, &line);
            self.0.iter().enumerate().for_each(|(i, entry)| a[(first + i, j)] -= share * entry);
        }
        for i in rows {
            line.iter_mut().enumerate().for_each(|(j, entry)| *entry = a[(i, first + j)]);
            let share = dot(&self.0, &line);
            self.0.iter().enumerate().for_each(|(j, entry)| a[(i, first + j)] -= share * entry);
        }
    }
}

/// Computes the eigenvalues of a Hessenberg matrix, one or two at a time from its end.
fn deflated(h: &mut DenseMatrix) -> Option<Vec<Eigenvalue>> {
    let (mut found, mut end, mut steps) = (Vec::new(), h.rows(), 0);
    while end > 0 {
        let start = (1..end).rev().find(|&row| is_negligible(h, row)).unwrap_or(0);
        if start > 0 {
            h[(start, start - 1)] = 0.0;
        }
        match end - start {
            1 => found.push((h[(start, start)], 0.0)),
            2 => found.extend(of_two(h, start)),
            _ if steps == MAX_STEPS => return None,
            _ => {
                steps += 1;
                double_shift(h, start, end, steps % STEPS_OF_A_CYCLE == 0);
                continue;
            }
        }
        (end, steps) = (start, 0);
    }
    Some(found)
}

/// True if the subdiagonal entry in this row is a rounding error relative to its neighbours.
fn is_negligible(h: &DenseMatrix, row: usize) -> bool {
    let neighbours = h[(row - 1, row - 1)].abs() + h[(row, row)].abs();
    let size = if neighbours == 0.0 { 1.0 } else { neighbours };
    h[(row, row - 1)].abs() <= f64::EPSILON * size
}

/// Computes the eigenvalues of two rows and columns.
fn of_two(h: &DenseMatrix, k: usize) -> [Eigenvalue; 2] {
    let (a, b, c, d) = (h[(k, k)], h[(k, k + 1)], h[(k + 1, k)], h[(k + 1, k + 1)]);
    let half = (a - d) / 2.0;
    let square = half * half + b * c;
    if square < 0.0 {
        return [(d + half, (-square).sqrt()), (d + half, -(-square).sqrt())];
    }
    let larger = half + square.sqrt().copysign(half);
    let smaller = if larger == 0.0 { 0.0 } else { -b * c / larger };
    [(d + larger, 0.0), (d + smaller, 0.0)]
}

/// Performs one step with two shifts in the rows from `start` to `end`, of which there must be at
/// least three. The shifts are the eigenvalues of the last two rows.
fn double_shift(h: &mut DenseMatrix, start: usize, end: usize, is_exceptional: bool) {
    let last = end - 1;
    let (mut s, mut t) = (
        h[(last - 1, last - 1)] + h[(last, last)],
        h[(last - 1, last - 1)] * h[(last, last)] - h[(last - 1, last)] * h[(last, last - 1)],
    );
    if is_exceptional {
        let size = h[(last, last - 1)].abs() + h[(last - 1, last - 2)].abs();
        (s, t) = (1.5 * size, size * size);
    }
    let (a, b, c) = (h[(start, start)], h[(start, start + 1)], h[(start + 1, start)]);
    let d = h[(start + 1, start + 1)];
    // The first column of H² − s H + t I.
    let mut bulge = std::vec![a * (a - s) + b * c + t, c * (a + d - s), c * h[(start + 2, start + 1)]];
    for k in start..last {
        let before = k.max(start + 1) - 1;
        if let Some(reflection) = Reflection::onto_axis(&bulge) {
            reflection.apply(h, k, before..end, start..end.min(k + 4));
        }
        bulge = (k + 1..end.min(k + 4)).map(|i| h[(i, k)]).collect();
        if k > start {
            (k + 1..end.min(k + 3)).for_each(|i| h[(i, k - 1)] = 0.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{DenseMatrix, Eigenvalue, eigenvalues};
    use std::vec::Vec;

    fn sorted(matrix: &DenseMatrix) -> Vec<Eigenvalue> {
        let mut found = eigenvalues(matrix).expect("finite");
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        found
    }

    #[test]
    fn the_worked_example_holds() {
        let companion = DenseMatrix::from_rows(&[[6.0, -11.0, 6.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        for ((real, imaginary), wanted) in sorted(&companion).into_iter().zip([1.0, 2.0, 3.0]) {
            assert!((real - wanted).abs() < 1e-13 && imaginary == 0.0, "{real} {imaginary}");
        }
    }

    #[test]
    fn a_cyclic_permutation_has_roots_of_one() {
        // Its shifts are zero, so only exceptional shifts make progress.
        let n = 8;
        let cycle = DenseMatrix::from_fn(n, n, |i, j| if (i + 1) % n == j { 1.0 } else { 0.0 });
        for (real, imaginary) in eigenvalues(&cycle).expect("finite") {
            let turns = imaginary.atan2(real) / std::f64::consts::TAU * n as f64;
            assert!((real.hypot(imaginary) - 1.0).abs() < 1e-14, "{real} {imaginary}");
            assert!((turns - turns.round()).abs() < 1e-13, "{turns}");
        }
    }

    #[test]
    fn units_of_the_variables_do_not_matter() {
        let units = [1e-9, 1.0, 1e7, 1e3];
        let plain = DenseMatrix::from_fn(4, 4, |i, j| 1.0 / (1.0 + (3 * i + j * j) as f64));
        let scaled = DenseMatrix::from_fn(4, 4, |i, j| plain[(i, j)] * units[i] / units[j]);
        for (found, wanted) in sorted(&scaled).into_iter().zip(sorted(&plain)) {
            assert!((found.0 - wanted.0).abs() < 1e-14 && (found.1 - wanted.1).abs() < 1e-14);
        }
    }

    #[test]
    fn extreme_sizes_and_undefined_entries_are_told_apart() {
        let huge = DenseMatrix::from_rows(&[[0.0, 1e300], [-1e300, 0.0]]);
        assert_eq!(sorted(&huge), [(0.0, -1e300), (0.0, 1e300)]);
        assert_eq!(sorted(&DenseMatrix::zeros(2, 2)), [(0.0, 0.0), (0.0, 0.0)]);
        assert!(eigenvalues(&DenseMatrix::from_rows(&[[f64::NAN]])).is_none());
        assert_eq!(eigenvalues(&DenseMatrix::zeros(0, 0)), Some(Vec::new()));
    }
}
