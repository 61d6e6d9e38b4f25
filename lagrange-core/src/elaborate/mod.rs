//! From the syntax tree of a declaration to a model.
//!
//! [`elaborate`] resolves names and checks meaning; its result, a [`Model`], contains energies and
//! loads as expressions.

mod assigned;
mod callable;
mod calls;
mod carried;
mod chains;
mod check;
mod constants;
mod constraints;
mod coordinates;
mod damping;
mod definitions;
mod delays;
mod elaborator;
mod entries;
mod evaluator;
mod events;
mod expression;
mod function_names;
mod gibbs;
mod history;
mod ignored;
mod inertia;
mod limits;
mod loads;
mod magnitudes;
mod matter;
mod messages;
mod noise;
mod numbers;
mod obligations;
mod opaque;
mod operand;
mod partials;
mod pinned;
mod products;
mod ranges;
mod rate_equations;
mod reactions;
mod reduce;
mod reductions;
mod renumbering;
mod routh;
mod scalar_range;
mod scene;
mod scene_in_space;
mod scope;
mod shared_contacts;
mod signs;
mod smoothness;
mod solve;
mod stabilisation;
mod staged;
mod start;
mod statements;
mod states;
mod symmetric;
mod tables;
mod torques;
mod unknown_names;
mod unresolved;

use crate::model::Model;
use check::finish;
use elaborator::Elaborator;
use expression::value_of;
use lagrange_expr::diagnostics::Report;
use lagrange_language::bodies::{Obligation, Plain};
use lagrange_language::syntax::ast::StatementKind;
use obligations::check_obligations;
use opaque::define_external;
use reduce::reduce;
use scene::add_scene;
use statements::add_statement;
use unknown_names::count_unresolved;

pub use obligations::is_physical;
pub use reductions::is_method_of_reduced;

/// Resolves and checks a declaration. All errors are reported; `None` after an error.
pub fn elaborate(plain: &Plain, report: &mut Report) -> Option<Model> {
    let mut elaborator = Elaborator::new(plain, report);
    for obligation in &plain.obligations {
        match obligation {
            Obligation::PlaneVector { value, .. } => {
                elaborator.evaluator.obliged_vectors.insert(*value);
            }
            Obligation::PositiveMass { mass: obliged, .. } | Obligation::Inertia { inertia: obliged, .. } => {
                elaborator.evaluator.obliged_masses.insert(*obliged);
            }
            _ => {}
        }
    }
    for statement in &plain.declaration.statements {
        if let StatementKind::External(function) = &statement.kind {
            define_external(&mut elaborator.evaluator, function);
        }
    }
    for (number, statement) in plain.declaration.statements.iter().enumerate() {
        elaborator.evaluator.unresolved.statement = number;
        add_statement(&mut elaborator, statement);
    }
    for &mentioned in &plain.mentioned {
        value_of(&mut elaborator.evaluator, mentioned);
    }
    check_obligations(&mut elaborator, &plain.obligations);
    add_scene(&mut elaborator, plain);
    count_unresolved(&mut elaborator.evaluator);
    let (mut model, reductions, terms) = finish(elaborator)?;
    let reduced = reductions.iter().map(|reduction| reduce(&model, reduction, &terms, report));
    let reduced = reduced.collect::<Vec<_>>();
    model.reduced = reduced.into_iter().collect::<Option<Vec<_>>>()?;
    Some(model)
}
