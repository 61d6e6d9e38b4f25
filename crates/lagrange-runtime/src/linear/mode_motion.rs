//! Modes as motions of the nonlinear system, for films and pictures.
//!
//! The deviation at the time τ is a Re(e^{λτ} s) with the shape s, whose largest displacement is
//! one, and the amplitude a. It contains dependent coordinates, which follow from the
//! [basis](super::LinearModel::basis) to first order. What remains is removed by a projection onto
//! the constraints. Source: Meirovitch, *Methods of Analytical Dynamics*, §6.

use core::f64::consts::{PI, TAU};
use std::vec::Vec;

use super::error::ModeMotionError;
use super::modes::Eigenmode;
use super::names::Names;
use crate::scalar::{Number, Scalar};
use crate::system::{LinearisedSystem, OdeSystem, StateVector, displaced, join, split};

/// Default number of periods shown, in units of 1/|λ| for a mode that does not oscillate.
const PERIODS: f64 = 3.0;
/// Maximum number of moments.
const MAX_COUNT: f64 = 1e5;
/// Number of integration steps between two moments, for orientations of a steady motion.
const STEPS: u32 = 16;

/// A time and a state of a system.
type TimedState<M> = (<M as OdeSystem>::Scalar, <M as OdeSystem>::State);
/// A result concerning the motion of a mode.
type Shown<M, T> = Result<T, ModeMotionError<<M as OdeSystem>::Scalar>>;

/// A mode as a motion of the system about an equilibrium or a steady motion, by
/// [`Linearise::mode_motion`](super::Linearise::mode_motion).
///
/// Time and the steady motion are frozen, unless the steady motion is added by
/// [`along`](Self::along). A growing mode ends with the amplitude, all others begin with it.
#[must_use = "a mode has no moments before they are asked for"]
pub struct ModeMotion<'a, M: LinearisedSystem> {
    pub(super) system: &'a M,
    pub(super) time: M::Scalar,
    pub(super) state: M::State,
    pub(super) mode: &'a Eigenmode,
    pub(super) amplitude: f64,
    is_level: bool,
    is_along: bool,
    periods: f64,
    slowness: f64,
}

impl<'a, M: LinearisedSystem> ModeMotion<'a, M> {
    pub(super) fn new(
        system: &'a M,
        (time, state): (M::Scalar, M::State),
        mode: &'a Eigenmode,
        amplitude: f64,
    ) -> Self {
        let (is_level, is_along, periods, slowness) = (false, false, PERIODS, 1.0);
        ModeMotion { system, time, state, mode, amplitude, is_level, is_along, periods, slowness }
    }

    /// Omits decay and growth: the amplitude is constant. A whole number of periods then repeats
    /// without a jump.
    pub fn level(self) -> Self {
        ModeMotion { is_level: true, ..self }
    }

    /// Adds the steady motion, so that coordinates and time advance.
    pub fn along(self) -> Self {
        ModeMotion { is_along: true, ..self }
    }

    /// Sets the number of periods; 3 by default. For a mode that does not oscillate, a period is
    /// 1/|λ|, in which it changes by the factor e.
    pub fn periods(self, periods: f64) -> Self {
        ModeMotion { periods, ..self }
    }

    /// Slows the film down by this factor.
    pub fn slowed(self, factor: f64) -> Self {
        ModeMotion { slowness: factor, ..self }
    }

    /// Returns moments at equal intervals, about `a_second` per second of the film. Each consists
    /// of its time in the film, the time of the system, and the state.
    ///
    /// # Errors
    /// If any of these holds:
    /// - a setting is not finite, or one that must be positive is not;
    /// - the numbers of components of the mode and the system differ;
    /// - its eigenvalue is zero up to rounding: nothing moves;
    /// - there would be more than 100 000 moments;
    /// - the constraints cannot be satisfied at this amplitude.
    pub fn moments(&self, a_second: f64) -> Shown<M, Vec<(f64, TimedState<M>)>> {
        let duration = self.checked(a_second)? * self.periods;
        let count = (duration * self.slowness * a_second).round().max(1.0);
        if count > MAX_COUNT {
            return Err(ModeMotionError::TooMany { moments: count });
        }
        // Without decay, the final moment would repeat the first.
        let last = if self.is_level { count as u32 - 1 } else { count as u32 };
        let (mut moments, step) = (Vec::new(), duration / count);
        let mut steady = self.state;
        for index in 0..=last {
            let passed = f64::from(index) * step;
            if self.is_along && index > 0 {
                steady = self.gone_on(passed, &steady, step);
            }
            let envelope = if self.is_level { 1.0 } else { self.envelope(passed, duration) };
            let time = if self.is_along { self.time_after(passed) } else { self.time };
            let y = self.deviating((time, &steady), envelope, self.mode.imaginary * passed)?;
            moments.push((passed * self.slowness, (time, y)));
        }
        Ok(moments)
    }

