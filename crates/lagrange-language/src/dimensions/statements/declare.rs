//! Names whose dimensions are declared, or determined by their use.

use super::definitions::{declared, define_value};
use super::form;
use crate::dimensions::checker::Checker;
use crate::dimensions::exponents::Exponents;
use crate::dimensions::kinds::FREQUENCY;
use crate::dimensions::measure::Measure;
use crate::syntax::ast::{Definition, ExternalFunction, Mode, Name, Quaternion};

/// Declares constants, whose values may be exponents.
pub(super) fn declare_constants(checker: &mut Checker<'_>, list: &[Definition]) {
    list.iter().for_each(|definition| define_value(checker, definition));
    let values = list.iter().filter_map(|definition| Some((&definition.name, definition.value?)));
    values.for_each(|(name, value)| checker.define_constant(&name.text, value));
}

/// Declares names whose values do not determine their dimensions.
pub(super) fn declare_variables(checker: &mut Checker<'_>, list: &[Definition]) {
    for Definition { name, .. } in list {
        let form = declared(checker, name);
        checker.scope.insert(name.text.clone(), Measure::known(form));
    }
}

/// Declares a mode and its values as plain numbers.
pub(super) fn declare_mode(checker: &mut Checker<'_>, mode: &Mode) {
    for Name { text, .. } in [&mode.name].into_iter().chain(&mode.values) {
        checker.scope.insert(text.clone(), Measure::known(form([0; 7])));
    }
}

/// Declares the components of a quaternion and its angular velocity.
pub(super) fn declare_quaternion(checker: &mut Checker<'_>, quaternion: &Quaternion) {
    for name in &quaternion.positions {
        checker.scope.insert(name.text.clone(), Measure::known(Exponents::plain()));
    }
    for name in &quaternion.velocities {
        checker.scope.insert(name.text.clone(), Measure::known(form(FREQUENCY)).with_rates(true));
    }
}

/// Declares a function of the crate.
pub(super) fn declare_external(checker: &mut Checker<'_>, function: &ExternalFunction) {
    let columns = function.parameters.iter().chain([&function.name]);
    let columns = columns.map(|name| declared(checker, name)).collect();
    checker.callables.insert(function.name.text.clone(), columns);
}
