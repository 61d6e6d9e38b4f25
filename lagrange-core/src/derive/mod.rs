//! From a model to its equations of motion.
//!
//! [`Equations`] derives from a [`Model`](crate::model::Model) what the emitted methods return.

mod algebra;
mod constraints;
mod cost;
mod elimination;
mod equations;
mod indefinite;
mod inverse_dynamics;
mod jacobian;
mod least_constraint;
mod messages;
mod quadratic_form;
mod responses;
mod strategies;
mod structure;
mod sum_of_squares;
mod sweep;
mod switches;
mod undetermined;

pub use algebra::Sums;
pub use constraints::ConstraintEquations;
pub use equations::Equations;
pub use responses::{Affine, ReactionEquations};
pub use strategies::{Road, RoadChoice, SingularMassMatrix};
pub use structure::{Conserved, MassStructure, Structure};
pub use switches::{Switch, one_sided};
pub use undetermined::undetermined;
