//! Motions of systems declared in text and read at run time.
//!
//! A [`DeclaredSystem`] consists of interpreted programs instead of the type emitted by the macro.
//! It is visited as a [`DynamicSystem`], which implements the traits of emitted types. Simulations,
//! methods, events, files and plots are therefore those of `lagrange-runtime`. Results are
//! bit-identical to those of the compiled type.
//!
//! ```
//! use lagrange_core::derive::StrategyChoice;
//! use lagrange_core::pipeline::{Programs, parse};
//! use lagrange_dynamic::{DeclaredSystem, DynamicSystem, Visitor};
//! use lagrange_runtime::simulate::Simulate;
//!
//! let text = "param l = 1, g = 9.81; coord theta = 0.5;
//!     kinetic = 1/2 * (l * dot(theta))^2; potential = -g * l * cos(theta);";
//! let derived = parse(text)?.derive(StrategyChoice::Cheapest)?;
//! let mut pendulum = DeclaredSystem::new(Programs::new(&derived))?;
//! pendulum.set("l", 2.0)?;
//!
//! /// The angle after a second.
//! struct Swing<'a>(&'a DeclaredSystem);
//!
//! impl Visitor for Swing<'_> {
//!     type Output = f64;
//!
//!     fn visit<const CAPACITY: usize>(self, pendulum: &DynamicSystem<CAPACITY>) -> f64 {
//!         let start = pendulum.state(&self.0.start().expect("declared"));
//!         let motion = pendulum.simulate(start).until(1.0).run().expect("a swing");
//!         motion.column("theta").expect("a coordinate").last().copied().expect("an end")
//!     }
//! }
//!
//! assert!((pendulum.visit(Swing(&pendulum)) + 0.287191278735).abs() < 1e-8);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The interpreter is several times slower than compiled code. [`DeclaredSystem::compiled_by`]
//! replaces it by a compiler, such as that of `lagrange-jit`; timings are in `docs/performance.md`.
//! Functions of the user's crate and large systems are [rejected](Refusal). Numbers are `f64`,
//! whatever scalar type is declared.
//!
//! Users of the macro do not compile this crate.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]

mod analysis;
mod constraints;
mod contacts;
mod declared;
#[cfg(feature = "ensemble")]
mod ensemble;
#[cfg(feature = "draw")]
mod film;
#[cfg(feature = "fit")]
mod fit;
#[cfg(feature = "fit")]
mod fixed;
mod inline;
#[cfg(feature = "draw")]
mod items;
mod linearised;
mod mechanics;
mod method;
mod motion;
mod names;
mod reactions;
mod refusal;
mod run;
mod rust_file;
mod series;
mod source;
mod system;
#[cfg(feature = "trade")]
mod trade;
mod watch;

pub use analysis::{AnalysisError, FoundEquilibrium, SearchSettings};
pub use contacts::DynamicTerms;
pub use declared::{DeclaredSystem, Visitor};
#[cfg(feature = "ensemble")]
pub use ensemble::{EnsembleEnds, EnsembleError, EnsembleSettings, FailedMotion};
#[cfg(feature = "draw")]
pub use film::{DeclaredFilm, title};
#[cfg(feature = "fit")]
pub use fit::{FitFailure, FitSettings, FoundFit};
pub use inline::{Inline, Rows};
#[cfg(feature = "draw")]
pub use items::{NumberedSpace, Numbers, connector, visit_items};
pub use method::{MethodChoice, MethodError};
pub use refusal::{NoSuchName, Refusal, StartError};
pub use run::RunSettings;
pub use series::DynamicSeries;
pub use source::Source;
pub use system::DynamicSystem;
#[cfg(feature = "trade")]
pub use trade::trade;
pub use watch::Watch;
