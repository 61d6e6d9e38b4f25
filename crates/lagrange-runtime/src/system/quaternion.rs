//! Unit quaternions among the positions of a system. The scalar part is at an index, followed by
//! the vector part.
//!
//! Emitted types define [`MechanicalSystem::normalise`](super::MechanicalSystem::normalise) and
//! [`MechanicalSystem::displacement`](super::MechanicalSystem::displacement) with these functions.
//! A quaternion q maps body axes to world axes. Its rate is q̇ = ½ q ⊗ (0, ω) with the angular
//! velocity ω in body axes.
//!
//! Source: Featherstone, *Rigid Body Dynamics Algorithms*, §4.5.

use crate::scalar::Scalar;

/// Below this squared length, components are scaled before they are squared, to avoid underflow.
const SMALLEST: f64 = 1e-30;

/// Normalises the quaternion that begins at an index; a zero quaternion becomes NaN.
///
/// ```
/// let mut positions = [7.0, 3.0, 0.0, 4.0, 0.0];
/// lagrange::system::quaternion::normalise(&mut positions, 1);
/// assert_eq!(positions, [7.0, 0.6, 0.0, 0.8, 0.0]);
/// ```
#[inline]
pub fn normalise<S: Scalar>(positions: &mut [S], first: usize) {
    let Some(quaternion) = positions.get_mut(first..first + 4) else { return };
    let sum_of_squares =
        |entries: &[S]| entries.iter().fold(S::ZERO, |sum, entry| entry.multiply_add(*entry, sum));
    let square = sum_of_squares(quaternion);
    if !(square.is_finite() && square > S::from_f64(SMALLEST)) {
        // Squares of very large or very small components overflow or underflow.
        let largest = quaternion.iter().fold(S::ZERO, |most, entry| most.max(entry.abs()));
        quaternion.iter_mut().for_each(|entry| *entry = *entry / largest);
    }
    let length = sum_of_squares(quaternion).sqrt();
    quaternion.iter_mut().for_each(|entry| *entry = *entry / length);
}

/// Computes the small rotation from one quaternion to another, as a vector in body axes: 2 Im(q̄ ⊗
/// p). The sign of p is chosen so that the scalar part is not negative, since p and −p describe the
/// same orientation.
///
/// ```
/// // A rotation by 0.002 about z, to a quaternion of opposite sign.
/// let (from, to) = ([1.0, 0.0, 0.0, 0.0], [-1.0, 0.0, 0.0, -0.001]);
/// assert_eq!(lagrange::system::quaternion::turn(&from, &to, 0), [0.0, 0.0, 0.002]);
/// ```
#[inline]
pub fn turn<S: Scalar>(from: &[S], to: &[S], first: usize) -> [S; 3] {
    let [a, b, c, d] = [0, 1, 2, 3].map(|index| from[first + index]);
    let [e, f, g, h] = [0, 1, 2, 3].map(|index| to[first + index]);
    let scalar = a * e + b * f + c * g + d * h;
    let two = S::ONE + S::ONE;
    let factor = if scalar < S::ZERO { -two } else { two };
    [a * f - b * e - c * h + d * g, a * g + b * h - c * e - d * f, a * h - b * g + c * f - d * e]
        .map(|entry| factor * entry)
}
