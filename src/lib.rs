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
//! | module or item | contents |
//! |---|---|
//! | [`system!`], [`mod@language`] | declarations, and their language with the code emitted for it |
//! | [`mod@system`] | traits that the emitted types implement, for code that is generic over systems |
//! | [`mod@simulate`] | the main entry point: simulations with samples, events, trajectories, files and plots |
//! | `ensemble` (feature) | many motions on threads and processes, reduced or saved |
//! | [`mod@laws`] | checks of the laws of mechanics |
//! | `linear` (feature) | equilibria, linear models, modes, responses |
//! | `orbits` (feature `linear`) | periodic orbits, their stability, Lyapunov exponents |
//! | `fit` (feature) | parameter estimation from data |
//! | `identification` (feature `fit`) | inertial parameters from measured forces |
//! | [`mod@integrate`] | integration methods, without heap allocation |
//! | [`mod@event`] | zeros of functions of time and state |
//! | [`mod@body`], [`mod@inertia`] | motion of rigid bodies; moments of inertia |
//! | [`mod@manifold`] | contact points of cuboids and capsules |
//! | [`mod@table`], [`mod@root`] | evaluation of tables and algebraic unknowns |
//! | [`mod@scene`], `draw` (feature) | descriptions of scenes; pictures and films of systems |
//! | `plot` (feature) | figures of curves over numbers |
//! | [`mod@constraint`] | residuals of constraints, and projection onto them |
//! | [`mod@kinematics`] | inverse kinematics: joint positions and rates for given poses and velocities of frames |
//! | [`mod@contact`] | contacts that open and close, impacts, dry friction |
//! | `trade` (feature) | comparison of methods by error and time |
//! | [`Scalar`] | number types for emitted code |
//! | [`Portable`] | numbers with bit-identical results on every platform |
//! | `Double` (feature `double`) | numbers of 106 bits |
//!
//! The folder `docs` of the repository is a book. It covers everything from a first film to
//! control, robots and ensembles, and its gallery shows the pictures of the examples.
//!
//! # Features
//!
//! `std` (default) takes elementary functions from the platform. Without it they come from `libm`,
//! and the crate is `no_std`, has no simulations and never allocates. `parquet` and `plot` save
//! trajectories as Parquet files and as plots in SVG and PNG. `ensemble` computes many motions on
//! threads and processes. `linear` finds equilibria, linear models and modes, and `fit` estimates
//! parameters from data. `draw` makes pictures and films of rigid bodies, in the plane and in
//! space. `trade` measures the cost of accuracy for a system. `double` adds numbers of 106 bits.
//! `symbolic` re-exports the computer algebra as `lagrange::symbolic`, for tools that derive
//! equations at run time.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(feature = "std", test))]
extern crate std;

pub mod event;
pub mod integrate;

/// The language of [`system!`]: all statements, and what is emitted for them.
///
#[doc = include_str!("language.md")]
pub mod language {}
#[doc(hidden)]
pub mod private;

#[cfg(feature = "double")]
#[doc(inline)]
pub use lagrange_double::{self as double, Double};
#[cfg(feature = "draw")]
#[doc(inline)]
pub use lagrange_draw as draw;
#[cfg(feature = "plot")]
#[doc(inline)]
pub use lagrange_plot as plot;
#[cfg(feature = "ensemble")]
#[doc(inline)]
pub use lagrange_runtime::ensemble::{self, Ensembles};
#[cfg(feature = "std")]
#[doc(inline)]
pub use lagrange_runtime::laws;
#[cfg(feature = "std")]
#[doc(inline)]
pub use lagrange_runtime::simulate::{self, Simulate};
#[cfg(feature = "trade")]
#[doc(inline)]
pub use lagrange_runtime::trade;
#[doc(inline)]
pub use lagrange_runtime::{
    Number, Portable, Scalar, body, constraint, contact, inertia, kinematics, manifold, root, scalar, scene,
    system, table,
};
#[cfg(feature = "fit")]
#[doc(inline)]
pub use lagrange_runtime::{fit, identification};
#[cfg(feature = "linear")]
#[doc(inline)]
pub use lagrange_runtime::{linear, orbits};

/// Compiles and runs the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(feature = "symbolic")]
pub use lagrange_core as symbolic;

#[doc = include_str!("overview.md")]
#[macro_export]
macro_rules! system {
    // Emitted paths start with the first group: `$crate` is correct even if a user renames the
    // dependency.
    ($($declaration:tt)*) => { $crate::private::system! { ($crate) $($declaration)* } };
}
