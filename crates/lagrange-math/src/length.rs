//! The length of a vector in the plane, without a branch. Squares are sums of two doubles, so only
//! the root is rounded.

use crate::pair::{Pair, product, square_root, sum};

/// Range of nonzero components in magnitude, in which no square overflows or is lost.
const LEAST_COMPONENT: f64 = 1e-130;
const LARGEST_COMPONENT: f64 = 1e150;

/// True if the length of a vector with these components is computed here.
#[inline(always)]
pub(crate) fn are_components(x: f64, y: f64) -> bool {
    let is_one = |x: f64| (LEAST_COMPONENT..=LARGEST_COMPONENT).contains(&x) | (x == 0.0);
    is_one(x.abs()) & is_one(y.abs())
}

/// Computes the length of a vector with [components](are_components) that are neither too large nor
/// too small.
#[inline(always)]
pub(crate) fn hypot<const FUSED: bool>(x: f64, y: f64) -> f64 {
    let (x, y) = (x.abs(), y.abs());
    let (larger, smaller) = if x < y { (y, x) } else { (x, y) };
    let (of_larger, of_smaller) = (product::<FUSED>(larger, larger), product::<FUSED>(smaller, smaller));
    let total = sum(of_larger.high, of_smaller.high);
    let low = total.low + (of_larger.low + of_smaller.low);
    let root = square_root::<FUSED>(Pair { high: total.high, low });
    root.high + root.low
}
