//! Methods for systems with white noise, in equal steps.
//!
//! Steps end at the multiples of their length, counted from time zero, as do the cells of the
//! [path](crate::integrate::WienerPath). Events, clocks and the end of a run shorten steps. Such
//! steps, and a first step that begins between multiples, use their part of the path in the cell.
//! The steps after them end at multiples again, so that an interrupted motion stays on the path.

mod euler_maruyama;
mod runge_kutta;

use core::cmp::Ordering;
use core::marker::PhantomData;

use crate::integrate::compensated::Compensated;
use crate::integrate::corrected::{admitted_with_noise, check_finite, corrected, is_same};
use crate::integrate::fixed::check_length;
use crate::integrate::interpolation::{Place, cubic};
use crate::integrate::method::{Stepper, Work};
use crate::integrate::wiener::{Increments, MAX_HALVINGS, WienerPath};
use crate::linalg::vector::{combined, difference};
use crate::scalar::{Number, Scalar};
use crate::system::{MAX_NOISES, NoiseKind, OdeSystem, SettingError, StepFailure};

pub use self::euler_maruyama::EulerMaruyama;
pub use self::runge_kutta::StochasticRungeKutta4;

/// Times that differ from an end of a step by this fraction of the step count as this end.
const SNAP: f64 = 1e-9;

const NO_NOISE: &str = "the system has no noise: take a method for ordinary equations, such as `Verner98`";
const BACKWARDS: &str = "noise runs forwards in time only";
const TOO_MANY: &str = "a system may have at most 16 noises";
const TOO_FINE: &str = "a path may be halved at most 31 times";
const NO_INTEGER: &str = "numbers of this type do not tell which step a time is in";
const NO_DIFFUSION: &str = "the diffusion is not a number: is the density of a noise negative here?";

/// A formula for steps with noise.
pub trait Scheme<M: OdeSystem + ?Sized> {
    /// Checks that the formula supports noise of this kind.
    ///
    /// # Errors
    /// If it does not.
    fn check(kind: NoiseKind) -> Result<(), SettingError<M::Scalar>>;

    /// True if the formula uses the area between the path and its chord for noise of this kind.
    fn uses_area(kind: NoiseKind) -> bool;

    /// Returns the change of the state `y` in a step of length `h` from time `t`.
    fn increment(
        system: &M,
        t: M::Scalar,
        y: &M::State,
        h: M::Scalar,
        path: &StepPath<M::Scalar>,
        work: &mut Work,
    ) -> M::State;
}

/// The path of all noises within a step: the parabola s W + 6 s (1 − s) H for each.
#[derive(Clone, Copy, Debug)]
pub struct StepPath<S> {
    count: usize,
    /// W and H of each noise.
    parts: [[S; 2]; MAX_NOISES],
}

impl<S: Scalar> StepPath<S> {
    /// Calls a function with w W + h H of each noise.
    #[inline]
    pub(super) fn weighted<R>(&self, [w, h]: [S; 2], then: impl FnOnce(&[S]) -> R) -> R {
        let mut values = [S::ZERO; MAX_NOISES];
        for (value, [increment, area]) in values.iter_mut().zip(&self.parts[..self.count]) {
            *value = h.multiply_add(*area, w * *increment);
        }
        then(&values[..self.count])
    }

    /// Calls a function with the values of the path after the fraction `s` of the step.
    fn at<R>(&self, s: S, then: impl FnOnce(&[S]) -> R) -> R {
        self.weighted([s, S::from_f64(6.0) * s * (S::ONE - s)], then)
    }
}

/// A position among steps of equal length.
#[derive(Clone, Copy, Debug)]
struct Location<S> {
    /// Number of the step.
    index: i64,
    /// The fraction of the step that has passed.
    share: S,
}

impl<S: Scalar> Location<S> {
    /// Returns the position of a time. The end of a step counts as the beginning of the next one.
    fn of(t: S, step: S) -> Option<Self> {
        let (passed, is_negative) = ((t / step).abs(), t < S::ZERO);
        let near = (passed + S::from_f64(0.5)).floor_below(usize::MAX)?;
        let miss = passed - S::from_f64(near as f64);
        let below = if is_negative { -miss } else { miss };
        let signed = if is_negative { -(near as i64) } else { near as i64 };
        Some(if miss.abs() <= tolerance(passed) {
            Location { index: signed, share: S::ZERO }
        } else if below < S::ZERO {
            Location { index: signed - 1, share: S::ONE + below }
        } else {
            Location { index: signed, share: below }
        })
    }

