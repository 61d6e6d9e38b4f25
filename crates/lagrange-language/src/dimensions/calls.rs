//! Dimensions of calls.

use super::checker::Checker;
use super::exponents::Exponents;
use super::kinds::{LENGTH, MASS, TIME};
use super::measure::{Measure, MeasuredComponent};
use super::messages;
use super::solver::Grounds;
use crate::syntax::ast::{ArrayShape, AstId, CONTACT_POINT, CONTACT_POINT_LENGTH, Expression, IN_AXES};
use lagrange_expr::elementary;
use lagrange_expr::number::Number;
use lagrange_expr::solids;
use lagrange_expr::units::Dimension;

/// Radians in a trigonometric function above which degrees may be meant: more than a turn.
const MANY_RADIANS: i64 = 7;

pub(super) fn call(checker: &mut Checker<'_>, id: AstId, function: &str, arguments: &[AstId]) -> Measure {
    let values = arguments.iter().map(|argument| checker.known_value(*argument)).collect::<Vec<_>>();
    let has_rates = values.iter().any(|value| value.has_rates);
    if let Some(columns) = checker.callables.get(&function.to_owned()).cloned() {
        return callable(checker, function, arguments, &columns).with_rates(has_rates);
    }
    let value = match (function, &values[..]) {
        ("dot" | "ddot", [value]) => {
            let seconds = Number::from(if function == "dot" { -1 } else { -2 });
            let second = Exponents::from(Dimension::of(TIME));
            value.map(|form| form.times_power(&second, &seconds)).with_rates(true)
        }
        ("partial", [of, by]) => match by.form() {
            Some(by) => of.map(|form| form.over(&by)),
            None => Measure::any(),
        },
        ("pow" | "powi" | "powf", [_, _]) => checker.power(arguments[0], arguments[1]),
        ("sqrt", [value]) => value.map(|form| form.power(&Number::HALF)),
        ("abs", [value]) => value.clone(),
        ("sign", [_]) => Measure::known(Exponents::plain()),
        ("min" | "max", [first, ..]) => {
            let one_by_one = arguments[1..].iter();
            let measures = one_by_one.map(|other| checker.same(arguments[0], *other, messages::COMPARED));
            measures.last().unwrap_or_else(|| first.clone())
        }
        ("hypot", [_, _]) => checker.same(arguments[0], arguments[1], messages::COMPARED),
        ("atan2", [_, _]) => {
            checker.same(arguments[0], arguments[1], messages::COMPARED);
            Measure::known(Exponents::plain())
        }
        ("norm", [value]) => Measure::scalar(total(checker, id, &value.components)),
        ("inner", [a, b]) => {
            let factors = a.components.iter().zip(&b.components).map(|(a, b)| [a, b]);
            Measure::scalar(dot_product(checker, id, factors))
        }
        ("cross", [a, b]) => cross(checker, id, a, b),
        ("transpose", [value]) => transpose(value),
        ("kinetic_energy" | "spring_energy", [factor, value]) => {
            let size = Measure::scalar(total(checker, id, &value.components));
            factor.times(&size).times(&size)
        }
        ("gravitational_energy", [mass, gravity, height]) => mass.times(gravity).times(height),
        (IN_AXES, [vector, _]) => vector.clone(),
        (CONTACT_POINT, [_, _, place, ..]) => contact_point(checker, arguments[0], place),
        _ => other(checker, function, arguments),
    };
    value.with_rates(has_rates)
}

/// Returns the dimension of a number of a contact point: a length, or none for the normal and the
/// tangent.
fn contact_point(checker: &Checker<'_>, number: AstId, length: &Measure) -> Measure {
    let number = match checker.expressions.get(number) {
        Expression::Number(number) => number.to_i32().and_then(|number| usize::try_from(number).ok()),
        _ => None,
    };
    match number.is_some_and(|number| (6..12).contains(&(number % CONTACT_POINT_LENGTH))) {
        true => Measure::known(Exponents::plain()),
        false => length.clone(),
    }
}

/// Returns the common dimension of all terms of a sum, or of all components of a vector.
pub(super) fn total(
    checker: &mut Checker<'_>,
    call: AstId,
    terms: &[MeasuredComponent],
) -> MeasuredComponent {
    let mut known = terms.iter().flatten();
    let first = known.next()?.clone();
    let place = checker.expressions.origin(call);
    for term in known {
        let reason = Grounds { words: messages::OF_ONE_VECTOR.to_owned(), place };
        checker.equate(call, term, &first, &reason);
    }
    Some(first)
}

