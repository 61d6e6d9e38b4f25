//! Tasks computed by the widest instructions that help them.
//!
//! Products of series come in fours, which fit the registers of AVX2; the default target of x86-64
//! does without. Results have the same bits: no products are fused that are not fused on the target
//! at large. Fused products would save up to a sixth for some motions and nothing for others.
//!
//! This is the one file of the crate with unsafe code. A function that is compiled for AVX2 may
//! only be called where the processor has it, and only a test at run time knows. A crate for such
//! calls would be a dependency of every user.

#![cfg_attr(
    all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")),
    expect(unsafe_code, reason = "only a test at run time knows the instructions of the processor")
)]

/// Something to compute, all of whose functions are inlined.
pub(super) trait WideTask {
    type Output;

    /// Computes it.
    fn compute(self) -> Self::Output;
}

/// Computes a task with the instructions that the processor has.
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
