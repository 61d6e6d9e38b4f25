//! From the syntax tree of a declaration to a model.
//!
//! [`elaborate`] resolves names and checks meaning; its result, a [`Model`], holds energies and loads as expressions.

mod calls;
mod chains;
mod check;
mod constants;
mod constraints;
mod damping;
mod definitions;
mod elaborator;
mod evaluator;
mod events;
mod expression;
mod function_names;
mod gibbs;
mod inertia;
mod loads;
mod magnitudes;
mod messages;
mod numbers;
mod obligations;
mod operand;
mod reactions;
mod reduce;
mod reductions;
mod scalar_range;
mod scene;
mod scope;
mod signs;
mod smoothness;
mod stabilisation;
mod staged;
mod torques;
mod unknown_names;
mod unresolved;

use crate::bodies::{Obligation, Plain};
use crate::diagnostics::Report;
use crate::model::Model;
use crate::syntax::ast::{Statement, StatementKind};
use check::finish;
use constraints::add_constraint;
use definitions::{
    add_output, add_product, define_abbreviation, define_abbreviations, define_constant, define_coordinate,
    define_parameter,
};
use elaborator::Elaborator;
use events::add_event;
use expression::value_of;
use gibbs::add_gibbs;
use loads::{add_force_at, add_force_on, add_torque};
use obligations::check_obligations;
use reactions::add_friction;
use reduce::reduce;
use reductions::add_reduction;
use scene::add_scene;
use scope::NameKind;
use stabilisation::set_stabilisation;
use unknown_names::count_unresolved;

pub use reductions::METHODS_OF_REDUCED;

/// Resolves and checks a declaration. All mistakes are reported; `None` if there was an error.
pub fn elaborate(plain: &Plain, report: &mut Report) -> Option<Model> {
    let mut elaborator = Elaborator::new(plain, report);
    for obligation in &plain.obligations {
        match obligation {
            Obligation::PlaneVector { value, .. } => {
                elaborator.evaluator.obliged_vectors.insert(*value, ());
            }
            Obligation::PositiveMass { mass: obliged, .. } | Obligation::Inertia { inertia: obliged, .. } => {
                elaborator.evaluator.obliged_masses.insert(*obliged, ());
            }
            _ => {}
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
    let (mut model, reductions) = finish(elaborator)?;
    let reduced = reductions.iter().map(|reduction| reduce(&model, reduction, report)).collect::<Vec<_>>();
    model.reduced = reduced.into_iter().collect::<Option<Vec<_>>>()?;
    Some(model)
}

fn add_statement(elaborator: &mut Elaborator<'_>, statement: &Statement) {
    let keyword = statement.origin.start;
    match &statement.kind {
        StatementKind::Parameters(list) => {
            list.iter().for_each(|d| define_parameter(elaborator, d, NameKind::Parameter));
        }
        StatementKind::Inputs(list) => {
            list.iter().for_each(|d| define_parameter(elaborator, d, NameKind::Input));
        }
        StatementKind::Constants(list) => list.iter().for_each(|d| define_constant(elaborator, d)),
        StatementKind::Coordinates(names) => {
            names.iter().for_each(|name| define_coordinate(elaborator, name));
        }
        StatementKind::Let(name, value) => define_abbreviation(elaborator, name, *value),
        StatementKind::LetTuple(names, value) => define_abbreviations(elaborator, names, *value),
        StatementKind::Kinetic(value) => {
            let term = elaborator.term(*value, keyword, "the kinetic energy");
            elaborator.kinetic.extend(term);
        }
        StatementKind::Potential(value) => {
            let term = elaborator.term(*value, keyword, "the potential energy");
            elaborator.potential.extend(term);
        }
        StatementKind::Lagrangian(value) => {
            let term = elaborator.term(*value, keyword, "the Lagrangian");
            elaborator.lagrangian.extend(term);
        }
        StatementKind::Gibbs { function, stated } => add_gibbs(elaborator, *function, *stated, keyword),
        StatementKind::Dissipation(value) => {
            let term = elaborator.term(*value, keyword, "the dissipation function");
            elaborator.dissipation.extend(term);
        }
        StatementKind::ForceOn(coordinate, value) => add_force_on(elaborator, coordinate, *value),
        StatementKind::ForceAt { force, point } => add_force_at(elaborator, *force, *point),
        StatementKind::Torque { moment, angle } => add_torque(elaborator, *moment, *angle, keyword),
        StatementKind::Constraint(name, value) => add_constraint(elaborator, name, *value),
        StatementKind::Stabilise(rate) => set_stabilisation(elaborator, *rate, keyword),
        StatementKind::Event(event) => add_event(elaborator, event),
        StatementKind::Friction(friction) => add_friction(elaborator, friction),
        StatementKind::Output(name, value) => add_output(elaborator, name, *value),
        StatementKind::Emit(items) => items.iter().for_each(|item| add_product(elaborator, item)),
        StatementKind::Reduce(reduction) => add_reduction(elaborator, reduction),
        // Plain statements have taken its place.
        StatementKind::Scene(_) => {}
    }
}
