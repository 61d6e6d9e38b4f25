//! Powers of e and hyperbolic functions, without a branch.
//!
//! With x = k ln 2 + r, |r| ≤ ln 2 / 2, and z = r²,
//!
//! ```text
//! sinh r ≈ r + r z S(z),    cosh r ≈ 1 + z/2 + z² C(z),    eˣ = 2ᵏ (cosh r + sinh r),
//! sinh x = sinh(k ln 2) cosh r + cosh(k ln 2) sinh r,
//! cosh x = cosh(k ln 2) cosh r + sinh(k ln 2) sinh r,
//! ```
//!
//! where sinh(k ln 2) = (2ᵏ − 2⁻ᵏ)/2 and cosh(k ln 2) = (2ᵏ + 2⁻ᵏ)/2. Leading terms are added
//! together with their rounding errors. The rest, which is rounded, is at most a fifth of the
//! result.

use core::f64::consts::LOG2_E;

use crate::fused::multiply_add;
use crate::pair::{Pair, normal, product, quotient, sum};

/// ln 2 in two parts. The first part has 42 bits, so its multiples of at most 11 bits are exact.
pub(crate) const LN_2: [f64; 2] =
    [f64::from_bits(0x3fe6_2e42_fefa_3800), f64::from_bits(0x3d2e_f357_93c7_6730)];

/// Coefficients of S: minimax for the relative error of sinh r on [0, ln 2 / 2], 2^−61.7.
const SINH: [f64; 5] = [
    f64::from_bits(0x3fc5_5555_5555_5559),
    f64::from_bits(0x3f81_1111_1110_f624),
    f64::from_bits(0x3f2a_01a0_1b02_510a),
    f64::from_bits(0x3ec7_1ddf_79df_c243),
    f64::from_bits(0x3e5a_f601_cc2a_f955),
];

/// Coefficients of C: minimax for the relative error of cosh r on [0, ln 2 / 2], 2^−70.
const COSH: [f64; 5] = [
    f64::from_bits(0x3fa5_5555_5555_5558),
    f64::from_bits(0x3f56_c16c_16c1_4ff1),
    f64::from_bits(0x3efa_01a0_1ad8_6c02),
    f64::from_bits(0x3e92_7e4c_bf6d_4c97),
    f64::from_bits(0x3e21_f8c1_3b42_c62e),
];

/// Maximum magnitude for which sinh and cosh are computed here.
pub(crate) const LARGEST_HYPERBOLIC: f64 = 600.0;

/// Adding it to a number below 2⁵¹ rounds the number to an integer in the last bits, also for
/// negative numbers.
const SHIFT: f64 = 6_755_399_441_055_744.0;
const BIAS: u64 = 1023;

/// The reduction x = k ln 2 + r.
struct Reduced {
    /// k; `shifted` contains it in its last bits as a two's complement.
    multiple: f64,
    shifted: f64,
    /// sinh r.
    sinh: Pair,
    /// cosh r − 1.
    cosh_less_one: f64,
}

#[inline(always)]
fn reduce<const FUSED: bool>(x: f64) -> Reduced {
    let shifted = multiply_add::<FUSED>(x, LOG2_E, SHIFT);
    let multiple = shifted - SHIFT;
    let first = multiply_add::<FUSED>(-multiple, LN_2[0], x);
    let r = multiply_add::<FUSED>(-multiple, LN_2[1], first);
    let low = multiply_add::<FUSED>(-multiple, LN_2[1], first - r);
    let z = r * r;
    let (s, c) = (polynomial::<FUSED>(&SINH, z), polynomial::<FUSED>(&COSH, z));
    let sinh = Pair { high: r, low: multiply_add::<FUSED>(z * r, s, low) };
    // The slope of cosh r is approximately r.
    let cosh_less_one = multiply_add::<FUSED>(z * z, c, multiply_add::<FUSED>(r, low, 0.5 * z));
    Reduced { multiple, shifted, sinh, cosh_less_one }
}

