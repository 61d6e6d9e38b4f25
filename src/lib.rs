//! Equations of motion from energies, derived and specialised at compile time.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(feature = "std", test))]
extern crate std;

pub mod integrate;
pub mod scalar;
pub mod system;

pub use crate::scalar::Scalar;