/// Returns the sum of products of the components of two values; zeros alone have an unknown
/// dimension.
fn dot_product<'m>(
    checker: &mut Checker<'_>,
    call: AstId,
    factors: impl Iterator<Item = [&'m MeasuredComponent; 2]>,
) -> MeasuredComponent {
    let products = factors.map(|[a, b]| Some(a.as_ref()?.times(b.as_ref()?))).collect::<Vec<_>>();
    total(checker, call, &products)
}

/// Returns the product of a matrix with a vector or a matrix; mismatched shapes give an unknown
/// dimension.
pub(super) fn matrix_product(checker: &mut Checker<'_>, call: AstId, a: &Measure, b: &Measure) -> Measure {
    let (Some(shape), ArrayShape::Matrix([rows, inner])) = (a.shape.times(b.shape), a.shape) else {
        return Measure::any();
    };
    let columns = b.components.len() / inner.max(1);
    let mut components = Vec::new();
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        let factors = (0..inner).map(|k| [&a.components[i * inner + k], &b.components[k * columns + j]]);
        components.push(dot_product(checker, call, factors));
    }
    Measure::of(shape, components).with_rates(a.has_rates || b.has_rates)
}

fn transpose(value: &Measure) -> Measure {
    let (Some(shape), ArrayShape::Matrix([rows, columns])) = (value.shape.transposed(), value.shape) else {
        return Measure::any();
    };
    let places = (0..columns).flat_map(|j| (0..rows).map(move |i| i * columns + j));
    Measure::of(shape, places.map(|place| value.components[place].clone()).collect())
}

fn cross(checker: &mut Checker<'_>, call: AstId, a: &Measure, b: &Measure) -> Measure {
    let product = |i: usize, j: usize| {
        let of = |value: &Measure, k: usize| value.components.get(k).cloned().flatten();
        Some(of(a, i)?.times(&of(b, j)?))
    };
    if a.components.len() == 2 {
        return Measure::scalar(total(checker, call, &[product(0, 1), product(1, 0)]));
    }
    let component = |i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        total(checker, call, &[product(j, k), product(k, j)])
    };
    Measure::vector((0..3).map(component).collect())
}

/// Checks a call of a function of the crate or a table.
fn callable(
    checker: &mut Checker<'_>,
    function: &str,
    arguments: &[AstId],
    columns: &[Exponents],
) -> Measure {
    for (argument, expected) in arguments.iter().zip(columns) {
        let place = checker.expressions.origin(*argument);
        let reason = Grounds { words: messages::argument_of(function), place };
        if let Some(found) = checker.known_value(*argument).form() {
            checker.equate(*argument, &found, expected, &reason);
        }
    }
    Measure::scalar(columns.last().cloned())
}

/// Checks calls of functions of plain numbers, and of moments of inertia.
fn other(checker: &mut Checker<'_>, function: &str, arguments: &[AstId]) -> Measure {
    let (mass, length) = (Dimension::of(MASS), Dimension::of(LENGTH));
    let inertia = mass.times(&length.power(&Number::TWO));
    if elementary::by_name(function).is_some() {
        for argument in arguments {
            checker.require_plain(*argument, &messages::plain_argument_of(function));
            look_for_degrees(checker, function, *argument);
        }
        return Measure::known(Exponents::plain());
    }
    let dimensions = match function {
        "steiner" => vec![inertia.clone(), mass, length],
        "slender_rod_end" => vec![mass, length],
        name if solids::by_name(name).is_some() => {
            let sizes = std::iter::repeat_n(length, arguments.len().saturating_sub(1));
            std::iter::once(mass).chain(sizes).collect()
        }
        _ => return Measure::any(),
    };
    for (argument, dimension) in arguments.iter().zip(&dimensions) {
        let place = checker.expressions.origin(*argument);
        let reason = Grounds { words: messages::argument_of(function), place };
        let found = checker.known_value(*argument);
        let expected = Some(Exponents::from(dimension.clone()));
        let expected = Measure::of(found.shape, vec![expected; found.components.len()]);
        checker.equate_values(*argument, &found, &expected, &reason);
    }
    Measure::known(inertia.into())
}

fn look_for_degrees(checker: &mut Checker<'_>, function: &str, argument: AstId) {
    let number = match checker.expressions.get(argument) {
        Expression::Number(number) => number.abs(),
        _ => return,
    };
    if ["sin", "cos", "tan"].contains(&function) && number >= Number::from(MANY_RADIANS) {
        checker.degrees.push(argument);
    }
}
