//! From the syntax tree of a declaration to a model.
//!
//! [`elaborate`] resolves names and checks meaning; its result, a [`Model`], holds energies and loads as expressions.

mod chains;
mod check;
mod constraints;
mod damping;
mod elaborator;
mod events;
mod expression;
mod inertia;
mod kinematics;
mod loads;
mod messages;
mod numbers;
mod obligations;
mod operand;
mod reactions;
mod reduce;
mod reductions;
mod scene;
mod scope;
mod signs;
mod smoothness;
mod stabilisation;
mod torques;
mod unresolved;

use crate::bodies::{Claim, Plain};
use crate::diagnostics::Report;
use crate::model::Model;
use elaborator::Elaborator;
use obligations::check_claims;
use reduce::reduce;

pub use reductions::METHODS_OF_REDUCED;

/// Resolves and checks a declaration. All mistakes are reported; `None` if there was an error.
pub fn elaborate(plain: &Plain, report: &mut Report) -> Option<Model> {
    let mut elaborator = Elaborator::new(plain, report);
    for claim in &plain.claims {
        match claim {
            Claim::PlaneVector { value, .. } => {
                elaborator.evaluator.claimed_vectors.insert(*value, ());
            }
            Claim::PositiveMass { mass: claimed, .. } | Claim::Inertia { inertia: claimed, .. } => {
                elaborator.evaluator.claimed_masses.insert(*claimed, ());
            }
            _ => {}
        }
    }
    for (number, statement) in plain.declaration.statements.iter().enumerate() {
        elaborator.evaluator.unresolved.statement = number;
        elaborator.statement(statement);
    }
    for &mentioned in &plain.mentioned {
        elaborator.evaluator.evaluate(mentioned);
    }
    check_claims(&mut elaborator, &plain.claims);
    elaborator.scene(plain);
    elaborator.evaluator.count_unresolved();
    let (mut model, reductions) = elaborator.finish()?;
    let reduced = reductions.iter().map(|reduction| reduce(&model, reduction, report)).collect::<Vec<_>>();
    model.reduced = reduced.into_iter().collect::<Option<Vec<_>>>()?;
    Some(model)
}
