//! Checks that constraints are independent enough for elimination, and bounds on their residuals.

use crate::constraint::minimum_norm::rank_tolerance;
use crate::scalar::Scalar;

/// True if all values are finite and their direct computation is reliable. Its growth of rounding
/// errors, `condition`, must be below the inverse square of [`rank_tolerance`], since pivots are
/// squares of remainders of gradients.
#[inline]
pub fn are_regular<S: Scalar>(values: &[S], condition: S) -> bool {
    condition * rank_tolerance::<S>() * rank_tolerance::<S>() < S::ONE && are_finite(values)
}

/// True if all values are finite.
#[inline]
pub fn are_finite<S: Scalar>(values: &[S]) -> bool {
    values.iter().all(|value| value.is_finite())
}

/// Computes Σⱼ |Aᵢⱼ| sⱼ for the rows of a matrix and weights s.
#[inline]
pub fn weighed<S: Scalar, const N: usize, const M: usize>(rows: &[[S; N]; M], shares: &[S; N]) -> [S; M] {
    rows.map(|row| row.iter().zip(shares).fold(S::ZERO, |sum, (entry, &share)| sum + entry.abs() * share))
}

/// Computes Σⱼ |Aᵢⱼ| sⱼ by rows, from the nonzero entries `(i, j, Aᵢⱼ)` of a matrix.
///
/// # Panics
/// If an index is too large.
#[inline]
pub fn weighed_entries<S: Scalar, const N: usize, const M: usize>(
    entries: &[(usize, usize, S)],
    shares: &[S; N],
) -> [S; M] {
    let mut scales = [S::ZERO; M];
    for &(row, column, entry) in entries {
        scales[row] = scales[row] + entry.abs() * shares[column];
    }
    scales
}

#[cfg(test)]
mod tests {
    use super::{are_finite, are_regular};

    #[test]
    fn what_is_not_known_is_not_regular() {
        assert!(are_regular(&[1.0, -2.0], 1e6));
        assert!(!are_regular(&[1.0], 1e13));
        assert!(!are_regular(&[1.0], f64::NAN));
        assert!(!are_regular(&[f64::NAN], 1.0));
        assert!(!are_finite(&[1.0, f64::INFINITY]));
    }
}
