//! Sine and cosine of one angle to 0.54 units in the last place, without branches, tables or fused
//! products.
//!
//! With the notation of [`crate::angle`], r is split into r₁, a multiple of 2⁻⁸, and r₂ = r − r₁.
//! Terms with few bits are then exact products: 1 − r₁²/2, c₁ r₁³ and C₁ r₁⁴. Here c₁ has 27 bits
//! of the polynomial's first coefficient c, C₁ has 21 of C, and c = c₁ + c₂, C = C₁ + C₂.
//!
//! ```text
//! sin(r + δ) = [r + c₁ r₁³] + (c r₂ (r² + r₁ (r + r₁)) + c₂ r₁³ + δ (1 − z/2) + z² r p(z)),
//! cos(r + δ) = [1 − r₁²/2 + C₁ r₁⁴] + (C₂ r₁⁴ − a (1 − 2 C (z + r₁²)) − r δ + z³ q(z)),    a = r₂ (r + r₁)/2,
//! ```
//!
//! where p and q lack their first terms. Sums in brackets are pairs of doubles. The remaining terms
//! are at most 1/60 of the result, so their rounding is almost negligible.
//!
//! Example: for r = 0.7, r₁ = 179/256 = 0.69921875 and r₂ = 0.00078125. c₁ r₁³ ≈ −0.0570 is exact.
//! The sine is 0.7 − 0.0570 with the rounding error of this sum, −0.000191 from r₂ and 0.00139 from
//! the other terms: 0.64421769.

use crate::angle::{COSINE, SINE, in_quadrant};
use crate::pair::{Pair, sum};
use crate::reduction::{Reduced, reduce, reduce_large};

/// 1.5 · 2⁴⁴: adding it to a number below one rounds the number to a multiple of 2⁻⁸.
const SHORT: f64 = 26_388_279_066_624.0;

/// The first coefficients of the polynomials, split into leading and remaining bits.
const FIRST_OF_SINE: Pair = split(SINE[0], 27);
const FIRST_OF_COSINE: Pair = split(COSINE[0], 21);

/// Splits a number into this number of leading bits and the rest.
const fn split(number: f64, bits: u32) -> Pair {
    let high = f64::from_bits(number.to_bits() >> (53 - bits) << (53 - bits));
    Pair { high, low: number - high }
}

/// Computes sine and cosine of an angle of at most 10⁵ in magnitude; for other angles the result is
/// meaningless.
#[inline(always)]
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    let reduced = reduce::<false>(x.abs());
    in_quadrant(reduced.quadrant, of_rest(&reduced), x)
}

/// Computes sine and cosine of an angle of any size.
pub(crate) fn sin_cos_large(x: f64) -> (f64, f64) {
    let reduced = reduce_large(x.abs());
    in_quadrant(reduced.quadrant, of_rest(&reduced), x)
}

/// Powers of the reduced angle and of its leading bits.
struct Powers {
    r: f64,
    /// r²
    z: f64,
    /// r⁴
    z2: f64,
    /// r₁
    short: f64,
    /// r₁²
    square: f64,
    /// r₂
    rest: f64,
    /// δ
    low: f64,
}

#[inline(always)]
fn of_rest(reduced: &Reduced) -> (Pair, Pair) {
    let Reduced { high: r, low, .. } = *reduced;
    let short = (r + SHORT) - SHORT;
    let z = r * r;
    let powers = Powers { r, z, z2: z * z, short, square: short * short, rest: r - short, low };
    (sine(&powers), cosine(&powers))
}

#[inline(always)]
fn sine(powers: &Powers) -> Pair {
    let Powers { r, z, z2, short, square, rest, low } = *powers;
    let cube = square * short;
    let near = sum(r, FIRST_OF_SINE.high * cube);
    let across = rest * (z + short * (r + short));
    let first = (SINE[0] * across + FIRST_OF_SINE.low * cube) + low * (1.0 - 0.5 * z);
    Pair { high: near.high, low: near.low + (first + (z2 * r) * tail(&SINE, z, z2)) }
}

#[inline(always)]
fn cosine(powers: &Powers) -> Pair {
    let Powers { r, z, z2, short, square, rest, low } = *powers;
    let fourth = square * square;
    let near = sum(1.0 - 0.5 * square, FIRST_OF_COSINE.high * fourth);
    let across = (0.5 * rest) * (r + short);
    let bent = across * (1.0 - (2.0 * COSINE[0]) * (z + square));
    let first = (FIRST_OF_COSINE.low * fourth - bent) - r * low;
    Pair { high: near.high, low: near.low + (first + (z2 * z) * tail(&COSINE, z, z2)) }
}

/// Computes a polynomial without its first term, divided by z.
#[inline(always)]
fn tail(coefficients: &[f64; 6], z: f64, z2: f64) -> f64 {
    let [_, first, second, third, fourth, last] = *coefficients;
    (first + second * z) + z2 * ((third + fourth * z) + z2 * last)
}
