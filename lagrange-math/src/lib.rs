//! Sine and cosine of several angles at a time: the elementary functions of the level of accuracy `fast`.
//!
//! [`sin_cos_each`] has no branch that depends on an angle and no table, so that the compiler inlines it and
//! computes several angles with each instruction where the target can. It is *not* a library of elementary
//! functions: what one of the platform does as well is left to the platform.
//!
//! The method is the classical one: reduction to [−π/4, π/4] with π/2 in three parts (W. J. Cody, W. Waite,
//! *Software Manual for the Elementary Functions*, 1980, chapter 8), then one minimax polynomial each for sine
//! and cosine, and exchange and change of sign by the quadrant (J.-M. Muller, *Elementary Functions*, 3rd ed.,
//! 2016, chapters 3 and 11). `tools/sin_cos.py` computes every constant.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(feature = "std", test))]
extern crate std;

mod angle;
mod batch;
mod fused;
mod reduction;

pub use batch::{LARGEST_ANGLE, sin_cos_each, sin_cos_each_f32, sines_and_cosines, sines_and_cosines_f32};
