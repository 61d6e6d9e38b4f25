//! Constraints at run time: residuals, and the way back onto them.
//!
//! Accelerations of a constrained system keep c̈ = 0, so that rounding and the errors of a method let c and ċ drift away
//! from zero. After each accepted step a state is therefore put back: with the mass matrix as metric, to the nearest
//! positions that satisfy c(t, q) = 0, and then to the nearest velocities that satisfy ċ(t, q, v) = 0. This is *projection*;
//! it is what [`OdeSystem::correct`](crate::system::OdeSystem::correct) of emitted types does, and all methods of
//! [`integrate`](crate::integrate) ask for it.
//! Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, 2nd ed., §VII.2; Eich-Soellner, Führer,
//! *Numerical Methods in Multibody Dynamics*, §5.3.

mod least_norm;
mod orthogonal;
mod projection;
mod regular;
mod residuals;
#[cfg(test)]
pub(crate) mod systems;
mod unprojected;
mod values;
mod violation;

pub use self::least_norm::{
    RedundantMotion, least_norm, rank_tolerance, redundant_correction, redundant_motion,
};
pub use self::projection::{admit, consistent_velocity, correct, project};
pub use self::regular::{are_finite, are_regular, weighed};
pub(crate) use self::residuals::sizes;
pub use self::unprojected::Unprojected;
pub use self::values::ConstraintValues;
pub(crate) use self::values::inner;
pub use self::violation::Violation;

use crate::system::{MechanicalSystem, StateVector};

/// A mechanical system under constraints. Emitted types with `constraint` statements implement it.
pub trait ConstrainedSystem: MechanicalSystem {
    /// A vector with one entry for each constraint: residuals or multipliers.
    type Multipliers: StateVector<Self::Scalar>;

    /// Names of the constraints in the order of their declaration.
    const CONSTRAINTS: &'static [&'static str];

    /// The multipliers λ in M a = f + Aᵀλ.
    fn multipliers(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Coordinates)
    -> Self::Multipliers;

    /// What must be zero of positions: c(t, q) of holonomic constraints; zero for the others.
    fn position_residuals(&self, t: Self::Scalar, q: &Self::Coordinates) -> Self::Multipliers;

    /// What must be zero of velocities: dc/dt, or c itself where it holds velocities.
    fn velocity_residuals(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
    ) -> Self::Multipliers;

    /// How far the residuals go if every coordinate changes by its share: Σⱼ |Aᵢⱼ| max(|qⱼ|, …) of each constraint.
    /// What counts as zero is measured by it.
    fn residual_scales(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        by: &Self::Coordinates,
    ) -> Self::Multipliers;

    /// The smallest change of the coordinates, measured by the mass matrix, that takes these residuals away to first order:
    /// δ with M δ = Aᵀμ and A δ = −residuals.
    fn correction(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
        residuals: &Self::Multipliers,
    ) -> Self::Coordinates;
}
