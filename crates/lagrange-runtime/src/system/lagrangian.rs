//! Systems that know what their equations were derived from.

use super::EnergyFunction;

/// A system with its Lagrangian and its generalised forces, from which laws are
/// [checked](crate::laws). Emitted types implement it if the declaration has `emit { tests }`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not know its Lagrangian",
    note = "add `emit {{ tests }}` to the declaration"
)]
pub trait LagrangianSystem: EnergyFunction {
    /// Computes the Lagrangian L(t, q, v).
    fn lagrangian(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Velocities) -> Self::Scalar;

    /// Computes the generalised forces Q of d/dt ∂L/∂v − ∂L/∂q = Q: those applied, of dissipation,
    /// of constraints, contacts and friction.
    fn generalised_forces(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
    ) -> Self::Velocities;
}
