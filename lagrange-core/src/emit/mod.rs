//! The items of a system as Rust. No algebra happens here.

mod base;
mod diagnostics;
mod features;
mod item;
mod skeleton;
mod system;
mod traits;

pub use base::attributes::of_struct;
pub use base::docs::{documentation, equations_latex};
pub use base::size::{Size, report_cost, report_hopeless_model};
pub use diagnostics::{diagnostics, report_refusal};
pub use features::reduced::{conversions, reduced_declarations};
pub use features::switches::{on_sides, report_unlocated};
pub use skeleton::skeleton;
pub use system::{Emitted, Refusal, system};
