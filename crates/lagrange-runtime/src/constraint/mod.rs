//! Constraints at run time: residuals, and projection onto the constraints.
//!
//! Accelerations of a constrained system keep c̈ = 0, so rounding and the errors of a method let c
//! and ċ drift away from zero. After each accepted step the state is therefore corrected, with the
//! mass matrix as metric. Positions are moved to satisfy c(t, q) = 0, each time by the smallest
//! possible correction. Velocities then become the nearest ones that satisfy ċ(t, q, v) = 0. From
//! nearby, these positions are also the nearest ones. From far away, [`project`] continues to the
//! nearest ones. This is *projection*. [`OdeSystem::correct`](crate::system::OdeSystem::correct) of
//! emitted types does it, and all methods of [`integrate`](crate::integrate) call it.
//!
//! There are two alternatives. Residuals can be left to the accelerations alone ([`Unprojected`]).
//! Or they can decay through a modification of the accelerations, c̈ + 2 κ ċ + κ² c = 0 (`stabilise
//! = κ;`, after Baumgarte). Projection is recommended: no rate must be chosen, and constraints hold
//! to rounding. As an example, a point mass on a rod of 1 m in Cartesian coordinates swings from a
//! horizontal start for 1000 s. The methods are `RungeKutta4` with steps of 0.01 s and `Verner98`
//! with the tolerance 10⁻¹⁰, observed at every step:
//!
//! | | largest c | largest ċ | error of the energy | of the position | evaluations |
//! |---|---|---|---|---|---|
//! | RK4, projection | 3·10⁻¹⁶ | 1·10⁻¹⁵ | 2·10⁻⁴ | 7·10⁻³ | 400 000 |
//! | κ = 1/s | 1·10⁻⁶ | 7·10⁻⁷ | 5·10⁻⁵ | 2·10⁻³ | 400 000 |
//! | κ = 5/s | 2·10⁻⁷ | 1·10⁻⁶ | 2·10⁻⁴ | 9·10⁻³ | 400 000 |
//! | κ = 20/s | 2·10⁻⁶ | 8·10⁻⁵ | 9·10⁻³ | 0.4 | 400 000 |
//! | κ = 100/s | 1·10⁻⁴ | 2·10⁻² | 5·10⁻² | 2 | 400 000 |
//! | neither | overflows | overflows | after 990 s | | 395 857 |
//! | Verner, projection | 4·10⁻¹⁶ | 9·10⁻¹⁶ | 2·10⁻⁸ | 8·10⁻⁷ | 268 161 |
//! | κ = 1/s | 4·10⁻¹² | 1·10⁻¹¹ | 5·10⁻⁸ | 2·10⁻⁶ | 267 617 |
//! | κ = 5/s | 9·10⁻¹³ | 9·10⁻¹² | 2·10⁻⁹ | 7·10⁻⁸ | 385 185 |
//! | κ = 20/s | 1·10⁻¹³ | 2·10⁻¹² | 2·10⁻¹⁰ | 9·10⁻⁹ | 1 013 632 |
//! | κ = 100/s | 2·10⁻¹⁴ | 3·10⁻¹² | 3·10⁻¹¹ | 1·10⁻⁹ | 4 203 087 |
//! | neither | 1·10⁻⁶ | 3·10⁻⁹ | 8·10⁻⁶ | 1·10⁻⁴ | 268 161 |
//!
//! A large rate makes the equations stiff. An adaptive method then takes shorter steps, which makes
//! its rows more accurate; steps of fixed length do not resolve it.
//! (`tests/trajectories/projected.rs` prints the table.)
//!
//! A projection takes about as long as three evaluations of the accelerations. The benchmark `cargo
//! bench -p lagrange-benches --bench projection` measures the rod, a four-bar linkage and Andrews'
//! squeezer. A step of `RungeKutta4` takes longer by factors of 1.5, 1.9 and 1.7, and a step of
//! `Verner98` by 2 %, 18 % and 17 %.
//!
//! Projection preserves the order of a method, but not its symplecticity. Energies and the momenta
//! of symmetries are then conserved to the accuracy of the method, with a slow drift. `Variational`
//! and `StormerVerlet` enforce constraints within their steps and are not projected; they suit long
//! motions at moderate accuracy.
//!
//! Sources: Hairer, Wanner, *Solving Ordinary Differential Equations II*, 2nd ed., §VII.2; Hairer,
//! Lubich, Wanner, *Geometric Numerical Integration*, 2nd ed., §IV.4, §VII.1; Eich-Soellner,
//! Führer, *Numerical Methods in Multibody Dynamics*, §5.3; Baumgarte, *Stabilization of
//! constraints and integrals of motion in dynamical systems*, Computer Methods in Applied Mechanics
//! and Engineering 1 (1972), 1–16.

