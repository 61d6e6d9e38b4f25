//! Declarations for `lagrange` from robot descriptions.
//!
//! [`urdf`] reads URDF files. The result is text for `lagrange::system!`, written to be read,
//! edited and kept; compiling it does not require this crate. The command `lagrange urdf
//! robot.urdf` does the same.
#![forbid(unsafe_code)]

mod decimal;
mod declaration;
mod mistakes;
mod mobility;
mod names;
mod robot;
mod rotation;
pub mod urdf;

pub use mistakes::{Mistake, listing};
