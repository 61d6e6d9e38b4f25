//! Exact derivatives of a step.
//!
//! A kick adds β h ∂a to the derivatives of velocities, with ∂a = ∂a/∂q ∂q + ∂a/∂p. A drift adds α
//! h ∂v to those of coordinates.

use super::{BlanesMoan4, Composition, Kick, StormerVerlet, SymplecticEuler};
use super::{blanes_moan, composed, symplectic_euler, verlet};
use crate::integrate::step_derivatives::{DerivativeColumns, DifferentiableStep, Slopes, StepDerivativesOf};
use crate::linalg::vector::combined;
use crate::scalar::Number;
use crate::system::{
    LeapfrogSystem, ParametricSystem, SeparableSystem, SettingError, StepFailure, join, split,
};

/// Implements derivatives of steps for a composition and systems of a kind.
macro_rules! differentiable {
    ($($Method:ident of $System:ident = $composition:expr;)*) => {
        $(impl<M: $System + ParametricSystem> DifferentiableStep<M> for $Method<M::Scalar> {
            fn step_derivatives<const K: usize>(
                &self,
                system: &M,
                t: M::Scalar,
                y: &M::State,
                indices: [usize; K],
            ) -> Result<StepDerivativesOf<M, K>, StepFailure<M::Scalar>> {
                differentiated(system, &$composition, (t, y), self.step, &indices)
            }
        })*
    };
}

differentiable! {
    SymplecticEuler of LeapfrogSystem = symplectic_euler::COMPOSITION;
    StormerVerlet of LeapfrogSystem = verlet::COMPOSITION;
    BlanesMoan4 of SeparableSystem = blanes_moan::COMPOSITION;
}

/// Computes a step of length `h` with its derivatives.
fn differentiated<M: LeapfrogSystem + ParametricSystem, const DRIFTS: usize, const K: usize>(
    system: &M,
    composition: &Composition<DRIFTS>,
    (t, y): (M::Scalar, &M::State),
    h: M::Scalar,
    indices: &[usize; K],
) -> Result<StepDerivativesOf<M, K>, StepFailure<M::Scalar>> {
    if M::IS_HELD {
        let held = "steps that end on constraints have no exact derivatives here: use `RungeKutta4`";
        return Err(SettingError::Invalid(held).into());
    }
    let (q, v) = split::<M>(y);
    let number = M::Scalar::from_f64;
    let mut columns = DerivativeColumns::<M, K>::start(y);
    let mut failure = kick(&mut columns, number(composition.first) * h, Slopes::at(system, t, y, indices));
    let start = system.acceleration(t, &q, &v);
    let (trial, gain) = composed(system, composition, t, (&q, &v), h, &start, |part: Kick<'_, M>| {
        columns.update(|_, column| drift::<M>(column, number(part.drift) * h));
        let slopes = Slopes::at(system, part.t, &join::<M>(part.q, part.v), indices);
        failure = failure.take().or(kick(&mut columns, number(part.kick) * h, slopes));
    });
    match failure {
        Some(failure) => Err(failure),
        None => columns.of_end(combined(y, M::Scalar::ONE, &join::<M>(&trial.change, &gain))),
    }
}

/// Adds `h` ∂a to the derivatives of velocities, given those of f. Returns the failure if there are
/// none.
fn kick<M: ParametricSystem, const K: usize>(
    columns: &mut DerivativeColumns<M, K>,
    h: M::Scalar,
    slopes: Result<Slopes<M, K>, StepFailure<M::Scalar>>,
) -> Option<StepFailure<M::Scalar>> {
    let slopes = match slopes {
        Ok(slopes) => slopes,
        Err(failure) => return Some(failure),
    };
    columns.update(|variable, column| {
        let rates = slopes.along(variable, column);
        let half = column.as_ref().len() / 2;
        for (entry, rate) in column.as_mut()[half..].iter_mut().zip(&rates.as_ref()[half..]) {
            *entry = rate.multiply_add(h, *entry);
        }
    });
    None
}

/// Adds `h` times the derivatives of velocities to those of coordinates.
fn drift<M: ParametricSystem>(column: &mut M::State, h: M::Scalar) {
    let half = column.as_ref().len() / 2;
    let (coordinates, velocities) = column.as_mut().split_at_mut(half);
    for (entry, rate) in coordinates.iter_mut().zip(velocities) {
        *entry = rate.multiply_add(h, *entry);
    }
}
