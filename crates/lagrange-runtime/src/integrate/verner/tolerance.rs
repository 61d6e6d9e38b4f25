//! Errors and rates relative to the tolerance.

use super::{AT_REST, LONGEST, LONGEST_AT_REST, Verner98};
use crate::integrate::corrected::is_finite;
use crate::linalg::vector::combined;
use crate::scalar::{Number, Scalar};
use crate::system::{Domain, OdeSystem, SettingError, StateVector, StepFailure};
use crate::tolerance::LEAST_TOLERANCE;

/// The tolerated error of a component: a fraction of its size, plus a part of its nominal value.
#[derive(Clone, Copy, Debug)]
pub(in crate::integrate) struct Tolerated<S> {
    pub(in crate::integrate) relative: S,
    pub(in crate::integrate) absolute: S,
    pub(in crate::integrate) domain: &'static Domain,
}

impl<S: Number> Tolerated<S> {
    /// Returns the tolerated error of the component of this index and size.
    #[inline(always)]
    pub(in crate::integrate) fn of(&self, component: usize, size: S) -> S {
        self.relative.multiply_add(size, self.of_nominal(component, self.absolute))
    }

    /// Returns a number times the nominal value of a component.
    #[inline(always)]
    pub(in crate::integrate) fn of_nominal(&self, component: usize, number: S) -> S {
        match self.domain.nominal.get(component) {
            Some(nominal) => number * S::from_f64(*nominal),
            None => number,
        }
    }

    /// Computes the root mean square of `h · error` relative to the tolerance between the states
    /// `from` and `to`.
    #[inline(always)]
    pub(in crate::integrate) fn norm<Y: StateVector<S>>(&self, h: S, error: &Y, from: &Y, to: &Y) -> S {
        let ends = from.as_ref().iter().zip(to.as_ref()).enumerate();
        let mut sum = S::ZERO;
        for (error, (component, (from, to))) in error.as_ref().iter().zip(ends) {
            let part = h * *error / self.of(component, from.abs().max(to.abs()));
            // Zero divided by zero if nothing moves and nothing is tolerated.
            let is_zero = error.less_equal(S::ZERO) & S::ZERO.less_equal(*error);
            sum = S::select(is_zero, sum, part.multiply_add(part, sum));
        }
        (sum / S::from_f64(from.as_ref().len() as f64)).sqrt()
    }

    /// True if a step of length `h` at this rate changes the state negligibly.
    #[inline(always)]
    pub(in crate::integrate) fn is_at_rest<Y: StateVector<S>>(&self, h: S, rate: &Y, y: &Y) -> S::Mask {
        self.norm(h, rate, y, y).less(S::from_f64(AT_REST))
    }

    /// Returns the length of an Euler step over which [`first_step`](Self::first_step) evaluates
    /// the change of rates.
    #[inline(always)]
    pub(super) fn trial<Y: StateVector<S>>(&self, y: &Y, rate: &Y, longest: S) -> S {
        let small = S::from_f64(1e-5);
        let (size, speed) = (self.norm(S::ONE, y, y, y), self.norm(S::ONE, rate, y, y));
        let proportion = S::from_f64(0.01) * size / speed;
        let guess = S::select(size.less(small) | speed.less(small), S::from_f64(1e-6), proportion);
        guess.min(longest)
    }

    /// Estimates a first step with a small error, at most as long as `longest`. Errors grow with
    /// the `power` of the length. The arguments are the rates at the state and after an Euler step
    /// of length `trial`. NaN if errors relative to the tolerance are not finite.
    #[inline(always)]
    pub(super) fn first_step<Y: StateVector<S>>(
        &self,
        y: &Y,
        [rate, ahead]: [&Y; 2],
        trial: S,
        (longest, power): (S, f64),
    ) -> S {
        let speed = self.norm(S::ONE, rate, y, y);
        let bend = self.norm(S::ONE / trial, &combined(ahead, -S::ONE, rate), y, y);
        let fastest = speed.max(bend);
        let slow = (trial * S::from_f64(1e-3)).max(S::from_f64(1e-6));
        let length = (S::from_f64(0.01) / fastest).powf(S::from_f64(1.0 / power));
        let length = S::select(fastest.less_equal(S::from_f64(1e-15)), slow, length);
        let length = length.min(S::from_f64(100.0) * trial).min(longest);
        // The trial may have left the domain of the system.
        let first = S::select(S::ZERO.less(length) & is_finite(length), length, trial);
        S::select(S::ZERO.less(first) & is_finite(first) & is_finite(speed), first, S::NAN)
    }
}

