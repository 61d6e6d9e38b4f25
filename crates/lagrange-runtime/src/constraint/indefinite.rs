//! Accelerations for a regular mass matrix with a vanishing pivot.

use crate::constraint::minimum_norm::{equilibration, finite, power_to_one, roundings};
use crate::linalg::orthogonal::OrthogonalFactors;
use crate::scalar::Scalar;

/// Computes the accelerations a of M a = f by orthogonal factors. The mass matrix M, in rows, is
/// symmetric and need not be definite. They are NaN if it is singular or a value is not finite.
/// Rows and columns are scaled alike before the rank is determined. The common unit is irrelevant:
/// multiplying matrix and forces by one power of two leaves the accelerations identical bit by bit.
///
/// ```
/// use lagrange::constraint::indefinite_motion;
///
/// let [first, second]: [f64; 2] = indefinite_motion(&[[0.0, 1.0], [1.0, 0.0]], &[2.0, 3.0]);
/// assert!((first - 3.0).abs() < 1e-14 && (second - 2.0).abs() < 1e-14);
/// assert!(indefinite_motion(&[[1.0, 1.0], [1.0, 1.0]], &[2.0_f64, 2.0])[0].is_nan());
/// ```
pub fn indefinite_motion<S: Scalar, const N: usize>(mass: &[[S; N]; N], forcing: &[S; N]) -> [S; N] {
    if !(finite(mass) && finite(&[*forcing])) {
        return [S::NAN; N];
    }
    let unit = power_to_one(mass.as_flattened().iter().map(|entry| entry.abs()));
    let (mass, forcing) = (mass.map(|row| row.map(|entry| unit * entry)), forcing.map(|force| unit * force));
    let scales = equilibration(&mass);
    // Columns equal rows, since the matrix is symmetric.
    let scaled: [[S; N]; N] =
        core::array::from_fn(|j| core::array::from_fn(|i| scales[i] * mass[i][j] * scales[j]));
    let factors = OrthogonalFactors::new(scaled, roundings::<S, N>());
    if factors.rank() < N {
        return [S::NAN; N];
    }
    let solution = factors.combination(core::array::from_fn(|i| scales[i] * forcing[i]));
    core::array::from_fn(|i| scales[i] * solution[i])
}
