//! Iteration of the equations of an implicit step down to rounding.
//!
//! The invariants of a symplectic method are violated by the residuals of its equations. Iterations
//! therefore continue until corrections stop decreasing, rather than until they are below a
//! tolerance. Unknowns may differ in units and scale: each is judged by its own corrections.
//! Source: Hairer, Lubich, Wanner, *Geometric Numerical Integration*, §VIII.6.2.

use crate::integrate::method::Work;
use crate::scalar::Scalar;
use crate::system::{StateVector, StepFailure};

/// Equations for K vectors of unknowns.
pub(super) trait Equations<S: Scalar, Y: StateVector<S>, const K: usize> {
    /// Returns the residual of the equations at `unknowns`; intermediate results may be stored.
    fn residual(&mut self, unknowns: &[Y; K], work: &mut Work) -> [Y; K];

    /// Returns the first-order correction of the unknowns for a residual.
    fn correction(&self, residual: &[Y; K]) -> [Y; K];

    /// Returns the magnitude of the terms of each residual; rounding errors are a small fraction of
    /// it.
    fn magnitude(&self, unknowns: &[Y; K]) -> Y;
}

/// Maximum number of iterations; if convergence is so slow, steps should be shorter.
const LIMIT: u32 = 100;

/// Number of iterations without decrease before rounding is suspected, since mutually dependent
/// unknowns may pause for one iteration.
const PAUSE: u32 = 2;

/// Maximum number of iterations without decrease.
const PATIENCE: u32 = 3;

/// Factor by which corrections must decrease.
const FALL: f64 = 0.7;

/// Solves `equations` from the starting values in `unknowns`. The last evaluation is at the values
/// that remain there.
pub(super) fn solve<S: Scalar, Y: StateVector<S>, const K: usize>(
    equations: &mut impl Equations<S, Y, K>,
    unknowns: &mut [Y; K],
    rounding: S,
    work: &mut Work,
) -> Result<(), StepFailure<S>> {
    let mut progress = Convergence::new(rounding);
    let mut stalls = 0;
    for iteration in 1..=LIMIT {
        let residual = equations.residual(unknowns, work);
        let correction = equations.correction(&residual);
        work.iterations += 1;
        if !finite(&correction) {
            return Err(StepFailure::NotFinite);
        }
        match progress.after(unknowns, &correction) {
            Trend::Falls => stalls = 0,
            Trend::Settled => return Ok(()),
            Trend::Stalls => stalls += 1,
        }
        if stalls >= PAUSE && is_rounding(&residual, &equations.magnitude(unknowns), rounding) {
            return Ok(());
        }
        if stalls > PATIENCE {
            return Err(StepFailure::NotConverged { iterations: iteration });
        }
        add(unknowns, &correction);
    }
    Err(StepFailure::NotConverged { iterations: LIMIT })
}

/// True if every entry is finite.
pub(super) fn finite<S: Scalar, Y: StateVector<S>>(vectors: &[Y]) -> bool {
    vectors.iter().all(|vector| vector.as_ref().iter().all(|entry| entry.is_finite()))
}

/// Returns the largest magnitude of each unknown over all vectors.
#[inline]
pub(super) fn largest<S: Scalar, Y: StateVector<S>>(vectors: &[Y]) -> Y {
    let mut largest = vectors.first().map_or(Y::ZERO, Y::zeros);
    for vector in vectors {
        for (largest, entry) in largest.as_mut().iter_mut().zip(vector.as_ref()) {
            *largest = largest.max(entry.abs());
        }
    }
    largest
}

/// The history of corrections of each unknown.
struct Convergence<S, Y> {
    rounding: S,
    /// The smallest correction, the last one, and the best ratio of consecutive ones; `None` at
    /// first.
    seen: Option<(Y, Y, Y)>,
}

impl<S: Scalar, Y: StateVector<S>> Convergence<S, Y> {
    fn new(rounding: S) -> Self {
        Convergence { rounding, seen: None }
    }

    /// Judges the next correction.
    #[inline]
    fn after<const K: usize>(&mut self, unknowns: &[Y; K], correction: &[Y; K]) -> Trend {
        let (now, scale) = (largest(correction), largest(unknowns));
        let (smallest, last, rate) = self.seen.get_or_insert((infinite(), infinite(), infinite()));
        let (mut falls, mut settled) = (false, true);
        let before = smallest.as_mut().iter_mut().zip(last.as_mut()).zip(rate.as_mut());
        for ((now, scale), ((smallest, last), rate)) in now.as_ref().iter().zip(scale.as_ref()).zip(before) {
            if !is_settled(*now, *last * *rate, *scale * self.rounding) {
                settled = false;
                falls |= *now < S::from_f64(FALL) * *smallest;
            }
            // A zero correction is a pause of an unknown that depends on others in turn, and does
            // not indicate the rate of convergence.
            if *now == S::ZERO {
                continue;
            }
            if *last < infinity() && *now < *last * *rate {
                *rate = *now / *last;
            }
            *smallest = smallest.min(*now);
            *last = *now;
        }
        match (settled, falls) {
            (true, _) => Trend::Settled,
            (false, true) => Trend::Falls,
            (false, false) => Trend::Stalls,
        }
    }
}

/// The trend of corrections.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Trend {
    /// Some corrections still decrease.
    Falls,
    /// All corrections are zero or rounding errors.
    Settled,
    /// No correction decreases.
    Stalls,
}

/// Returns a number larger than any correction.
fn infinity<S: Scalar>() -> S {
    S::ONE / S::ZERO
}

/// Returns entries larger than any correction.
fn infinite<S: Scalar, Y: StateVector<S>>() -> Y {
    let mut vector = Y::ZERO;
    vector.as_mut().fill(infinity());
    vector
}

/// True if the correction `now` is a rounding error of an unknown for which a change by `unseen` is
/// lost.
#[inline(always)]
fn is_settled<S: Scalar>(now: S, expected: S, unseen: S) -> bool {
    now == S::ZERO || (now <= S::from_f64(100.0) * unseen && S::from_f64(8.0) * expected <= unseen)
}

/// True if residuals are a small fraction of their terms.
fn is_rounding<S: Scalar, Y: StateVector<S>>(residuals: &[Y], magnitude: &Y, rounding: S) -> bool {
    let root = rounding.sqrt();
    let part = root * root.sqrt();
    let largest = largest(residuals);
    largest.as_ref().iter().zip(magnitude.as_ref()).all(|(residual, terms)| *residual <= part * *terms)
}

fn add<S: Scalar, Y: StateVector<S>, const K: usize>(unknowns: &mut [Y; K], correction: &[Y; K]) {
    for (unknowns, correction) in unknowns.iter_mut().zip(correction) {
        for (unknown, correction) in unknowns.as_mut().iter_mut().zip(correction.as_ref()) {
            *unknown = *unknown + *correction;
        }
    }
}

#[cfg(test)]
mod tests;
