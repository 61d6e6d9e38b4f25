//! Systems as units of the Functional Mock-up Interface 2.0 or 3.0, for model exchange and
//! co-simulation.
//!
//! A unit is an archive with an XML description, sources, and a library for one platform. The
//! sources are the module written by `lagrange-c`, and C code for the functions of the standard:
//! instances, and a thin layer for each version. Other platforms can compile them. The same
//! declaration and the same compiler give the same bytes.
//!
//! The standards: *Functional Mock-up Interface for Model Exchange and Co-Simulation*, version
//! 2.0.4, Modelica Association 2022; *Functional Mock-up Interface Specification*, version 3.0.2,
//! Modelica Association 2024.
//!
//! ```
//! use lagrange_core::derive::StrategyChoice;
//! use lagrange_core::pipeline::{Programs, parse};
//! use lagrange_fmi::{MockupUnit, Start, Version};
//!
//! let swing = "struct Swing; param l: m = 2, g: m/s^2 = 9.81; coord theta: rad = 0.5;
//!     kinetic = 1/2 * (1 [kg]) * (l * dot(theta))^2; potential = -(1 [kg]) * g * l * cos(theta);";
//! let programs = Programs::new(&parse(swing)?.derive(StrategyChoice::Cheapest)?);
//! let start = Start { fields: vec![2.0, 9.81], state: vec![0.5, 0.0], are_given: vec![false; 2] };
//! let unit = MockupUnit::new(&programs, &start, Version::Three)?;
//! assert!(unit.description.contains("modelName=\"Swing\""));
//! let sources = unit.archive(None)?;
//! assert!(sources.starts_with(b"PK"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod archive;
mod binding;
mod compile;
mod dependencies;
mod description;
mod error;
mod quantities;
mod unit;
mod variables;
mod version;

pub use compile::Binary;
pub use error::ExportError;
pub use unit::MockupUnit;
pub use variables::Start;
pub use version::Version;
