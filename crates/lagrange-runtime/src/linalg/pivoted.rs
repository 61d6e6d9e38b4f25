//! Small dense systems of linear equations, real and complex, in arrays of fixed size.
//!
//! Gaussian elimination with partial pivoting, without scaling. A matrix that is singular or not
//! finite has no factors. Source: Golub, Van Loan, *Matrix Computations*, 4th ed., §3.4.

use core::ops::{Index, IndexMut, Range};

use crate::linalg::vector::{StateVector, dot};
use crate::scalar::Scalar;

/// A square matrix in rows.
#[derive(Debug)]
pub(crate) struct Matrix<S: Scalar, Y: StateVector<S>>(pub(crate) Y::Square);

impl<S: Scalar, Y: StateVector<S>> Clone for Matrix<S, Y> {
    fn clone(&self) -> Self {
        Matrix(self.0.clone())
    }
}

impl<S: Scalar, Y: StateVector<S>> Index<(usize, usize)> for Matrix<S, Y> {
    type Output = S;

    #[inline(always)]
    fn index(&self, (row, column): (usize, usize)) -> &S {
        &self.0.as_ref()[row].as_ref()[column]
    }
}

impl<S: Scalar, Y: StateVector<S>> IndexMut<(usize, usize)> for Matrix<S, Y> {
    #[inline(always)]
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut S {
        &mut self.0.as_mut()[row].as_mut()[column]
    }
}

impl<S: Scalar, Y: StateVector<S>> Matrix<S, Y> {
    pub(crate) const ZERO: Self = Matrix(Y::ZERO_SQUARE);

    /// Returns the number of rows.
    #[inline(always)]
    pub(crate) fn rows(&self) -> usize {
        self.0.as_ref().len()
    }

    /// Creates the matrix with the entry `entry(row, column)` at each row and column.
    #[inline]
    pub(crate) fn of(entry: impl Fn(usize, usize) -> S) -> Self {
        Self::ZERO.with(entry)
    }

    /// Creates the zero matrix for vectors with the length of this one.
    #[inline(always)]
    pub(crate) fn zeros(vector: &Y) -> Self {
        Matrix(vector.zero_square())
    }

    /// Creates the matrix with these entries and the size of this one.
    #[inline]
    pub(crate) fn with(&self, entry: impl Fn(usize, usize) -> S) -> Self {
        let mut matrix = self.clone();
        for row in 0..matrix.rows() {
            for column in 0..matrix.rows() {
                matrix[(row, column)] = entry(row, column);
            }
        }
        matrix
    }

    /// Creates the identity matrix.
    pub(crate) fn identity(vector: &Y) -> Self {
        Self::zeros(vector).with(|row, column| if row == column { S::ONE } else { S::ZERO })
    }

    /// Computes the product with another matrix.
    #[inline]
    pub(crate) fn times(&self, other: &Self) -> Self {
        let rows = 0..self.rows();
        Self::of(|i, j| rows.clone().fold(S::ZERO, |sum, k| self[(i, k)].multiply_add(other[(k, j)], sum)))
    }

    /// Computes the product with a vector.
    #[inline]
    pub(crate) fn apply(&self, x: &Y) -> Y {
        let mut product = x.zeros();
        for (entry, row) in product.as_mut().iter_mut().zip(self.0.as_ref()) {
            *entry = dot(row, x);
        }
        product
    }

    pub(super) fn swap_rows(&mut self, one: usize, other: usize) {
        self.0.as_mut().swap(one, other);
    }
}

/// The factors L and U of a real matrix with exchanged rows.
#[derive(Clone, Debug)]
pub(crate) struct Factors<S: Scalar, Y: StateVector<S>> {
    /// L below the diagonal, without its diagonal of ones, and U above; the reciprocals of pivots
    /// on the diagonal.
    factors: Matrix<S, Y>,
    /// Index of the row with which each row was exchanged.
    exchanged: Y::Indices,
}

