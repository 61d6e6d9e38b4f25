//! Equations of motion from energies, derived and specialised at compile time.
//!
//! Write down generalised coordinates and energies; [`system!`] differentiates them symbolically
//! while your crate compiles and emits allocation-free Rust for the Euler–Lagrange equations
//!
//! ```text
//! d/dt ∂L/∂v − ∂L/∂q = Q,    L(q, v, t) = T − V.
//! ```
//!
//! ```
//! use lagrange::Simulate;
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
//! let trajectory = Pendulum::default().simulate([0.5, 0.0]).until(10.0).tolerance(1e-12).energy().run()?;
//! assert!(trajectory.theta().iter().all(|theta| theta.abs() < 0.5 + 1e-10));
//! let energy = trajectory.column("energy").unwrap_or_default();
//! assert!(energy.iter().all(|now| (now - energy[0]).abs() < 1e-10));
//! # Ok::<(), lagrange::simulate::SimulationError<Pendulum>>(())
//! ```
//!
//! | where | what |
//! |---|---|
//! | [`system!`] | the language of declarations and what is emitted for one |
//! | [`mod@system`] | traits that the emitted types implement, for code that takes any system |
//! | [`mod@simulate`] | the front door: runs with samples, events, trajectories, files and plots |
//! | `ensemble` (feature) | many motions: over threads and processes, reduced or saved |
//! | [`mod@laws`] | laws of mechanics that a system must obey, checked |
//! | `linear` (feature) | equilibria, linear models, modes, responses |
//! | `orbits` (feature `linear`) | periodic orbits, their stability, Lyapunov exponents |
//! | `fit` (feature) | parameters from data |
//! | [`mod@integrate`] | methods that advance a system in time, without heap |
//! | [`mod@event`] | zeros of functions of time and state |
//! | [`mod@body`], [`mod@inertia`] | motion of rigid bodies; moments of inertia |
//! | [`mod@table`], [`mod@root`] | tables and algebraic unknowns of declarations, as they are evaluated |
//! | [`mod@scene`], `draw` (feature) | what there is to draw of a system; pictures and films of it |
//! | [`mod@constraint`] | residuals of constraints, and projection onto them |
//! | [`mod@kinematics`] | postures in which frames stand at given places, and velocities that move them |
//! | [`mod@contact`] | contacts that open and close, impacts, dry friction |
//! | `trade` (feature) | methods measured against each other |
//! | [`Scalar`] | numbers that emitted code can compute with |
//! | [`Portable`] | numbers with the same bits on every platform |
//! | `Double` (feature `double`) | numbers of 106 bits |
//!
//! The folder `docs` of the repository is a book. It leads from an empty crate to films, control,
//! robots and ensembles, and its gallery shows what the examples draw.
//!
//! # Features
//!
//! `std` (default) takes elementary functions from the platform. Without it they come from `libm`,
//! and the crate is `no_std`, has no simulations and never allocates. `parquet` and `plot` let
//! trajectories save to Parquet and plot to SVG and PNG. `ensemble` computes many motions over
//! threads and processes. `linear` finds equilibria, linear models and modes, and `fit`
//! parameters from data. `draw` makes pictures
//! and films of rigid bodies, in the plane and in space. `trade` measures what every digit costs on
//! a system. `double` adds numbers of 106 bits. `symbolic` re-exports the computer algebra as
//! `lagrange::symbolic`, for tools that derive at run time.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(feature = "std", test))]
extern crate std;

pub mod event;
pub mod integrate;
#[cfg(feature = "trade")]
pub mod trade;

#[doc(hidden)]
pub mod private;

#[cfg(feature = "double")]
#[doc(inline)]
pub use lagrange_double::{self as double, Double};
#[cfg(feature = "draw")]
#[doc(inline)]
pub use lagrange_draw as draw;
#[cfg(feature = "ensemble")]
#[doc(inline)]
pub use lagrange_runtime::ensemble::{self, Ensembles};
#[cfg(feature = "fit")]
#[doc(inline)]
pub use lagrange_runtime::fit;
#[cfg(feature = "std")]
#[doc(inline)]
pub use lagrange_runtime::laws;
#[cfg(feature = "std")]
#[doc(inline)]
pub use lagrange_runtime::simulate::{self, Simulate};
#[doc(inline)]
pub use lagrange_runtime::{
    Number, Portable, Scalar, body, constraint, contact, inertia, kinematics, root, scalar, scene, system,
    table,
};
#[cfg(feature = "linear")]
#[doc(inline)]
pub use lagrange_runtime::{linear, orbits};

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
