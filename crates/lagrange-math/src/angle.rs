//! Sine and cosine of one angle, without a branch.
//!
//! With r the reduced angle, z = r² and δ its low part,
//!
//! ```text
//! sin(r + δ) ≈ r + (r z p(z) + δ (1 − z/2)),    cos(r + δ) ≈ 1 − z/2 + (z² q(z) − r δ),
//! ```
//!
//! where the first term is exact or its rounding error is added back. The rest is at most a tenth
//! of the first term. In units in the last place the error is at most the sum of these
//! contributions:
//! - 0.5 from the last sum;
//! - 0.34 from the rounding of the rest (the sine at r = π/4, where six roundings of terms near
//!   0.08 meet a unit of 2⁻⁵³);
//! - 0.04 from the polynomial;
//! - 0.01 from the reduction.
//!
//! The polynomials are evaluated such that few operations depend on each other.

use crate::fused::multiply_add;
use crate::pair::Pair;
use crate::reduction::{Reduced, reduce, reduce_large};

/// Coefficients of p: minimax for the relative error of sin r on [0, π/4], 2^−57.9.
pub(crate) const SINE: [f64; 6] = [
    f64::from_bits(0xbfc5_5555_5555_5548),
    f64::from_bits(0x3f81_1111_1110_f730),
    f64::from_bits(0xbf2a_01a0_19be_9215),
    f64::from_bits(0x3ec7_1de3_5552_b247),
    f64::from_bits(0xbe5a_e5e4_b83b_76fe),
    f64::from_bits(0x3de5_d8b5_585c_7708),
];

/// Coefficients of q: minimax for the relative error of cos r on [0, π/4], 2^−63.9.
pub(crate) const COSINE: [f64; 6] = [
    f64::from_bits(0x3fa5_5555_5555_554b),
    f64::from_bits(0xbf56_c16c_16c1_5015),
    f64::from_bits(0x3efa_01a0_19c8_f25a),
    f64::from_bits(0xbe92_7e4f_7f19_1d98),
    f64::from_bits(0x3e21_ee9d_bcf8_d339),
    f64::from_bits(0xbda8_fa68_4e7e_cf41),
];

const SIGN: u64 = 1 << 63;

/// Computes sine and cosine of an angle of at most 10⁵ in magnitude; for other angles the result is
/// meaningless.
#[inline(always)]
pub(crate) fn sin_cos<const FUSED: bool>(x: f64) -> (f64, f64) {
    let reduced = reduce::<FUSED>(x.abs());
    in_quadrant(reduced.quadrant, of_rest::<FUSED>(&reduced), x)
}

/// Computes sine and cosine of an angle of any size.
pub(crate) fn sin_cos_large(x: f64) -> (f64, f64) {
    let reduced = reduce_large(x.abs());
    in_quadrant(reduced.quadrant, of_rest::<false>(&reduced), x)
}

/// Computes sine and cosine of the reduced angle. The second number of each pair is at most a tenth
/// of the first.
#[inline(always)]
pub(crate) fn of_rest<const FUSED: bool>(reduced: &Reduced) -> (Pair, Pair) {
    let z = reduced.high * reduced.high;
    let half = 0.5 * z;
    let near_cosine = 1.0 - half;
    (sine::<FUSED>(reduced, z, near_cosine), cosine::<FUSED>(reduced, z, half, near_cosine))
}

#[inline(always)]
fn sine<const FUSED: bool>(reduced: &Reduced, z: f64, near_cosine: f64) -> Pair {
    let Reduced { high: r, low, .. } = *reduced;
    let (z2, cube) = (z * z, z * r);
    let rest = multiply_add::<FUSED>(pair::<FUSED>(&SINE, 4, z), z2, pair::<FUSED>(&SINE, 2, z));
    let first = multiply_add::<FUSED>(pair::<FUSED>(&SINE, 0, z), cube, low * near_cosine);
    Pair { high: r, low: multiply_add::<FUSED>(rest, cube * z2, first) }
}

#[inline(always)]
fn cosine<const FUSED: bool>(reduced: &Reduced, z: f64, half: f64, near_cosine: f64) -> Pair {
    let Reduced { high: r, low, .. } = *reduced;
    let z2 = z * z;
    let rest = multiply_add::<FUSED>(pair::<FUSED>(&COSINE, 4, z), z2, pair::<FUSED>(&COSINE, 2, z));
    let lost = (1.0 - near_cosine) - half;
    let first = multiply_add::<FUSED>(pair::<FUSED>(&COSINE, 0, z), z2, lost - r * low);
    Pair { high: near_cosine, low: multiply_add::<FUSED>(rest, z2 * z2, first) }
}

/// Computes two adjacent terms of a polynomial, divided by their common power of z.
#[inline(always)]
fn pair<const FUSED: bool>(coefficients: &[f64; 6], index: usize, z: f64) -> f64 {
    multiply_add::<FUSED>(coefficients[index + 1], z, coefficients[index])
}

/// Adds up sine and cosine, exchanges them in odd quadrants and sets their signs; the sine also
/// takes the sign of the angle. It operates on bits, since a selection between numbers is a branch
/// on many targets.
#[inline(always)]
pub(crate) fn in_quadrant(quadrant: u64, (sine, cosine): (Pair, Pair), x: f64) -> (f64, f64) {
    let (sine, cosine, sign) = (sine.high + sine.low, cosine.high + cosine.low, x.to_bits() & SIGN);
    let is_odd = (quadrant & 1).wrapping_neg();
    let exchange = (sine.to_bits() ^ cosine.to_bits()) & is_odd;
    let sine_sign = ((quadrant & 2) << 62) ^ sign;
    let cosine_sign = (quadrant.wrapping_add(1) & 2) << 62;
    let sine = f64::from_bits(sine.to_bits() ^ exchange ^ sine_sign);
    let cosine = f64::from_bits(cosine.to_bits() ^ exchange ^ cosine_sign);
    (sine, cosine)
}
