//! Errors and rates measured by what is tolerated.

use super::Verner98;
use crate::scalar::Scalar;
use crate::system::{OdeSystem, StateVector};

/// Fewer roundings of the state than this are tolerated in any case, since shorter steps only round more.
const LEAST_ROUNDINGS: f64 = 16.0;

impl<S: Scalar> Verner98<S> {
    /// The root mean square of `h · error` in units of what is tolerated between the states `from` and `to`.
    pub(super) fn norm<Y: StateVector<S>>(&self, h: S, error: &Y, from: &Y, to: &Y) -> S {
        let ends = from.as_ref().iter().zip(to.as_ref());
        let relative = self.relative.max(S::from_f64(LEAST_ROUNDINGS) * S::epsilon());
        let mut sum = S::ZERO;
        for (error, (from, to)) in error.as_ref().iter().zip(ends) {
            let size = from.abs().max(to.abs());
            let part = h * *error / relative.multiply_add(size, self.absolute);
            // Zero by zero where nothing moves and nothing is tolerated.
            sum = if *error == S::ZERO { sum } else { part.multiply_add(part, sum) };
        }
        (sum / S::from_f64(from.as_ref().len() as f64)).sqrt()
    }

    /// A first step whose error is small in all likelihood, not longer than `span`.
    pub(super) fn first_step<M>(&self, system: &M, t: S, y: &M::State, rate: &M::State, span: S) -> S
    where
        M: OdeSystem<Scalar = S> + ?Sized,
    {
        let (one, small) = (S::ONE, S::from_f64(1e-5));
        let size = self.norm(one, y, y, y);
        let speed = self.norm(one, rate, y, y);
        let guess =
            if size < small || speed < small { S::from_f64(1e-6) } else { S::from_f64(0.01) * size / speed };
        let guess = guess.min(span.abs());
        let h = if span < S::ZERO { -guess } else { guess };
        let mut ahead = *y;
        for (y, rate) in ahead.as_mut().iter_mut().zip(rate.as_ref()) {
            *y = rate.multiply_add(h, *y);
        }
        let mut bend = system.rhs(t + h, &ahead);
        for (bend, rate) in bend.as_mut().iter_mut().zip(rate.as_ref()) {
            *bend = *bend - *rate;
        }
        let bend = self.norm(one / guess, &bend, y, y);
        let fastest = speed.max(bend);
        let length = if fastest <= S::from_f64(1e-15) {
            (guess * S::from_f64(1e-3)).max(S::from_f64(1e-6))
        } else {
            (S::from_f64(0.01) / fastest).powf(S::from_f64(1.0 / 9.0))
        };
        let length = length.min(S::from_f64(100.0) * guess);
        let longest = self.longest_step.unwrap_or(length).min(span.abs());
        // The guess may have left the domain of the system.
        if length <= longest {
            length
        } else if length.is_finite() {
            longest
        } else {
            guess.min(longest)
        }
    }
}
