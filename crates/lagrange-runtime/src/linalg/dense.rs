//! Matrices whose size is known at run time, and linear equations with them.

use core::ops::{Index, IndexMut};
use std::vec::Vec;

/// A matrix of `f64` in rows, whose size is known at run time.
///
/// ```
/// use lagrange::linear::DenseMatrix;
///
/// let matrix = DenseMatrix::from_rows(&[[1.0, 2.0], [3.0, 4.0]]);
/// assert_eq!(matrix.times(&matrix).row(0), [7.0, 10.0]);
/// assert_eq!(matrix[(1, 0)], 3.0);
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct DenseMatrix {
    columns: usize,
    rows: usize,
    entries: Vec<f64>,
}

impl DenseMatrix {
    /// Creates the zero matrix of this size.
    #[must_use]
    pub fn zeros(rows: usize, columns: usize) -> DenseMatrix {
        DenseMatrix { columns, rows, entries: std::vec![0.0; rows * columns] }
    }

    /// Creates the square matrix with these entries on its diagonal, and zeros elsewhere.
    #[must_use]
    pub fn diagonal(entries: &[f64]) -> DenseMatrix {
        let mut matrix = DenseMatrix::zeros(entries.len(), entries.len());
        entries.iter().enumerate().for_each(|(i, entry)| matrix[(i, i)] = *entry);
        matrix
    }

    /// Creates the identity matrix with this number of rows.
    #[must_use]
    pub fn identity(rows: usize) -> DenseMatrix {
        DenseMatrix::diagonal(&std::vec![1.0; rows])
    }

    /// Creates the matrix with these rows.
    #[must_use]
    pub fn from_rows<const N: usize>(rows: &[[f64; N]]) -> DenseMatrix {
        DenseMatrix { columns: N, rows: rows.len(), entries: rows.concat() }
    }

    /// Creates the matrix of this size whose entries are functions of their row and column.
    #[must_use]
    pub fn from_fn(rows: usize, columns: usize, mut entry: impl FnMut(usize, usize) -> f64) -> DenseMatrix {
        let mut matrix = DenseMatrix::zeros(rows, columns);
        for i in 0..rows {
            for j in 0..columns {
                matrix[(i, j)] = entry(i, j);
            }
        }
        matrix
    }

    /// Returns the number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Returns the number of columns.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Returns a row.
    ///
    /// # Panics
    /// If there is no such row.
    #[must_use]
    pub fn row(&self, index: usize) -> &[f64] {
        &self.entries[index * self.columns..(index + 1) * self.columns]
    }

    /// Returns a column.
    ///
    /// # Panics
    /// If there is no such column.
    #[must_use]
    pub fn column(&self, index: usize) -> Vec<f64> {
        (0..self.rows).map(|row| self[(row, index)]).collect()
    }

    /// Returns the transpose.
    #[must_use]
    pub fn transposed(&self) -> DenseMatrix {
        DenseMatrix::from_fn(self.columns, self.rows, |i, j| self[(j, i)])
    }

    /// Multiplies by a matrix whose number of rows equals the number of columns of this one.
    ///
    /// # Panics
    /// If these numbers differ.
    #[must_use]
    pub fn times(&self, other: &DenseMatrix) -> DenseMatrix {
        assert_eq!(self.columns, other.rows, "the factors of a product do not fit");
        DenseMatrix::from_fn(self.rows, other.columns, |i, j| {
            self.row(i).iter().enumerate().fold(0.0, |sum, (k, entry)| sum + entry * other[(k, j)])
        })
    }

    /// Adds a multiple of a matrix with the same size.
    ///
    /// # Panics
    /// If the sizes differ.
    #[must_use]
    pub fn plus(&self, factor: f64, other: &DenseMatrix) -> DenseMatrix {
        assert_eq!((self.rows, self.columns), (other.rows, other.columns), "the terms of a sum do not fit");
        DenseMatrix::from_fn(self.rows, self.columns, |i, j| self[(i, j)] + factor * other[(i, j)])
    }

    /// Multiplies all entries by a number.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> DenseMatrix {
        DenseMatrix::from_fn(self.rows, self.columns, |i, j| factor * self[(i, j)])
    }

    /// Returns the largest magnitude of an entry; NaN if any entry is NaN.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let larger =
            |most: f64, entry: &f64| if entry.abs() <= most { most } else { most + (entry.abs() - most) };
        self.entries.iter().fold(0.0, larger)
    }

    /// True if no entry is NaN or infinite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.entries.iter().all(|entry| entry.is_finite())
    }

    /// Returns the solution x of A x = b. `None` if a pivot is zero or not finite, or if A is
    /// not square and as long as b.
    ///
    /// ```
    /// use lagrange::linear::DenseMatrix;
    ///
    /// let matrix = DenseMatrix::from_rows(&[[1.0, 2.0], [3.0, 4.0]]);
    /// assert_eq!(matrix.solve(&[5.0, 11.0]), Some(vec![1.0, 2.0]));
    /// assert_eq!(DenseMatrix::zeros(2, 2).solve(&[1.0, 0.0]), None);
    /// ```
    #[cfg(any(feature = "linear", test))]
    #[must_use]
    pub fn solve(&self, b: &[f64]) -> Option<Vec<f64>> {
        let fits = self.rows == self.columns && self.rows == b.len();
        Some(TriangularFactors::new(fits.then(|| self.clone())?, 0.0)?.solve(b))
    }

    /// Returns the submatrix with these rows and columns.
    pub(crate) fn part(&self, rows: &[usize], columns: &[usize]) -> DenseMatrix {
        DenseMatrix::from_fn(rows.len(), columns.len(), |i, j| self[(rows[i], columns[j])])
    }
}