impl<S: Scalar, Y: StateVector<S>> Factors<S, Y> {
    /// Factors a matrix; `None` if it is singular or not finite.
    #[inline]
    pub(crate) fn new(matrix: Matrix<S, Y>) -> Option<Self> {
        let count = matrix.rows();
        Self::leading(matrix, count)
    }

    /// Factors the first `count` rows and columns; `None` if they are singular or not finite.
    #[inline(always)]
    pub(crate) fn leading(mut matrix: Matrix<S, Y>, count: usize) -> Option<Self> {
        let mut exchanged = Y::ZERO_INDICES;
        let count = count.min(matrix.rows());
        for (k, exchanged) in exchanged.as_mut().iter_mut().enumerate().take(count) {
            *exchanged = largest(k..count, |row| matrix[(row, k)].abs());
            matrix.swap_rows(k, *exchanged);
            let reciprocal = S::ONE / matrix[(k, k)];
            if !reciprocal.is_finite() || reciprocal == S::ZERO {
                return None;
            }
            matrix[(k, k)] = reciprocal;
            eliminate(&mut matrix, k..count);
        }
        Some(Factors { factors: matrix, exchanged })
    }

    /// Computes the solution for a right-hand side.
    #[inline]
    pub(crate) fn solve(&self, right: &Y) -> Y {
        self.solve_leading(right, self.factors.rows())
    }

    /// Computes the solution for the first `count` entries of a right-hand side; the others are
    /// unchanged.
    #[inline(always)]
    pub(crate) fn solve_leading(&self, right: &Y, count: usize) -> Y {
        let mut solution = *right;
        let (x, factors) = (solution.as_mut(), &self.factors);
        let count = count.min(factors.rows());
        for (row, other) in self.exchanged.as_ref().iter().enumerate().take(count) {
            x.swap(row, *other);
        }
        for row in 1..count {
            for column in 0..row {
                x[row] = (-factors[(row, column)]).multiply_add(x[column], x[row]);
            }
        }
        for row in (0..count).rev() {
            for column in row + 1..count {
                x[row] = (-factors[(row, column)]).multiply_add(x[column], x[row]);
            }
            x[row] = x[row] * factors[(row, row)];
        }
        solution
    }
}

/// Subtracts multiples of the first of these rows from the others. Its pivot is already replaced by
/// the reciprocal.
#[inline(always)]
fn eliminate<S: Scalar, Y: StateVector<S>>(matrix: &mut Matrix<S, Y>, rows: Range<usize>) {
    let k = rows.start;
    for row in k + 1..rows.end {
        let multiple = matrix[(row, k)] * matrix[(k, k)];
        matrix[(row, k)] = multiple;
        for column in k + 1..rows.end {
            matrix[(row, column)] = (-multiple).multiply_add(matrix[(k, column)], matrix[(row, column)]);
        }
    }
}

/// The factors L and U of a complex matrix with exchanged rows.
#[derive(Clone, Debug)]
pub(crate) struct ComplexFactors<S: Scalar, Y: StateVector<S>> {
    /// Real part, in the format of [`Factors`].
    real: Matrix<S, Y>,
    imaginary: Matrix<S, Y>,
    exchanged: Y::Indices,
}

impl<S: Scalar, Y: StateVector<S>> ComplexFactors<S, Y> {
    /// Factors a matrix; `None` if it is singular or not finite.
    #[inline]
    pub(crate) fn new(real: Matrix<S, Y>, imaginary: Matrix<S, Y>) -> Option<Self> {
        let count = real.rows();
        Self::leading(real, imaginary, count)
    }

