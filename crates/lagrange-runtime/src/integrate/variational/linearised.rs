//! The linear equations of a Newton iteration over the velocities at both ends of a step.

use crate::integrate::canonical::Pencil;
use crate::linalg::pivoted::{Factors, Matrix};
use crate::linalg::vector::add;
use crate::scalar::Scalar;
use crate::system::StateVector;

/// −C₀⁻¹C₁, where Cₖ contains the coefficients of hᵏ in the derivatives of the equations.
pub(super) const LINEAR: [[f64; 2]; 2] = [[1.0 / 12.0, -1.0 / 12.0], [7.0 / 12.0, 5.0 / 12.0]];

/// −C₀⁻¹C₂
pub(super) const QUADRATIC: [[f64; 2]; 2] = [[-1.0 / 16.0, -1.0 / 48.0], [5.0 / 16.0, 5.0 / 48.0]];

/// −C₀⁻¹
const TURNED: [[f64; 2]; 2] = [[1.0, -1.0 / 3.0], [1.0, 2.0 / 3.0]];

/// The factors of the equations, by blocks.
#[derive(Clone, Debug)]
pub(super) struct Linearised<S: Scalar, Y: StateVector<S>> {
    first: Factors<S, Y>,
    /// Result of the elimination of the first velocity: the remainder and the off-diagonal blocks,
    /// with the upper one solved for that velocity. `None` if the velocities are independent.
    rest: Option<Rest<S, Y>>,
}

#[derive(Clone, Debug)]
struct Rest<S: Scalar, Y: StateVector<S>> {
    second: Factors<S, Y>,
    upper: Matrix<S, Y>,
    lower: Matrix<S, Y>,
}

impl<S: Scalar, Y: StateVector<S>> Linearised<S, Y> {
    /// Factors the equations. Only the mass matrix is factored if derivatives are not available or
    /// lead to a singular matrix.
    pub(super) fn new(pencil: &Pencil<S, Y>) -> Option<Self> {
        let coupled = pencil.derivatives.as_ref().and_then(|(linear, quadratic)| {
            let block = |i: usize, j: usize| {
                let (first, second) = (S::from_f64(LINEAR[i][j]), S::from_f64(QUADRATIC[i][j]));
                Matrix::of(|k, l| {
                    let constant = if i == j { pencil.constant[(k, l)] } else { S::ZERO };
                    constant - first * linear[(k, l)] - second * quadratic[(k, l)]
                })
            };
            let (first, lower) = (Factors::new(block(0, 0))?, block(1, 0));
            let upper = solved(&first, &block(0, 1));
            let (corner, product) = (block(1, 1), lower.times(&upper));
            let second = Factors::new(Matrix::of(|k, l| corner[(k, l)] - product[(k, l)]))?;
            Some(Linearised { first, rest: Some(Rest { second, upper, lower }) })
        });
        coupled.or_else(|| Some(Linearised { first: Factors::new(pencil.constant.clone())?, rest: None }))
    }

    /// Returns the corrections of both velocities for the residuals of the equations.
    #[inline]
    pub(super) fn solve(&self, residual: &[Y; 2]) -> [Y; 2] {
        self.solve_turned(&turned(residual))
    }

    /// Solves for residuals that are already [`turned`].
    #[inline]
    pub(super) fn solve_turned(&self, [one, two]: &[Y; 2]) -> [Y; 2] {
        let mut first = self.first.solve(one);
        let Some(Rest { second, upper, lower }) = &self.rest else {
            return [first, self.first.solve(two)];
        };
        let mut rest = *two;
        add(&mut rest, -S::ONE, &lower.apply(&first));
        let last = second.solve(&rest);
        add(&mut first, -S::ONE, &upper.apply(&last));
        [first, last]
    }
}

/// Combines the residuals into equations with one velocity each, if derivatives are neglected.
#[inline]
pub(super) fn turned<S: Scalar, Y: StateVector<S>>(residual: &[Y; 2]) -> [Y; 2] {
    TURNED.map(|row| {
        let mut sum = Y::ZERO;
        for (part, residual) in row.iter().zip(residual) {
            add(&mut sum, S::from_f64(*part), residual);
        }
        sum
    })
}

/// Computes the solutions for the columns of a matrix.
fn solved<S: Scalar, Y: StateVector<S>>(factors: &Factors<S, Y>, right: &Matrix<S, Y>) -> Matrix<S, Y> {
    let mut solution = Matrix::ZERO;
    for j in 0..right.rows() {
        let mut column = Y::ZERO;
        for (i, entry) in column.as_mut().iter_mut().enumerate() {
            *entry = right[(i, j)];
        }
        for (i, entry) in factors.solve(&column).as_ref().iter().enumerate() {
            solution[(i, j)] = *entry;
        }
    }
    solution
}
