//! Generalised velocities that move a frame as given.

use crate::linalg::singular::nearest;
use crate::linalg::vector::dot;
use crate::scalar::Scalar;

/// Returns the generalised velocities that move a frame as given, closest to preferred ones.
///
/// `jacobian` is that of the frame, as returned by emitted methods `NAME_jacobian`. `twist` is the
/// angular velocity of the frame in rad/s and the velocity of its origin, in world axes. With the
/// preferred velocities z, the result is
///
/// ```text
/// v = z + Jᵀ (J Jᵀ)⁻¹ (twist − J z),
/// ```
///
/// the solution of J v = twist with the smallest |v − z|. In singular postures not every twist is
/// possible. The lost directions are then left out. Source: Whitney, "Resolved motion rate control
/// of manipulators and human prostheses", *IEEE Trans. Man-Machine Systems* 10 (1969) 47–53;
/// Siciliano, Sciavicco, Villani, Oriolo, *Robotics*, §3.5.
///
/// Example: for J = (1 1), twist 2 and z = (1, 0), J Jᵀ = 2 and twist − J z = 1, so v = (1½, ½).
#[must_use]
pub fn resolved_rates<S: Scalar, const N: usize, const R: usize>(
    jacobian: &[[S; N]; R],
    twist: &[S; R],
    preferred: &[S; N],
) -> [S; N] {
    let square = jacobian.map(|row| jacobian.map(|other| dot(&row, &other)));
    let missing = core::array::from_fn(|i| twist[i] - dot(&jacobian[i], preferred));
    let shares = nearest(&square, &missing, R);
    let mut rates = *preferred;
    for (row, share) in jacobian.iter().zip(shares) {
        for (rate, entry) in rates.iter_mut().zip(row) {
            *rate = share.multiply_add(*entry, *rate);
        }
    }
    rates
}

#[cfg(test)]
mod tests {
    use super::resolved_rates;

    #[test]
    fn the_example_in_numbers_holds() {
        assert_eq!(resolved_rates(&[[1.0, 1.0]], &[2.0], &[1.0, 0.0]), [1.5, 0.5]);
    }

    #[test]
    fn a_direction_that_is_lost_is_left_out() {
        let rates: [f64; 2] = resolved_rates(&[[1.0, 1.0], [0.0, 0.0]], &[2.0, 5.0], &[0.0, 0.0]);
        assert!((rates[0] - 1.0).abs() + (rates[1] - 1.0).abs() < 1e-14, "{rates:?}");
    }
}
