//! Diagnosis of values that are not finite, which methods only detect.
//!
//! Methods check the values from which they continue and leave the diagnosis to the loops that
//! drive them. Loops have access to the system, whose [`undefined`](OdeSystem::undefined) provides
//! names. If values are finite where a run stopped, the system is evaluated further ahead, along
//! the direction of the motion. The distances double, starting at rounding: a root of 1 − t is
//! finite up to t = 1, and NaN immediately after.

use crate::linalg::pivoted::Matrix;
use crate::linalg::ranked::RankedFactors;
use crate::linalg::vector::combined;
use crate::scalar::{Number, Scalar};
use crate::system::{Component, MechanicalSystem, OdeSystem, StepFailure, Undefined, VelocityMatrix, split};

/// Fraction of the remaining interval that is searched for the cause of steps too short for the
/// resolution of time.
const NEAR: f64 = 1e-9;

/// Finds the cause, by name, of the end of a run at this time and state on its way to `end`.
#[cold]
pub fn explained<M: OdeSystem + ?Sized>(
    cause: StepFailure<M::Scalar>,
    system: &M,
    (t, y): (M::Scalar, &M::State),
    end: M::Scalar,
) -> StepFailure<M::Scalar> {
    let here = || system.undefined(t, y, &system.rhs(t, y));
    let found = match cause {
        StepFailure::NotFinite => {
            of_times(t, end).or_else(here).or_else(|| ahead(system, (t, y), end, M::Scalar::ONE))
        }
        StepFailure::StepUnderflow { .. } => ahead(system, (t, y), end, M::Scalar::from_f64(NEAR)),
        StepFailure::Violated(violation) if !violation.residual.is_finite() => here(),
        StepFailure::SingularMassMatrix => here().filter(|what| matches!(what, Undefined::MassMatrix { .. })),
        _ => None,
    };
    found.map_or(cause, StepFailure::Undefined)
}

fn of_times<S: Scalar>(start: S, end: S) -> Option<Undefined<S>> {
    match (start.is_finite(), end.is_finite()) {
        (false, _) => Some(Undefined::StartTime { value: start }),
        (true, false) => Some(Undefined::EndTime { value: end }),
        (true, true) => None,
    }
}

/// Returns the first value that is not finite on this fraction of the way to `end`, along the rates
/// at the start.
fn ahead<M: OdeSystem + ?Sized>(
    system: &M,
    (t, y): (M::Scalar, &M::State),
    end: M::Scalar,
    part: M::Scalar,
) -> Option<Undefined<M::Scalar>> {
    let (rates, left) = (system.rhs(t, y), (end - t).abs());
    let mut distance = M::Scalar::epsilon() * t.abs().max(left);
    let farthest = part * left;
    while distance > M::Scalar::ZERO && distance <= farthest && distance.is_finite() {
        let h = if end < t { -distance } else { distance };
        let (later, there) = (t + h, combined(y, h, &rates));
        let found = system.undefined(later, &there, &system.rhs(later, &there));
        // The state is only a guess: its overflow has no meaning.
        if let Some(found) = found {
            return (!matches!(found, Undefined::State { .. })).then_some(found);
        }
        distance = distance + distance;
    }
    None
}

/// Returns the first component of the state and of its rates at a time that is not finite.
/// Undefined rates are attributed to [parameters](MechanicalSystem::parameter) and inputs that are
/// not finite, otherwise to the mass matrix if it is singular.
///
/// Emitted types implement [`OdeSystem::undefined`] by this function.
#[cold]
pub fn undefined<M: MechanicalSystem>(
    system: &M,
    (time, y, rates): (M::Scalar, &M::State, &M::State),
    inputs: &[(&'static str, M::Scalar)],
    mass_matrix: impl FnOnce(&M::Coordinates, &M::Velocities) -> Option<VelocityMatrix<M>>,
) -> Option<Undefined<M::Scalar>> {
    let found = Undefined::of_state(time, y.as_ref(), rates.as_ref(), |index| {
        Component::of(system.description(), index)
    })?;
    if let Undefined::State { .. } = found {
        return Some(found);
    }
    let mut parameters = (0..).map_while(|index| system.parameter(index));
    if let Some((name, value)) = parameters.find(|(_, value)| !value.is_finite()) {
        return Some(Undefined::Parameter { name, value });
    }
    let bad = inputs.iter().find(|(_, value)| !value.is_finite());
    if let Some(&(name, value)) = bad {
        return Some(Undefined::Input { name, value, time });
    }
    let (q, v) = split::<M>(y);
    let singular = mass_matrix(&q, &v).and_then(|mass| {
        let (index, pivot) = lost_pivot::<M>(mass)?;
        Some(Undefined::MassMatrix {
            velocity: Component::of_velocity(system.description(), index)?,
            pivot,
            time,
        })
    });
    singular.or(Some(found))
}

/// Returns the column and the value of the first pivot that is lost in rounding, if the mass matrix
/// is singular.
fn lost_pivot<M: MechanicalSystem>(mass: VelocityMatrix<M>) -> Option<(usize, M::Scalar)> {
    let matrix = Matrix::<M::Scalar, M::Velocities>(mass);
    let rows = matrix.rows();
    RankedFactors::new(matrix, rows)?.lost_pivot()
}
