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
/// It has order one, is symplectic but not symmetric, and uses one acceleration per step. The
/// energy oscillates by O(h) without drift, so games and sketches run indefinitely.
/// [`StormerVerlet`](crate::integrate::StormerVerlet) has the same cost and order two. Constraints
/// on positions are satisfied in the same way.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SymplecticEuler<S> {
    /// Length of a step.
    pub step: S,
}

pub(super) const COMPOSITION: Composition<1> = Composition { first: 1.0, rest: [(1.0, 0.0)], stable: 2.0 };

impl<M: LeapfrogSystem + ?Sized> Method<M> for SymplecticEuler<M::Scalar> {
    fixed_steps! { "symplectic Euler", 1, Splitting<M::Scalar, M::Coordinates, 1> = Splitting::new(COMPOSITION), lanes }
}
