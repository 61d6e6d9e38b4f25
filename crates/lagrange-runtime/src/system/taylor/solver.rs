//! The linear equations of accelerations and multipliers, which are the same for every order.

use crate::linalg::pivoted::{Factors, Matrix};
use crate::linalg::vector::StateVector;
use crate::scalar::{Number, Scalar, product_sum};

/// The negative inverse of the matrix of accelerations and multipliers in the residuals, in
/// columns, for every order.
#[derive(Clone, Copy, Debug)]
pub struct SeriesSolver<S, const N: usize>([[S; N]; N]);

impl<S: Scalar, const N: usize> SeriesSolver<S, N> {
    /// Inverts a matrix, given row by row; the inverse of a singular one is NaN.
    pub fn new<const ENTRIES: usize>(mut entries: [S; ENTRIES]) -> Self {
        negative_inverse(&mut entries, &[S::ZERO; N]);
        Self::of_columns(&entries)
    }
}

impl<S: Number, const N: usize> SeriesSolver<S, N> {
    /// Inverts a positive definite matrix, which needs no pivoting.
    #[inline(always)]
    pub fn definite<const ENTRIES: usize>(mut entries: [S; ENTRIES]) -> Self {
        negative_inverse_of_definite(&mut entries, N);
        Self::of_columns(&entries)
    }

    #[inline(always)]
    fn of_columns(entries: &[S]) -> Self {
        let mut columns = [[S::ZERO; N]; N];
        for (column, entries) in columns.iter_mut().zip(entries.chunks_exact(N.max(1))) {
            column.copy_from_slice(entries);
        }
        SeriesSolver(columns)
    }

    /// Computes (a, λ) = −M⁻¹ r.
    #[inline(always)]
    pub fn accelerations<const FUSED: bool>(&self, residuals: &[S]) -> [S; N] {
        let mut sums = [S::ZERO; N];
        for (j, (column, residual)) in self.0.iter().zip(residuals).enumerate() {
            for (sum, entry) in sums.iter_mut().zip(column) {
                *sum = if j == 0 {
                    *entry * *residual
                } else {
                    product_sum::<FUSED, S>(*entry, *residual, *sum)
                };
            }
        }
        sums
    }
}

/// Replaces a matrix M, given row by row, by −M⁻¹ in columns; by NaN if it is singular. Vectors
/// have the length of `vector`.
pub fn negative_inverse<S: Scalar, V: StateVector<S>>(entries: &mut [S], vector: &V) {
    let unknowns = vector.as_ref().len();
    let factors = Factors::new(Matrix::zeros(vector).with(|i, j| entries[i * unknowns + j]));
    for (j, column) in entries.chunks_exact_mut(unknowns.max(1)).enumerate() {
        let mut unit = vector.zeros();
        unit.as_mut()[j] = -S::ONE;
        match &factors {
            Some(factors) => column.copy_from_slice(factors.solve(&unit).as_ref()),
            None => column.fill(S::NAN),
        }
    }
}

/// Replaces a positive definite matrix M, given row by row, by −M⁻¹ in columns.
///
/// Gauss–Jordan elimination in place: Peters and Wilkinson, "On the stability of Gauss–Jordan
/// elimination with pivoting", *Communications of the ACM* 18 (1975) 20–24. For the rows (2, 1) and
/// (1, 1), the pivot 2 leads to (1/2, 1/2) and (−1/2, 1/2). The pivot 1/2 then leads to the
/// inverse, (1, −1) and (−1, 2).
#[inline(always)]
pub fn negative_inverse_of_definite<S: Number>(entries: &mut [S], unknowns: usize) {
    let n = unknowns;
    for pivot in 0..n {
        let reciprocal = S::ONE / entries[pivot * n + pivot];
        entries[pivot * n + pivot] = S::ONE;
        for j in 0..n {
            entries[pivot * n + j] = entries[pivot * n + j] * reciprocal;
        }
        for i in (0..n).filter(|i| *i != pivot) {
            let factor = -entries[i * n + pivot];
            entries[i * n + pivot] = S::ZERO;
            for j in 0..n {
                entries[i * n + j] = entries[pivot * n + j].multiply_add(factor, entries[i * n + j]);
            }
        }
    }
    for i in 0..n {
        entries[i * n + i] = -entries[i * n + i];
        for j in 0..i {
            (entries[i * n + j], entries[j * n + i]) = (-entries[j * n + i], -entries[i * n + j]);
        }
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
        let [found, wanted] = [definite, pivoted].map(|solver| solver.accelerations::<false>(&residual));
        for (row, (found, wanted)) in found.iter().zip(wanted).enumerate() {
            assert!((found - wanted).abs() < 1e-15, "{row}");
            let product = (0..3)
                .map(|j| entries[3 * row + j] * definite.accelerations::<false>(&residual)[j])
                .sum::<f64>();
            assert!((product + residual[row]).abs() < 1e-15, "{row}");
        }
    }
}
