//! Periodic orbits by shooting.
//!
//! With the motion φ over a period T from a state y, a step (δ, τ) of Newton's method solves
//!
//! ```text
//! (Φ − I) δ + f(φ) τ = y + w − φ,    f(y) · δ = 0,    Φ = ∂φ/∂y,
//! ```
//!
//! where w is the advance of coordinates in a period. Without a free period there is neither τ nor
//! the second equation, which selects a state along the orbit. Orbits of conservative systems come
//! in families; the shortest step leads to a nearby member. If such a step does not halve the
//! distance, damped ones are tried, which stay short in nearly singular directions. The eigenvalues
//! of Φ are Floquet's multipliers: perturbations of the orbit grow by these factors in a period.
//! For an autonomous system one of them is 1, along the orbit.
//!
//! Sources: Nayfeh, Balachandran, *Applied Nonlinear Dynamics*, §3.2, §6.5; Seydel, *Practical
//! Bifurcation and Stability Analysis*, 3rd ed., §7.1–7.4.
//!
//! Example: for ẋ = −x + cos t, φ = ½ + (x − ½) e^{−2π} after 2π. From x = 0 the step is δ = (φ −
//! x)/(1 − e^{−2π}) = ½, which is the orbit.

use std::vec::Vec;

use super::error::OrbitError;
use super::flow::{FlowEnd, flow};
use crate::linalg::dense::DenseMatrix;
use crate::linalg::singular_values::{SingularValues, length};
use crate::system::{OdeSystem, ParametricSystem};

/// Maximum number of steps of Newton's method.
const MAX_STEPS: u32 = 50;
/// Number of dampings of a step, each ten times as strong as the one before.
const MAX_DAMPINGS: i32 = 13;
/// Smallest damping, relative to the square of the largest singular value.
const LEAST_DAMPING: f64 = 1e-8;
/// Singular values below this fraction of the largest one are rounding.
const RANK: f64 = 1e-9;
/// Default error tolerance of integration steps.
const TOLERANCE: f64 = 1e-12;
/// A motion is an orbit if it misses its start by less than this, relative to the state.
const CLOSED: f64 = 1e-9;
/// A state is at rest if its rates are below this fraction of the rates at the start.
const RESTING: f64 = 1e-6;
/// A multiplier whose magnitude exceeds one by less than this is one up to rounding.
const ROUNDING: f64 = 1e-6;

/// A search for a periodic orbit.
#[must_use = "a search does nothing before `solve`"]
pub struct OrbitSearch<'a, M, const N: usize> {
    system: &'a M,
    near: [f64; N],
    period: f64,
    from: f64,
    is_period_free: bool,
    advance: [f64; N],
    tolerance: f64,
    mistake: Option<OrbitError>,
}

/// A periodic orbit.
#[derive(Clone, PartialEq, Debug)]
pub struct PeriodicOrbit<const N: usize> {
    /// The state at the start of a period.
    pub state: [f64; N],
    /// The period.
    pub period: f64,
    /// Real and imaginary parts of Floquet's multipliers; pairs are adjacent.
    pub multipliers: Vec<(f64, f64)>,
    /// Derivatives of the state after a period with respect to the state: the monodromy matrix.
    pub monodromy: DenseMatrix,
    /// Distance of the end of a period from its start.
    pub distance: f64,
}

impl<const N: usize> PeriodicOrbit<N> {
    /// True if no multiplier lies outside the unit circle, up to rounding. If one lies on it, other
    /// than that along the orbit, nonlinear terms decide.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.multipliers.iter().all(|(re, im)| re.hypot(*im) <= 1.0 + ROUNDING)
    }
}

