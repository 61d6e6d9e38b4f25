//! The items of a system as Rust. No algebra happens here.

mod assemble;
mod base;
mod diagnostics;
mod features;
mod item;
mod skeleton;
mod traits;

pub use assemble::{Emitted, system};
pub use base::attributes::of_struct;
pub use base::docs::{documentation, equations_latex};
pub use base::refusal::{Refusal, report_refusal};
pub use base::sides::on_sides;
pub use base::size::{Size, report_cost, report_hopeless_model};
pub use diagnostics::diagnostics;
pub use features::reduced::{conversions, reduced_declarations};
pub use features::switches::report_unlocated;
pub use skeleton::skeleton;
