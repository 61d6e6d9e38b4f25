//! Systems handed to the integrators of other crates.
//!
//! These have multistep methods for stiff systems. Nothing is integrated here, and nothing is projected: constraints and the
//! length of unit quaternions are kept as accurately as those crates integrate. The project's
//! `tests/adapters/differential_equations.rs` hands systems to the crate `differential-equations`, for its methods and events.

pub mod diffsol;

mod jacobian;