    /// Returns the time at which its step ends.
    fn end(&self, step: S) -> S {
        S::from_f64((self.index + 1) as f64) * step
    }
}

/// Returns the rounding error of a time, in steps, at this number of steps from zero.
fn tolerance<S: Scalar>(passed: S) -> S {
    S::from_f64(SNAP) + S::from_f64(4.0) * S::epsilon() * passed
}

/// An integration of a system with noise in progress.
#[derive(Debug)]
pub struct StochasticStepper<M: OdeSystem + ?Sized, F> {
    scheme: PhantomData<F>,
    step: M::Scalar,
    increments: Increments,
    time: M::Scalar,
    location: Location<M::Scalar>,
    state: Compensated<M::State>,
    last: Last<M::Scalar, M::State>,
    work: Work,
}

/// The last step: time and state at its start, its path, and the rates at both ends once they have
/// been requested.
#[derive(Clone, Copy, Debug)]
struct Last<S, Y> {
    time: S,
    state: Y,
    path: StepPath<S>,
    rates: Option<[Y; 2]>,
}

impl<M: OdeSystem + ?Sized, F> Clone for StochasticStepper<M, F> {
    fn clone(&self) -> Self {
        StochasticStepper { ..*self }
    }
}

impl<M: OdeSystem + ?Sized, F: Scheme<M>> StochasticStepper<M, F> {
    /// Starts at `y` at time `t`, with steps of length `step`, towards `end`.
    fn start(
        (step, path): (M::Scalar, WienerPath),
        system: &M,
        t: M::Scalar,
        y: &M::State,
        end: M::Scalar,
    ) -> Result<Self, StepFailure<M::Scalar>> {
        check_settings(step, path)?;
        check_finite(end, y)?;
        let noise = system.noise();
        let refused = [(!noise.acts(), NO_NOISE), (noise.count > MAX_NOISES, TOO_MANY), (end < t, BACKWARDS)];
        refused
            .into_iter()
            .find(|(is_so, _)| *is_so)
            .map_or(Ok(()), |(_, why)| Err(SettingError::Invalid(why)))?;
        F::check(noise.kind)?;
        let state = admitted_with_noise(system, t, y)?;
        let path_of_step = StepPath { count: noise.count, parts: [[M::Scalar::ZERO; 2]; MAX_NOISES] };
        Ok(StochasticStepper {
            scheme: PhantomData,
            step,
            increments: path.increments(),
            time: t,
            location: Location::of(t, step).ok_or(SettingError::Invalid(NO_INTEGER))?,
            state: Compensated::new(state),
            last: Last { time: t, state, path: path_of_step, rates: None },
            work: Work::default(),
        })
    }

    /// Returns the end of the next step and its position, at most `limit`.
    fn next(&self, limit: M::Scalar) -> (M::Scalar, Location<M::Scalar>) {
        let Location { index, share } = self.location;
        let end = self.location.end(self.step);
        let ahead = (limit - end) / self.step;
        let snap = tolerance((end / self.step).abs());
        if ahead > snap {
            (end, Location { index: index + 1, share: M::Scalar::ZERO })
        } else if ahead >= -snap {
            (limit, Location { index: index + 1, share: M::Scalar::ZERO })
        } else {
            (limit, Location { index, share: (M::Scalar::ONE + ahead).max(share) })
        }
    }

    /// Returns the path from here to a position in the same step or at its end.
    fn path_to(&self, kind: NoiseKind, to: &Location<M::Scalar>) -> StepPath<M::Scalar> {
        let (one, six) = (M::Scalar::ONE, M::Scalar::from_f64(6.0));
        let start = self.location.share;
        let end = if to.index > self.location.index { one } else { to.share };
        let (part, root) = (end - start, self.step.sqrt());
        let bend = six * (end * (one - end) - start * (one - start));
        let mut path = self.last.path;
        for (noise, parts) in path.parts[..path.count].iter_mut().enumerate() {
            let [w, h] = self.increments.over(noise as u32, self.location.index);
            let h = if F::uses_area(kind) { h } else { 0.0 };
            let [w, h] = [w, h].map(|value| M::Scalar::from_f64(value) * root);
            *parts = [part * w + bend * h, part * part * h];
        }
        path
    }

