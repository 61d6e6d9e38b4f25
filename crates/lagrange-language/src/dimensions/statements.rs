//! Dimensions required by statements, in three passes: names are declared, then abbreviations are
//! followed, then conditions are imposed. Between the last two, the dimensions of labels are
//! required.

mod abbreviate;
mod declare;
mod definitions;
mod require;

use self::abbreviate::abbreviate;
use self::declare::declare;
use self::require::require;
use super::checker::Checker;
use super::exponents::Exponents;
use super::kinds::POWER;
use super::labels::Label;
use super::measure::Measure;
use super::messages;
use super::solver::Grounds;
use crate::syntax::ast::{ArrayShape, Declaration, Statement, StatementKind};
use lagrange_expr::units::Dimension;

fn form(exponents: [i8; 7]) -> Exponents {
    Exponents::from(Dimension::of(exponents))
}

/// Checks a declaration in plain statements: first names, then values of labels, then statements.
pub(super) fn check(checker: &mut Checker<'_>, declaration: &Declaration, labels: &[Label]) {
    // Terms of bodies that occur in both energies and accelerations have units in the energies.
    let is_computed = |statement: &Statement| {
        let (StatementKind::Let(_, value) | StatementKind::Gibbs { function: value, .. }) = &statement.kind
        else {
            return false;
        };
        declaration.expressions.is_computed(*value)
    };
    let statements = || declaration.statements.iter();
    let written = || statements().filter(|statement| !is_computed(statement));
    statements().for_each(|statement| declare(checker, statement));
    written().for_each(|statement| abbreviate(checker, statement));
    for label in labels {
        let expected = Some(Exponents::from(label.unit.dimension.clone()));
        let expected = Measure::of(ArrayShape::Scalar, vec![expected; 3]);
        let reason =
            Grounds { words: messages::labelled(label.what), place: checker.expressions.origin(label.value) };
        checker.require(label.value, &expected, &reason);
    }
    written().for_each(|statement| require(checker, statement));
}

/// Returns the key of an output; outputs have separate names.
pub(super) fn output_key(name: &str) -> String {
    format!("output {name}")
}

/// Returns the form of a force along a slip velocity.
fn form_of_force(slip: &Exponents) -> Exponents {
    form(POWER).over(slip)
}
