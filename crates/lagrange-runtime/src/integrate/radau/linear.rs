//! The linear equations (μ − J) x = r of a Newton iteration, for real and complex μ.
//!
//! If the rates of the first components are other components, as for q̇ = v, their equations μ q −
//! v = r yield q = (r + v) / μ. The factors are those of the other equations alone, at an eighth of
//! the cost for a mechanical system. For q̇ = v, v̇ = A q + B v, these are
//!
//! ```text
//! (μ − B − A/μ) δv = r_v + A r_q / μ,    δq = (r_q + δv) / μ.
//! ```
//!
//! Example: A = −6, B = −1, μ = 2, r = (1, 7) leads to (2 + 1 + 3) δv = 7 − 3, so δv = 2/3 and δq =
//! 5/6. Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §IV.8, "Second order
//! equations".

use crate::linalg::pivoted::{ComplexFactors, Factors, Matrix, product};
use crate::scalar::Scalar;
use crate::system::StateVector;

/// The leading components that follow from others: their number, and the index of the first
/// component that is their rate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct LeadingPositions {
    pub(super) count: usize,
    pub(super) rates: usize,
}

impl LeadingPositions {
    /// Finds these components in a Jacobian, by rows with a single entry of one.
    fn of<S: Scalar, Y: StateVector<S>>(jacobian: &Matrix<S, Y>) -> Self {
        let rows = jacobian.0.as_ref();
        let Some(rates) = rows.first().and_then(only_one) else {
            return LeadingPositions { count: 0, rates: 0 };
        };
        let is_position = |place: &usize| *place < rates && only_one(&rows[*place]) == Some(rates + *place);
        LeadingPositions { count: (0..rows.len()).take_while(is_position).count(), rates }
    }

    /// Calls a function with these positions. They are known at compile time if their number is
    /// zero or half of all components.
    #[inline(always)]
    fn known<R>(self, size: usize, call: impl Fn(LeadingPositions) -> R) -> R {
        let (half, none) =
            (LeadingPositions { count: size / 2, rates: size / 2 }, LeadingPositions { count: 0, rates: 0 });
        match self {
            found if found == half => call(half),
            found if found.count == 0 => call(none),
            found => call(found),
        }
    }
}

/// Returns the column of the only nonzero entry, if this entry is one.
fn only_one<S: Scalar, Y: StateVector<S>>(row: &Y) -> Option<usize> {
    let mut entries = row.as_ref().iter().enumerate().filter(|(_, entry)| **entry != S::ZERO);
    let (column, entry) = entries.next()?;
    (entries.next().is_none() && *entry == S::ONE).then_some(column)
}

/// A Jacobian and its structure.
#[derive(Clone, Debug)]
pub(super) struct LinearSystem<S: Scalar, Y: StateVector<S>> {
    jacobian: Matrix<S, Y>,
    positions: LeadingPositions,
}

impl<S: Scalar, Y: StateVector<S>> LinearSystem<S, Y> {
    pub(super) fn new(jacobian: Matrix<S, Y>) -> Self {
        LinearSystem { positions: LeadingPositions::of(&jacobian), jacobian }
    }

    /// Returns the components whose rates are other components, and the place of these.
    pub(super) fn positions(&self) -> LeadingPositions {
        self.positions
    }

    /// Computes a part of the matrix of the other components: the given parts of μ and of 1 / μ,
    /// and `share` times the Jacobian.
    #[inline(always)]
    fn matrix(
        &self,
        LeadingPositions { count, rates }: LeadingPositions,
        [mu, reciprocal, share]: [S; 3],
    ) -> Matrix<S, Y> {
        let mut matrix = self.jacobian.with(|_, _| S::ZERO);
        for row in 0..matrix.rows() - count {
            for column in 0..matrix.rows() - count {
                matrix[(row, column)] = -(share * self.jacobian[(count + row, count + column)]);
            }
            for place in 0..count {
                let column = rates - count + place;
                matrix[(row, column)] =
                    (-reciprocal).multiply_add(self.jacobian[(count + row, place)], matrix[(row, column)]);
            }
            matrix[(row, row)] = matrix[(row, row)] + mu;
        }
        matrix
    }

    /// Computes the product of a row of the Jacobian with the first entries of a vector.
    #[inline(always)]
    fn by_positions(&self, count: usize, component: usize, right: &Y) -> S {
        (0..count).fold(S::ZERO, |sum, place| {
            self.jacobian[(component, place)].multiply_add(right.as_ref()[place], sum)
        })
    }
}

