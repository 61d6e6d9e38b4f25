//! States between the samples.
//!
//! Each step is kept as its states at the Chebyshev points of the second kind, found by the
//! method's own interpolation. It is evaluated by the barycentric formula
//!
//! ```text
//! p(s) = Σ wⱼ yⱼ/(s − sⱼ) / Σ wⱼ/(s − sⱼ),   sⱼ = (1 − cos(π j/d))/2,   wⱼ = ±1, halved at both ends.
//! ```
//!
//! with both sums times the distance of s from the nearest of these points, so that nothing
//! overflows however small that is.
//!
//! A polynomial of degree d is reproduced except for rounding, and d is chosen not to be below the
//! degree of the methods' interpolants. Source: Berrut, Trefethen, *Barycentric Lagrange
//! Interpolation*, SIAM Review 46 (2004), §5.

use std::vec::Vec;

use crate::scalar::Scalar;
use crate::system::StateVector;

/// The steps of a run, each as a polynomial.
#[derive(Clone, Debug)]
pub(super) struct Dense<S, Y> {
    /// Positions of the points in a step, from 0 to 1; d + 1 numbers.
    points: Vec<S>,
    /// Start and end of each step.
    steps: Vec<(S, S)>,
    /// The states at the points of each step.
    states: Vec<Y>,
}

/// Quintic Hermite interpolation, which methods of low order use, has this degree.
const LEAST_DEGREE: u32 = 5;

impl<S: Scalar, Y: StateVector<S>> Dense<S, Y> {
    /// Creates an empty record for a method of this order.
    pub(super) fn new(order: u32) -> Self {
        let degree = LEAST_DEGREE.max(order + 1);
        let angle = |j: u32| S::from_f64(core::f64::consts::PI * f64::from(j) / f64::from(degree));
        // Exact at both ends and at the middle, unlike (1 − cos)/2.
        let points = (0..=degree).map(|j| (angle(j) / S::from_f64(2.0)).sin().powi(2));
        Dense { points: points.collect(), steps: Vec::new(), states: Vec::new() }
    }

    /// Keeps the step between these times, in which the state is known.
    pub(super) fn push(&mut self, (from, to): (S, S), state: &mut dyn FnMut(S) -> Y) {
        if from == to {
            return;
        }
        let states = self.times((from, to)).map(state).collect::<Vec<_>>();
        self.append((from, to), &states);
    }

    /// Returns the times of the points in a step.
    pub(super) fn times(&self, (from, to): (S, S)) -> impl Iterator<Item = S> + '_ {
        let last = self.points.len() - 1;
        let time = move |(index, s): (usize, &S)| if index == last { to } else { from + *s * (to - from) };
        self.points.iter().enumerate().map(time)
    }

    /// Keeps a step with the states at its points.
    pub(super) fn append(&mut self, step: (S, S), states: &[Y]) {
        self.states.extend(states);
        self.steps.push(step);
    }

    /// Returns start and end of each step.
    pub(super) fn steps(&self) -> &[(S, S)] {
        &self.steps
    }

    /// Forgets the first steps that are of no use, if they are as many as the others.
    pub(super) fn forget(&mut self, is_useless: impl Fn(&(S, S)) -> bool) {
        let count = self.steps.partition_point(is_useless);
        if 2 * count > self.steps.len() {
            self.steps.drain(..count);
            self.states.drain(..count * self.points.len());
        }
    }

    /// Returns the state at `t`, at an end shared by two steps that of the later one; `None`
    /// outside of all steps.
    pub(super) fn at(&self, t: S) -> Option<Y> {
        let backwards = self.steps.first().is_some_and(|(from, to)| to < from);
        let is_past = |(from, _): &(S, S)| if backwards { *from >= t } else { *from <= t };
        let index = self.steps.partition_point(is_past).checked_sub(1)?;
        let (from, to) = *self.steps.get(index)?;
        let s = (t - from) / (to - from);
        if !(s >= S::ZERO && s <= S::ONE) {
            return None;
        }
        Some(self.within(index, s))
    }

    /// Returns the state at a part of a step.
    pub(super) fn within(&self, index: usize, s: S) -> Y {
        let count = self.points.len();
        self.barycentric(&self.states[index * count..(index + 1) * count], s)
    }

    fn barycentric(&self, states: &[Y], s: S) -> Y {
        let nearest = self.nearest(s);
        let distance = s - self.points[nearest];
        if distance == S::ZERO {
            return states[nearest];
        }
        let (mut sum, mut weights) = (states[nearest].zeros(), S::ZERO);
        let half = S::from_f64(0.5);
        let last = self.points.len() - 1;
        for (j, (point, state)) in self.points.iter().zip(states).enumerate() {
            let sign = if j % 2 == 0 { S::ONE } else { -S::ONE };
            let part = if j == nearest { S::ONE } else { distance / (s - *point) };
            let weight = if j == 0 || j == last { half * sign * part } else { sign * part };
            weights = weights + weight;
            for (sum, component) in sum.as_mut().iter_mut().zip(state.as_ref()) {
                *sum = component.multiply_add(weight, *sum);
            }
        }
        sum.as_mut().iter_mut().for_each(|sum| *sum = *sum / weights);
        sum
    }

    /// Returns the point that is nearest to this part of a step.
    fn nearest(&self, s: S) -> usize {
        let after = self.points.partition_point(|point| *point < s).min(self.points.len() - 1);
        let before = after.saturating_sub(1);
        if s - self.points[before] < self.points[after] - s { before } else { after }
    }
}
