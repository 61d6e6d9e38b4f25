//! Angles with a given tangent, sine or cosine, without a branch.
//!
//! The angle of a point is first computed in an eighth of the plane. Let a ≤ b be the smaller and
//! the larger of its coordinates in magnitude:
//!
//! ```text
//! arctan(a/b) = arctan t,           t = a / b                 if a ≤ b tan(π/8),
//!             = π/4 + arctan t,     t = (a − b) / (a + b)     else,
//! arctan t ≈ t + t z A(z),          z = t²,  |t| ≤ tan(π/8),
//! ```
//!
//! The result is subtracted from, or added to, a multiple of π/4. t is a sum of two doubles, and so
//! is the sum of the multiple and t. For arcsine and arccosine, the other coordinate is √(1 − x²),
//! also a sum of two doubles.

use core::f64::consts::FRAC_PI_4;

use crate::fused::multiply_add;
use crate::pair::{Pair, product, quotient, square_root, sum};

/// π/4 as a double, with exact multiples up to four, and the remainder.
const QUARTER_PI: [f64; 2] = [FRAC_PI_4, f64::from_bits(0x3c81_a626_3314_5c07)];

/// Approximation of tan(π/8): near it, both formulas are valid.
const TAN_EIGHTH: f64 = 0.414_213_562_373;

/// Coefficients of A: minimax for the relative error of arctan t on [0, tan(π/8)], 2^−59.4.
const TAIL: [f64; 11] = [
    f64::from_bits(0xbfd5_5555_5555_553d),
    f64::from_bits(0x3fc9_9999_9999_5869),
    f64::from_bits(0xbfc2_4924_922a_d50f),
    f64::from_bits(0x3fbc_71c7_0e60_7f49),
    f64::from_bits(0xbfb7_45cf_8db8_5732),
    f64::from_bits(0x3fb3_b111_90d4_f4ee),
    f64::from_bits(0xbfb1_0ebb_7b6e_37e8),
    f64::from_bits(0x3fad_f0f4_4fe7_1c2e),
    f64::from_bits(0xbfa9_cd2a_aa47_0d99),
    f64::from_bits(0x3fa3_7d58_f4dc_33b1),
    f64::from_bits(0xbf92_56a6_0d99_b473),
];

/// Range of nonzero coordinates in magnitude, in which nothing overflows or is lost.
const LEAST_COORDINATE: f64 = 1e-270;
const LARGEST_COORDINATE: f64 = 1e270;

/// True if these are coordinates of a point whose angle is computed here.
#[inline(always)]
pub(crate) fn are_coordinates(ordinate: f64, abscissa: f64) -> bool {
    let is_between = |x: f64| (LEAST_COORDINATE..=LARGEST_COORDINATE).contains(&x);
    let (y, x) = (ordinate.abs(), abscissa.abs());
    (is_between(y) & (is_between(x) | (x == 0.0))) | ((y == 0.0) & is_between(x))
}

/// Computes the angle of a point with [coordinates](are_coordinates) that are neither too large nor
/// too small.
#[inline(always)]
pub(crate) fn atan2<const FUSED: bool>(ordinate: f64, abscissa: f64) -> f64 {
    angle::<FUSED>(ordinate.abs().into(), abscissa.into()).copysign(ordinate)
}

/// Computes the arctangent of any number.
#[inline(always)]
pub(crate) fn atan<const FUSED: bool>(x: f64) -> f64 {
    /// Beyond this the angle is π/2 to the last bit.
    const FAR: f64 = 1e20;
    let magnitude = x.abs();
    let magnitude = if magnitude > FAR { FAR } else { magnitude };
    angle::<FUSED>(magnitude.into(), Pair::from(1.0)).copysign(x)
}

/// Computes the arcsine of any number; NaN outside [−1, 1].
#[inline(always)]
pub(crate) fn asin<const FUSED: bool>(x: f64) -> f64 {
    angle::<FUSED>(x.abs().into(), leg::<FUSED>(x)).copysign(x)
}

/// Computes the arccosine of any number; NaN outside [−1, 1].
#[inline(always)]
pub(crate) fn acos<const FUSED: bool>(x: f64) -> f64 {
    angle::<FUSED>(leg::<FUSED>(x), x.into())
}

/// Computes √(1 − x²).
#[inline(always)]
fn leg<const FUSED: bool>(x: f64) -> Pair {
    let square = product::<FUSED>(x, x);
    let rest = sum(1.0, -square.high);
    square_root::<FUSED>(Pair { high: rest.high, low: rest.low - square.low })
}

/// Computes the angle in [0, π] of a point with a nonnegative ordinate.
#[inline(always)]
fn angle<const FUSED: bool>(ordinate: Pair, abscissa: Pair) -> f64 {
    let is_left = abscissa.high.is_sign_negative();
    let turned = Pair { high: -abscissa.high, low: -abscissa.low };
    let abscissa = if is_left { turned } else { abscissa };
    let is_high = ordinate.high > abscissa.high;
    let (smaller, larger) = if is_high { (abscissa, ordinate) } else { (ordinate, abscissa) };
    let is_steep = smaller.high > TAN_EIGHTH * larger.high;
    let (difference, total) = (sum(-larger.high, smaller.high), sum(larger.high, smaller.high));
    let numerator = if is_steep { widened(difference, smaller.low - larger.low) } else { smaller };
    let denominator = if is_steep { widened(total, smaller.low + larger.low) } else { larger };
    let eighths = if is_steep { 1.0 } else { 0.0 };
    let eighths = if is_high { 2.0 - eighths } else { eighths };
    let eighths = if is_left { 4.0 - eighths } else { eighths };
    let sign = if is_high != is_left { -1.0 } else { 1.0 };
    from_axis::<FUSED>(eighths, sign, quotient::<FUSED>(numerator, denominator))
}

#[inline(always)]
fn widened(pair: Pair, low: f64) -> Pair {
    Pair { high: pair.high, low: pair.low + low }
}

/// Adds a number of eighths of a turn and, with this sign, the angle with a small tangent.
#[inline(always)]
fn from_axis<const FUSED: bool>(eighths: f64, sign: f64, tangent: Pair) -> f64 {
    let z = tangent.high * tangent.high;
    // The slope of the arctangent is 1/(1 + z).
    let of_low = tangent.low * multiply_add::<FUSED>(z, z - 1.0, 1.0);
    let rest = multiply_add::<FUSED>(z * tangent.high, tail::<FUSED>(z), of_low);
    let near = sum(eighths * QUARTER_PI[0], sign * tangent.high);
    near.high + (near.low + multiply_add::<FUSED>(eighths, QUARTER_PI[1], sign * rest))
}

/// Computes A(z) such that few operations depend on each other.
#[inline(always)]
fn tail<const FUSED: bool>(z: f64) -> f64 {
    let pair = |k: usize| multiply_add::<FUSED>(TAIL[k + 1], z, TAIL[k]);
    let (z2, z4) = (z * z, (z * z) * (z * z));
    let four = |k: usize| multiply_add::<FUSED>(pair(k + 2), z2, pair(k));
    let last = multiply_add::<FUSED>(TAIL[10], z2, pair(8));
    multiply_add::<FUSED>(multiply_add::<FUSED>(last, z4, four(4)), z4, four(0))
}
