//! Declarations for `lagrange` from descriptions of robots.
//!
//! [`urdf`] reads URDF files. What comes out is text for `lagrange::system!`, written to be read,
//! edited and kept; nothing here is needed where it is compiled. `lagrange urdf robot.urdf` is the
//! same as a command.
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
