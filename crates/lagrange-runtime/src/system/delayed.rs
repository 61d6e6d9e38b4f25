//! Systems with delayed signals.

use super::{ControlledSystem, MechanicalSystem, OdeSystem, SettingError, StateVector};

/// A system whose rates depend on past values of signals.
///
/// Emitted types implement it if their declaration calls `delay(e, tau)`. Delayed signals are
/// inputs; [`with_history`](crate::simulate::Simulation::with_history) sets their values.
#[diagnostic::on_unimplemented(
    message = "`{Self}` delays no signals",
    note = "write a delayed signal as `delay(x, 0.1)` in a force, a rate, an event or an output"
)]
pub trait DelayedSystem: ControlledSystem + MechanicalSystem {
    /// A number for each delayed signal, such as `[S; K]`.
    type Signals: StateVector<<Self as OdeSystem>::Scalar>;

    /// Returns the times by which the signals are delayed.
    fn lags(&self) -> Self::Signals;

    /// Computes the signals at time `t`, positions `q` and velocities `v`, without delay.
    fn signals(
        &self,
        t: <Self as OdeSystem>::Scalar,
        q: &Self::Coordinates,
        v: &Self::Velocities,
    ) -> Self::Signals;

    /// Computes the signals at time `t` before the start of a motion at positions `q` and
    /// velocities `v`. `None` if they always had the values of the start.
    fn signals_before(
        &self,
        _t: <Self as OdeSystem>::Scalar,
        _q: &Self::Coordinates,
        _v: &Self::Velocities,
    ) -> Option<Self::Signals> {
        None
    }

    /// Returns the system with other values of the delayed signals.
    #[must_use]
    fn with_delayed(&self, values: &Self::Signals) -> Self;
}

/// Checks that a system can run without a history.
///
/// # Errors
/// If it has delays.
pub fn check_delays<M: OdeSystem + ?Sized>(system: &M) -> Result<(), SettingError<M::Scalar>> {
    match system.has_delays() {
        true => Err(SettingError::Invalid(
            "delayed signals need a past, which is not kept here: use `.simulate(…)` and `.with_history()`",
        )),
        false => Ok(()),
    }
}
