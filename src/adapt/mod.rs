//! Systems handed to the integrators of other crates.
//!
//! For what this crate does not have itself: multistep and diagonally implicit methods for stiff systems, and the
//! events and outputs of those crates. Each module is behind the feature of its name; nothing is integrated here. Nothing is projected
//! either: constraints and the length of unit quaternions are kept as accurately as those crates integrate.

#[cfg(feature = "differential-equations")]
pub mod differential_equations;
#[cfg(feature = "diffsol")]
pub mod diffsol;

mod jacobian;
