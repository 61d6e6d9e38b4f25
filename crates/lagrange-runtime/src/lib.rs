//! The run-time support of systems derived at compile time: traits, integrators, contacts, runs,
//! and the simulation builder.
//!
//! Users depend on `lagrange`, which shows all of this under its own paths. Below it stand plots,
//! which know numbers and names only; pictures and films of systems stand above.
//!
//! | layer | what it holds |
//! |---|---|
//! | [`scalar`], `linalg`, `differences` | numbers; vectors and small solvers; numerical derivatives |
//! | [`system`] | traits of systems, and what passes between a system and a run |
//! | [`body`], [`inertia`], [`scene`] | rigid bodies and what there is to draw of them |
//! | [`table`], [`root`] | splines of tables in declarations; solutions of equations in them |
//! | [`manifold`] | contact points of cuboids and capsules |
//! | [`constraint`] | residuals, projection, dependent constraints |
//! | [`integrate`] | methods |
//! | [`contact`], [`event`] | contacts and friction; zeros within steps |
//! | [`run`] | the one loop |
//! | [`kinematics`] | postures in which frames stand at given places |
//! | `laws` (`std`) | laws that motions must obey, checked |
//! | `simulate` (`std`) | the front door |
//! | `linear` (feature) | equilibria, linear models, modes |
//! | `orbits` (feature `linear`) | periodic orbits, Lyapunov exponents |
//! | `fit` (feature) | parameters from data |
//! | `identification` (feature `fit`) | inertial parameters from forces |
//! | `ensemble` (feature) | many motions |
//! | `trade` (feature) | the cost of accuracy, by method |
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]
#![deny(unsafe_code)]

#[cfg(any(feature = "std", test))]
extern crate std;

pub mod body;
pub mod constraint;
pub mod contact;
mod differences;
#[cfg(feature = "ensemble")]
pub mod ensemble;
pub mod event;
#[cfg(feature = "fit")]
pub mod fit;
#[cfg(feature = "fit")]
pub mod identification;
pub mod inertia;
pub mod integrate;
pub mod kinematics;
#[cfg(feature = "std")]
pub mod laws;
mod linalg;
#[cfg(feature = "linear")]
pub mod linear;
pub mod manifold;
#[cfg(feature = "linear")]
pub mod orbits;
mod random;
pub mod root;
pub mod run;
pub mod scalar;
pub mod scene;
#[cfg(feature = "std")]
pub mod simulate;
mod spread;
pub mod system;
pub mod table;
mod tolerance;
#[cfg(feature = "trade")]
pub mod trade;

pub use crate::scalar::{Number, Portable, Scalar};
