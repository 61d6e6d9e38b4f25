//! The tangent of one angle, without a branch. It is the quotient of the sine and the cosine of the
//! reduced angle, or of the cosine and the sine in odd quadrants. Both are sums of two doubles, so
//! only the quotient is rounded.

use crate::angle::of_rest;
use crate::pair::{Pair, normal, quotient};
use crate::reduction::{Reduced, reduce, reduce_large};

/// Computes the tangent of an angle of at most 10⁵ in magnitude; for other angles the result is
/// meaningless.
#[inline(always)]
pub(crate) fn tan<const FUSED: bool>(x: f64) -> f64 {
    of_reduced::<FUSED>(&reduce::<FUSED>(x.abs()), x)
}

/// Computes the tangent of an angle of any size.
pub(crate) fn tan_large(x: f64) -> f64 {
    of_reduced::<false>(&reduce_large(x.abs()), x)
}

#[inline(always)]
fn of_reduced<const FUSED: bool>(reduced: &Reduced, x: f64) -> f64 {
    let (sine, cosine) = of_rest::<FUSED>(reduced);
    let (sine, cosine) = (normal(sine), normal(cosine));
    let is_odd = (reduced.quadrant & 1).wrapping_neg();
    let (numerator, denominator) = (chosen(is_odd, cosine, sine), chosen(is_odd, sine, cosine));
    let Pair { high, low } = quotient::<FUSED>(numerator, denominator);
    let sign = (x.to_bits() ^ is_odd) & (1 << 63);
    f64::from_bits((high + low).to_bits() ^ sign)
}

/// Returns the first pair if all bits of the mask are set, and the second if none is set. It
/// operates on bits, as in [`crate::angle`].
#[inline(always)]
fn chosen(mask: u64, then: Pair, otherwise: Pair) -> Pair {
    let choose = |then: f64, otherwise: f64| {
        f64::from_bits(otherwise.to_bits() ^ (mask & (then.to_bits() ^ otherwise.to_bits())))
    };
    Pair { high: choose(then.high, otherwise.high), low: choose(then.low, otherwise.low) }
}
