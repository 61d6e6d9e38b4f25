//! Velocities for given momenta.

use crate::integrate::canonical::magnitude;
use crate::integrate::method::Work;
use crate::integrate::newton::{self, Equations, finite};
use crate::linalg::pivoted::{Factors, Matrix};
use crate::scalar::{Number, Scalar};
use crate::system::{CanonicalSystem, StateVector, StepFailure};

/// Computes the velocities v with ∂L/∂v = p, from a guess and the mass matrix there.
///
/// One correction suffices if L is quadratic in the velocities; another one removes its rounding
/// errors. The length `h` of the last step determines which velocities are small.
pub(in crate::integrate) fn velocities<M: CanonicalSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    (q, p): (&M::Coordinates, &M::Coordinates),
    guess: M::Coordinates,
    mass: &Matrix<M::Scalar, M::Coordinates>,
    h: M::Scalar,
    work: &mut Work,
) -> Result<M::Coordinates, StepFailure<M::Scalar>> {
    let mut unknowns = [guess];
    let mut uncounted = Work::default();
    let mut equations = Momenta { system, t, q, p, h, mass, factors: factors(mass)? };
    newton::solve(&mut equations, &mut unknowns, Scalar::epsilon(), &mut uncounted)?;
    work.evaluations += uncounted.evaluations;
    Ok(unknowns[0])
}

/// Factors a mass matrix.
pub(in crate::integrate) fn factors<S: Scalar, Y: StateVector<S>>(
    mass: &Matrix<S, Y>,
) -> Result<Factors<S, Y>, StepFailure<S>> {
    if !finite(mass.0.as_ref()) {
        return Err(StepFailure::NotFinite);
    }
    Factors::new(mass.clone()).ok_or(StepFailure::SingularMassMatrix)
}

/// The equations ∂L/∂v = p for v.
struct Momenta<'a, M: CanonicalSystem + ?Sized> {
    system: &'a M,
    t: M::Scalar,
    q: &'a M::Coordinates,
    p: &'a M::Coordinates,
    h: M::Scalar,
    mass: &'a Matrix<M::Scalar, M::Coordinates>,
    factors: Factors<M::Scalar, M::Coordinates>,
}

impl<M: CanonicalSystem + ?Sized> Equations<M::Scalar, M::Coordinates, 1> for Momenta<'_, M> {
    #[inline]
    fn residual(&mut self, [v]: &[M::Coordinates; 1], work: &mut Work) -> [M::Coordinates; 1] {
        work.evaluations += 1;
        let mut residual = *self.p;
        let momenta = self.system.momenta(self.t, self.q, v);
        for (residual, momentum) in residual.as_mut().iter_mut().zip(momenta.as_ref()) {
            *residual = *residual - *momentum;
        }
        [residual]
    }

    fn correction(&self, [residual]: &[M::Coordinates; 1]) -> [M::Coordinates; 1] {
        [self.factors.solve(residual)]
    }

    fn magnitude(&self, [v]: &[M::Coordinates; 1]) -> M::Coordinates {
        let unknowns = magnitude(*v, self.q, self.h);
        Matrix::of(|i, j| self.mass[(i, j)].abs()).apply(&unknowns)
    }
}
