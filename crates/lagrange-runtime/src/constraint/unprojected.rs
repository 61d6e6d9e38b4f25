//! Systems without projection.

use super::ConstrainedSystem;
use crate::system::{
    CanonicalSystem, DeclaredEvent, EnergyFunction, MechanicalSystem, OdeSystem, Reacted, Response,
    SeparableSystem, StateMatrix, StepFailure, Undefined, VelocityMatrix,
};

/// A system whose states methods leave as they find them: what its constraints demand of accelerations is all that holds it.
///
/// For measurements of what projection does, and for systems that are stabilised otherwise. Starts are checked and put onto the
/// constraints all the same; errors of the method then carry the motion away from them, and unit quaternions away from length one.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Unprojected<M>(
    /// The system.
    pub M,
);

impl<M: OdeSystem> OdeSystem for Unprojected<M> {
    type Scalar = M::Scalar;
    type State = M::State;

    #[inline]
    fn rhs(&self, t: M::Scalar, y: &M::State) -> M::State {
        self.0.rhs(t, y)
    }

    fn undefined(&self, t: M::Scalar, y: &M::State, rates: &M::State) -> Option<Undefined<M::Scalar>> {
        self.0.undefined(t, y, rates)
    }

    #[inline]
    fn jacobian(&self, t: M::Scalar, y: &M::State) -> Option<StateMatrix<M>> {
        self.0.jacobian(t, y)
    }

    #[inline]
    fn next_restart(&self, t: M::Scalar, end: M::Scalar) -> Option<M::Scalar> {
        self.0.next_restart(t, end)
    }

    fn beyond(&self, t: M::Scalar, end: M::Scalar) -> Option<Self> {
        self.0.beyond(t, end).map(Unprojected)
    }

    #[inline]
    fn admit(&self, t: M::Scalar, y: &mut M::State) -> Result<(), StepFailure<M::Scalar>> {
        self.0.admit(t, y)
    }

    #[inline]
    fn restore(&self, t: M::Scalar, y: &mut M::State) -> Result<(), StepFailure<M::Scalar>> {
        self.0.restore(t, y)
    }

    const EVENTS: &'static [DeclaredEvent] = M::EVENTS;

    #[inline]
    fn event_values(&self, t: M::Scalar, y: &M::State, values: &mut [M::Scalar]) {
        self.0.event_values(t, y, values);
    }

    fn react(&self, event: usize, t: M::Scalar, elapsed: M::Scalar, y: &M::State) -> Reacted<Self> {
        let Response { action, system, kind } = self.0.react(event, t, elapsed, y)?;
        Ok(Response { action, system: system.map(Unprojected), kind })
    }

    fn begin(&self, t: M::Scalar, y: &M::State) -> Result<Option<Self>, StepFailure<M::Scalar>> {
        Ok(self.0.begin(t, y)?.map(Unprojected))
    }

    fn on_sides(&self, t: M::Scalar, y: &M::State) -> Option<Self> {
        self.0.on_sides(t, y).map(Unprojected)
    }

    fn freed(&self) -> Option<Self> {
        self.0.freed().map(Unprojected)
    }
}

impl<M: MechanicalSystem> MechanicalSystem for Unprojected<M> {
    type Coordinates = M::Coordinates;
    type Velocities = M::Velocities;
    type Columns<C> = M::Columns<C>;

    const COORDINATES: &'static [&'static str] = M::COORDINATES;
    const VELOCITIES: &'static [&'static str] = M::VELOCITIES;

    #[inline]
    fn acceleration(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Velocities {
        self.0.acceleration(t, q, v)
    }

    #[inline]
    fn position_rates(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Coordinates {
        self.0.position_rates(t, q, v)
    }

    #[inline]
    fn position_change(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Coordinates {
        self.0.position_change(t, q, v)
    }

    #[inline]
    fn normalise(q: &mut M::Coordinates) {
        M::normalise(q);
    }

    #[inline]
    fn displacement(&self, t: M::Scalar, from: &M::Coordinates, to: &M::Coordinates) -> M::Velocities {
        self.0.displacement(t, from, to)
    }

    fn parameter(&self, index: usize) -> Option<(&'static str, M::Scalar)> {
        self.0.parameter(index)
    }
}

impl<M: EnergyFunction> EnergyFunction for Unprojected<M> {
    #[inline]
    fn energy(&self, t: M::Scalar, q: &M::Coordinates, v: &M::Velocities) -> M::Scalar {
        self.0.energy(t, q, v)
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