    /// Returns the two moments at which the largest displacement is plus and minus the amplitude.
    ///
    /// # Errors
    /// As [`moments`](Self::moments), but the eigenvalue may be zero.
    pub fn extremes(&self) -> Shown<M, [TimedState<M>; 2]> {
        self.check_numbers(1.0)?;
        let at = |phase: f64| Ok((self.time, self.deviating((self.time, &self.state), 1.0, phase)?));
        Ok([at(0.0)?, at(PI)?])
    }

    /// Checks the settings and returns the duration of a period.
    fn checked(&self, a_second: f64) -> Shown<M, f64> {
        self.check_numbers(a_second)?;
        let Eigenmode { imaginary, uncertainty, .. } = *self.mode;
        if self.mode.natural_frequency() <= uncertainty {
            return Err(ModeMotionError::Still);
        }
        Ok(if imaginary > 0.0 { TAU / imaginary } else { 1.0 / self.mode.real.abs() })
    }

    fn check_numbers(&self, a_second: f64) -> Shown<M, ()> {
        let positive = [("moments a second", a_second), ("periods", self.periods), ("factor", self.slowness)];
        let is_wrong = |(_, value): &&(_, f64)| !(*value > 0.0 && value.is_finite());
        if let Some(&(what, value)) = positive.iter().find(is_wrong) {
            return Err(ModeMotionError::Setting { what, value });
        }
        if !self.amplitude.is_finite() {
            return Err(ModeMotionError::Setting { what: "amplitude", value: self.amplitude });
        }
        let (of_mode, of_system) = (self.mode.shape.len(), Names::of(self.system).tangent().len());
        if of_mode != of_system {
            return Err(ModeMotionError::OtherSystem { of_mode, of_system });
        }
        Ok(())
    }

    /// Returns the fraction of the amplitude at a time, at most one.
    fn envelope(&self, passed: f64, duration: f64) -> f64 {
        let rate = self.mode.real;
        (rate * (if rate > 0.0 { passed - duration } else { passed })).exp()
    }

    fn time_after(&self, passed: f64) -> M::Scalar {
        self.time + M::Scalar::from_f64(passed)
    }

    /// Advances the steady motion to a time from the previous moment. Its velocities are constant.
    fn gone_on(&self, passed: f64, before: &M::State, step: f64) -> M::State {
        let (mut q, v) = split::<M>(before);
        if self.system.description().velocities_are_rates() {
            // This avoids accumulated rounding.
            let (start, _) = split::<M>(&self.state);
            q = displaced(self.system, self.time, &start, [(M::Scalar::from_f64(passed), &v)]);
            return join::<M>(&q, &v);
        }
        let part = M::Scalar::from_f64(step / f64::from(STEPS));
        let half = M::Scalar::from_f64(0.5) * part;
        let t = self.time_after(passed);
        for _ in 0..STEPS {
            // The midpoint rule.
            let middle = displaced(self.system, t, &q, [(half, &v)]);
            let rates = self.system.position_change(t, &middle, &v);
            for (entry, rate) in q.as_mut().iter_mut().zip(rates.as_ref()) {
                *entry = *entry + part * *rate;
            }
            q = displaced(self.system, t, &q, []);
        }
        join::<M>(&q, &v)
    }

    /// Returns a state that deviates by this fraction of the amplitude, at a phase of the
    /// oscillation.
    fn deviating(&self, (time, from): (M::Scalar, &M::State), part: f64, phase: f64) -> Shown<M, M::State> {
        let names = Names::of(self.system);
        let (n, first, states) = (names.freedoms(), names.first_state(), names.state.first_order_states);
        let (sine, cosine) = phase.sin_cos();
        let entry = |index: usize| {
            let (real, imaginary) = self.mode.shape[index];
            M::Scalar::from_f64(self.amplitude * part * (real * cosine - imaginary * sine))
        };
        let (q, mut v) = split::<M>(from);
        let mut displacement = v.zeros();
        for j in 0..n {
            displacement.as_mut()[j] = entry(j);
            v.as_mut()[j] = v.as_ref()[j] + entry(n + states + j);
        }
        let mut q = displaced(self.system, time, &q, [(M::Scalar::ONE, &displacement)]);
        for j in 0..states {
            q.as_mut()[first + j] = q.as_ref()[first + j] + entry(n + j);
        }
        let mut y = join::<M>(&q, &v);
        self.system.restore(time, &mut y).map_err(ModeMotionError::Constrained)?;
        match y.as_ref().iter().all(|entry| entry.is_finite()) {
            true => Ok(y),
            false => Err(ModeMotionError::Setting { what: "amplitude", value: self.amplitude }),
        }
    }
}
