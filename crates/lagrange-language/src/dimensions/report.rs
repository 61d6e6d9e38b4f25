//! Contradictions between dimensions as diagnostics.

use std::collections::BTreeSet;

use super::checker::Checker;
use super::exponents::{Exponents, Unknown};
use super::kinds::ENERGY;
use super::messages;
use super::solver::{Contradiction, Grounds};
use crate::syntax::ast::{AstId, BinaryOperator, Expression, Expressions};
use crate::syntax::print;
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::{Origin, Report};
use lagrange_expr::number::Number;
use lagrange_expr::units::{Dimension, Unit, described, meaning, noun, spelled};

/// Maximum length of a chain of reasons; longer ones are truncated.
const MAX_NOTES: usize = 4;

/// A name and the factor that it lacks for an equation to hold.
type Correction = (Unknown, Dimension);

/// Reports contradictions. Those in expressions of the user come first, since the others follow
/// from the same errors.
pub(super) fn report(checker: &Checker<'_>, last_written: Option<AstId>, report: &mut Report) {
    let contradictions = checker.solver.contradictions.iter();
    let mut located =
        contradictions.filter_map(|one| Some((one, one.equation.expression?))).collect::<Vec<_>>();
    let is_written = |id: AstId| last_written.is_some_and(|last| id <= last);
    if located.iter().any(|(_, id)| is_written(*id)) {
        located.retain(|(_, id)| is_written(*id));
    }
    let mut corrections: Vec<Correction> = Vec::new();
    let mut said: HashSet<String> = HashSet::default();
    let mut wrong: HashSet<AstId> = HashSet::default();
    for (contradiction, expression) in located {
        let origin = checker.expressions.origin(expression);
        let own = corrections_of(contradiction);
        let follows = own.iter().any(|correction| corrections.contains(correction));
        corrections.extend(own);
        let is_said = !said.insert(format!("{:?} {:?}", origin.start, origin.end));
        // Terms of one sum that lack the same factor are one error.
        let lack = format!("{:?} {:?}", contradiction.equation.reason.place, contradiction.missing);
        let is_lacking_again = !said.insert(lack);
        let holds_mistake = checker.expressions.parts(expression).iter().any(|part| wrong.contains(part));
        wrong.insert(expression);
        if !follows && !is_said && !is_lacking_again && !holds_mistake {
            report_contradiction(checker, contradiction, (expression, origin), report);
        }
    }
    for argument in &checker.degrees {
        let number = print::expression(checker.expressions, *argument);
        let warning = report.doubtful(checker.expressions.origin(*argument), messages::many_radians(&number));
        warning.help(messages::many_radians_help(&number));
    }
}

/// Returns the changes of single names that would each remove a contradiction. A change that
/// removes two of them indicates a single error.
fn corrections_of(contradiction: &Contradiction) -> Vec<Correction> {
    let equation = &contradiction.equation;
    let difference = equation.found.over(&equation.expected);
    let corrections = difference.unknowns.iter().filter_map(|(unknown, exponent)| {
        Some((*unknown, contradiction.missing.power(&exponent.reciprocal()?)))
    });
    corrections.collect()
}

fn report_contradiction(
    checker: &Checker<'_>,
    contradiction: &Contradiction,
    (expression, origin): (AstId, Origin),
    report: &mut Report,
) {
    let Contradiction { equation, missing } = contradiction;
    let of_names = inferences(checker, contradiction);
    let definitions = of_names.iter().filter_map(|(number, _)| checker.solver.equations[*number].expression);
    let mut suspects = [expression].into_iter().chain(definitions);
    if let Some((above, below, unit)) = suspects.find_map(|id| unit_below(checker, id, missing)) {
        let text = unit.to_string();
        let error = report.error(unit.origin, messages::unit_below(&below, &text));
        error.help(messages::unit_below_help((&above, &below), &text));
        return;
    }
    let found = checker.solver.dimension(&equation.found).map(|dimension| described(&dimension));
    let square = factor_to_square(checker, expression, missing);
    let factor = match &square {
        Some(_) => messages::SQUARE_MISSING.to_owned(),
        None => in_words(missing),
    };
    let said = said(checker, &equation.reason, &equation.expected);
    let error = report.error(origin, messages::contradiction(found.as_deref(), &said, &factor));
    let reason = equation.reason.place;
    if reason.start.start().line != origin.start.start().line {
        error.related(reason, messages::REASON_IS_HERE);
    }
    for (place, note) in notes(checker, &of_names) {
        error.related(place, note);
    }
    error.help(match square {
        Some(factor) => messages::write_square(print::expression(checker.expressions, factor)),
        None => advice(checker, contradiction, expression),
    });
}

