//! Numbers that the optimiser computes in the written order.
//!
//! LLVM combines equal operations of neighbouring bodies into vectors. To do so it moves the
//! elimination of bodies behind the calls of sine and cosine, so the two no longer overlap. A chain
//! of 20 pendulums then takes up to 1.3 times as long. An empty instruction whose operand is the
//! angle of a sine or a pivot keeps both in place, and costs nothing. [`core::hint::black_box`]
//! would send the number through memory, which takes longer than is gained.

#![cfg_attr(
    all(target_arch = "x86_64", target_feature = "sse2", not(miri)),
    expect(unsafe_code, reason = "an empty instruction has no safe form that stays in a register")
)]

/// Defines a function that returns its argument, in an order fixed among all such calls.
macro_rules! in_order {
    ($name:ident, $number:ty) => {
        /// Returns the same number. Calls remain in the written order.
        #[inline(always)]
        pub(super) fn $name(number: $number) -> $number {
            #[cfg(all(target_arch = "x86_64", target_feature = "sse2", not(miri)))]
            {
                let mut number = number;
                // SAFETY: the instruction is a comment. It changes no register, flag or memory.
                unsafe {
                    core::arch::asm!(
                        "/* {0} */",
                        inout(xmm_reg) number,
                        options(nomem, nostack, preserves_flags)
                    );
                }
                number
            }
            #[cfg(not(all(target_arch = "x86_64", target_feature = "sse2", not(miri))))]
            number
        }
    };
}

in_order!(f64_in_order, f64);
in_order!(f32_in_order, f32);
