//! Entries of the state that are assigned values, by events and at the start.

use super::elaborator::Elaborator;
use super::evaluator::Evaluator;
use super::expression::value_of;
use super::messages::{events, names, start, states};
use super::states::state_named;
use lagrange_expr::expr::ExprId;
use lagrange_expr::symbol::Symbol;
use lagrange_language::syntax::ast::{AstId, Expression, Name, Quaternion};

/// Returns the spelling of the entry with this index in [q…, v…].
pub(super) fn spelling_of(elaborator: &Elaborator<'_>, index: usize) -> String {
    let count = elaborator.declaration.coordinates().len();
    let symbol = match index.checked_sub(count) {
        Some(velocity) => elaborator.speeds.get(velocity).map(|(speed, _)| speed.velocity),
        None => position_at(elaborator, index),
    };
    let symbol = symbol.and_then(|symbol| elaborator.evaluator.graph.symbol_of(symbol));
    symbol.map(Symbol::text).unwrap_or_default()
}

/// Returns the position with this index; states come after all others.
pub(super) fn position_at(elaborator: &Elaborator<'_>, index: usize) -> Option<ExprId> {
    match index.checked_sub(elaborator.first_state) {
        Some(state) => elaborator.states.get(state).map(|state| state.position),
        None => elaborator.coordinates.get(index).map(|(coordinate, _)| coordinate.position),
    }
}

/// Returns the index in [q…, v…] of the target of an assignment; an invalid target is reported with
/// this help.
pub(super) fn assigned_index(elaborator: &mut Elaborator<'_>, syntax: AstId, help: &str) -> Option<usize> {
    let (coordinate, is_velocity) = match elaborator.evaluator.syntax(syntax) {
        Expression::Call(function, arguments) if function.text == "dot" && arguments.len() == 1 => {
            (arguments[0], true)
        }
        _ => (syntax, false),
    };
    let Expression::Name(text) = elaborator.evaluator.syntax(coordinate) else {
        // Errors within the target are reported first.
        value_of(&mut elaborator.evaluator, syntax)?;
        return elaborator.evaluator.refuse(syntax, events::NOT_ASSIGNABLE, help);
    };
    if elaborator.evaluator.scope.resolve(text).is_none() {
        return refuse_unknown(elaborator, coordinate, text, help);
    }
    let found = entry_of_state(elaborator, text, is_velocity);
    if is_velocity && state_named(elaborator, text).is_some() {
        let help = states::assigned_rate_help(text);
        return elaborator.evaluator.refuse(syntax, states::assigned_rate(text), &help);
    }
    if found.is_none() {
        let name = Name::new(text.as_str(), elaborator.evaluator.origin(coordinate).start);
        elaborator.report_no_coordinate(&name, help);
    }
    found
}

/// Reports a name that is not declared, with this help if it is predefined. The name of an
/// orientation also counts as not declared, since only its components have values.
fn refuse_unknown<T>(elaborator: &mut Elaborator<'_>, syntax: AstId, text: &str, help: &str) -> Option<T> {
    let Some(components) = components_of(elaborator, syntax, text) else {
        return report_undeclared(&mut elaborator.evaluator, syntax, text, help);
    };
    let help = start::whole_quaternion(components.each_ref().map(String::as_str));
    elaborator.evaluator.refuse(syntax, start::whole_orientation(text), &help)
}

/// Returns the components of the orientation with this name, if it is one.
pub(super) fn components_of(elaborator: &Elaborator<'_>, syntax: AstId, text: &str) -> Option<[String; 4]> {
    let span = elaborator.evaluator.origin(syntax).start;
    let components = Quaternion::named(Name::new(text, span)).positions.map(|component| component.text);
    elaborator.coordinates.iter().any(|(known, _)| known.name == components[0]).then_some(components)
}

/// Reports an unknown name where an entry of the state is assigned, unless it was reported before.
/// A predefined name, such as that of time, has a value but is not assigned.
fn report_undeclared<T>(evaluator: &mut Evaluator<'_>, syntax: AstId, text: &str, help: &str) -> Option<T> {
    let mistake = evaluator.report.diagnostics().len();
    if value_of(evaluator, syntax).is_some() {
        return evaluator.refuse(syntax, events::NOT_ASSIGNABLE, help);
    }
    let reported = evaluator.report.diagnostic_mut(mistake);
    if let Some(general) = reported.filter(|one| one.help.as_deref() == Some(names::DECLARE_FIRST)) {
        general.help(start::declare_entry(text));
    }
    None
}

/// Returns the index in [q…, v…] of a position or velocity, or of the rate of a coordinate.
fn entry_of_state(elaborator: &Elaborator<'_>, name: &str, is_rate: bool) -> Option<usize> {
    // Coordinates may also be declared further down.
    let count = elaborator.declaration.coordinates().len();
    let velocity = || elaborator.speed_of(name).map(|index| count + index);
    let position = elaborator.coordinates.iter().position(|(known, _)| known.name == name);
    let position = position.or_else(|| state_named(elaborator, name));
    match (position, is_rate) {
        (Some(_), true) => velocity(),
        (Some(index), false) => Some(index),
        (None, is_rate) => velocity().filter(|_| !is_rate),
    }
}