impl<'a, M, const N: usize> OrbitSearch<'a, M, N>
where
    M: ParametricSystem + OdeSystem<Scalar = f64, State = [f64; N]>,
{
    pub(super) fn new(system: &'a M, near: [f64; N], period: f64) -> Self {
        let (from, is_period_free, advance, tolerance) = (0.0, false, [0.0; N], TOLERANCE);
        OrbitSearch { system, near, period, from, is_period_free, advance, tolerance, mistake: None }
    }

    /// Starts periods at this time instead of 0.
    pub fn from(self, time: f64) -> Self {
        OrbitSearch { from: time, ..self }
    }

    /// Makes the period an unknown, too, for systems that do not depend on time. Rest, which has
    /// any period, is reported as an error.
    pub fn free_period(self) -> Self {
        OrbitSearch { is_period_free: true, ..self }
    }

    /// Makes a coordinate advance in each period, such as an angle by 2π.
    pub fn advancing(mut self, coordinate: &str, by: f64) -> Self {
        let known = self.system.description().coordinates;
        match known.iter().position(|name| *name == coordinate) {
            Some(index) => self.advance[index] = by,
            None => self.mistake = Some(OrbitError::UnknownCoordinate { name: coordinate.into(), known }),
        }
        self
    }

    /// Sets the error tolerance of integration steps, 1e-12 by default.
    pub fn tolerance(self, tolerance: f64) -> Self {
        OrbitSearch { tolerance, ..self }
    }

    /// Searches for the orbit.
    ///
    /// # Errors
    /// If a motion fails, or no orbit is found near the start.
    pub fn solve(self) -> Result<PeriodicOrbit<N>, OrbitError> {
        if let Some(mistake) = self.mistake {
            return Err(mistake);
        }
        if !(self.period > 0.0 && self.period.is_finite()) {
            return Err(OrbitError::Setting("the period must be positive and finite"));
        }
        let mut now = self.trial(self.near, self.period)?;
        for iterations in 0..MAX_STEPS {
            let (distance, size) = (now.distance(), length(&now.state).max(1.0));
            let is_closed = distance <= CLOSED * size;
            // Below rounding, steps that come closer are meaningless.
            match self.next(&now).filter(|_| distance > f64::EPSILON * size) {
                Some(next) => now = next,
                // Rounding: no step comes closer.
                None if is_closed && self.is_at_rest(&now) => return Err(OrbitError::AtRest),
                None if is_closed => return now.orbit(),
                None => return Err(OrbitError::NotFound { distance, iterations }),
            }
        }
        Err(OrbitError::NotFound { distance: now.distance(), iterations: MAX_STEPS })
    }

    /// True if the state is at rest, which has any period.
    fn is_at_rest(&self, now: &OrbitTrial<N>) -> bool {
        let speed = |y: &[f64; N]| length(&self.system.rhs(self.from, y));
        self.is_period_free && speed(&now.state) <= RESTING * speed(&self.near)
    }

    fn trial(&self, state: [f64; N], period: f64) -> Result<OrbitTrial<N>, OrbitError> {
        let end = flow(self.system, &state, [self.from, self.from + period], self.tolerance)?;
        let missing = core::array::from_fn(|i| state[i] + self.advance[i] - end.state[i]);
        Ok(OrbitTrial { state, period, end, missing })
    }

    /// Returns a trial that misses its start by less, from Newton's step and damped ones: the first
    /// that halves the distance, or the best.
    fn next(&self, now: &OrbitTrial<N>) -> Option<OrbitTrial<N>> {
        let (matrix, right) = self.equations(now);
        let values = SingularValues::of(&matrix)?;
        let scale = values.values().first().map_or(0.0, |largest| largest * largest);
        let mut best = None::<OrbitTrial<N>>;
        for damping in 0..MAX_DAMPINGS {
            let step = match damping {
                0 => values.shortest(&right, RANK),
                _ => values.damped(&right, scale * LEAST_DAMPING * 10.0_f64.powi(damping)),
            };
            let (state, period) = now.moved(&step);
            let Some(next) = self.trial(state, period).ok().filter(|_| period > 0.0) else { continue };
            let is_near = next.distance() < 0.5 * now.distance();
            if next.distance() < best.as_ref().unwrap_or(now).distance() {
                best = Some(next);
            }
            if is_near {
                break;
            }
        }
        best
    }

    /// Returns the equations of Newton's step for the state, followed by the period if it is free.
    fn equations(&self, now: &OrbitTrial<N>) -> (DenseMatrix, Vec<f64>) {
        let size = if self.is_period_free { N + 1 } else { N };
        let rates = |time: f64, y: &[f64; N]| self.system.rhs(time, y);
        let (along, leaving) = (rates(self.from + now.period, &now.end.state), rates(self.from, &now.state));
        let matrix = DenseMatrix::from_fn(size, size, |i, j| match (i < N, j < N) {
            (true, true) => now.end.matrix[(i, j)] - if i == j { 1.0 } else { 0.0 },
            (true, false) => along[i],
            (false, true) => leaving[j],
            (false, false) => 0.0,
        });
        let mut right = now.missing.to_vec();
        right.resize(size, 0.0);
        (matrix, right)
    }
}

/// A motion over a period.
struct OrbitTrial<const N: usize> {
    state: [f64; N],
    period: f64,
    end: FlowEnd<N>,
    /// The advanced start minus the end.
    missing: [f64; N],
}

impl<const N: usize> OrbitTrial<N> {
    fn distance(&self) -> f64 {
        length(&self.missing)
    }

    /// Returns the state and the period after a step.
    fn moved(&self, step: &[f64]) -> ([f64; N], f64) {
        let period = self.period + step.get(N).copied().unwrap_or(0.0);
        (core::array::from_fn(|i| self.state[i] + step[i]), period)
    }

    fn orbit(self) -> Result<PeriodicOrbit<N>, OrbitError> {
        let distance = self.distance();
        let multipliers = self.end.matrix.eigenvalues();
        let multipliers = multipliers.ok_or(OrbitError::Setting("the multipliers do not converge"))?;
        let OrbitTrial { state, period, end, .. } = self;
        Ok(PeriodicOrbit { state, period, multipliers, monodromy: end.matrix, distance })
    }
}
