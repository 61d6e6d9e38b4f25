//! States from which methods may continue, on the constraints of their system.

use crate::integrate::compensated::Compensated;
use crate::scalar::{Number, Scalar};
use crate::system::{OdeSystem, SettingError, StateVector, StepFailure, check_delays};

/// Checks that time and state are finite, so that a motion can continue from them.
#[inline]
pub(super) fn check_finite<S: Scalar, Y: StateVector<S>>(t: S, y: &Y) -> Result<(), StepFailure<S>> {
    if t.is_finite() && y.as_ref().iter().all(|component| component.is_finite()) {
        return Ok(());
    }
    Err(StepFailure::NotFinite)
}

/// True in each lane in which this is neither NaN nor infinite.
#[inline(always)]
pub(super) fn is_finite<S: Number>(value: S) -> S::Mask {
    // Infinity times zero is NaN.
    (value * S::ZERO).less_equal(S::ZERO)
}

const NOISE: &str = "the system has white noise, which only `EulerMaruyama` and `StochasticRungeKutta4` integrate, \
     `maruyama` and `stochastic` in the command and in Python";

/// Returns an initial state of a system without noise, projected onto the constraints if it nearly
/// satisfies them.
pub(super) fn admitted<M: OdeSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
) -> Result<M::State, StepFailure<M::Scalar>> {
    if system.noise().acts() {
        return Err(SettingError::Invalid(NOISE).into());
    }
    admitted_with_noise(system, t, y)
}

/// Returns an initial state of any system, as [`admitted`].
pub(super) fn admitted_with_noise<M: OdeSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
) -> Result<M::State, StepFailure<M::Scalar>> {
    check_delays(system)?;
    check_finite(t, y)?;
    let mut admitted = *y;
    system.admit(t, &mut admitted)?;
    check_finite(t, &admitted)?;
    Ok(admitted)
}

/// Projects the end of a step onto the constraints.
#[inline]
pub(super) fn correct<M: OdeSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    state: &mut Compensated<M::State>,
) -> Result<(), StepFailure<M::Scalar>> {
    if !system.is_constrained() {
        return Ok(());
    }
    let mut y = *state.value();
    system.correct(t, &mut y)?;
    check_finite(t, &y)?;
    state.replace(y);
    Ok(())
}

/// Returns a state within a step, projected onto the constraints if possible. It is as close to
/// them as the method is accurate, and lies between two projected states.
#[inline]
pub(super) fn corrected<M: OdeSystem + ?Sized>(system: &M, t: M::Scalar, y: M::State) -> M::State {
    if !system.is_constrained() {
        return y;
    }
    let mut corrected = y;
    match system.correct(t, &mut corrected) {
        Ok(()) => corrected,
        Err(_) => y,
    }
}

/// True if both states are equal.
#[inline]
pub(super) fn is_same<S: Scalar, Y: StateVector<S>>(from: &Y, to: &Y) -> bool {
    from.as_ref() == to.as_ref()
}
