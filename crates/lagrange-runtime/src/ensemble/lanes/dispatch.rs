//! Run-time detection of processor features.

use pulp::{Arch, NullaryFnOnce};

/// A computation all of whose functions are inlined.
pub(super) trait Task {
    type Output;

    /// Computes the result, with fused products if FUSED. The bits of the result depend on nothing
    /// else.
    fn compute<const FUSED: bool>(self) -> Self::Output;
}

/// Computes a task with the widest instructions that the processor supports.
pub(super) fn compute<T: Task>(task: T) -> T::Output {
    compute_on(Arch::new(), task)
}

fn compute_on<T: Task>(processor: Arch, task: T) -> T::Output {
    match processor {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Arch::V3(processor) => processor.vectorize(Fused(task)),
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Arch::V4(processor) => processor.vectorize(Fused(task)),
        #[cfg(target_arch = "aarch64")]
        Arch::Neon(processor) => processor.vectorize(Fused(task)),
        _ => task.compute::<false>(),
    }
}

/// True if products are fused.
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

/// A task computed with fused products.
struct Fused<T>(T);

impl<T: Task> NullaryFnOnce for Fused<T> {
    type Output = T::Output;

    #[inline(always)]
    fn call(self) -> T::Output {
        self.0.compute::<true>()
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use std::vec::Vec;

    use pulp::Arch;
    use pulp::x86::{V3, V4};

    use super::{Task, compute_on};
    use crate::scalar::{Lanes, Number};

    /// A recursion over all elementary functions.
    struct Recursion;

    impl Task for Recursion {
        type Output = Vec<u64>;

        #[inline(always)]
        fn compute<const FUSED: bool>(self) -> Vec<u64> {
            let mut x = Lanes::<f64, 8, FUSED>([0.1, -0.2, 0.3, 0.4, 0.5, 3.0, 7.0, 1e6]);
            for _ in 0..20 {
                let (sine, cosine) = x.sin_cos();
                let circular = sine.multiply_add(cosine, x.tan().tanh()) + sine.asin() * cosine.acos();
                let others = x.atan2(cosine).exp() + x.hypot(sine).ln() + x.atan().sinh() * sine.cosh();
                x = circular.multiply_add(others, x.abs().sqrt() * Lanes([0.3; 8]));
            }
            x.0.map(f64::to_bits).to_vec()
        }
    }

    /// If only the baseline of the target is detected, results differ from fused products alone.
    #[test]
    fn bits_depend_on_fused_products_alone() {
        let apart = compute_on(Arch::Scalar, Recursion);
        assert_eq!(apart, Recursion.compute::<false>());
        let fused = Recursion.compute::<true>();
        assert_ne!(fused, apart);
        assert!(fused.iter().all(|bits| f64::from_bits(*bits).is_finite()));
        if let Some(processor) = V3::try_new() {
            assert_eq!(compute_on(Arch::V3(processor), Recursion), fused);
        }
        if let Some(processor) = V4::try_new() {
            assert_eq!(compute_on(Arch::V4(processor), Recursion), fused);
        }
    }
}
