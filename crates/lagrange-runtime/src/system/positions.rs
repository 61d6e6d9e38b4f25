//! Positions and velocities of a state, and displacements of positions.

use super::mechanical::description_of_type;
use super::{Description, MechanicalSystem, StateVector, StepFailure, quaternion};
use crate::linalg::vector::add;
use crate::scalar::{Number, Scalar};

/// Splits a state into positions and velocities.
#[inline]
pub fn split<M: MechanicalSystem + ?Sized>(y: &M::State) -> (M::Coordinates, M::Velocities) {
    let (positions, velocities) = y.parts(M::Coordinates::ZERO.as_ref().len());
    (M::Coordinates::of(positions), M::Velocities::of(velocities))
}

/// Joins positions and velocities into a state, or the rates of both into the rates of a state.
#[inline]
pub fn join<M: MechanicalSystem + ?Sized>(q: &M::Coordinates, v: &M::Velocities) -> M::State {
    M::State::joined(q.as_ref(), v.as_ref())
}

/// Error message for a quaternion that cannot be normalised.
const NO_ORIENTATION: &str = "a quaternion of zeros is not an orientation";

/// Normalises unit quaternions among the positions of a state, and leaves the rest unchanged. If
/// velocities are the rates of the positions, the state is unchanged.
/// [`OdeSystem::correct`](super::OdeSystem::correct) calls it for systems with unit quaternions and
/// no other constraints.
///
/// # Errors
/// [`StepFailure::Stuck`] if one is zero; the state is then unchanged.
#[inline]
pub fn normalise<M: MechanicalSystem + ?Sized>(y: &mut M::State) -> Result<(), StepFailure<M::Scalar>> {
    normalise_described::<M>(description_of_type::<M>(), y)
}

/// Normalises unit quaternions of a state like [`normalise`], for a system with this description.
///
/// # Errors
/// [`StepFailure::Stuck`] if one is zero; the state is then unchanged.
#[inline]
pub fn normalise_described<M: MechanicalSystem + ?Sized>(
    description: &Description,
    y: &mut M::State,
) -> Result<(), StepFailure<M::Scalar>> {
    if description.velocities_are_rates() {
        return Ok(());
    }
    let found = normalised::<M>(description, y);
    let is_finite = |y: &M::State| y.as_ref().iter().all(|entry| entry.is_finite());
    if is_finite(y) && !is_finite(&found) {
        return Err(StepFailure::Stuck(NO_ORIENTATION));
    }
    *y = found;
    Ok(())
}

/// Normalises unit quaternions among positions.
#[inline]
pub(crate) fn normalise_positions<M: MechanicalSystem + ?Sized>(
    description: &Description,
    q: &mut M::Coordinates,
) {
    M::normalise(q);
    for &first in description.quaternions {
        quaternion::normalise::<M::Scalar>(q.as_mut(), first);
    }
}

/// Returns the state with normalised unit quaternions.
#[inline]
pub(crate) fn normalised<M: MechanicalSystem + ?Sized>(description: &Description, y: &M::State) -> M::State {
    let (mut q, v) = split::<M>(y);
    normalise_positions::<M>(description, &mut q);
    join::<M>(&q, &v)
}

/// Computes the positions q + Σ c N(q) δ, normalised, for these numbers c and displacements δ.
#[inline]
pub(crate) fn displaced<'a, M>(
    system: &M,
    t: M::Scalar,
    q: &M::Coordinates,
    displacements: impl IntoIterator<Item = (M::Scalar, &'a M::Velocities)>,
) -> M::Coordinates
where
    M: MechanicalSystem + ?Sized,
    M::Velocities: 'a,
{
    let mut to = *q;
    for (part, displacement) in displacements {
        add(&mut to, part, &system.position_change(t, q, displacement));
    }
    normalise_positions::<M>(system.description(), &mut to);
    to
}

/// Returns the displacement of each degree of freedom if positions change by `by`. It is `by`
/// itself, in magnitude, if velocities are rates. Otherwise it is Σᵢ |Nᵢⱼ| |byᵢ| / Σᵢ Nᵢⱼ², the
/// maximum if the columns of N are orthogonal, as for unit quaternions.
#[inline]
pub(crate) fn reach<M: MechanicalSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    q: &M::Coordinates,
    by: &M::Coordinates,
) -> M::Velocities {
    if system.description().velocities_are_rates() {
        let mut reach = M::Velocities::of(by.as_ref());
        reach.as_mut().iter_mut().for_each(|entry| *entry = entry.abs());
        return reach;
    }
    let velocities = system.description().velocities.len();
    let mut reach = M::Velocities::of(&M::Velocities::ZERO.as_ref()[..velocities]);
    let mut unit = reach.zeros();
    for (j, reach) in reach.as_mut().iter_mut().enumerate() {
        unit.as_mut()[j] = M::Scalar::ONE;
        *reach = most(system.position_change(t, q, &unit).as_ref(), by.as_ref());
        unit.as_mut()[j] = M::Scalar::ZERO;
    }
    reach
}

/// Computes Σ |nᵢ| |byᵢ| / Σ nᵢ²; zero for a zero column.
fn most<S: Scalar>(column: &[S], by: &[S]) -> S {
    let (mut sum, mut square) = (S::ZERO, S::ZERO);
    for (entry, by) in column.iter().zip(by) {
        sum = entry.abs().multiply_add(by.abs(), sum);
        square = entry.multiply_add(*entry, square);
    }
    if square == S::ZERO { S::ZERO } else { sum / square }
}
