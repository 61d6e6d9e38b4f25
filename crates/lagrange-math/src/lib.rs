//! Elementary functions of several numbers at a time. They serve the accuracy level `fast` (sine
//! and cosine), numbers in lanes of vector instructions, and numbers with the same bits everywhere.
//!
//! [`sin_cos_each`], [`values`] and the others use no table and no branch that depends on a number.
//! The compiler inlines them and computes several numbers per instruction if the target supports
//! it. They do not call the platform: without fused products, results have the same bits
//! everywhere.
//!
//! The methods are the classical ones:
//! - Sine and cosine are reduced to [−π/4, π/4] with π/2 in three parts, as in W. J. Cody, W.
//!   Waite, *Software Manual for the Elementary Functions*, 1980, chapter 8. One minimax polynomial
//!   each gives sine and cosine, which the quadrant exchanges and changes in sign: J.-M. Muller, *Elementary
//!   Functions*, 3rd ed., 2016, chapters 3 and 11.
//! - The others are reduced by multiples of ln 2 and π/4 in two parts (Cody and Waite, chapters 5,
//!   6, 11 and 12). One or two minimax polynomials follow. Important terms are sums of two doubles,
//!   as in P. T. P. Tang, "Table-driven implementation of the exponential function in IEEE
//!   floating-point arithmetic", ACM TOMS 15, 1989, and Muller, chapters 2 and 11.
//!
//! `tools/sin_cos.py` and `tools/elementary.py` compute every constant.
#![cfg_attr(docsrs, feature(doc_cfg))]
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
