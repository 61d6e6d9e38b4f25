//! States within a step, from states and rates at its ends.
//!
//! The polynomials are expressed in changes over the step, so that short steps lose no digits.
//! Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, §II.6.

use crate::scalar::Number;
use crate::system::StateVector;

/// A step of length `h`, and the fraction `s` of it at which the state is requested.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<S> {
    pub(super) h: S,
    pub(super) s: S,
}

/// Computes cubic Hermite interpolation between the states `y0` and `y1` with the rates `f0` and
/// `f1`. The error is O(h⁴).
#[inline(always)]
pub(super) fn cubic<S: Number, Y: StateVector<S>>(
    Place { h, s }: Place<S>,
    [y0, y1]: [&Y; 2],
    [f0, f1]: [&Y; 2],
) -> Y {
    let (one, two) = (S::ONE, S::from_f64(2.0));
    let mut y = *y0;
    let ends = y1.as_ref().iter().zip(f0.as_ref()).zip(f1.as_ref());
    for (y, ((y1, f0), f1)) in y.as_mut().iter_mut().zip(ends) {
        let change = *y1 - *y;
        let bend = (one - two * s) * change + (s - one) * h * *f0 + s * h * *f1;
        *y = *y + s * change + s * (s - one) * bend;
    }
    y
}

/// The known motion of a mechanical system in a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion<Q> {
    /// Change of the coordinates.
    pub(super) change: Q,
    /// Velocities at both ends.
    pub(super) velocities: [Q; 2],
    /// Accelerations at both ends.
    pub(super) accelerations: [Q; 2],
}

/// Interpolates the change of coordinates, and the velocities, by quintic Hermite polynomials. The
/// errors are O(h⁶) and O(h⁵).
///
/// The velocity is the cubic with the right values and rates at the ends, plus κ s² (1 − s)². This
/// term makes its integral equal to the change of the coordinates.
#[inline(always)]
pub(super) fn quintic<S: Number, Q: StateVector<S>>(Place { h, s }: Place<S>, motion: &Motion<Q>) -> (Q, Q) {
    let number = S::from_f64;
    let [v0, v1] = &motion.velocities;
    let [a0, a1] = &motion.accelerations;
    let (mut change, mut velocity) = (motion.change, *v0);
    let rest = S::ONE - s;
    let ends = v1.as_ref().iter().zip(a0.as_ref()).zip(a1.as_ref());
    let results = change.as_mut().iter_mut().zip(velocity.as_mut());
    for ((change, velocity), ((v1, a0), a1)) in results.zip(ends) {
        let (v0, total, gain) = (*velocity, *change, *v1 - *velocity);
        let (b0, b1) = (h * *a0 - gain, h * *a1 - gain);
        // v = v₀ + s gain + s (1 − s) ((1 − s) b₀ − s b₁) + κ s² (1 − s)²
        let missing = total - h * (v0 + gain / number(2.0) + (b0 - b1) / number(12.0));
        let bubble = number(30.0) * missing;
        *velocity = v0 + s * gain + s * rest * (rest * b0 - s * b1 + s * rest * bubble / h);
        let square = s * s;
        let first = square * (number(0.5) - s * (number(2.0) - s * number(0.75)) / number(3.0));
        let second = square * s * (number(4.0) - number(3.0) * s) / number(12.0);
        let third = square * s * (number(10.0) - s * (number(15.0) - number(6.0) * s)) / number(30.0);
        *change = h * (s * v0 + square * gain / number(2.0) + first * b0 - second * b1) + third * bubble;
    }
    (change, velocity)
}

#[cfg(test)]
mod tests;
