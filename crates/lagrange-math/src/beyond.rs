//! Functions beyond the domains of the formulas, by `libm`, which is pure Rust and returns the same
//! bits on every platform.

use crate::tangent;

pub(crate) use libm::{atan2, cosh, hypot, sinh};

/// Computes the tangent of an angle of any size.
#[cold]
#[inline(never)]
pub(crate) fn tan(x: f64) -> f64 {
    tangent::tan_large(x)
}
