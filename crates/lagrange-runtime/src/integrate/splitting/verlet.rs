//! The Störmer–Verlet method in its velocity form.
//!
//! Source: Hairer, Lubich, Wanner, *Geometric numerical integration illustrated by the
//! Störmer–Verlet method*, Acta Numerica 12 (2003), 399–450.

use crate::integrate::fixed::fixed_steps;
use crate::integrate::method::Method;
use crate::integrate::splitting::{Composition, Splitting};
use crate::system::LeapfrogSystem;

/// The Störmer–Verlet method in equal steps: half a kick, a drift, half a kick.
///
/// It has order two, is symplectic and symmetric, and uses one acceleration per step. The energy
/// oscillates by O(h²) without drift; steps longer than 2/ω, with the highest frequency ω, are
/// unstable.
///
/// At the end of each step, positions satisfy constraints to rounding, and so do velocities
/// (RATTLE). Each iteration in between uses one correction. Momenta are conserved if the
/// constraints have the same symmetry.
///
/// ```
/// use lagrange::integrate::{StormerVerlet, integrate};
///
/// lagrange::system! {
///     /// A planet around a fixed sun.
///     pub struct Planet;
///
///     param mu = 1.0;
///     coord x, y;
///     kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
///     potential = -mu / hypot(x, y);
/// }
///
/// let planet = Planet::default();
/// let method = StormerVerlet { step: 1e-2 };
/// let [x, y, u, v] = integrate(&planet, 0.0, [1.0, 0.0, 0.0, 1.2], 1000.0, &method, |_, _| {})?;
/// assert!((planet.energy(0.0, &[x, y], &[u, v]) + 0.28).abs() < 1e-4);
/// assert!((x * v - y * u - 1.2).abs() < 1e-14);
/// # Ok::<(), lagrange::integrate::IntegrationError<f64, [f64; 4]>>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StormerVerlet<S> {
    /// Length of a step.
    pub step: S,
}

pub(super) const COMPOSITION: Composition<1> = Composition { first: 0.5, rest: [(1.0, 0.5)], stable: 2.0 };

impl<M: LeapfrogSystem + ?Sized> Method<M> for StormerVerlet<M::Scalar> {
    fixed_steps! { "Störmer–Verlet", 2, Splitting<M::Scalar, M::Coordinates, 1> = Splitting::new(COMPOSITION), lanes }
}
