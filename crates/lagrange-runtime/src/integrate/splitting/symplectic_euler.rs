//! The symplectic Euler method.
//!
//! Source: Hairer, Lubich, Wanner, *Geometric Numerical Integration*, 2nd ed., §I.1.2 and theorem
//! VI.3.3.

use crate::integrate::fixed::fixed_steps;
use crate::integrate::method::Method;
use crate::integrate::splitting::{Composition, Splitting};
use crate::system::LeapfrogSystem;

/// The symplectic Euler method in equal steps: velocities first, then coordinates with the new
/// velocities.
///
/// Order one; symplectic, not symmetric. One acceleration a step. The energy oscillates by O(h)
/// without drift, so that games and sketches stay alive for ever;
/// [`StormerVerlet`](crate::integrate::StormerVerlet) costs the same and has order two. Constraints
/// on positions are satisfied as there.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SymplecticEuler<S> {
    /// Length of a step.
    pub step: S,
}

pub(super) const COMPOSITION: Composition<1> = Composition { first: 1.0, rest: [(1.0, 0.0)], stable: 2.0 };

impl<M: LeapfrogSystem + ?Sized> Method<M> for SymplecticEuler<M::Scalar> {
    fixed_steps! { "symplectic Euler", 1, Splitting<M::Scalar, M::Coordinates, 1> = Splitting::new(COMPOSITION), lanes }
}
