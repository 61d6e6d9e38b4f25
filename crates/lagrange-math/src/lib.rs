//! Elementary functions of several numbers at a time: sine and cosine of the level of accuracy
//! `fast`, and all functions of numbers side by side, in the lanes of vector instructions, and of
//! numbers with the same bits on every platform.
//!
//! [`sin_cos_each`], [`values`] and the others have no branch that depends on a number and no
//! table, so that the compiler inlines them and computes several numbers with each instruction
//! where the target can. They call nothing of the platform: without fused products, results have
//! the same bits everywhere.
//!
//! The methods are the classical ones. Sine and cosine: reduction to [−π/4, π/4] with π/2 in three
//! parts (W. J. Cody, W. Waite, *Software Manual for the Elementary Functions*, 1980, chapter 8),
//! then one minimax polynomial each for sine and cosine, and exchange and change of sign by the
//! quadrant (J.-M. Muller, *Elementary Functions*, 3rd ed., 2016, chapters 3 and 11). The others:
//! reduction by multiples of ln 2 and π/4 in two parts (Cody and Waite, chapters 5, 6, 11 and 12),
//! one or two minimax polynomials, and the terms that matter as sums of two doubles (P. T. P. Tang,
//! "Table-driven implementation of the exponential function in IEEE floating-point arithmetic", ACM
//! TOMS 15, 1989, has such sums; Muller, chapters 2 and 11). `tools/sin_cos.py` and
//! `tools/elementary.py` compute every constant.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(feature = "std", test))]
extern crate std;

mod angle;
mod arc;
mod batch;
mod beyond;
mod elementary;
mod exponential;
mod functions;
mod fused;
mod length;
mod logarithm;
mod pair;
mod precise;
mod quarters;
mod reduction;
mod tangent;

pub use batch::{
    LARGEST_ANGLE, precise_sines_and_cosines, sin_cos_each, sin_cos_each_f32, sines_and_cosines,
    sines_and_cosines_f32,
};
pub use elementary::{Elementary, angles, angles_f32, lengths, lengths_f32, power, values, values_f32};
pub use quarters::{nearest_quarter, quarter_turns};
