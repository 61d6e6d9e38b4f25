//! Tasks computed with the widest useful instructions.
//!
//! Products of series are computed in groups of four, which fit vector registers of AVX2; the
//! default target of x86-64 lacks AVX2. Fused products save a tenth beyond that. They have
//! other bits, as in [lanes](crate::scalar::Lanes).
//!
//! A function compiled for AVX2 and FMA may only be called if the processor supports them, which
//! requires a test at run time. A crate for such calls would be a dependency of every user.

#![cfg_attr(
    all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")),
    expect(unsafe_code, reason = "only a test at run time knows the instructions of the processor")
)]

/// A computation whose functions are all inlined.
pub(super) trait WideTask {
    type Output;

    /// Computes the result, with fused products if FUSED.
    fn compute<const FUSED: bool>(self) -> Self::Output;
}

/// Computes a task, with fused products and AVX2 if that is `allowed` and the processor supports
/// them.
#[inline]
pub(super) fn compute<T: WideTask>(task: T, allowed: bool) -> T::Output {
    if cfg!(all(target_feature = "avx2", target_feature = "fma")) && allowed {
        return task.compute::<true>();
    }
    #[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")))]
    if allowed && std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma") {
        // SAFETY: the processor has AVX2 and FMA.
        return unsafe { compute_with_avx2(task) };
    }
    task.compute::<false>()
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")))]
#[target_feature(enable = "avx2,fma")]
fn compute_with_avx2<T: WideTask>(task: T) -> T::Output {
    task.compute::<true>()
}
