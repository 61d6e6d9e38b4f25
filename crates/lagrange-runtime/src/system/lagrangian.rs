//! Systems that provide their Lagrangian and generalised forces.

use super::EnergyFunction;

/// A system with its Lagrangian and its generalised forces, used to [check laws](crate::laws).
/// Emitted types implement it if the declaration has `emit { tests }`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not know its Lagrangian",
    note = "add `emit {{ tests }}` to the declaration"
)]
pub trait LagrangianSystem: EnergyFunction {
    /// Computes the Lagrangian L(t, q, v).
    fn lagrangian(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Velocities) -> Self::Scalar;

    /// Computes the generalised forces Q of d/dt ∂L/∂v − ∂L/∂q = Q. They comprise applied forces
    /// and those of dissipation, constraints, contacts and friction.
    fn generalised_forces(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
    ) -> Self::Velocities;
}
