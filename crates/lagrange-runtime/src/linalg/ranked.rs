//! Equations that may be dependent.

use crate::linalg::pivoted::Matrix;
use crate::linalg::vector::StateVector;
use crate::scalar::Scalar;
use crate::tolerance::DEPENDENT_PIVOT;

/// The factors L and U of the first rows and columns of a matrix, with complete pivoting.
///
/// Rows and columns are scaled to largest entries of one, so that their units are irrelevant. If
/// equations are dependent, the undetermined unknowns are zero. Source: Golub, Van Loan, *Matrix
/// Computations*, 4th ed., §3.4.8.
#[derive(Clone, Debug)]
pub(crate) struct RankedFactors<S: Scalar, Y: StateVector<S>> {
    /// L below the diagonal, without its diagonal of ones, and U above.
    factors: Matrix<S, Y>,
    scales: [Y; 2],
    exchanged: [Y::Indices; 2],
    size: usize,
    rank: usize,
}

impl<S: Scalar, Y: StateVector<S>> RankedFactors<S, Y> {
    /// Factors the first `size` rows and columns; `None` if they are not finite.
    pub(crate) fn new(matrix: Matrix<S, Y>, size: usize) -> Option<Self> {
        let (scales, exchanged) = ([Y::ZERO; 2], [Y::ZERO_INDICES; 2]);
        let mut factors = RankedFactors { factors: matrix, scales, exchanged, size, rank: size };
        if !factors.is_finite() {
            return None;
        }
        factors.equilibrate();
        for k in 0..size {
            let (row, column) = factors.largest(k);
            if factors.factors[(row, column)].abs() <= DEPENDENT_PIVOT.part::<S>() {
                factors.rank = k;
                break;
            }
            factors.exchange(k, row, column);
            factors.eliminate(k);
        }
        Some(factors)
    }

    /// Computes the solution for a right-hand side; entries beyond the equations are irrelevant.
    #[inline]
    pub(crate) fn solve(&self, right: &Y) -> Y {
        let mut solution = *right;
        let (x, [row_scales, column_scales]) = (solution.as_mut(), &self.scales);
        for (x, scale) in x.iter_mut().zip(row_scales.as_ref()) {
            *x = *x * *scale;
        }
        for (k, row) in self.exchanged[0].as_ref().iter().enumerate().take(self.rank) {
            x.swap(k, *row);
        }
        for row in 1..self.rank {
            for column in 0..row {
                x[row] = (-self.factors[(row, column)]).multiply_add(x[column], x[row]);
            }
        }
        x[self.rank..].fill(S::ZERO);
        for row in (0..self.rank).rev() {
            for column in row + 1..self.rank {
                x[row] = (-self.factors[(row, column)]).multiply_add(x[column], x[row]);
            }
            x[row] = x[row] / self.factors[(row, row)];
        }
        for (k, column) in self.exchanged[1].as_ref().iter().enumerate().take(self.rank).rev() {
            x.swap(k, *column);
        }
        for (x, scale) in x.iter_mut().zip(column_scales.as_ref()) {
            *x = *x * *scale;
        }
        solution
    }

    /// Returns the column and the value of the first pivot that indicates dependent equations, if
    /// there is one.
    pub(crate) fn lost_pivot(&self) -> Option<(usize, S)> {
        if self.rank == self.size {
            return None;
        }
        let [row, column] = [0, 1].map(|side| {
            // The index before exchanges of the entry that is now at the pivot.
            let exchanges = self.exchanged[side].as_ref()[..self.rank].iter().enumerate().rev();
            exchanges.fold(self.rank, |place, (k, other)| match place {
                _ if place == *other => k,
                _ if place == k => *other,
                _ => place,
            })
        });
        let [rows, columns] = &self.scales;
        let scale = rows.as_ref()[row] * columns.as_ref()[column];
        Some((column, self.factors[(self.rank, self.rank)] / scale))
    }

    fn is_finite(&self) -> bool {
        let size = self.size;
        (0..size).all(|row| (0..size).all(|column| self.factors[(row, column)].is_finite()))
    }

