//! Names that stand for expressions, and named forces.

use super::definitions::{named_component, named_value};
use super::{form, form_of_force};
use crate::dimensions::checker::Checker;
use crate::dimensions::kinds::{ENERGY, POWER};
use crate::dimensions::measure::Measure;
use crate::syntax::ast::{AstId, Expression, Friction, Name};

/// Gives a name the dimension of an expression.
pub(super) fn abbreviate(checker: &mut Checker<'_>, name: &Name, value: AstId) {
    let value = named_value(checker, name, value);
    checker.scope.insert(name.text.clone(), value);
}

/// Gives names the dimensions of the components of an expression.
pub(super) fn abbreviate_components(checker: &mut Checker<'_>, names: &[Name], value: AstId) {
    let parts = match checker.expressions.get(value) {
        Expression::Tuple(parts) => parts.clone(),
        _ => Vec::new(),
    };
    let whole = checker.value(value);
    for (i, name) in names.iter().enumerate() {
        let component = match parts.get(i) {
            Some(part) => named_value(checker, name, *part),
            None => named_component(checker, name, value, whole.entry(&[i])),
        };
        checker.scope.insert(name.text.clone(), component.with_rates(whole.has_rates));
    }
}

/// Names the force of a constraint or a contact, from the expression along which it does work.
pub(super) fn abbreviate_force(checker: &mut Checker<'_>, name: &Name, along: AstId) {
    let along = checker.value(along);
    name_force(checker, name, &along);
}

/// Names the force of friction: a vector if the slip velocity is one.
pub(super) fn abbreviate_friction(checker: &mut Checker<'_>, Friction { name, slip, .. }: &Friction) {
    let slip = checker.value(*slip).with_rates(true);
    name_force(checker, name, &slip);
    if !slip.is_scalar() {
        let force = slip.map(form_of_force);
        checker.scope.insert(name.text.clone(), Measure::vector(force.components));
    }
}

/// Names the force of a constraint, a contact or friction. The quantity on which it does work is
/// known.
fn name_force(checker: &mut Checker<'_>, name: &Name, along: &Measure) {
    let work = form(if along.has_rates { POWER } else { ENERGY });
    let force = along.form().map(|form| work.over(&form));
    checker.scope.insert(name.text.clone(), Measure::scalar(force));
}