impl Index<(usize, usize)> for DenseMatrix {
    type Output = f64;

    #[inline]
    fn index(&self, (row, column): (usize, usize)) -> &f64 {
        &self.entries[row * self.columns + column]
    }
}

impl IndexMut<(usize, usize)> for DenseMatrix {
    #[inline]
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut f64 {
        &mut self.entries[row * self.columns + column]
    }
}

/// Triangular factors of a regular square matrix, with the rows in the order of the pivots.
#[cfg(any(feature = "linear", test))]
pub(crate) struct TriangularFactors {
    factors: DenseMatrix,
    order: Vec<usize>,
}

#[cfg(any(feature = "linear", test))]
impl TriangularFactors {
    /// Eliminates with the largest pivot of each column. `None` if a pivot is zero or not finite.
    /// The magnitude `least` replaces smaller pivots, for matrices that are singular by design.
    pub(crate) fn new(mut a: DenseMatrix, least: f64) -> Option<TriangularFactors> {
        let n = a.rows;
        let mut order = (0..n).collect::<Vec<_>>();
        for k in 0..n {
            let larger = |best: usize, i| if a[(i, k)].abs() > a[(best, k)].abs() { i } else { best };
            let pivot = (k..n).fold(k, larger);
            order.swap(k, pivot);
            for j in 0..n {
                let upper = a[(k, j)];
                a[(k, j)] = a[(pivot, j)];
                a[(pivot, j)] = upper;
            }
            if a[(k, k)].abs() < least {
                a[(k, k)] = least;
            }
            if a[(k, k)] == 0.0 || !a[(k, k)].is_finite() {
                return None;
            }
            for i in k + 1..n {
                let multiple = a[(i, k)] / a[(k, k)];
                a[(i, k)] = multiple;
                for j in k + 1..n {
                    a[(i, j)] -= multiple * a[(k, j)];
                }
            }
        }
        Some(TriangularFactors { factors: a, order })
    }

    /// Solves A x = b.
    pub(crate) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let (a, n) = (&self.factors, self.order.len());
        let mut x = self.order.iter().map(|&row| b[row]).collect::<Vec<_>>();
        for i in 0..n {
            x[i] = (0..i).fold(x[i], |sum, j| sum - a[(i, j)] * x[j]);
        }
        for i in (0..n).rev() {
            x[i] = (i + 1..n).fold(x[i], |sum, j| sum - a[(i, j)] * x[j]) / a[(i, i)];
        }
        x
    }

    /// Returns A⁻¹ B.
    pub(crate) fn solve_columns(&self, b: &DenseMatrix) -> DenseMatrix {
        let columns = (0..b.columns).map(|j| self.solve(&b.column(j))).collect::<Vec<_>>();
        DenseMatrix::from_fn(b.rows, b.columns, |i, j| columns[j][i])
    }

    /// Returns the mean logarithm of the pivot magnitudes.
    pub(crate) fn mean_log(&self) -> f64 {
        let n = self.order.len();
        (0..n).fold(0.0, |sum, k| sum + self.factors[(k, k)].abs().ln()) / n as f64
    }
}

#[cfg(test)]
mod tests {
    use super::{DenseMatrix, TriangularFactors};

    #[test]
    fn equations_are_solved_with_any_order_of_rows() {
        let matrix = DenseMatrix::from_rows(&[[0.0, 2.0, 1.0], [4.0, 0.0, 0.0], [1.0, 1.0, 0.0]]);
        let factors = TriangularFactors::new(matrix, 0.0).expect("regular");
        assert_eq!(factors.solve(&[7.0, 4.0, 3.0]), [1.0, 2.0, 3.0]);
        assert!((factors.mean_log() - 4.0_f64.ln() / 3.0).abs() < 1e-15);
    }

    #[test]
    fn equations_of_another_shape_have_no_solution() {
        let matrix = DenseMatrix::identity(2);
        assert_eq!(matrix.solve(&[3.0, 4.0]), Some(std::vec![3.0, 4.0]));
        assert!(matrix.solve(&[3.0]).is_none() && DenseMatrix::zeros(2, 1).solve(&[1.0, 1.0]).is_none());
        assert_eq!(DenseMatrix::zeros(0, 0).solve(&[]), Some(std::vec![]));
    }

    #[test]
    fn singular_and_undefined_matrices_have_no_factors() {
        let singular = [[1.0, 2.0], [2.0, 4.0]];
        assert!(TriangularFactors::new(DenseMatrix::from_rows(&singular), 0.0).is_none());
        assert!(TriangularFactors::new(DenseMatrix::from_rows(&[[f64::NAN]]), 0.0).is_none());
    }

    #[test]
    fn the_largest_entry_of_an_undefined_matrix_is_undefined() {
        assert_eq!(DenseMatrix::from_rows(&[[1.0, -3.0, 2.0]]).largest(), 3.0);
        assert!(DenseMatrix::from_rows(&[[1.0, f64::NAN, 2.0]]).largest().is_nan());
    }
}
