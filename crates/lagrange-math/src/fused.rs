//! Products and sums with one rounding, if requested.

/// True if the compilation target has an instruction for a product and a sum with one rounding.
pub(crate) const HAS_FUSED: bool = cfg!(all(feature = "std", target_feature = "fma"));

/// Computes `a * b + c`, rounded once if FUSED and twice otherwise. If the target lacks the
/// instruction, FUSED calls a library.
#[inline(always)]
pub(crate) fn multiply_add<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if !FUSED {
        return a * b + c;
    }
    #[cfg(feature = "std")]
    let value = a.mul_add(b, c);
    #[cfg(not(feature = "std"))]
    let value = libm::fma(a, b, c);
    value
}
