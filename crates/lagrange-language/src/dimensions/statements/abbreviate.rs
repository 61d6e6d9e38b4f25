//! Names that stand for expressions, and named forces.

use super::definitions::{define_unknowns, named_component, named_value};
use super::{form, form_of_force};
use crate::dimensions::checker::Checker;
use crate::dimensions::kinds::{ENERGY, POWER};
use crate::dimensions::measure::Measure;
use crate::syntax::ast::{Action, Event, Friction, Name, Statement, StatementKind};

/// Determines the dimensions of names that stand for expressions, and of named forces.
pub(super) fn abbreviate(checker: &mut Checker<'_>, statement: &Statement) {
    match &statement.kind {
        StatementKind::Let(name, value) | StatementKind::Velocity(name, value) => {
            let value = named_value(checker, name, *value);
            checker.scope.insert(name.text.clone(), value);
        }
        StatementKind::Delay { name, signal, .. } => {
            let value = named_value(checker, name, *signal);
            checker.scope.insert(name.text.clone(), value);
        }
        StatementKind::Solve(unknowns) => define_unknowns(checker, unknowns),
        kind @ StatementKind::LetTuple(names, value) => {
            let parts = kind.named_expressions(checker.expressions);
            let whole = checker.value(*value);
            for (i, name) in names.iter().enumerate() {
                let value = match parts.get(i) {
                    Some((_, part)) => named_value(checker, name, *part),
                    None => named_component(checker, name, *value, whole.entry(&[i])),
                };
                checker.scope.insert(name.text.clone(), value.with_rates(whole.has_rates));
            }
        }
        StatementKind::Constraint(name, value) => {
            let value = checker.value(*value);
            name_force(checker, name, &value);
        }
        StatementKind::Event(Event { name, value, action: Action::Impact(_), .. }) => {
            let gap = checker.value(*value);
            name_force(checker, name, &gap);
        }
        StatementKind::Friction(Friction { name, slip, .. }) => {
            let slip = checker.value(*slip).with_rates(true);
            name_force(checker, name, &slip);
            if !slip.is_scalar() {
                let force = slip.map(form_of_force);
                checker.scope.insert(name.text.clone(), Measure::vector(force.components));
            }
        }
        // These only concern other passes, or none: loops, bodies and functions with a formula no
        // longer exist.
        StatementKind::Parameters(_)
        | StatementKind::Inputs(_)
        | StatementKind::Noises(_)
        | StatementKind::Constants(_)
        | StatementKind::Coordinates(_)
        | StatementKind::States(..)
        | StatementKind::Mode(_)
        | StatementKind::Start(_)
        | StatementKind::History(_)
        | StatementKind::Ranges(_)
        | StatementKind::StateRate(..)
        | StatementKind::RateEquation(_)
        | StatementKind::Quaternion(_)
        | StatementKind::Function(_)
        | StatementKind::External(_)
        | StatementKind::Table(_)
        | StatementKind::Kinetic(_)
        | StatementKind::Potential(_)
        | StatementKind::Lagrangian(_)
        | StatementKind::Gibbs { .. }
        | StatementKind::Dissipation(_)
        | StatementKind::ForceOn(..)
        | StatementKind::ForceAt { .. }
        | StatementKind::ForceAlong { .. }
        | StatementKind::Torque { .. }
        | StatementKind::Stabilise(_)
        | StatementKind::Event(_)
        | StatementKind::Every(_)
        | StatementKind::Output(..)
        | StatementKind::Emit(_)
        | StatementKind::Reduce(_)
        | StatementKind::Block(_)
        | StatementKind::Scene(_) => {}
    }
}

/// Names the force of a constraint, a contact or friction. The quantity on which it does work is
/// known.
fn name_force(checker: &mut Checker<'_>, name: &Name, along: &Measure) {
    let work = form(if along.has_rates { POWER } else { ENERGY });
    let force = along.form().map(|form| work.over(&form));
    checker.scope.insert(name.text.clone(), Measure::scalar(force));
}
