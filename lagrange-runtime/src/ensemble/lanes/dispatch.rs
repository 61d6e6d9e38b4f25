//! What the processor has, found out at run time.

use pulp::{Arch, NullaryFnOnce};

/// Something to compute, all of whose functions are inlined.
pub(super) trait Task {
    type Output;

    /// Computes it, with products fused if FUSED; the bits of the result depend on that alone.
    fn compute<const FUSED: bool>(self) -> Self::Output;
}

/// Computes a task with the instructions that the processor has.
pub(super) fn compute<T: Task>(task: T) -> T::Output {
    match Arch::new() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Arch::V3(processor) => processor.vectorize(Fused(task)),
        #[cfg(target_arch = "aarch64")]
        Arch::Neon(processor) => processor.vectorize(Fused(task)),
        _ => task.compute::<false>(),
    }
}

/// Whether products are fused.
#[cfg(any(feature = "parquet", test))]
pub(in crate::ensemble) fn is_fused() -> bool {
    struct Ask;

    impl Task for Ask {
        type Output = bool;

        #[inline(always)]
        fn compute<const FUSED: bool>(self) -> bool {
            FUSED
        }
    }

    compute(Ask)
}

/// The same with fused products.
struct Fused<T>(T);

impl<T: Task> NullaryFnOnce for Fused<T> {
    type Output = T::Output;

    #[inline(always)]
    fn call(self) -> T::Output {
        self.0.compute::<true>()
    }
}
