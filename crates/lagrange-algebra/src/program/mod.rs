//! Straight-line programs: operations and their order, without any notation.
//!
//! [`lower()`] turns expressions of the graph into a [`Program`], in which every value is one
//! machine-sized operation on earlier ones. [`optimise`] runs the passes, each of which returns an
//! equivalent program. [`run`] interprets programs, [`OperationCounts`] measures them, and
//! [`verify()`] checks the conditions that every program must satisfy.
//!
//! The [`Builder`] handles equal operations, constants and unused values, so passes need not. No
//! algebra is performed here: a program has the shape of its expressions.

mod builder;
mod count;
mod interpret;
mod ir;
mod labels;
mod listing;
mod lower;
mod newton;
mod passes;
mod preparation;
mod variability;
mod verify;

pub use builder::{Builder, remainder};
pub use count::OperationCounts;
#[cfg(test)]
pub(crate) use interpret::integer_power;
pub(crate) use interpret::{SolutionKey, solution_key};
pub use interpret::{run, run_with};
pub use ir::{Float, Op, Program, ValueId, ValueTable};
pub use labels::Labels;
pub use listing::{Listing, listing};
pub use lower::{is_written_out, lower};
pub use newton::NewtonProgram;
pub use passes::{
    Pass, batch_sines_and_cosines, fuse_multiply_adds, optimise, pair_sines_and_cosines, passes, schedule,
};
pub use preparation::Preparation;
pub use variability::Variability;
pub use verify::{Fault, verify};

#[cfg(test)]
pub(crate) mod tests;
