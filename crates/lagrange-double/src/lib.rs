//! [`Double`], a real number of about 106 bits: the sum of two doubles.
//!
//! It is a [`Scalar`](lagrange_runtime::Scalar), so declarations with a type parameter, such as
//! `struct Pendulum<S>;`, can use it.
//!
//! | operation | error, in units of 2⁻¹⁰⁶ of the result | source |
//! |---|---|---|
//! | `+`, `-` | at most 3.0001 | Joldes, Muller, Popescu, algorithm 6 |
//! | `*` | at most 5 | the same, algorithm 10; bound by Muller and Rideau |
//! | `/` | at most 15.0001 | the same, algorithm 17 |
//! | `sqrt` | at most 3.125 | Lefèvre, Louvet, Muller, Picot, Rideau |
//! | other functions | at most 0.48 of 1678 values, not proven | `tools/double.py`, `tests/functions.rs` |
//!
//! Sources: M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic
//! building blocks of double-word arithmetic", *ACM TOMS* 44 (2017), 15res; J.-M. Muller, L.
//! Rideau, "Formalization of double-word arithmetic, and comments on …", *ACM TOMS* 48 (2022), 9;
//! V. Lefèvre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau, "Accurate calculation of Euclidean
//! norms using double-word arithmetic", *ACM TOMS* 49 (2023), 1.
//!
//! The bounds hold if neither the result nor an intermediate result is below 2⁻⁹⁶⁹ or close to
//! overflow. Otherwise, results keep the 53 bits of a double. Functions compute with 192 bits in
//! integers, and use no library of the platform. All results have the same bits with and without
//! fused products.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(feature = "std", test))]
extern crate std;

mod double;
mod elementary;
mod exact;
mod functions;
mod number;
mod reduction;
mod text;
mod wide;

pub use double::Double;
pub use text::ParseDoubleError;