/// Computes e to this power, for all numbers.
#[inline(always)]
pub(crate) fn exp<const FUSED: bool>(x: f64) -> f64 {
    // Beyond these bounds the result is infinite or zero; the comparisons preserve NaN.
    let x = if x > 710.0 { 710.0 } else { x };
    let x = if x < -746.0 { -746.0 } else { x };
    let Reduced { multiple, sinh, cosh_less_one, .. } = reduce::<FUSED>(x);
    let near = sum(1.0, sinh.high);
    let value = near.high + (near.low + (cosh_less_one + sinh.low));
    // In two steps, since 2ᵏ alone may overflow or underflow.
    let half = 0.5 * multiple + SHIFT;
    let other_half = (multiple - (half - SHIFT)) + SHIFT;
    value * power_of_two(half) * power_of_two(other_half)
}

/// Computes sinh x and cosh x for x from 0 to [`LARGEST_HYPERBOLIC`].
#[inline(always)]
fn sinh_cosh<const FUSED: bool>(x: f64) -> (Pair, Pair) {
    let Reduced { shifted, sinh, cosh_less_one, .. } = reduce::<FUSED>(x);
    let (grown, shrunk) = (0.5 * power_of_two(shifted), 0.5 * power_of_minus_two(shifted));
    // sinh and cosh of k ln 2.
    let (odd, even) = (sum(grown, -shrunk), sum(grown, shrunk));
    let of = |first: Pair, second: Pair| {
        let linear = product::<FUSED>(second.high, sinh.high);
        let near = sum(first.high, linear.high);
        let lost = near.low + (linear.low + multiply_add::<FUSED>(second.low, sinh.high, first.low));
        let rest = multiply_add::<FUSED>(first.high, cosh_less_one, second.high * sinh.low);
        normal(Pair { high: near.high, low: rest + lost })
    };
    (of(odd, even), of(even, odd))
}

/// Computes the hyperbolic sine for magnitudes of at most [`LARGEST_HYPERBOLIC`].
#[inline(always)]
pub(crate) fn sinh<const FUSED: bool>(x: f64) -> f64 {
    sinh_cosh::<FUSED>(x.abs()).0.high.copysign(x)
}

/// Computes the hyperbolic cosine for magnitudes of at most [`LARGEST_HYPERBOLIC`].
#[inline(always)]
pub(crate) fn cosh<const FUSED: bool>(x: f64) -> f64 {
    sinh_cosh::<FUSED>(x.abs()).1.high
}

/// Computes the hyperbolic tangent of any number.
#[inline(always)]
pub(crate) fn tanh<const FUSED: bool>(x: f64) -> f64 {
    /// Above this it is one to the last bit.
    const ONE_FROM: f64 = 20.0;
    let magnitude = x.abs();
    let magnitude = if magnitude > ONE_FROM { ONE_FROM } else { magnitude };
    let (sinh, cosh) = sinh_cosh::<FUSED>(magnitude);
    let Pair { high, low } = quotient::<FUSED>(sinh, cosh);
    (high + low).copysign(x)
}

/// Computes 2ᵏ for k from −1022 to 1023 in the last bits of a shifted number.
#[inline(always)]
fn power_of_two(shifted: f64) -> f64 {
    f64::from_bits(shifted.to_bits().wrapping_add(BIAS) << 52)
}

/// Computes 2⁻ᵏ.
#[inline(always)]
fn power_of_minus_two(shifted: f64) -> f64 {
    f64::from_bits(BIAS.wrapping_sub(shifted.to_bits()) << 52)
}

/// Computes c₀ + c₁ z + … + c₄ z⁴ such that few operations depend on each other.
#[inline(always)]
fn polynomial<const FUSED: bool>(c: &[f64; 5], z: f64) -> f64 {
    let first = multiply_add::<FUSED>(c[1], z, c[0]);
    let second = multiply_add::<FUSED>(c[3], z, c[2]);
    let last = multiply_add::<FUSED>(c[4], z * z, second);
    multiply_add::<FUSED>(last, z * z, first)
}