/// Returns the text of a reason with the dimension inserted.
fn said(checker: &Checker<'_>, reason: &Grounds, expected: &Exponents) -> String {
    let expected = checker.solver.dimension(expected);
    let is_moment = expected.as_ref() == Some(&Dimension::of(ENERGY));
    let words = expected.map_or_else(|| messages::ANOTHER.to_owned(), |dimension| described(&dimension));
    let load = if is_moment { messages::MOMENT } else { &words };
    reason.words.replace('%', load).replace('#', &words)
}

fn in_words(missing: &Dimension) -> String {
    if let Some(noun) = noun(missing) {
        return messages::factor_missing(noun);
    }
    match noun(&Dimension::NONE.over(missing)) {
        Some(noun) => messages::factor_too_much(noun),
        None => messages::factor_in_unit(spelled(missing)),
    }
}

/// Finds a factor of a product that equals the missing dimension.
fn factor_to_square(checker: &Checker<'_>, expression: AstId, missing: &Dimension) -> Option<AstId> {
    let mut pending = vec![expression];
    while let Some(id) = pending.pop() {
        match checker.expressions.get(id) {
            Expression::Binary(BinaryOperator::Multiply, _, left, right) => pending.extend([*left, *right]),
            Expression::Binary(BinaryOperator::Divide, _, left, _) => pending.push(*left),
            Expression::Negate(of) => pending.push(*of),
            Expression::Name(_) | Expression::Call(..) if id != expression || is_call(checker, id) => {
                let form = checker.known_value(id).form();
                if form.and_then(|form| checker.solver.dimension(&form)).as_ref() == Some(missing) {
                    return Some(id);
                }
            }
            _ => {}
        }
    }
    None
}

fn is_call(checker: &Checker<'_>, id: AstId) -> bool {
    matches!(checker.expressions.get(id), Expression::Call(..))
}

fn advice(checker: &Checker<'_>, contradiction: &Contradiction, expression: AstId) -> String {
    let equation = &contradiction.equation;
    let expected = checker.solver.dimension(&equation.expected);
    if let (Expression::Number(_), Some(expected)) = (checker.expressions.get(expression), &expected)
        && !expected.is_none()
    {
        let number = print::expression(checker.expressions, expression);
        return messages::write_unit(&number, spelled(expected));
    }
    if let Some(unit) = unit_across_names(checker, expression) {
        return messages::in_brackets(&unit);
    }
    let names = equation.found.unknowns.keys().chain(equation.expected.unknowns.keys());
    // Each is listed once, since a name may be on both sides.
    let names = names.copied().collect::<BTreeSet<_>>();
    let units = names.into_iter().filter_map(|unknown| unit_of(checker, unknown));
    // The argument of a table may have the name of a coordinate.
    let mut units = units.collect::<Vec<_>>();
    units.dedup();
    match units.is_empty() {
        true => messages::COMPARE_HELP.to_owned(),
        false => messages::units_are(&units),
    }
}

