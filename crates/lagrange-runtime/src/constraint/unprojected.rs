//! Systems without projection.

use super::ConstrainedSystem;
use crate::system::{CanonicalSystem, OdeSystem, SeparableSystem, StateMatrix, VelocityMatrix, Wrapper};

/// A system whose states are not corrected by methods: constraints act only through the
/// accelerations.
///
/// It serves to measure the effect of projection, and for systems with another stabilisation.
/// Initial states are still checked and brought onto the constraints. Errors of the method then
/// carry the motion away from them, and unit quaternions away from length one.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Unprojected<M>(
    /// The system.
    pub M,
);

impl<M: OdeSystem> Wrapper for Unprojected<M> {
    type Inner = M;
    type State = M::State;

    const IS_PROJECTED: bool = false;

    #[inline]
    fn inner(&self) -> &M {
        &self.0
    }

    fn around(&self, inner: M) -> Self {
        Unprojected(inner)
    }

    #[inline]
    fn outer_rhs(&self, t: M::Scalar, y: &M::State) -> M::State {
        self.0.rhs(t, y)
    }

    #[inline]
    fn outer_jacobian(&self, t: M::Scalar, y: &M::State) -> Option<StateMatrix<M>> {
        self.0.jacobian(t, y)
    }
}

impl<M: SeparableSystem> SeparableSystem for Unprojected<M> {}

impl<M: CanonicalSystem> CanonicalSystem for Unprojected<M> {
    #[inline]
    fn momenta(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Coordinates) -> M::Coordinates {
        self.0.momenta(t, q, v)
    }

    #[inline]
    fn momentum_rates(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Coordinates) -> M::Coordinates {
        self.0.momentum_rates(t, q, v)
    }

    #[inline]
    fn mass_matrix(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Coordinates) -> VelocityMatrix<M> {
        self.0.mass_matrix(t, q, v)
    }
}

impl<M: ConstrainedSystem> ConstrainedSystem for Unprojected<M> {
    type Multipliers = M::Multipliers;

    const CONSTRAINTS: &'static [&'static str] = M::CONSTRAINTS;

    #[inline]
    fn constraint_names(&self) -> &'static [&'static str] {
        self.0.constraint_names()
    }

    #[inline]
    fn multipliers(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Multipliers {
        self.0.multipliers(t, q, v)
    }

    #[inline]
    fn position_residuals(&self, t: M::Scalar, q: &M::Coordinates) -> M::Multipliers {
        self.0.position_residuals(t, q)
    }

    #[inline]
    fn velocity_residuals(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Multipliers {
        self.0.velocity_residuals(t, q, v)
    }

    #[inline]
    fn residual_scales(&self, t: M::Scalar, q: &M::Coordinates, by: &M::Velocities) -> M::Multipliers {
        self.0.residual_scales(t, q, by)
    }

    #[inline]
    fn correction(
        &self,
        t: M::Scalar,
        q: &M::Coordinates,
        v: &M::Velocities,
        residuals: &M::Multipliers,
    ) -> M::Velocities {
        self.0.correction(t, q, v, residuals)
    }

    #[inline]
    fn mass_times(
        &self,
        t: M::Scalar,
        q: &M::Coordinates,
        v: &M::Velocities,
        change: &M::Velocities,
    ) -> M::Velocities {
        self.0.mass_times(t, q, v, change)
    }
}