/// The factors for a real μ.
#[derive(Clone, Debug)]
pub(super) struct RealShift<S: Scalar, Y: StateVector<S>> {
    reciprocal: S,
    factors: Factors<S, Y>,
}

impl<S: Scalar, Y: StateVector<S>> RealShift<S, Y> {
    /// Factors the equations; `None` if the matrix is singular or not finite.
    pub(super) fn new(linearised: &LinearSystem<S, Y>, mu: S) -> Option<Self> {
        let (reciprocal, size) = (S::ONE / mu, linearised.jacobian.rows());
        linearised.positions.known(
            size,
            #[inline(always)]
            |positions| {
                let matrix = linearised.matrix(positions, [mu, reciprocal, S::ONE]);
                Some(RealShift { reciprocal, factors: Factors::leading(matrix, size - positions.count)? })
            },
        )
    }

    /// Computes the solution for a right-hand side.
    #[inline]
    pub(super) fn solve(&self, linearised: &LinearSystem<S, Y>, right: &Y) -> Y {
        let size = linearised.jacobian.rows();
        linearised.positions.known(
            size,
            #[inline(always)]
            |LeadingPositions { count, rates }| {
                let mut others = right.zeros();
                for row in 0..size - count {
                    let known = linearised.by_positions(count, count + row, right);
                    others.as_mut()[row] = known.multiply_add(self.reciprocal, right.as_ref()[count + row]);
                }
                let found = self.factors.solve_leading(&others, size - count);
                let mut solution = right.zeros();
                for (place, x) in solution.as_mut().iter_mut().enumerate() {
                    *x = match place.checked_sub(count) {
                        Some(row) => found.as_ref()[row],
                        None => {
                            (right.as_ref()[place] + found.as_ref()[rates - count + place]) * self.reciprocal
                        }
                    };
                }
                solution
            },
        )
    }
}

/// The factors for a complex μ.
#[derive(Clone, Debug)]
pub(super) struct ComplexShift<S: Scalar, Y: StateVector<S>> {
    reciprocal: (S, S),
    factors: ComplexFactors<S, Y>,
}

impl<S: Scalar, Y: StateVector<S>> ComplexShift<S, Y> {
    /// Factors the equations; `None` if the matrix is singular or not finite.
    pub(super) fn new(linearised: &LinearSystem<S, Y>, mu: (S, S)) -> Option<Self> {
        let square = mu.0 * mu.0 + mu.1 * mu.1;
        let (reciprocal, size) = ((mu.0 / square, -(mu.1 / square)), linearised.jacobian.rows());
        linearised.positions.known(
            size,
            #[inline(always)]
            |positions| {
                let real = linearised.matrix(positions, [mu.0, reciprocal.0, S::ONE]);
                let imaginary = linearised.matrix(positions, [mu.1, reciprocal.1, S::ZERO]);
                let factors = ComplexFactors::leading(real, imaginary, size - positions.count)?;
                Some(ComplexShift { reciprocal, factors })
            },
        )
    }

    /// Computes the solution for a right-hand side with these real and imaginary parts.
    #[inline]
    pub(super) fn solve(&self, linearised: &LinearSystem<S, Y>, right: (&Y, &Y)) -> (Y, Y) {
        let size = linearised.jacobian.rows();
        let at = |vectors: (&Y, &Y), place: usize| (vectors.0.as_ref()[place], vectors.1.as_ref()[place]);
        linearised.positions.known(
            size,
            #[inline(always)]
            |LeadingPositions { count, rates }| {
                let (mut real, mut imaginary) = (right.0.zeros(), right.0.zeros());
                for row in 0..size - count {
                    let by_positions = |right| linearised.by_positions(count, count + row, right);
                    let known = product((by_positions(right.0), by_positions(right.1)), self.reciprocal);
                    let own = at(right, count + row);
                    (real.as_mut()[row], imaginary.as_mut()[row]) = (own.0 + known.0, own.1 + known.1);
                }
                let found = self.factors.solve_leading((&real, &imaginary), size - count);
                let mut solution = (right.0.zeros(), right.0.zeros());
                for place in 0..size {
                    let x = match place.checked_sub(count) {
                        Some(row) => at((&found.0, &found.1), row),
                        None => {
                            let (own, rate) =
                                (at(right, place), at((&found.0, &found.1), rates - count + place));
                            product((own.0 + rate.0, own.1 + rate.1), self.reciprocal)
                        }
                    };
                    (solution.0.as_mut()[place], solution.1.as_mut()[place]) = x;
                }
                solution
            },
        )
    }
}

