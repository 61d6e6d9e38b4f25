//! The items of a system as Rust. No algebra happens here.
//!
//! [`system`] lets every feature write its methods and assembles them into items; [`skeleton()`]
//! writes the same items without equations. Features share a common base: the shape of the emitted
//! type, its members and the writer of methods.

mod assemble;
mod base;
mod diagnostics;
mod features;
mod item;
mod skeleton;
mod traits;
mod variables;

pub use assemble::{kernel, system};
pub use base::attributes::attributes_of_struct;
pub use base::docs::{documentation, equations_latex};
pub use base::fingerprint::fingerprint;
pub use base::sides::{NamedRoots, on_sides};
pub use base::size::{MAX_CONTACT_EVENTS, report_hopeless_model, report_too_many};
pub use base::statements::statements;
pub use diagnostics::diagnostics;
pub use features::events::separate_events;
pub use features::jacobian::{by_fields, by_state};
pub use features::linearised::{by_state_and_inputs, system_matrix};
pub use features::reaction_terms::ReactionTerms;
pub use features::reduced::{conversions, reduced_declarations};
pub use features::series::series_programs;
pub use skeleton::skeleton;
pub use variables::{EventOfSystem, ModeOfReaction, ReactionOfSystem, Variables, variables};
