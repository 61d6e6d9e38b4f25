//! Errors and rates measured by what is tolerated.

use super::{AT_REST, LONGEST, LONGEST_AT_REST, Verner98};
use crate::linalg::vector::combined;
use crate::scalar::Scalar;
use crate::system::{OdeSystem, StateVector, StepFailure};
use crate::tolerance::LEAST_TOLERANCE;

impl<S: Scalar> Verner98<S> {
    /// The root mean square of `h · error` in units of what is tolerated between the states `from` and `to`.
    pub(super) fn norm<Y: StateVector<S>>(&self, h: S, error: &Y, from: &Y, to: &Y) -> S {
        let ends = from.as_ref().iter().zip(to.as_ref());
        let relative = self.relative.max(LEAST_TOLERANCE.part::<S>());
        let mut sum = S::ZERO;
        for (error, (from, to)) in error.as_ref().iter().zip(ends) {
            let size = from.abs().max(to.abs());
            let part = h * *error / relative.multiply_add(size, self.absolute);
            // Zero by zero where nothing moves and nothing is tolerated.
            sum = if *error == S::ZERO { sum } else { part.multiply_add(part, sum) };
        }
        (sum / S::from_f64(from.as_ref().len() as f64)).sqrt()
    }

    /// The longest step that is tried on a way of this length, with the state moving or at rest.
    pub(super) fn longest(&self, span: S, is_at_rest: bool) -> S {
        let part = if is_at_rest { LONGEST_AT_REST } else { LONGEST };
        self.longest_step.unwrap_or(span.abs() * S::from_f64(part))
    }

    /// Whether a step of the length `h` at this rate changes the state by next to nothing.
    pub(super) fn is_at_rest<Y: StateVector<S>>(&self, h: S, rate: &Y, y: &Y) -> bool {
        self.norm(h, rate, y, y) < S::from_f64(AT_REST)
    }

    /// A first step whose error is small in all likelihood, not longer than `longest`, from a state at this rate.
    ///
    /// # Errors
    /// If there is none because errors measured by the tolerance are no numbers.
    pub(super) fn first_step<M>(
        &self,
        system: &M,
        (t, y): (S, &M::State),
        rate: &M::State,
        (longest, is_backwards): (S, bool),
    ) -> Result<S, StepFailure<S>>
    where
        M: OdeSystem<Scalar = S> + ?Sized,
    {
        let small = S::from_f64(1e-5);
        let (size, speed) = (self.norm(S::ONE, y, y, y), self.norm(S::ONE, rate, y, y));
        let guess =
            if size < small || speed < small { S::from_f64(1e-6) } else { S::from_f64(0.01) * size / speed };
        let guess = guess.min(longest);
        let bend = self.bend(system, (t, y), rate, if is_backwards { -guess } else { guess });
        let fastest = speed.max(bend);
        let length = if fastest <= S::from_f64(1e-15) {
            (guess * S::from_f64(1e-3)).max(S::from_f64(1e-6))
        } else {
            (S::from_f64(0.01) / fastest).powf(S::from_f64(1.0 / 9.0))
        };
        let length = length.min(S::from_f64(100.0) * guess).min(longest);
        // The guess may have left the domain of the system.
        let first = if length > S::ZERO && length.is_finite() { length } else { guess };
        if first > S::ZERO && first.is_finite() && speed.is_finite() {
            return Ok(first);
        }
        Err(StepFailure::NoFirstStep { relative: self.relative, absolute: self.absolute })
    }

    /// How fast rates change, measured over an Euler step of the length `h`.
    fn bend<M>(&self, system: &M, (t, y): (S, &M::State), rate: &M::State, h: S) -> S
    where
        M: OdeSystem<Scalar = S> + ?Sized,
    {
        let mut bend = system.rhs(t + h, &combined(y, h, rate));
        for (bend, rate) in bend.as_mut().iter_mut().zip(rate.as_ref()) {
            *bend = *bend - *rate;
        }
        self.norm(S::ONE / h.abs(), &bend, y, y)
    }
}
