//! The frozen derivatives of the equations of a step.

use crate::linalg::pivoted::Matrix;
use crate::scalar::Scalar;
use crate::system::StateVector;

/// The matrix constant − λ linear − μ quadratic. A method replaces λ and μ by its coefficients; μ
/// is of second order in them. The matrices contain the length of the step.
#[derive(Clone, Debug)]
pub(in crate::integrate) struct Pencil<S: Scalar, Y: StateVector<S>> {
    pub(in crate::integrate) constant: Matrix<S, Y>,
    /// The matrices linear and quadratic, if derivatives are available.
    pub(in crate::integrate) derivatives: Option<(Matrix<S, Y>, Matrix<S, Y>)>,
}

impl<S: Scalar, Y: StateVector<S>> Pencil<S, Y> {
    /// Computes the sum of the magnitudes of all terms in the equations, for unknowns of this
    /// magnitude.
    pub(in crate::integrate) fn magnitude(&self, unknowns: &Y) -> Y {
        let constant = |i, j| self.constant[(i, j)].abs();
        match &self.derivatives {
            None => self.constant.with(constant).apply(unknowns),
            Some((linear, quadratic)) => {
                let sum = |i, j| constant(i, j) + linear[(i, j)].abs() + quadratic[(i, j)].abs();
                self.constant.with(sum).apply(unknowns)
            }
        }
    }
}
