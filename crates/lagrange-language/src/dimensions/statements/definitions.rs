//! Dimensions of names from their units and values.

use crate::dimensions::checker::Checker;
use crate::dimensions::exponents::Exponents;
use crate::dimensions::measure::{Measure, MeasuredComponent};
use crate::dimensions::messages;
use crate::dimensions::quantities::is_of_numbers;
use crate::dimensions::solver::{DimensionEquation, Grounds};
use crate::syntax::ast::{AstId, Definition, Expression, Name, TableDefinition, UnknownDefinition};
use lagrange_expr::diagnostics::Origin;

/// Returns the dimension of a name: the declared one, or one to be found.
pub(super) fn declared(checker: &mut Checker<'_>, name: &Name) -> Exponents {
    let unknown = checker.solver.unknown(&name.text);
    if let Some(unit) = &name.unit {
        let reason = Grounds { words: messages::declared(&name.text, unit.to_string()), place: unit.origin };
        let (found, expected) = (Exponents::of(unknown), Exponents::from(unit.dimension.clone()));
        checker.solver.equate(DimensionEquation { found, expected, expression: None, reason });
    }
    Exponents::of(unknown)
}

pub(super) fn define_value(checker: &mut Checker<'_>, definition: &Definition) {
    let Definition { name, range, value, .. } = definition;
    let form = declared(checker, name);
    let values = range.limits().map(|limit| limit.value).chain(*value);
    for value in values.filter(|value| !is_of_numbers(checker.expressions, *value)).collect::<Vec<_>>() {
        let reason = value_of(name);
        checker.require(value, &Measure::known(form.clone()), &reason);
    }
    checker.scope.insert(name.text.clone(), Measure::known(form));
}

/// Requires the dimension of an initial value or a bound; a plain number is in coherent units.
pub(super) fn require_start(checker: &mut Checker<'_>, value: AstId, target: &Measure, reason: &Grounds) {
    if !is_of_numbers(checker.expressions, value) {
        checker.require(value, target, reason);
    }
}

/// Returns the reason why the value of a name has its dimension.
pub(super) fn value_of(name: &Name) -> Grounds {
    match &name.unit {
        Some(unit) => Grounds { words: messages::declared(&name.text, unit.to_string()), place: unit.origin },
        None => Grounds { words: messages::stands_for(&name.text), place: Origin::from(name.span) },
    }
}

pub(super) fn define_unknowns(checker: &mut Checker<'_>, unknowns: &UnknownDefinition) {
    let forms = unknowns.names.iter().map(|name| Measure::known(declared(checker, name)));
    let forms = forms.collect::<Vec<_>>();
    for (name, form) in unknowns.names.iter().zip(&forms) {
        checker.scope.insert(name.text.clone(), form.clone());
    }
    unknowns.residuals.iter().for_each(|&residual| drop(checker.value(residual)));
    for ((name, form), &start) in unknowns.names.iter().zip(&forms).zip(&unknowns.starts) {
        require_start(checker, start, form, &value_of(name));
    }
}

pub(super) fn define_table(checker: &mut Checker<'_>, table: &TableDefinition) {
    let columns = table.parameters.iter().chain([&table.name]).collect::<Vec<_>>();
    let forms = columns.iter().map(|name| declared(checker, name)).collect::<Vec<_>>();
    for (column, number) in table.source.numbers() {
        let (Some(form), Some(name)) = (forms.get(column), columns.get(column)) else { continue };
        if !is_of_numbers(checker.expressions, number) {
            checker.require(number, &Measure::known(form.clone()), &value_of(name));
        }
    }
    checker.callables.insert(table.name.text.clone(), forms);
}

/// Returns the dimension of the value of a name; a number adopts the dimension of the name.
pub(super) fn named_value(checker: &mut Checker<'_>, name: &Name, value: AstId) -> Measure {
    if is_of_numbers(checker.expressions, value) {
        return of_numbers(checker, name, value);
    }
    if name.unit.is_none() {
        return checker.value(value);
    }
    let form = declared(checker, name);
    let found = checker.value(value);
    let expected = Measure::of(found.shape, vec![Some(form); found.components.len()]);
    checker.require(value, &expected, &value_of(name))
}

pub(super) fn named_component(
    checker: &mut Checker<'_>,
    name: &Name,
    whole: AstId,
    component: Measure,
) -> Measure {
    if name.unit.is_none() {
        return component;
    }
    let expected = Measure::known(declared(checker, name));
    checker.equate_values(whole, &component, &expected, &value_of(name));
    expected
}

pub(super) fn of_numbers(checker: &mut Checker<'_>, name: &Name, value: AstId) -> Measure {
    let component = |checker: &mut Checker<'_>, id: AstId| -> MeasuredComponent {
        let is_zero = matches!(checker.expressions.get(id), Expression::Number(number) if number.is_zero());
        (!is_zero).then(|| declared(checker, name))
    };
    match checker.expressions.get(value) {
        Expression::Tuple(parts) => {
            Measure::vector(parts.iter().map(|part| component(checker, *part)).collect())
        }
        _ => Measure::scalar(component(checker, value)),
    }
}