impl<S: Scalar> Tolerated<S> {
    /// Creates the tolerance in a domain, with rounding as the minimum.
    #[inline(always)]
    pub(in crate::integrate) fn new(relative: S, absolute: S, domain: &'static Domain) -> Self {
        Tolerated { relative: relative.max(LEAST_TOLERANCE.part::<S>()), absolute, domain }
    }

    /// Estimates a first step with a small error, at most as long as `longest`, from a state with
    /// this rate. Errors grow with the `power` of the length.
    ///
    /// # Errors
    /// If there is none, because errors relative to the tolerance are not finite.
    pub(in crate::integrate) fn first_step_of<M>(
        &self,
        system: &M,
        (t, y): (S, &M::State),
        rate: &M::State,
        (longest, is_backwards): (S, bool),
        power: f64,
    ) -> Result<S, StepFailure<S>>
    where
        M: OdeSystem<Scalar = S> + ?Sized,
    {
        let trial = self.trial(y, rate, longest);
        let h = if is_backwards { -trial } else { trial };
        let ahead = system.rhs(t + h, &combined(y, h, rate));
        let first = self.first_step(y, [rate, &ahead], trial, (longest, power));
        if first > S::ZERO {
            return Ok(first);
        }
        Err(StepFailure::NoFirstStep { relative: self.relative, absolute: self.absolute })
    }
}

/// Checks the tolerances and the lengths of steps of an adaptive method.
///
/// # Errors
/// If one of them is invalid.
pub(in crate::integrate) fn check_settings<S: Scalar>(
    [relative, absolute]: [S; 2],
    lengths: &[Option<S>],
) -> Result<(), SettingError<S>> {
    let is_tolerance = |part: S| part >= S::ZERO && part.is_finite();
    if !is_tolerance(relative) || !is_tolerance(absolute) || relative + absolute == S::ZERO {
        return Err(SettingError::Invalid("tolerances must be finite and not negative, and not both zero"));
    }
    if lengths.iter().flatten().all(|length| *length > S::ZERO && length.is_finite()) {
        return Ok(());
    }
    Err(SettingError::Invalid("step sizes must be positive and finite"))
}

/// Checks that coefficients in double precision can keep the tolerances, in numbers wider than
/// that. Below this limit, steps become ever shorter without an end.
///
/// # Errors
/// If both tolerances are less than `least`.
pub(in crate::integrate) fn check_precision<S: Scalar>(
    tolerances: [S; 2],
    least: f64,
) -> Result<(), SettingError<S>> {
    let is_wide = S::epsilon() < S::from_f64(f64::EPSILON);
    if is_wide && tolerances.into_iter().all(|part| part < S::from_f64(least)) {
        return Err(SettingError::Invalid(
            "the coefficients of this method have 16 digits, too few for this tolerance: use `Taylor`",
        ));
    }
    Ok(())
}

/// Returns the maximum step length in an interval of this length, for a moving state or one at
/// rest, unless it is a setting.
pub(in crate::integrate) fn longest_step<S: Scalar>(setting: Option<S>, span: S, is_at_rest: bool) -> S {
    let part = if is_at_rest { LONGEST_AT_REST } else { LONGEST };
    setting.unwrap_or(span.abs() * S::from_f64(part))
}

impl<S: Scalar> Verner98<S> {
    /// Returns the tolerance in a domain, with rounding as the minimum.
    #[inline(always)]
    pub(super) fn tolerated(&self, domain: &'static Domain) -> Tolerated<S> {
        Tolerated::new(self.relative, self.absolute, domain)
    }

    /// Returns the maximum step length in an interval of this length, for a moving state or one at
    /// rest.
    pub(super) fn longest(&self, span: S, is_at_rest: bool) -> S {
        longest_step(self.longest_step, span, is_at_rest)
    }
}
