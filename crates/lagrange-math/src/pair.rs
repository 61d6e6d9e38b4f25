//! Numbers as sums of two doubles, and their exact operations (T. J. Dekker, "A floating-point
//! technique for extending the available precision", Numerische Mathematik 18, 1971).

use crate::fused::multiply_add;

/// The sum of two numbers; the second is small relative to the first.
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

/// Returns the rounded sum of a number and one that is not larger, and the rounding error.
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

/// Returns the rounded product and the rounding error. For factors beyond 10²⁷⁰ the error may be
/// NaN unless products are fused.
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

/// Splits a number into its leading 26 bits and the rest, so that products of halves are exact (G.
/// W. Veltkamp).
#[inline(always)]
fn halves(number: f64) -> Pair {
    const SPLITTER: f64 = 134_217_729.0;
    let scaled = SPLITTER * number;
    let high = scaled - (scaled - number);
    Pair { high, low: number - high }
}

/// Returns the quotient of pairs, within a unit in the last place of the rounded one, and the
/// remainder to about a hundred bits.
#[inline(always)]
pub(crate) fn quotient<const FUSED: bool>(numerator: Pair, denominator: Pair) -> Pair {
    let reciprocal = 1.0 / denominator.high;
    let high = numerator.high * reciprocal;
    let back = product::<FUSED>(high, denominator.high);
    let rest = (numerator.high - back.high) - back.low;
    let rest = rest + multiply_add::<FUSED>(-high, denominator.low, numerator.low);
    Pair { high, low: rest * reciprocal }
}

/// Returns the square root of a pair, and the remainder; zero for zero, NaN below.
#[inline(always)]
pub(crate) fn square_root<const FUSED: bool>(square: Pair) -> Pair {
    /// Prevents a division of zero by zero, and is otherwise negligible.
    const NOTHING: f64 = 1e-300;
    let high = root(square.high);
    let back = product::<FUSED>(high, high);
    let rest = ((square.high - back.high) - back.low) + square.low;
    Pair { high, low: rest / (2.0 * high + NOTHING) }
}

/// Computes the correctly rounded square root.
#[inline(always)]
fn root(square: f64) -> f64 {
    #[cfg(feature = "std")]
    let value = square.sqrt();
    #[cfg(not(feature = "std"))]
    let value = libm::sqrt(square);
    value
}
