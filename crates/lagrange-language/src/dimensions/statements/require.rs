//! Conditions that statements impose on expressions.

use super::definitions::{named_value, require_start, value_of};
use super::{form, form_of_force, output_key};
use crate::dimensions::calls::total;
use crate::dimensions::checker::Checker;
use crate::dimensions::kinds::{ENERGY, FORCE, FREQUENCY, LENGTH, POWER, TIME};
use crate::dimensions::measure::Measure;
use crate::dimensions::messages;
use crate::dimensions::quantities::is_of_numbers;
use crate::dimensions::solver::Grounds;
use crate::syntax::ast::{
    Action, Assignment, AstId, Definition, Event, Friction, LimitedEntry, Name, Reduction,
};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::number::Number;
use lagrange_expr::units::Dimension;

/// Requires the dimensions of initial values, bounds and nominal values.
pub(super) fn require_starts(checker: &mut Checker<'_>, list: &[Definition]) {
    for Definition { name, range, nominal, value } in list {
        let known = named(checker, name);
        let limits = range.limits().map(|limit| limit.value);
        for value in limits.chain(*nominal).chain(*value) {
            require_start(checker, value, &known, &value_of(name));
        }
    }
}

/// Requires that limits and nominal values have the dimensions of their entries.
pub(super) fn require_ranges(checker: &mut Checker<'_>, entries: &[LimitedEntry]) {
    for entry in entries {
        let target = checker.value(entry.target);
        let place = checker.expressions.origin(entry.target);
        let reason = Grounds { words: messages::RANGES.to_owned(), place };
        entry.values().for_each(|value| require_start(checker, value, &target, &reason));
    }
}

/// Requires that the rate of a state has its dimension, divided by time.
pub(super) fn require_rate(checker: &mut Checker<'_>, name: &Name, value: AstId, place: Origin) {
    let rate = named(checker, name).map(|state| state.times_power(&form(FREQUENCY), &Number::ONE));
    checker.require(value, &rate, &Grounds { words: messages::rate_of(&name.text), place });
}

/// Requires a force on a coordinate.
pub(super) fn require_force_on(checker: &mut Checker<'_>, name: &Name, force: AstId, place: Origin) {
    let along = named(checker, name);
    require_work(checker, force, &along, &Grounds { words: messages::force_on(&name.text), place });
}

/// Requires a force and its point of application, component by component.
pub(super) fn require_force_at(checker: &mut Checker<'_>, [force, point]: [AstId; 2], place: Origin) {
    for (value, exponents, words) in [(point, LENGTH, messages::POINT), (force, FORCE, messages::FORCE)] {
        let expected = Measure::vector(vec![Some(form(exponents)); 3]);
        checker.require(value, &expected, &Grounds { words: words.to_owned(), place });
    }
}

/// Requires the dimension of an output, which has a name of its own.
pub(super) fn require_output(checker: &mut Checker<'_>, name: &Name, value: AstId) {
    let value = named_value(checker, name, value);
    checker.scope.insert(output_key(&name.text), value);
}

/// Returns the dimension of a name; any if it is not declared.
fn named(checker: &Checker<'_>, name: &Name) -> Measure {
    checker.scope.get(&name.text).cloned().unwrap_or_else(Measure::any)
}

/// Requires that assigned values have the dimensions of their entries.
pub(super) fn require_entries(checker: &mut Checker<'_>, assignments: &[Assignment], words: &str) {
    for assignment in assignments {
        let target = checker.value(assignment.target);
        let place = checker.expressions.origin(assignment.target);
        let reason = Grounds { words: words.to_owned(), place };
        require_start(checker, assignment.value, &target, &reason);
    }
}

/// Requires a force from the quantity along which it does work.
pub(super) fn require_work(checker: &mut Checker<'_>, force: AstId, along: &Measure, reason: &Grounds) {
    let work = form(if along.has_rates { POWER } else { ENERGY });
    let expected = along.map(|form| work.over(form));
    checker.require(force, &expected, reason);
}

/// Requires the density of a noise to be the square of the noise times time.
pub(super) fn require_densities(checker: &mut Checker<'_>, noises: &[Definition]) {
    for Definition { name, value, .. } in noises {
        let density = named(checker, name).map(|form| form.times(form).times(&self::form(TIME)));
        let reason = Grounds { words: messages::density_of(&name.text), place: Origin::from(name.span) };
        value.iter().for_each(|value| require_start(checker, *value, &density, &reason));
    }
}

/// Requires the restitution of an impact to be a plain number, and assigned values to fit.
pub(super) fn require_event(checker: &mut Checker<'_>, event: &Event, place: Origin) {
    checker.value(event.value);
    match &event.action {
        Action::Stop | Action::Record => {}
        Action::Impact(restitution) => {
            let reason = Grounds { words: messages::RESTITUTION.to_owned(), place };
            checker.require_dimension(*restitution, &Dimension::NONE, &reason);
        }
        Action::Assign(assignments) => require_assignments(checker, assignments),
    }
}

/// Requires that assigned values have the dimensions of their targets, plain numbers included.
pub(super) fn require_assignments(checker: &mut Checker<'_>, assignments: &[Assignment]) {
    for assignment in assignments {
        let target = checker.value(assignment.target);
        let place = checker.expressions.origin(assignment.target);
        let reason = Grounds { words: messages::ASSIGNED.to_owned(), place };
        checker.require(assignment.value, &target, &reason);
    }
}

/// Requires limits of friction to be forces along the slip velocity.
pub(super) fn require_friction(checker: &mut Checker<'_>, friction: &Friction, place: Origin) {
    let slip = checker.value(friction.slip);
    let slip = Measure::scalar(total(checker, friction.slip, &slip.components));
    let force = slip.map(form_of_force);
    let reason = Grounds { words: messages::limit(&friction.name.text), place };
    for limit in [Some(friction.kinetic), friction.fixed].into_iter().flatten() {
        checker.require(limit, &force, &reason);
    }
    if let Some(width) = friction.width {
        let reason = Grounds { words: messages::WIDTH.to_owned(), place };
        checker.require(width, &slip, &reason);
    }
}

/// Requires that frozen coordinates have values of their dimensions.
pub(super) fn require_reduction(checker: &mut Checker<'_>, reduction: &Reduction, place: Origin) {
    for item in &reduction.items {
        let coordinate = named(checker, &item.coordinate);
        let Some(value) = item.value.filter(|value| !is_of_numbers(checker.expressions, *value)) else {
            continue;
        };
        let reason = Grounds { words: messages::stands_for(&item.coordinate.text), place };
        checker.require(value, &coordinate, &reason);
    }
}
