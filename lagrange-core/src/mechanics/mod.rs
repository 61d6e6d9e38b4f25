//! From the syntax tree of a declaration to its equations of motion.
//!
//! [`elaborate`] resolves names and checks meaning; its result, a [`Model`], holds energies and loads as
//! expressions. [`Equations`] derives from a model what the emitted methods return.

mod algebra;
mod chains;
mod check;
mod claims;
mod constraints;
mod contracted;
mod cost;
mod damping;
mod elaborate;
mod elimination;
mod equations;
mod events;
mod expression;
mod form;
mod gauss;
mod indefinite;
mod inertia;
mod jacobian;
mod kinematics;
mod loads;
mod messages;
mod model;
mod numbers;
mod operand;
mod pivot;
mod product;
mod queue;
mod reactions;
mod reduce;
mod reductions;
mod responses;
mod roads;
mod scene;
mod scope;
mod signs;
mod smoothness;
mod solve;
mod squares;
mod stabilisation;
mod structure;
mod sweep;
mod switches;
mod torques;
mod undetermined;
mod unresolved;

pub use algebra::Sums;
pub use constraints::ConstraintEquations;
pub use elaborate::elaborate;
pub use equations::Equations;
pub use model::{
    Action, Assignment, Constraint, Coordinate, Energies, Event, Held, Load, Model, Output, Parameter,
    Reaction, ReactionKind, Reduced, Reduction,
};
pub use product::Product;
pub use reductions::METHODS_OF_REDUCED;
pub use responses::{Affine, ReactionEquations};
pub use roads::{Road, RoadChoice, SingularMassMatrix};
pub use scene::{BodyMotion, DrawnItem, OutlinedPart, Scene};
pub use structure::{Conserved, MassStructure, Structure};
pub use switches::{Switch, one_sided};
pub use undetermined::undetermined;
