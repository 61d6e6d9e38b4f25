//! Equations of motion from energies, derived and specialised at compile time.
//!
//! Write down generalised coordinates and energies; [`system!`] differentiates them symbolically while
//! your crate compiles and emits allocation-free Rust for the Euler–Lagrange equations
//!
//! ```text
//! d/dt ∂L/∂v − ∂L/∂q = Q,    L(q, v, t) = T − V.
//! ```
//!
//! ```
//! use lagrange::integrate::{RungeKutta4, integrate};
//!
//! lagrange::system! {
//!     /// A point mass on a massless rod; θ is measured from the rest position.
//!     #[derive(Clone, Debug)]
//!     pub struct Pendulum;
//!
//!     param m = 1.0, l = 1.0, g = 9.81;
//!     coord theta;
//!     kinetic = 1/2 * m * (l * dot(theta))^2;
//!     potential = -m * g * l * cos(theta);
//! }
//!
//! let pendulum = Pendulum::default();
//! let start = [0.5, 0.0];
//! let end = integrate(&pendulum, 0.0, start, 10.0, &RungeKutta4 { step: 1e-3 }, |_, _| {}).unwrap();
//! let energy = |y: [f64; 2]| pendulum.energy(0.0, &[y[0]], &[y[1]]);
//! assert!((energy(end) - energy(start)).abs() < 1e-9);
//! # Ok::<(), lagrange::integrate::IntegrationError<f64, [f64; 2]>>(())
//! ```
//!
//! | where | what |
//! |---|---|
//! | [`system!`] | the language of declarations and what is emitted for one |
//! | [`mod@system`] | traits that the emitted types implement, for code that takes any system |
//! | [`mod@integrate`] | methods that advance a system in time |
//! | [`Scalar`] | numbers that emitted code can compute with |
//!
//! # Features
//!
//! `std` (default) takes elementary functions from the platform. Without it they come from `libm`, and
//! the crate is `no_std`; it never allocates. `symbolic` re-exports the computer algebra as
//! `lagrange::symbolic`, for tools that derive at run time.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(any(feature = "differential-equations", feature = "diffsol"))]
pub mod adapt;
pub mod event;
pub mod integrate;
#[cfg(feature = "plot")]
mod plot;
pub mod scalar;
#[cfg(feature = "std")]
pub mod simulate;
pub mod system;
#[cfg(feature = "trade")]
pub mod trade;

#[doc(hidden)]
pub mod private;

pub use crate::scalar::Scalar;
#[cfg(feature = "std")]
pub use crate::simulate::Simulate;

/// Keeps the example of the README true.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(feature = "symbolic")]
pub use lagrange_core as symbolic;

#[doc = include_str!("language.md")]
#[macro_export]
macro_rules! system {
    // Emitted paths start at the first group: `$crate` holds however a user renames the dependency.
    ($($declaration:tt)*) => { $crate::private::system! { ($crate) $($declaration)* } };
}
