//! The natural logarithm, without a branch.
//!
//! With x = 2ᵏ (1 + f), √½ ≤ 1 + f < √2, s = f / (2 + f) and w = s²,
//!
//! ```text
//! ln(1 + f) = 2 artanh s ≈ 2 s + s w L(w) = f − s (f − w L(w)),    ln x = k ln 2 + ln(1 + f),
//! ```
//!
//! where f is exact, and so is k times the first part of ln 2; the rounding error of their sum is
//! added back. The rounded rest is at most a fifth of the result.

use crate::exponential::LN_2;
use crate::fused::multiply_add;
use crate::pair::sum;

/// Coefficients of L: minimax for the relative error of artanh s on [0, (√2 − 1) / (√2 + 1)],
/// 2^−59.5.
const TAIL: [f64; 7] = [
    f64::from_bits(0x3fe5_5555_5555_5592),
    f64::from_bits(0x3fd9_9999_9997_ff65),
    f64::from_bits(0x3fd2_4924_941d_b1e9),
    f64::from_bits(0x3fcc_71c5_21a4_29e1),
    f64::from_bits(0x3fc7_4663_b99f_c68c),
    f64::from_bits(0x3fc3_9a20_ca20_0034),
    f64::from_bits(0x3fc2_f024_73f9_ff73),
];

const MANTISSA: u64 = (1 << 52) - 1;
/// 2⁵²: a small integer written to its last bits is added to it.
const WHOLE: f64 = 4_503_599_627_370_496.0;
/// 2⁵⁴, which makes all positive numbers normal.
const GROWTH: f64 = 18_014_398_509_481_984.0;
const BIAS: f64 = 1023.0;

/// Computes the natural logarithm of any number.
#[inline(always)]
pub(crate) fn ln<const FUSED: bool>(x: f64) -> f64 {
    let value = of_positive::<FUSED>(x);
    // Infinity and NaN are their own logarithms.
    let value = if x < f64::INFINITY { value } else { x };
    let at_most_zero = if x == 0.0 { f64::NEG_INFINITY } else { f64::NAN };
    if x > 0.0 { value } else { at_most_zero }
}

#[inline(always)]
fn of_positive<const FUSED: bool>(x: f64) -> f64 {
    let is_small = x < f64::MIN_POSITIVE;
    let normal = if is_small { x * GROWTH } else { x };
    let bias = if is_small { BIAS + 54.0 } else { BIAS };
    // Shifts √½ to a change of the exponent, so that 1 + f lies on both sides of one.
    let root_half = core::f64::consts::FRAC_1_SQRT_2.to_bits();
    let moved = normal.to_bits().wrapping_add(1_f64.to_bits() - root_half);
    let multiple = f64::from_bits((moved >> 52) | WHOLE.to_bits()) - (WHOLE + bias);
    let f = f64::from_bits((moved & MANTISSA) + root_half) - 1.0;
    let s = f / (2.0 + f);
    let w = s * s;
    let near = sum(multiple * LN_2[0], f);
    let curved = s * multiply_add::<FUSED>(-w, tail::<FUSED>(w), f);
    near.high - (curved - multiply_add::<FUSED>(multiple, LN_2[1], near.low))
}

/// Computes L(w) such that few operations depend on each other.
#[inline(always)]
fn tail<const FUSED: bool>(w: f64) -> f64 {
    let pair = |k: usize| multiply_add::<FUSED>(TAIL[k + 1], w, TAIL[k]);
    let w2 = w * w;
    let (low, middle) = (pair(0), pair(2));
    let high = multiply_add::<FUSED>(TAIL[6], w2, pair(4));
    multiply_add::<FUSED>(multiply_add::<FUSED>(high, w2, middle), w2, low)
}
