//! Programs and expressions as text in other languages. No algebra happens here.

mod attributes;
mod bindings;
mod constrained;
mod contacts;
mod diagnostics;
mod docs;
mod events;
mod indefinite;
mod item;
mod jacobian;
mod layout;
mod messages;
mod method;
mod naming;
mod numerals;
mod ports;
mod product;
mod reduced;
mod redundant;
mod scene;
mod shape;
mod size;
mod skeleton;
mod sparse;
mod state;
mod switches;
mod system;
mod traits;

pub mod graphviz;
pub mod latex;
pub mod rust_body;
pub mod text;

pub use attributes::of_struct;
pub use diagnostics::{diagnostics, report_refusal};
pub use docs::{documentation, equations_latex};
pub use reduced::{conversions, reduced_declarations};
pub use size::{Size, report_cost, report_hopeless_model};
pub use skeleton::skeleton;
pub use switches::{on_sides, report_unlocated};
pub use system::{Emitted, Refusal, system};

#[cfg(test)]
mod tests;
