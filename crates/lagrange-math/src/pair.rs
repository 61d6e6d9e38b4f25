//! Numbers as sums of two doubles, and their exact operations (T. J. Dekker, "A floating-point
//! technique for extending the available precision", Numerische Mathematik 18, 1971).

use crate::fused::multiply_add;

/// The sum of two numbers, of which the second is small beside the first.
#[derive(Clone, Copy)]
pub(crate) struct Pair {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

impl From<f64> for Pair {
    #[inline(always)]
    fn from(number: f64) -> Pair {
        Pair { high: number, low: 0.0 }
    }
}

/// The sum of a number and one that is not larger, rounded, and what was lost.
#[inline(always)]
pub(crate) fn sum(larger: f64, smaller: f64) -> Pair {
    let high = larger + smaller;
    Pair { high, low: (larger - high) + smaller }
}

/// Normalises a pair: the first number is the rounded sum.
#[inline(always)]
pub(crate) fn normal(pair: Pair) -> Pair {
    sum(pair.high, pair.low)
}

/// The product, rounded, and what was lost. Of factors beyond 10²⁷⁰ it is not a number where
/// products are not fused.
#[inline(always)]
pub(crate) fn product<const FUSED: bool>(a: f64, b: f64) -> Pair {
    let high = a * b;
    if FUSED {
        return Pair { high, low: multiply_add::<FUSED>(a, b, -high) };
    }
    let (a, b) = (halves(a), halves(b));
    let low = ((a.high * b.high - high) + a.high * b.low + a.low * b.high) + a.low * b.low;
    Pair { high, low }
}

/// The leading 26 bits of a number and the others, so that products of halves are exact (G. W.
/// Veltkamp).
#[inline(always)]
fn halves(number: f64) -> Pair {
    const SPLITTER: f64 = 134_217_729.0;
    let scaled = SPLITTER * number;
    let high = scaled - (scaled - number);
    Pair { high, low: number - high }
}

/// The quotient of pairs, a unit in the last place from rounded, and what is missing to some
/// hundred bits.
#[inline(always)]
pub(crate) fn quotient<const FUSED: bool>(numerator: Pair, denominator: Pair) -> Pair {
    let reciprocal = 1.0 / denominator.high;
    let high = numerator.high * reciprocal;
    let back = product::<FUSED>(high, denominator.high);
    let rest = (numerator.high - back.high) - back.low;
    let rest = rest + multiply_add::<FUSED>(-high, denominator.low, numerator.low);
    Pair { high, low: rest * reciprocal }
}

/// The square root of a pair, and what is missing of it; zero of zero, NaN below.
#[inline(always)]
pub(crate) fn square_root<const FUSED: bool>(square: Pair) -> Pair {
    /// Added to what is zero only where it may as well be this.
    const NOTHING: f64 = 1e-300;
    let high = root(square.high);
    let back = product::<FUSED>(high, high);
    let rest = ((square.high - back.high) - back.low) + square.low;
    Pair { high, low: rest / (2.0 * high + NOTHING) }
}

/// The square root, correctly rounded.
#[inline(always)]
fn root(square: f64) -> f64 {
    #[cfg(feature = "std")]
    let value = square.sqrt();
    #[cfg(not(feature = "std"))]
    let value = libm::sqrt(square);
    value
}