/// Returns the numbers and the unit of `1/2 [kg]`, which is 1/(2 kg), if half a kilogram would fit:
/// kg² is missing.
fn unit_below<'a>(
    checker: &Checker<'a>,
    expression: AstId,
    missing: &Dimension,
) -> Option<(String, String, &'a Unit)> {
    let expressions = checker.expressions;
    let number = |id| print::expression(expressions, id);
    expressions.parts(expression).into_iter().find_map(|part| {
        let Expression::Binary(BinaryOperator::Divide, _, left, right) = expressions.get(part) else {
            return None;
        };
        let Expression::Quantity(below, unit) = expressions.get(*right) else { return None };
        let above = last_factor(expressions, *left)?;
        let powers = [2, -2, 4, -4].map(|power| unit.dimension.power(&Number::from(power)));
        powers.contains(missing).then(|| (number(above), number(*below), &**unit))
    })
}

/// Returns the last factor of a product, if it is a number without a unit.
fn last_factor(expressions: &Expressions, product: AstId) -> Option<AstId> {
    let last = match expressions.get(product) {
        Expression::Binary(BinaryOperator::Multiply, _, _, last) => *last,
        _ => product,
    };
    matches!(expressions.get(last), Expression::Number(_)).then_some(last)
}

/// Returns `3 [N/m]` for an expression with `3 N/m`, where `m` is also a name of the declaration.
fn unit_across_names(checker: &Checker<'_>, expression: AstId) -> Option<String> {
    let expressions = checker.expressions;
    expressions.parts(expression).into_iter().find_map(|part| {
        let Expression::Binary(operator, _, left, right) = expressions.get(part) else { return None };
        let sign = match operator {
            BinaryOperator::Divide => '/',
            BinaryOperator::Multiply => '*',
            _ => return None,
        };
        let (Expression::Quantity(number, unit), Expression::Name(name)) =
            (expressions.get(*left), expressions.get(*right))
        else {
            return None;
        };
        let number = print::expression(expressions, *number);
        meaning(name).map(|_| format!("{number} [{unit}{sign}{name}]"))
    })
}

fn unit_of(checker: &Checker<'_>, unknown: Unknown) -> Option<String> {
    let dimension = checker.solver.dimension(&Exponents::of(unknown))?;
    let name = checker.solver.name(unknown);
    Some(match dimension.is_none() {
        true => messages::plain_number(name),
        false => messages::unit_of(name, spelled(&dimension)),
    })
}

/// Returns the equations that determined undeclared dimensions of names, with the names, last one
/// first.
fn inferences(checker: &Checker<'_>, contradiction: &Contradiction) -> Vec<(usize, Unknown)> {
    let solver = &checker.solver;
    let equation = &contradiction.equation;
    let mut pending = equation.found.over(&equation.expected).unknowns.into_keys().collect::<Vec<_>>();
    let mut numbers: Vec<(usize, Unknown)> = Vec::new();
    while let Some(unknown) = pending.pop() {
        let Some(number) = solver.equation_of(unknown) else { continue };
        let of_unknown = &solver.equations[number];
        if of_unknown.expression.is_none() || numbers.iter().any(|(known, _)| *known == number) {
            continue;
        }
        numbers.push((number, unknown));
        pending.extend(of_unknown.found.over(&of_unknown.expected).unknowns.into_keys());
    }
    numbers.sort_by(|a, b| b.cmp(a));
    numbers
}

/// Returns notes on the first of these, each at its place.
fn notes(checker: &Checker<'_>, inferences: &[(usize, Unknown)]) -> Vec<(Origin, String)> {
    let solver = &checker.solver;
    let notes = inferences.iter().take(MAX_NOTES).filter_map(|&(number, unknown)| {
        let of_unknown = &solver.equations[number];
        let dimension = solver.dimension(&Exponents::of(unknown))?;
        let place = of_unknown.expression.map(|id| checker.expressions.origin(id))?;
        let said = said(checker, &of_unknown.reason, &of_unknown.expected);
        Some((place, messages::inferred(solver.name(unknown), described(&dimension), &said)))
    });
    notes.collect()
}
