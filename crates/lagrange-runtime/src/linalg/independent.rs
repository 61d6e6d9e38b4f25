//! Independent columns of a tall matrix, and the combinations that yield the others.
//!
//! Householder reflections bring columns to triangular form. Each step takes the first column whose
//! remainder is not much smaller than the largest. The order of columns is thus a preference, and
//! the factors remain well conditioned. Source: Golub, Van Loan, *Matrix Computations*, 4th ed.,
//! §5.4.2. Sparse matrices are factored with a similar threshold.

use std::vec::Vec;

use super::dense::DenseMatrix;
use super::orthogonal::{applied, reflector};
use super::singular_values::length;

/// Minimum remainder of a column, relative to the largest remainder, to be taken first.
const PRECEDENCE: f64 = 0.05;

/// The triangular factor R of columns, in pivot order.
#[derive(Clone, Debug)]
pub(crate) struct IndependentColumns {
    /// The column taken k-th. For independent columns, it contains entries of R above the diagonal
    /// and the reflection below. For dependent columns, all its entries belong to R.
    columns: Vec<Vec<f64>>,
    diagonal: Vec<f64>,
    order: Vec<usize>,
}

impl IndependentColumns {
    /// Factors columns of similar lengths. Columns with a remainder of at most `tolerance` are
    /// dependent.
    pub(crate) fn of(mut columns: Vec<Vec<f64>>, tolerance: f64) -> IndependentColumns {
        let rows = columns.first().map_or(0, Vec::len);
        let mut order = (0..columns.len()).collect::<Vec<_>>();
        let mut diagonal = Vec::new();
        for k in 0..rows.min(columns.len()) {
            let left = columns[k..].iter().map(|column| length(&column[k..])).collect::<Vec<_>>();
            let most = left.iter().fold(0.0, |most: f64, left| most.max(*left));
            if most <= tolerance {
                break;
            }
            let pivot = left.iter().position(|left| *left > PRECEDENCE * most).unwrap_or_default();
            // The others keep their order.
            columns[k..=k + pivot].rotate_right(1);
            order[k..=k + pivot].rotate_right(1);
            let (taken, others) = columns[k..].split_at_mut(1);
            diagonal.push(reflector(&mut taken[0][k..], left[pivot]));
            others.iter_mut().for_each(|other| applied(&taken[0][k..], &mut other[k..]));
        }
        IndependentColumns { columns, diagonal, order }
    }

    /// Returns the indices of the independent columns.
    pub(crate) fn independent(&self) -> &[usize] {
        &self.order[..self.diagonal.len()]
    }

    /// Returns the index of each dependent column, with the coefficients of the independent ones
    /// that add up to it.
    pub(crate) fn dependent(&self) -> impl Iterator<Item = (usize, Vec<f64>)> {
        let rank = self.diagonal.len();
        (rank..self.order.len()).map(move |l| (self.order[l], self.back(self.columns[l][..rank].to_vec())))
    }

    /// Returns the coefficients of the independent columns whose sum is as close as possible to
    /// `right`.
    pub(crate) fn combination(&self, mut right: Vec<f64>) -> Vec<f64> {
        let rank = self.diagonal.len();
        for (k, column) in self.columns[..rank].iter().enumerate() {
            applied(&column[k..], &mut right[k..]);
        }
        right.truncate(rank);
        self.back(right)
    }

    /// Returns (RᵀR)⁻¹ of the independent columns.
    pub(crate) fn inverse_gram(&self) -> DenseMatrix {
        let rank = self.diagonal.len();
        let unit = |i: usize| (0..rank).map(|k| f64::from(u8::from(k == i))).collect::<Vec<_>>();
        // Rows of R⁻¹ᵀ.
        let inverse = (0..rank).map(|i| self.back(unit(i))).collect::<Vec<_>>();
        let product = |i: usize, j: usize| inverse.iter().map(|row| row[i] * row[j]).sum();
        DenseMatrix::from_fn(rank, rank, product)
    }

    /// Computes R⁻¹ x.
    fn back(&self, mut x: Vec<f64>) -> Vec<f64> {
        for k in (0..self.diagonal.len()).rev() {
            x[k] /= self.diagonal[k];
            for i in 0..k {
                x[i] -= self.columns[k][i] * x[k];
            }
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::IndependentColumns;
    use std::vec;

    #[test]
    fn first_columns_are_taken_before_those_that_depend_on_them() {
        let columns = vec![vec![3.0, 0.0, 4.0], vec![0.0, 2.0, 0.0], vec![6.0, -2.0, 8.0], vec![0.0; 3]];
        let found = IndependentColumns::of(columns, 1e-12);
        assert_eq!(found.independent(), [0, 1]);
        for (index, amounts) in found.dependent() {
            let wanted = if index == 2 { [2.0, -1.0] } else { [0.0, 0.0] };
            assert!(amounts.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-15), "{index} {amounts:?}");
        }
        let amounts = found.combination(vec![1.5, 4.0, 2.0]);
        assert!((amounts[0] - 0.5).abs() < 1e-15 && (amounts[1] - 2.0).abs() < 1e-15);
        let gram = found.inverse_gram();
        assert!((gram[(0, 0)] - 0.04).abs() < 1e-16 && (gram[(1, 1)] - 0.25).abs() < 1e-16);
        assert!(gram[(0, 1)].abs() < 1e-16);
    }

    #[test]
    fn what_nearly_depends_is_taken_last() {
        let columns = vec![vec![1.0, 0.0], vec![1.0, 1e-3], vec![0.0, 1.0]];
        assert_eq!(IndependentColumns::of(columns, 1e-12).independent(), [0, 2]);
    }

    #[test]
    fn there_may_be_no_columns_or_no_rows() {
        assert!(IndependentColumns::of(vec![], 1e-12).independent().is_empty());
        assert!(IndependentColumns::of(vec![vec![], vec![]], 1e-12).independent().is_empty());
    }
}
