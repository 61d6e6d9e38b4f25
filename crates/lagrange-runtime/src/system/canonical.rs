//! Systems in canonical coordinates, which symplectic methods require: velocities are the rates of
//! the coordinates.

use super::{ConstraintValues, MechanicalSystem, StateVector, VelocityMatrix};

/// A system whose accelerations do not depend on its velocities and whose mass matrix is constant.
///
/// This makes the Hamiltonian a sum of a function of momenta and one of coordinates, as explicit
/// symplectic methods require. Source: Hairer, Lubich, Wanner, *Geometric Numerical Integration*,
/// 2nd ed., §VI.3.
#[diagnostic::on_unimplemented(
    message = "the accelerations of `{Self}` depend on velocities or constraints, or its mass matrix is not constant",
    note = "compositions of kicks and drifts only accept separable systems without constraints",
    note = "`StormerVerlet` also accepts constraints on positions",
    note = "`GaussLegendre` and `Variational` are symplectic for any mass matrix",
    note = "methods in coordinates and momenta do not accept unit quaternions or first-order states: use \
    `Verner98`, `RungeKutta4`, or `GaussLegendre` with `.plain()`"
)]
pub trait SeparableSystem: MechanicalSystem<Velocities = <Self as MechanicalSystem>::Coordinates> {}

/// A system that is [separable](SeparableSystem), or would be without its constraints, all of which
/// hold positions.
///
/// Every separable system qualifies. Emitted types with constraints implement it if their mass
/// matrix is constant and only constraint forces depend on velocities. Explicit steps then end on
/// the constraints by corrections in the space of constraint forces. Source: Hairer, Lubich,
/// Wanner, *Geometric Numerical Integration*, 2nd ed., §VII.1.3.
#[diagnostic::on_unimplemented(
    message = "the accelerations of `{Self}` depend on velocities, or its mass matrix is not constant",
    note = "symplectic Euler and Störmer–Verlet only accept separable systems, possibly with constraints on positions",
    note = "`GaussLegendre` and `Variational` are symplectic for any mass matrix",
    note = "methods in coordinates and momenta do not take unit quaternions or first-order states: for these there are `Verner98`, `RungeKutta4` and \
            `GaussLegendre` with `.plain()`"
)]
pub trait LeapfrogSystem: MechanicalSystem<Velocities = <Self as MechanicalSystem>::Coordinates> {
    /// True if constraints hold the system and the corrections below are implemented.
    const IS_HELD: bool = false;

    /// Computes the change δ of coordinates that removes the residuals at the coordinates `to` and
    /// the time `later` to first order. Constraint forces at `q` cause it: M δ = A(t, q)ᵀμ and A(t,
    /// q) δ = −c(later, to).
    #[inline]
    fn position_correction(
        &self,
        _t: Self::Scalar,
        _q: &Self::Coordinates,
        _later: Self::Scalar,
        _to: &Self::Coordinates,
    ) -> Self::Coordinates {
        Self::Coordinates::ZERO
    }

    /// Computes the change δ of velocities by constraint forces that leaves no residual: M δ = Aᵀμ
    /// and A δ = −ċ(t, q, v).
    #[inline]
    fn velocity_correction(
        &self,
        _t: Self::Scalar,
        _q: &Self::Coordinates,
        _v: &Self::Coordinates,
    ) -> Self::Coordinates {
        Self::Coordinates::ZERO
    }
}

impl<M: SeparableSystem + ?Sized> LeapfrogSystem for M {}

/// A mechanical system that provides its momenta p = ∂L/∂v and their rates ṗ = ∂L/∂q + Q.
///
/// These are Hamilton's equations with velocities instead of momenta; methods that are symplectic
/// for any mass matrix integrate (q, p). Emitted types implement it if the declaration contains
/// `emit { momentum_rates }`.
#[diagnostic::on_unimplemented(
    message = "the momenta of `{Self}` and their rates are unknown",
    note = "if its velocities are rates of coordinates, add `emit {{ momentum_rates }}` to its declaration",
    note = "methods in coordinates and momenta do not take unit quaternions or first-order states: for these there are `Verner98`, `RungeKutta4` and \
            `GaussLegendre` with `.plain()`"
)]
pub trait CanonicalSystem: MechanicalSystem<Velocities = <Self as MechanicalSystem>::Coordinates> {
    /// Computes the momenta p = ∂L/∂v.
    fn momenta(&self, t: Self::Scalar, q: &Self::Coordinates, v: &Self::Coordinates) -> Self::Coordinates;

    /// Computes the rates ∂L/∂q + Q of the momenta.
    fn momentum_rates(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
    ) -> Self::Coordinates;

    /// Computes the mass matrix ∂p/∂v, in rows.
    fn mass_matrix(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
    ) -> VelocityMatrix<Self>;

    /// Computes the rates of the momenta without the forces Aᵀλ of constraints. Methods that solve
    /// for these forces ignore combinations of the rows of A, so rates that include them are also
    /// valid.
    #[inline]
    fn free_momentum_rates(
        &self,
        t: Self::Scalar,
        q: &Self::Coordinates,
        v: &Self::Coordinates,
    ) -> Self::Coordinates {
        self.momentum_rates(t, q, v)
    }

    /// True if [`constraint_values`](Self::constraint_values) lists every constraint of the system.
    /// Methods with their own enforcement of constraints then use it; for other systems, states are
    /// corrected after steps.
    const SAYS_CONSTRAINTS: bool = false;

    /// Returns the acting constraints, always in the same order.
    #[inline]
    fn constraint_values(
        &self,
        _t: Self::Scalar,
        _q: &Self::Coordinates,
        _v: &Self::Coordinates,
    ) -> ConstraintValues<Self::Scalar, Self::Coordinates> {
        ConstraintValues::NONE
    }
}