    /// Scales the largest entries of all rows to one, then those of all columns.
    fn equilibrate(&mut self) {
        for row in 0..self.size {
            let scale = reciprocal((0..self.size).map(|column| self.factors[(row, column)]));
            (0..self.size).for_each(|column| self.scale((row, column), scale));
            self.scales[0].as_mut()[row] = scale;
        }
        for column in 0..self.size {
            let scale = reciprocal((0..self.size).map(|row| self.factors[(row, column)]));
            (0..self.size).for_each(|row| self.scale((row, column), scale));
            self.scales[1].as_mut()[column] = scale;
        }
    }

    fn scale(&mut self, place: (usize, usize), scale: S) {
        self.factors[place] = self.factors[place] * scale;
    }

    /// Returns the place of the largest entry after elimination of `k` rows and columns.
    fn largest(&self, k: usize) -> (usize, usize) {
        let places = (k..self.size).flat_map(|row| (k..self.size).map(move |column| (row, column)));
        places.fold(
            (k, k),
            |best, place| {
                if self.factors[place].abs() <= self.factors[best].abs() { best } else { place }
            },
        )
    }

    fn exchange(&mut self, k: usize, row: usize, column: usize) {
        self.factors.swap_rows(k, row);
        for row in 0..self.size {
            let left = self.factors[(row, k)];
            self.factors[(row, k)] = self.factors[(row, column)];
            self.factors[(row, column)] = left;
        }
        self.exchanged[0].as_mut()[k] = row;
        self.exchanged[1].as_mut()[k] = column;
    }

    fn eliminate(&mut self, k: usize) {
        for row in k + 1..self.size {
            let multiple = self.factors[(row, k)] / self.factors[(k, k)];
            self.factors[(row, k)] = multiple;
            for column in k + 1..self.size {
                self.factors[(row, column)] =
                    (-multiple).multiply_add(self.factors[(k, column)], self.factors[(row, column)]);
            }
        }
    }
}

/// Returns the reciprocal of the largest magnitude; one if all entries are zero.
fn reciprocal<S: Scalar>(entries: impl Iterator<Item = S>) -> S {
    let largest = entries.fold(S::ZERO, |largest, entry| largest.max(entry.abs()));
    let reciprocal = S::ONE / largest;
    if largest > S::ZERO && reciprocal.is_finite() { reciprocal } else { S::ONE }
}

#[cfg(test)]
mod tests {
    use super::RankedFactors;
    use crate::linalg::pivoted::Matrix;

    const MATRIX: [[f64; 3]; 3] = [[0.0, 2.0e9, 1.0e3], [3.0e-6, 1.0, 0.0], [0.0, 1.0, 4.0e-6]];

    #[test]
    fn independent_equations_are_solved_whatever_their_units() {
        let wanted = [2.0e6, -1.0, 0.5e6];
        let factors = RankedFactors::new(Matrix(MATRIX), 3).expect("finite");
        let found = factors.solve(&Matrix::<f64, [f64; 3]>(MATRIX).apply(&wanted));
        for (found, wanted) in found.into_iter().zip(wanted) {
            assert!((found / wanted - 1.0).abs() < 1e-14, "{found} {wanted}");
        }
    }

    #[test]
    fn only_the_first_equations_count() {
        let matrix = [[2.0, 0.0, 9.0], [0.0, 4.0, 9.0], [9.0, f64::NAN, 9.0]];
        let factors = RankedFactors::new(Matrix(matrix), 2).expect("finite");
        assert_eq!(factors.solve(&[2.0, 4.0, 7.0]), [1.0, 1.0, 0.0]);
    }

    #[test]
    fn dependent_equations_that_agree_are_satisfied() {
        let matrix = [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [0.0, 0.0, 0.0]];
        let factors = RankedFactors::new(Matrix(matrix), 3).expect("finite");
        let product = Matrix::<f64, [f64; 3]>(matrix).apply(&factors.solve(&[5.0, 10.0, 0.0]));
        for (found, wanted) in product.into_iter().zip([5.0, 10.0, 0.0]) {
            assert!((found - wanted).abs() < 1e-14, "{product:?}");
        }
    }

    #[test]
    fn what_is_not_finite_has_no_factors() {
        assert!(RankedFactors::new(Matrix::<f64, [f64; 2]>([[f64::NAN, 1.0], [1.0, 2.0]]), 2).is_none());
    }
}