    fn advance(
        &mut self,
        system: &M,
        (end, to): (M::Scalar, Location<M::Scalar>),
    ) -> Result<(), StepFailure<M::Scalar>> {
        let from = *self.state.value();
        let path = self.path_to(system.noise().kind, &to);
        let change = F::increment(system, self.time, &from, end - self.time, &path, &mut self.work);
        let mut state = self.state;
        state.add(&change);
        check_finite(end, state.value()).map_err(|cause| self.undefined(system, cause))?;
        if system.is_constrained() {
            let mut onto = *state.value();
            system.correct(end, &mut onto)?;
            check_finite(end, &onto)?;
            if !is_same(&onto, state.value()) {
                state.replace(onto);
            }
        }
        self.last = Last { time: self.time, state: from, path, rates: None };
        (self.time, self.location, self.state) = (end, to, state);
        self.work.steps += 1;
        Ok(())
    }

    /// Returns the reason why a step failed: a diffusion that is not finite, or else this cause.
    #[cold]
    fn undefined(&self, system: &M, cause: StepFailure<M::Scalar>) -> StepFailure<M::Scalar> {
        let ones = [M::Scalar::ONE; MAX_NOISES];
        let diffusion = system.diffuse(self.time, self.state.value(), &ones[..self.last.path.count]);
        match check_finite(self.time, &diffusion) {
            Err(_) => StepFailure::Stuck(NO_DIFFUSION),
            Ok(()) => cause,
        }
    }
}

impl<M: OdeSystem + ?Sized, F: Scheme<M>> Stepper<M> for StochasticStepper<M, F> {
    fn time(&self) -> M::Scalar {
        self.time
    }

    fn state(&self) -> &M::State {
        self.state.value()
    }

    fn step(&mut self, system: &M, limit: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
        if limit < self.time {
            return Err(SettingError::Invalid(BACKWARDS).into());
        }
        let next = self.next(limit);
        if next.0.partial_cmp(&self.time) != Some(Ordering::Greater) {
            return Err(StepFailure::StepLost { step: self.step, time: self.time });
        }
        self.advance(system, next)
    }

    fn last_time(&self) -> M::Scalar {
        self.last.time
    }

    /// Adds the parabola of the noise to the cubic Hermite polynomial of everything else.
    fn interpolate(&mut self, system: &M, t: M::Scalar) -> M::State {
        let (to, end) = (self.time, *self.state.value());
        let Last { time: from, state: start, path, rates } = &mut self.last;
        if t == to || to == *from {
            return end;
        }
        let work = &mut self.work;
        let [f0, f1] = *rates.get_or_insert_with(|| {
            work.evaluations += 2;
            [system.rhs(*from, start), system.rhs(to, &end)]
        });
        let (h, one) = (to - *from, M::Scalar::ONE);
        let s = (t - *from) / h;
        let of_noise = |s| path.at(s, |increments| system.diffuse(*from, start, increments));
        let smooth = difference(&end, &of_noise(one));
        let y = cubic(Place { h, s }, [start, &smooth], [&f0, &f1]);
        corrected(system, t, combined(&y, one, &of_noise(s)))
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) -> Result<(), StepFailure<M::Scalar>> {
        let state = admitted_with_noise(system, t, y)?;
        self.location = Location::of(t, self.step).ok_or(SettingError::Invalid(NO_INTEGER))?;
        (self.time, self.state) = (t, Compensated::new(state));
        self.last = Last { time: t, state, rates: None, ..self.last };
        Ok(())
    }

    fn work(&self) -> Work {
        self.work
    }
}

/// Checks the step length and the path.
fn check_settings<S: Scalar>(step: S, path: WienerPath) -> Result<(), SettingError<S>> {
    if path.halvings() > MAX_HALVINGS {
        return Err(SettingError::Invalid(TOO_FINE));
    }
    check_length(step)
}

/// Implements [`Method`](super::Method) for a method with the fields `step` and `path`. The
/// arguments are its name and its scheme.
macro_rules! stochastic_steps {
    ($name:expr, $Scheme:ty) => {
        type Stepper = $crate::integrate::stochastic::StochasticStepper<M, $Scheme>;

        fn name(&self) -> &'static str {
            $name
        }

        fn order(&self) -> u32 {
            1
        }

        fn check(&self) -> Result<(), $crate::system::SettingError<M::Scalar>> {
            $crate::integrate::stochastic::check_settings(self.step, self.path)
        }

        fn start(
            &self,
            system: &M,
            t: M::Scalar,
            y: &M::State,
            end: M::Scalar,
        ) -> Result<Self::Stepper, $crate::system::StepFailure<M::Scalar>> {
            $crate::integrate::stochastic::StochasticStepper::start((self.step, self.path), system, t, y, end)
        }

        fn of_motion(self, index: usize) -> Self {
            Self { path: self.path.of_motion(index), ..self }
        }
    };
}
use stochastic_steps;

#[cfg(test)]
mod tests;
