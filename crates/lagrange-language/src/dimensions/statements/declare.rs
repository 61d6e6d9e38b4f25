//! Names whose dimensions are declared, or determined by their use.

use super::definitions::{declared, define_table, define_value};
use super::form;
use crate::dimensions::checker::Checker;
use crate::dimensions::exponents::Exponents;
use crate::dimensions::kinds::FREQUENCY;
use crate::dimensions::measure::Measure;
use crate::syntax::ast::{Definition, Name, Statement, StatementKind};

/// Declares names whose dimensions are declared, or determined by their use.
pub(super) fn declare(checker: &mut Checker<'_>, statement: &Statement) {
    match &statement.kind {
        StatementKind::Parameters(list) | StatementKind::Inputs(list) => {
            list.iter().for_each(|definition| define_value(checker, definition));
        }
        StatementKind::Constants(list) => {
            list.iter().for_each(|definition| define_value(checker, definition));
            let values = list.iter().filter_map(|definition| Some((&definition.name, definition.value?)));
            values.for_each(|(name, value)| checker.define_constant(&name.text, value));
        }
        StatementKind::Coordinates(list) | StatementKind::States(_, list) | StatementKind::Noises(list) => {
            for Definition { name, .. } in list {
                let form = declared(checker, name);
                checker.scope.insert(name.text.clone(), Measure::known(form));
            }
        }
        StatementKind::Mode(mode) => {
            for Name { text, .. } in [&mode.name].into_iter().chain(&mode.values) {
                checker.scope.insert(text.clone(), Measure::known(form([0; 7])));
            }
        }
        StatementKind::Quaternion(quaternion) => {
            for name in &quaternion.positions {
                checker.scope.insert(name.text.clone(), Measure::known(Exponents::plain()));
            }
            for name in &quaternion.velocities {
                checker.scope.insert(name.text.clone(), Measure::known(form(FREQUENCY)).with_rates(true));
            }
        }
        StatementKind::External(function) => {
            let columns = function.parameters.iter().chain([&function.name]);
            let columns = columns.map(|name| declared(checker, name)).collect();
            checker.callables.insert(function.name.text.clone(), columns);
        }
        StatementKind::Table(table) => define_table(checker, table),
        // These only concern other passes, or none: loops, bodies and functions with a formula no
        // longer exist.
        StatementKind::Start(_)
        | StatementKind::History(_)
        | StatementKind::Ranges(_)
        | StatementKind::StateRate(..)
        | StatementKind::RateEquation(_)
        | StatementKind::Velocity(..)
        | StatementKind::Let(..)
        | StatementKind::LetTuple(..)
        | StatementKind::Delay { .. }
        | StatementKind::Function(_)
        | StatementKind::Solve(_)
        | StatementKind::Kinetic(_)
        | StatementKind::Potential(_)
        | StatementKind::Lagrangian(_)
        | StatementKind::Gibbs { .. }
        | StatementKind::Dissipation(_)
        | StatementKind::ForceOn(..)
        | StatementKind::ForceAt { .. }
        | StatementKind::ForceAlong { .. }
        | StatementKind::Torque { .. }
        | StatementKind::Constraint(..)
        | StatementKind::Stabilise(_)
        | StatementKind::Event(_)
        | StatementKind::Every(_)
        | StatementKind::Friction(_)
        | StatementKind::Output(..)
        | StatementKind::Emit(_)
        | StatementKind::Reduce(_)
        | StatementKind::Block(_)
        | StatementKind::Scene(_) => {}
    }
}
