//! Tasks computed with the widest useful instructions.
//!
//! Products of series are computed in groups of four, which fit the registers of AVX2; the default
//! target of x86-64 lacks AVX2. Results have the same bits: products are fused only if they are
//! fused on the whole target. Fused products would save up to a sixth for some motions and nothing
//! for others.
//!
//! This is the only file of the crate with unsafe code. A function compiled for AVX2 may only be
//! called if the processor supports it, which requires a test at run time. A crate for such calls
//! would be a dependency of every user.

#![cfg_attr(
    all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")),
    expect(unsafe_code, reason = "only a test at run time knows the instructions of the processor")
)]

/// A computation whose functions are all inlined.
pub(super) trait WideTask {
    type Output;

    /// Computes the result.
    fn compute(self) -> Self::Output;
}

/// Computes a task with the instructions that the processor supports.
#[inline]
pub(super) fn compute<T: WideTask>(task: T) -> T::Output {
    #[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")))]
    if std::is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has AVX2.
        return unsafe { compute_with_avx2(task) };
    }
    task.compute()
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")))]
#[target_feature(enable = "avx2")]
fn compute_with_avx2<T: WideTask>(task: T) -> T::Output {
    task.compute()
}