    /// Factors the first `count` rows and columns; `None` if they are singular or not finite.
    #[inline(always)]
    pub(crate) fn leading(real: Matrix<S, Y>, imaginary: Matrix<S, Y>, count: usize) -> Option<Self> {
        let count = count.min(real.rows());
        let mut factors = ComplexFactors { real, imaginary, exchanged: Y::ZERO_INDICES };
        for k in 0..count {
            factors.exchange(k..count);
            let pivot = factors.at(k, k);
            let square = pivot.0 * pivot.0 + pivot.1 * pivot.1;
            let reciprocal = (pivot.0 / square, -(pivot.1 / square));
            if !(square.is_finite()
                && square > S::ZERO
                && reciprocal.0.is_finite()
                && reciprocal.1.is_finite())
            {
                return None;
            }
            factors.put(k, k, reciprocal);
            factors.eliminate(k..count);
        }
        Some(factors)
    }

    /// Computes the solution for a right-hand side with these real and imaginary parts.
    #[inline]
    pub(crate) fn solve(&self, right: (&Y, &Y)) -> (Y, Y) {
        self.solve_leading(right, self.real.rows())
    }

    /// Computes the solution for the first `count` entries of a right-hand side; the others are
    /// unchanged.
    #[inline(always)]
    pub(crate) fn solve_leading(&self, right: (&Y, &Y), count: usize) -> (Y, Y) {
        let mut solution = (*right.0, *right.1);
        let rows = count.min(self.real.rows());
        for (row, other) in self.exchanged.as_ref().iter().enumerate().take(rows) {
            solution.0.as_mut().swap(row, *other);
            solution.1.as_mut().swap(row, *other);
        }
        let (x, y) = (solution.0.as_mut(), solution.1.as_mut());
        for row in 1..rows {
            for column in 0..row {
                (x[row], y[row]) = less((x[row], y[row]), self.at(row, column), (x[column], y[column]));
            }
        }
        for row in (0..rows).rev() {
            for column in row + 1..rows {
                (x[row], y[row]) = less((x[row], y[row]), self.at(row, column), (x[column], y[column]));
            }
            (x[row], y[row]) = product((x[row], y[row]), self.at(row, row));
        }
        solution
    }

    #[inline(always)]
    fn exchange(&mut self, rows: Range<usize>) {
        let k = rows.start;
        let other = largest(rows, |row| {
            let (x, y) = self.at(row, k);
            x.abs() + y.abs()
        });
        self.real.swap_rows(k, other);
        self.imaginary.swap_rows(k, other);
        self.exchanged.as_mut()[k] = other;
    }

    #[inline(always)]
    fn eliminate(&mut self, rows: Range<usize>) {
        let k = rows.start;
        for row in k + 1..rows.end {
            let multiple = product(self.at(row, k), self.at(k, k));
            self.put(row, k, multiple);
            for column in k + 1..rows.end {
                self.put(row, column, less(self.at(row, column), multiple, self.at(k, column)));
            }
        }
    }

    #[inline(always)]
    fn at(&self, row: usize, column: usize) -> (S, S) {
        (self.real[(row, column)], self.imaginary[(row, column)])
    }

    #[inline(always)]
    fn put(&mut self, row: usize, column: usize, (x, y): (S, S)) {
        self.real[(row, column)] = x;
        self.imaginary[(row, column)] = y;
    }
}

/// Returns the row with the largest size. NaN invalidates the factors, whichever row is chosen.
#[inline]
fn largest<S: Scalar>(rows: Range<usize>, size: impl Fn(usize) -> S) -> usize {
    let first = rows.start;
    rows.fold(first, |best, row| if size(row) <= size(best) { best } else { row })
}

/// Computes the product of two complex numbers.
#[inline(always)]
pub(crate) fn product<S: Scalar>(a: (S, S), b: (S, S)) -> (S, S) {
    ((-a.1).multiply_add(b.1, a.0 * b.0), a.1.multiply_add(b.0, a.0 * b.1))
}

/// Computes a − b c.
#[inline(always)]
fn less<S: Scalar>(a: (S, S), b: (S, S), c: (S, S)) -> (S, S) {
    let bc = product(b, c);
    (a.0 - bc.0, a.1 - bc.1)
}

#[cfg(test)]
mod tests;
