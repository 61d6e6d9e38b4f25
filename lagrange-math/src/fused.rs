//! Products and sums in one rounding, where the target has such an instruction.

/// `a * b + c`, rounded once where that is one instruction and twice elsewhere.
#[inline(always)]
pub(crate) fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
    #[cfg(all(feature = "std", target_feature = "fma"))]
    let value = a.mul_add(b, c);
    #[cfg(not(all(feature = "std", target_feature = "fma")))]
    let value = a * b + c;
    value
}
