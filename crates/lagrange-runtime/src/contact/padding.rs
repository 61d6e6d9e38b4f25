//! Velocities as arrays. If their number is known at run time only, zeros fill the arrays.

use super::ContactSystem;
use crate::scalar::Number;
use crate::system::{MechanicalSystem, StateVector, join, split};

/// Splits a state into positions and filled velocities.
#[inline]
pub(super) fn parts<M: MechanicalSystem, const N: usize>(y: &M::State) -> (M::Coordinates, [M::Scalar; N]) {
    let (q, v) = split::<M>(y);
    (q, filled::<M, N>(&v))
}

/// Returns velocities, followed by zeros.
#[inline]
pub(super) fn filled<M: MechanicalSystem, const N: usize>(v: &M::Velocities) -> [M::Scalar; N] {
    let (mut filled, v) = ([M::Scalar::ZERO; N], v.as_ref());
    filled[..v.len()].copy_from_slice(v);
    filled
}

/// Returns the velocities without the zeros after them.
#[inline]
pub(crate) fn own<M, const N: usize, const K: usize>(system: &M, v: &[M::Scalar; N]) -> M::Velocities
where
    M: ContactSystem<N, K>,
{
    M::Velocities::of(&v[..system.velocities()])
}

/// Joins positions and filled velocities into a state.
#[inline]
pub(super) fn joined<M, const N: usize, const K: usize>(
    system: &M,
    q: &M::Coordinates,
    v: &[M::Scalar; N],
) -> M::State
where
    M: ContactSystem<N, K>,
{
    join::<M>(q, &own(system, v))
}
