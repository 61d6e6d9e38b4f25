//! From a model to its equations of motion.
//!
//! The Lagrangian becomes a quadratic form in velocities (`least_constraint`, `quadratic_form`), of which a strategy eliminates one
//! velocity after the other (`strategies`; `elimination` and `sum_of_squares`, in the order of `sweep`). Constraints, contacts and
//! friction are further unknowns and right-hand sides of the same elimination (`constraints`, `responses`, `jacobian`).
//!
//! [`Equations`] are what the emitted methods return; [`derive()`] finds them, or says which motion nothing determines.

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

use proc_macro2::Span;

use crate::diagnostics::Report;
use crate::model::Model;
use crate::syntax::ast::{Declaration, StatementKind};
use undetermined::undetermined;

pub use algebra::Sums;
pub use constraints::ConstraintEquations;
pub use equations::Equations;
pub use responses::{Affine, ReactionEquations};
pub use strategies::{SingularMassMatrix, Strategy, StrategyChoice};
pub use structure::{Conserved, MassStructure, Structure};
pub use switches::{Switch, one_sided};

/// The equations of a model. That there are none is reported at `place`, or at a coordinate that nothing determines.
pub fn derive(
    declaration: &Declaration,
    place: Option<Span>,
    model: &mut Model,
    choice: StrategyChoice,
    report: &mut Report,
) -> Option<Equations> {
    let singular = match Equations::derive(model, choice) {
        Ok(equations) => return Some(equations),
        Err(error) => error,
    };
    let coordinates = declaration.coordinates();
    let moving = undetermined(model).into_iter().filter_map(|index| coordinates.get(index).copied());
    let moving = moving.collect::<Vec<_>>();
    let is_energy =
        |kind: &StatementKind| matches!(kind, StatementKind::Kinetic(_) | StatementKind::Lagrangian(_));
    let energy = declaration.statements.iter().find(|statement| is_energy(&statement.kind));
    let place = place.or(moving.first().map(|name| name.span)).or(energy.map(|energy| energy.origin.start));
    let place = place.unwrap_or(declaration.name.span);
    let names = moving.iter().map(|name| name.text.as_str()).collect::<Vec<_>>();
    report.error(place, singular.message(&names)).help(singular.help());
    None
}
