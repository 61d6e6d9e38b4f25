//! The linear equations of a Newton iteration over all stages of a Gauss method.
//!
//! With the derivatives frozen, those equations are polynomials in the matrix of coefficients. In the basis of its
//! eigenvectors they fall apart into one real system as large as one stage and a complex one. Source: Hairer, Wanner,
//! *Solving Ordinary Differential Equations II*, §IV.8.

use crate::integrate::gauss::tableau::{Mode, Tableau};
use crate::integrate::linear::{ComplexFactors, Factors, Matrix};
use crate::scalar::Scalar;
use crate::system::StateVector;

/// The matrix constant − λ linear − λ² quadratic, which λ, an eigenvalue or the coefficients themselves, turns into
/// that of the equations.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pencil<S: Scalar, Y: StateVector<S>> {
    pub(super) constant: Matrix<S, Y>,
    /// Linear and quadratic, if derivatives are known.
    pub(super) derivatives: Option<(Matrix<S, Y>, Matrix<S, Y>)>,
}

/// A real eigenvalue with the factors of its equations.
type Real<S, Y, const K: usize> = (Mode<f64, K>, Factors<S, Y>);

/// A complex eigenvalue with the factors of its equations.
type Complex<S, Y, const K: usize> = (Mode<(f64, f64), K>, ComplexFactors<S, Y>);

/// The factors of the equations of all stages.
#[derive(Clone, Copy, Debug)]
pub(super) enum Linearised<S: Scalar, Y: StateVector<S>, const K: usize> {
    /// Every stage for itself.
    Constant(Factors<S, Y>),
    /// One system for each mode.
    Modes(Option<Real<S, Y, K>>, Option<Complex<S, Y, K>>),
}

impl<S: Scalar, Y: StateVector<S>> Pencil<S, Y> {
    /// The factors, of the constant alone if derivatives are not known or lead to a singular matrix.
    pub(super) fn factors<const K: usize>(&self, tableau: &Tableau<S, K>) -> Option<Linearised<S, Y, K>> {
        let modes = self.derivatives.as_ref().and_then(|(linear, quadratic)| {
            let real = match tableau.real {
                Some(mode) => Some((mode, Factors::new(self.at(linear, quadratic, mode.value))?)),
                None => None,
            };
            let complex = match tableau.complex {
                Some(mode) => Some((mode, self.at_complex(linear, quadratic, mode.value)?)),
                None => None,
            };
            Some(Linearised::Modes(real, complex))
        });
        modes.or_else(|| Some(Linearised::Constant(Factors::new(self.constant)?)))
    }

    /// Σ of the magnitudes of all terms of the equations for unknowns of this magnitude.
    pub(super) fn magnitude(&self, unknowns: &Y) -> Y {
        let constant = |i, j| self.constant[(i, j)].abs();
        match &self.derivatives {
            None => Matrix::of(constant).apply(unknowns),
            Some((linear, quadratic)) => {
                Matrix::of(|i, j| constant(i, j) + linear[(i, j)].abs() + quadratic[(i, j)].abs())
                    .apply(unknowns)
            }
        }
    }

    fn at(&self, linear: &Matrix<S, Y>, quadratic: &Matrix<S, Y>, value: f64) -> Matrix<S, Y> {
        let value = S::from_f64(value);
        Matrix::of(|i, j| self.constant[(i, j)] - value * (linear[(i, j)] + value * quadratic[(i, j)]))
    }

    fn at_complex(
        &self,
        linear: &Matrix<S, Y>,
        quadratic: &Matrix<S, Y>,
        (x, y): (f64, f64),
    ) -> Option<ComplexFactors<S, Y>> {
        let (re, im) = (S::from_f64(x), S::from_f64(y));
        let (square_re, square_im) = (S::from_f64(x * x - y * y), S::from_f64(2.0 * x * y));
        ComplexFactors::new(
            Matrix::of(|i, j| self.constant[(i, j)] - re * linear[(i, j)] - square_re * quadratic[(i, j)]),
            Matrix::of(|i, j| -(im * linear[(i, j)]) - square_im * quadratic[(i, j)]),
        )
    }
}

impl<S: Scalar, Y: StateVector<S>, const K: usize> Linearised<S, Y, K> {
    /// The solution for a right-hand side.
    #[inline]
    pub(super) fn solve(&self, right: &[Y; K]) -> [Y; K] {
        match self {
            Linearised::Constant(factors) => right.map(|right| factors.solve(&right)),
            Linearised::Modes(real, complex) => {
                let mut solution = [Y::ZERO; K];
                if let Some((mode, factors)) = real {
                    let component = factors.solve(&combination(&mode.row, right));
                    for (solution, part) in solution.iter_mut().zip(mode.column) {
                        add(solution, S::from_f64(part), &component);
                    }
                }
                if let Some((mode, factors)) = complex {
                    let real = combination(&mode.row.map(|(x, _)| x), right);
                    let imaginary = combination(&mode.row.map(|(_, y)| y), right);
                    let component = factors.solve((&real, &imaginary));
                    for (solution, (x, y)) in solution.iter_mut().zip(mode.column) {
                        add(solution, S::from_f64(2.0 * x), &component.0);
                        add(solution, S::from_f64(-2.0 * y), &component.1);
                    }
                }
                solution
            }
        }
    }
}

/// Σ part vector
#[inline]
fn combination<S: Scalar, Y: StateVector<S>, const K: usize>(parts: &[f64; K], vectors: &[Y; K]) -> Y {
    let mut sum = Y::ZERO;
    for (part, vector) in parts.iter().zip(vectors) {
        add(&mut sum, S::from_f64(*part), vector);
    }
    sum
}

/// y + c x
#[inline]
pub(super) fn add<S: Scalar, Y: StateVector<S>>(y: &mut Y, c: S, x: &Y) {
    for (y, x) in y.as_mut().iter_mut().zip(x.as_ref()) {
        *y = x.multiply_add(c, *y);
    }
}