mod adjoint;
#[cfg(test)]
pub(crate) mod doubles;
mod indefinite;
mod minimum_norm;
mod nearest;
mod projection;
mod regular;
mod residuals;
mod unprojected;

pub use self::adjoint::correct_adjoint;
pub use self::indefinite::indefinite_motion;
pub use self::minimum_norm::{
    RedundantMotion, minimum_norm, rank_tolerance, redundant_correction, redundant_motion,
};
pub(crate) use self::projection::UNDETERMINED;
pub use self::projection::{admit, consistent_velocity, correct, project, restore};
pub use self::regular::{are_finite, are_regular, weighed, weighed_entries};
pub(crate) use self::residuals::sizes;
pub use self::unprojected::Unprojected;
pub use crate::system::{ConstraintValues, Violated, Violation};

use crate::system::{MechanicalSystem, StateVector};

/// A mechanical system with constraints. Emitted types with `constraint` statements implement it.
pub trait ConstrainedSystem: MechanicalSystem {
    /// A vector with one entry for each constraint: residuals or multipliers.
    type Multipliers: StateVector<Self::Scalar>;

    /// Names of the constraints in the order of their declaration.
    const CONSTRAINTS: &'static [&'static str];

    /// Returns the names of the constraints of this system. They are
    /// [`CONSTRAINTS`](Self::CONSTRAINTS) unless the system was read at run time.
    #[inline]
    fn constraint_names(&self) -> &'static [&'static str] {
        Self::CONSTRAINTS
    }

    /// Computes the multipliers λ in M a = f + Aᵀλ.
    fn multipliers(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Velocities) -> Self::Multipliers;

    /// Returns the residuals of positions: c(t, q) for holonomic constraints; zero for the others.
    fn position_residuals(&self, t: Self::Scalar, q: &Self::Coordinates) -> Self::Multipliers;

    /// Returns the residuals of velocities: dc/dt, or c itself if it contains velocities.
    fn velocity_residuals(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
    ) -> Self::Multipliers;

    /// Returns the scale of each residual: its maximum change Σⱼ |Aᵢⱼ| byⱼ if positions are
    /// displaced, or velocities change, by `by`. Here A contains the gradients with respect to
    /// velocities. Tolerances are relative to these scales; see [`project`].
    fn residual_scales(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        by: &Self::Velocities,
    ) -> Self::Multipliers;

    /// Computes the smallest [displacement](MechanicalSystem) of the positions, or change of the
    /// velocities, that removes these residuals to first order. It is measured by the mass matrix:
    /// δ with M δ = Aᵀμ and A δ = −residuals. If there is none, the result is not finite.
    /// [`redundant_correction`] handles dependent constraints.
    fn correction(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
        residuals: &Self::Multipliers,
    ) -> Self::Velocities;

    /// Multiplies M(t, q, v) by a displacement of the positions, or a change of the velocities.
    fn mass_times(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
        change: &Self::Velocities,
    ) -> Self::Velocities;
}
