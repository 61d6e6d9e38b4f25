//! A hint at steps limited by stability, from the coefficients of a series.
//!
//! A component that decays or oscillates at a rate λ has the coefficients λᵏ/k!, which dominate
//! high orders even if the component itself is tiny. The quotient of two of them, in turn, is λ²
//! for oscillations, whose successive coefficients vary with the phase. In a motion without such a
//! component, the quotient depends on the nearest singularity, and is too small to count as fast.

use crate::integrate::stiffness::{StabilityLimit, are_many, is_fast};
use crate::linalg::vector::l1_norm;
use crate::scalar::{Number, Scalar};
use crate::system::StateVector;

/// The largest stable |h λ| grows by this per order. The polynomials 1 + z + … + zᵖ/p! are at most
/// one in a region about as far to the left and, within a few per cent, up and down.
const STABLE_PER_ORDER: f64 = 0.37;
/// The largest stable |h λ| at order zero of the same line, which is within 4 % of ᵖ√p! for orders
/// from 6 to 40.
const STABLE_AT_ZERO: f64 = 0.9;
/// Near the limit, the last terms are at least this part of those at the limit.
const LAST_TERM: f64 = 0.04;

/// Returns the stability limit of series of this order.
pub(super) fn stability<S: Scalar>(order: usize) -> StabilityLimit<S> {
    let p = S::from_f64(order as f64);
    let stable = p.multiply_add(S::from_f64(STABLE_PER_ORDER), S::from_f64(STABLE_AT_ZERO));
    StabilityLimit { stable, near: (S::from_f64(LAST_TERM).ln() / p).exp() }
}

/// True if a step of length `h` along these coefficients is at the stability limit, with many
/// others until the end of the time `ahead`.
#[inline(always)]
pub(super) fn is_at_limit<S: Number, Y: StateVector<S>>(
    limit: &StabilityLimit<S>,
    (h, ahead): (S, S),
    y: &Y,
    coefficients: &[Y],
) -> S::Mask {
    let [rate, .., before, _, last] = coefficients else { return (S::ONE).less(S::ZERO) };
    let order = coefficients.len();
    let orders = S::from_f64((order * (order - 1)) as f64);
    let eigenvalue = (orders * l1_norm(last) / l1_norm(before)).sqrt();
    let is_near = (limit.near * limit.stable).less(h.abs() * eigenvalue);
    are_many((h, ahead)) & is_near & is_fast(eigenvalue, (l1_norm(y), l1_norm(rate)))
}
