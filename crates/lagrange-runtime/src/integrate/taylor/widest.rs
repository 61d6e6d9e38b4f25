//! Expansions by the widest instructions that help them.
//!
//! Products of series come in fours. With AVX2, which the default target of x86-64 does without, an
//! expansion takes about two thirds of the time. Results have the same bits: no products are fused
//! that are not fused on the target at large.
//!
//! This is the one file of the crate with unsafe code. A function that is compiled for AVX2 may
//! only be called where the processor has it, and only a test at run time knows. A crate for such
//! calls would be a dependency of every user.

#![cfg_attr(
    all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")),
    expect(unsafe_code, reason = "only a test at run time knows the instructions of the processor")
)]

use crate::system::TaylorSystem;

/// Expands the motion as [`TaylorSystem::expand`] does.
#[inline]
pub(super) fn expand<M: TaylorSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
    series: &mut M::Series,
    coefficients: &mut [M::State],
) {
    #[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")))]
    if std::is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has AVX2.
        return unsafe { expand_with_avx2(system, t, y, series, coefficients) };
    }
    system.expand(t, y, series, coefficients);
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(target_feature = "avx2")))]
#[target_feature(enable = "avx2")]
fn expand_with_avx2<M: TaylorSystem + ?Sized>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
    series: &mut M::Series,
    coefficients: &mut [M::State],
) {
    system.expand(t, y, series, coefficients);
}