#[cfg(test)]
mod tests {
    use super::{ComplexShift, LeadingPositions, LinearSystem, RealShift};
    use crate::linalg::pivoted::{Matrix, product};

    /// q̇ = v, arbitrary ż, v̇; then a matrix without structure, and one in which the rate of the
    /// first component is the second.
    const MATRICES: [[[f64; 5]; 5]; 3] = [
        [
            [0.0, 0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 0.0, 1.0],
            [0.3, -0.7, -2.0, 0.1, 0.4],
            [-6.0, 1.0, 0.5, -1.0, 0.2],
            [2.0, -9.0, 1.5, 0.3, -3.0],
        ],
        [
            [0.2, 0.1, 0.0, 1.0, 0.0],
            [1.0, 0.0, 0.0, 0.0, 0.0],
            [0.3, -0.7, -2.0, 0.1, 0.4],
            [-6.0, 1.0, 0.5, -1.0, 0.2],
            [2.0, -9.0, 1.5, 0.3, -3.0],
        ],
        [
            [0.0, 1.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0, 0.0],
            [0.3, -0.7, -2.0, 0.1, 0.4],
            [-6.0, 1.0, 0.5, -1.0, 0.2],
            [2.0, -9.0, 1.5, 0.3, -3.0],
        ],
    ];
    const FOUND: [LeadingPositions; 3] = [
        LeadingPositions { count: 2, rates: 3 },
        LeadingPositions { count: 0, rates: 0 },
        LeadingPositions { count: 1, rates: 1 },
    ];

    /// Returns the largest entry of (μ − J) x − r.
    fn residual(matrix: &[[f64; 5]; 5], mu: (f64, f64), x: &[[f64; 5]; 2], right: &[[f64; 5]; 2]) -> f64 {
        (0..5).fold(0.0, |most, row| {
            let own = product(mu, (x[0][row], x[1][row]));
            let sum = |part: usize| (0..5).map(|column| matrix[row][column] * x[part][column]).sum::<f64>();
            let left = [own.0 - sum(0) - right[0][row], own.1 - sum(1) - right[1][row]];
            left.iter().fold(most, |most: f64, left| most.max(left.abs()))
        })
    }

    #[test]
    fn rows_of_a_single_one_are_positions() {
        for (matrix, positions) in MATRICES.iter().zip(FOUND) {
            assert_eq!(LinearSystem::new(Matrix::<f64, [f64; 5]>(*matrix)).positions(), positions);
        }
    }

    #[test]
    fn solutions_satisfy_all_equations_whatever_is_eliminated() {
        let right = [[1.0, 7.0, -2.0, 0.5, 3.0], [-0.3, 0.2, 4.0, 1.0, -6.0]];
        for matrix in MATRICES {
            let linearised = LinearSystem::new(Matrix::<f64, [f64; 5]>(matrix));
            let real = RealShift::new(&linearised, 2.0).expect("regular").solve(&linearised, &right[0]);
            let left = residual(&matrix, (2.0, 0.0), &[real, [0.0; 5]], &[right[0], [0.0; 5]]);
            assert!(left < 1e-13, "{left}");
            let complex = ComplexShift::new(&linearised, (2.0, -3.0)).expect("regular");
            let (x, y) = complex.solve(&linearised, (&right[0], &right[1]));
            let left = residual(&matrix, (2.0, -3.0), &[x, y], &right);
            assert!(left < 1e-13, "{left}");
        }
    }

    #[test]
    fn half_of_the_components_are_eliminated_as_in_the_example() {
        let linearised = LinearSystem::new(Matrix::<f64, [f64; 2]>([[0.0, 1.0], [-6.0, -1.0]]));
        let [q, v] = RealShift::new(&linearised, 2.0).expect("regular").solve(&linearised, &[1.0, 7.0]);
        assert!((v - 2.0 / 3.0).abs() < 1e-15 && (q - 5.0 / 6.0).abs() < 1e-15, "{q} {v}");
    }

    #[test]
    fn a_singular_matrix_has_no_factors() {
        let linearised = LinearSystem::new(Matrix::<f64, [f64; 2]>([[2.0, 0.0], [0.0, 1.0]]));
        assert!(RealShift::new(&linearised, 2.0).is_none());
    }
}
