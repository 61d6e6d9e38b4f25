//! The linear equations of a Newton iteration over all stages of a Gauss method.
//!
//! With frozen derivatives, these equations are polynomials in the matrix of coefficients. In the
//! basis of its eigenvectors they decouple into one real system with the size of one stage and a
//! complex one. Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §IV.8.

use crate::integrate::canonical::Pencil;
use crate::integrate::gauss_legendre::tableau::{EigenMode, Tableau};
use crate::linalg::pivoted::{ComplexFactors, Factors, Matrix};
use crate::linalg::vector::add;
use crate::scalar::Scalar;
use crate::system::StateVector;

/// A real eigenvalue with the factors of its equations.
type Real<S, Y, const K: usize> = (EigenMode<f64, K>, Factors<S, Y>);

/// A complex eigenvalue with the factors of its equations.
type Complex<S, Y, const K: usize> = (EigenMode<(f64, f64), K>, ComplexFactors<S, Y>);

/// The factors of the equations of all stages.
#[derive(Clone, Debug)]
pub(super) enum Linearised<S: Scalar, Y: StateVector<S>, const K: usize> {
    /// Each stage separately.
    Constant(Factors<S, Y>),
    /// One system for each mode.
    Modes(Option<Real<S, Y, K>>, Option<Complex<S, Y, K>>),
}

impl<S: Scalar, Y: StateVector<S>, const K: usize> Linearised<S, Y, K> {
    /// Factors the equations. Only the constant is factored if derivatives are not available or
    /// lead to a singular matrix.
    pub(super) fn new(pencil: &Pencil<S, Y>, tableau: &Tableau<S, K>) -> Option<Self> {
        let modes = pencil.derivatives.as_ref().and_then(|(linear, quadratic)| {
            let real = match tableau.real {
                Some(mode) => Some((mode, at_real(&pencil.constant, linear, quadratic, mode.value)?)),
                None => None,
            };
            let complex = match tableau.complex {
                Some(mode) => Some((mode, at_complex(&pencil.constant, linear, quadratic, mode.value)?)),
                None => None,
            };
            Some(Linearised::Modes(real, complex))
        });
        modes.or_else(|| Some(Linearised::Constant(Factors::new(pencil.constant.clone())?)))
    }

    /// Computes the solution for a right-hand side.
    #[inline]
    pub(super) fn solve(&self, right: &[Y; K]) -> [Y; K] {
        match self {
            Linearised::Constant(factors) => right.map(|right| factors.solve(&right)),
            Linearised::Modes(real, complex) => {
                let mut solution = [right[0].zeros(); K];
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

/// Computes Σ part vector.
#[inline]
fn combination<S: Scalar, Y: StateVector<S>, const K: usize>(parts: &[f64; K], vectors: &[Y; K]) -> Y {
    let mut sum = vectors[0].zeros();
    for (part, vector) in parts.iter().zip(vectors) {
        add(&mut sum, S::from_f64(*part), vector);
    }
    sum
}

/// Factors constant − λ linear − λ² quadratic.
fn at_real<S: Scalar, Y: StateVector<S>>(
    constant: &Matrix<S, Y>,
    linear: &Matrix<S, Y>,
    quadratic: &Matrix<S, Y>,
    value: f64,
) -> Option<Factors<S, Y>> {
    let (first, second) = (S::from_f64(value), S::from_f64(value * value));
    Factors::new(constant.with(|i, j| constant[(i, j)] - first * linear[(i, j)] - second * quadratic[(i, j)]))
}

/// Factors like [`at_real`] for a complex λ.
fn at_complex<S: Scalar, Y: StateVector<S>>(
    constant: &Matrix<S, Y>,
    linear: &Matrix<S, Y>,
    quadratic: &Matrix<S, Y>,
    (x, y): (f64, f64),
) -> Option<ComplexFactors<S, Y>> {
    let first = (S::from_f64(x), S::from_f64(y));
    let second = (S::from_f64(x * x - y * y), S::from_f64(2.0 * x * y));
    ComplexFactors::new(
        constant.with(|i, j| constant[(i, j)] - first.0 * linear[(i, j)] - second.0 * quadratic[(i, j)]),
        linear.with(|i, j| -(first.1 * linear[(i, j)]) - second.1 * quadratic[(i, j)]),
    )
}
