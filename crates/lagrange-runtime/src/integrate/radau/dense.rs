//! States within a step.
//!
//! The polynomial of the stages has order three, less than the step. If the rate of a component is
//! another component, as for q̇ = v, both follow from a quintic polynomial. It matches positions,
//! velocities and accelerations at the ends. Other components are cubic. The slopes at the ends are
//! those of the polynomial of the stages, in this step and the previous one. They equal the rates
//! except for the residual of Newton's method, which a stiff system would magnify.

use super::linear::LeadingPositions;
use super::newton::{StageChanges, numbers, weighted};
use super::tableau::{END_SLOPE, NODES, POLYNOMIALS, STAGES, START_SLOPE};
use crate::integrate::interpolation::{Motion, Place, cubic, quintic};
use crate::linalg::vector::add;
use crate::scalar::Scalar;
use crate::system::StateVector;

/// A step of length `h` from the time `t`.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepTaken<S, Y> {
    pub(super) t: S,
    pub(super) h: S,
    pub(super) ends: [Y; 2],
    /// Change of the state, with more digits than the difference of the ends.
    pub(super) change: Y,
    pub(super) stages: StageChanges<Y>,
    /// The rates at the ends.
    pub(super) rates: [Y; 2],
    pub(super) slopes: [Y; 2],
}

/// Distance of values for difference quotients of the interpolant, as a fraction of a step.
const DISTANCE: f64 = 0.05;

impl<S: Scalar, Y: StateVector<S>> StepTaken<S, Y> {
    /// Creates an empty step at this time and state, with this rate.
    pub(super) fn none(t: S, y: Y, rate: Y) -> Self {
        let (h, none) = (S::ZERO, Y::ZERO);
        StepTaken {
            t,
            h,
            ends: [y; 2],
            change: none,
            stages: [none; STAGES],
            rates: [rate; 2],
            slopes: [rate; 2],
        }
    }

    /// Returns the slope of the polynomial of the stages at the end.
    pub(super) fn end_slope(&self) -> Y {
        self.slope(&END_SLOPE)
    }

    /// Returns the step with the slopes of the polynomial of the stages at both ends. These slopes
    /// are not affected by fast motions that the step does not resolve.
    pub(super) fn smooth(&self) -> Self {
        StepTaken { slopes: [self.slope(&START_SLOPE), self.slope(&END_SLOPE)], ..*self }
    }

    fn slope(&self, parts: &[f64; STAGES]) -> Y {
        let mut slope = weighted(&numbers(parts), &self.stages);
        slope.as_mut().iter_mut().for_each(|slope| *slope = *slope / self.h);
        slope
    }

    /// Extrapolates the changes from the fraction `s` of the step to the nodes of a step of length
    /// `h` that begins there.
    #[inline(always)]
    pub(super) fn continued(&self, s: S, h: S) -> StageChanges<Y> {
        let (start, ratio) = (parts(s), h / self.h);
        let mut changes = self.stages;
        for (change, node) in changes.iter_mut().zip(NODES) {
            let mut parts = parts(ratio.multiply_add(S::from_f64(node), s));
            for (part, start) in parts.iter_mut().zip(start) {
                *part = *part - start;
            }
            *change = weighted(&parts, &self.stages);
        }
        changes
    }

    /// Returns the state at the fraction `s` of the step.
    pub(super) fn state(&self, positions: LeadingPositions, s: S) -> Y {
        let StepTaken { h, ends: [from, to], slopes: [before, after], .. } = self;
        let place = Place { h: *h, s };
        let mut y = cubic(place, [from, to], [before, after]);
        let zeros = y.zeros();
        let mut motion = Motion { change: zeros, velocities: [zeros; 2], accelerations: [zeros; 2] };
        for (position, velocity) in self.positions(positions) {
            motion.change.as_mut()[position] = self.change.as_ref()[position];
            for end in 0..2 {
                motion.velocities[end].as_mut()[position] = self.ends[end].as_ref()[velocity];
                motion.accelerations[end].as_mut()[position] = self.slopes[end].as_ref()[velocity];
            }
        }
        let (changes, velocities) = quintic(place, &motion);
        for (position, velocity) in self.positions(positions) {
            y.as_mut()[position] = from.as_ref()[position] + changes.as_ref()[position];
            y.as_mut()[velocity] = velocities.as_ref()[position];
        }
        y
    }

    /// Returns the components whose rates are other components, together with these. Components
    /// whose rates contain additional time-dependent terms are excluded.
    fn positions(
        &self,
        LeadingPositions { count, rates }: LeadingPositions,
    ) -> impl Iterator<Item = (usize, usize)> + '_ {
        (0..count).map(move |position| (position, rates + position)).filter(|(position, velocity)| {
            let mut ends = self.rates.iter().zip(&self.ends);
            ends.all(|(rate, y)| rate.as_ref()[*position] == y.as_ref()[*velocity])
        })
    }

    /// Computes the slope of the interpolant at the fraction `s` of the step, by differences that
    /// are exact for quartic polynomials.
    pub(super) fn slope_at(&self, positions: LeadingPositions, s: S) -> Y {
        let mut slope = self.change.zeros();
        for (steps, weight) in [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)] {
            let y = self.state(positions, S::from_f64(steps * DISTANCE) + s);
            add(&mut slope, S::from_f64(weight), &y);
        }
        let width = S::from_f64(12.0 * DISTANCE) * self.h;
        slope.as_mut().iter_mut().for_each(|slope| *slope = *slope / width);
        slope
    }
}

/// Returns the weights of the stages in their polynomial at the fraction `s` of the step.
#[inline(always)]
fn parts<S: Scalar>(s: S) -> [S; STAGES] {
    let mut parts = [S::ZERO; STAGES];
    for (part, coefficients) in parts.iter_mut().zip(&POLYNOMIALS) {
        let [one, two, three] = numbers::<S>(coefficients);
        *part = s * s.multiply_add(s.multiply_add(three, two), one);
    }
    parts
}
