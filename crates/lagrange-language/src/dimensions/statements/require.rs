//! Conditions that statements impose on expressions.

use super::definitions::{named_value, require_start, value_of};
use super::{form, form_of_force, output_key};
use crate::dimensions::calls::total;
use crate::dimensions::checker::Checker;
use crate::dimensions::exponents::Exponents;
use crate::dimensions::kinds::{ENERGY, FORCE, FREQUENCY, GIBBS, LENGTH, POWER, TIME};
use crate::dimensions::measure::Measure;
use crate::dimensions::messages;
use crate::dimensions::quantities::is_of_numbers;
use crate::dimensions::solver::Grounds;
use crate::syntax::ast::{
    Action, Assignment, AstId, Definition, Event, Friction, Reduction, Statement, StatementKind,
};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::number::Number;
use lagrange_expr::units::Dimension;

/// Requires the conditions that a statement imposes on expressions.
pub(super) fn require(checker: &mut Checker<'_>, statement: &Statement) {
    let place = Origin::from(statement.origin.start);
    let said = |words: &str| Grounds { words: words.to_owned(), place };
    match &statement.kind {
        StatementKind::Noises(list) => {
            list.iter().for_each(|definition| demand_of_noise(checker, definition));
        }
        StatementKind::Coordinates(list) | StatementKind::States(_, list) => {
            for Definition { name, range, nominal, value } in list {
                let known = checker.scope.get(&name.text).cloned().unwrap_or_else(Measure::any);
                let limits = range.limits().map(|limit| limit.value);
                for value in limits.chain(*nominal).chain(*value) {
                    require_start(checker, value, &known, &value_of(name));
                }
            }
        }
        StatementKind::Start(assignments) => {
            require_entries(checker, assignments, messages::STARTS);
        }
        StatementKind::History(assignments) => {
            require_entries(checker, assignments, messages::HISTORIES);
        }
        StatementKind::Ranges(entries) => {
            for entry in entries {
                let target = checker.value(entry.target);
                let place = checker.expressions.origin(entry.target);
                let reason = Grounds { words: messages::RANGES.to_owned(), place };
                entry.values().for_each(|value| require_start(checker, value, &target, &reason));
            }
        }
        StatementKind::Delay { lag, .. } => {
            checker.require_dimension(*lag, &Dimension::of(TIME), &said(messages::LAG));
        }
        StatementKind::Kinetic(value) => {
            energy(checker, *value, &said(messages::KINETIC));
        }
        StatementKind::Potential(value) => {
            energy(checker, *value, &said(messages::POTENTIAL));
        }
        StatementKind::Lagrangian(value) => {
            energy(checker, *value, &said(messages::LAGRANGIAN));
        }
        StatementKind::Gibbs { function, stated } => {
            checker.require_dimension(*function, &Dimension::of(GIBBS), &said(messages::GIBBS));
            energy(checker, *stated, &said(messages::LAGRANGIAN));
        }
        StatementKind::Dissipation(value) => {
            checker.require_dimension(*value, &Dimension::of(POWER), &said(messages::DISSIPATION));
        }
        StatementKind::StateRate(name, value) => {
            let state = checker.scope.get(&name.text).cloned().unwrap_or_else(Measure::any);
            checker.require(*value, &state.map(rate), &said(&messages::rate_of(&name.text)));
        }
        StatementKind::RateEquation(difference) => {
            checker.value(*difference);
        }
        StatementKind::Stabilise(rate) => {
            checker.require_dimension(*rate, &Dimension::of(FREQUENCY), &said(messages::STABILISE));
        }
        StatementKind::ForceOn(name, force) => {
            let along = checker.scope.get(&name.text).cloned().unwrap_or_else(Measure::any);
            work(checker, *force, &along, &said(&messages::force_on(&name.text)));
        }
        StatementKind::ForceAt { force, point } => {
            let each = |exponents| Measure::vector(vec![Some(form(exponents)); 3]);
            checker.require(*point, &each(LENGTH), &said(messages::POINT));
            checker.require(*force, &each(FORCE), &said(messages::FORCE));
        }
        StatementKind::ForceAlong { force, velocity } => {
            let along = checker.value(*velocity).with_rates(true);
            work(checker, *force, &along, &said(messages::FORCE_ALONG));
        }
        StatementKind::Torque { moment, angle } => {
            let along = checker.value(*angle);
            work(checker, *moment, &along, &said(messages::TORQUE));
        }
        StatementKind::Every(clock) => {
            checker.require_dimension(clock.period, &Dimension::of(TIME), &said(messages::PERIOD));
            demand_of_assignments(checker, &clock.assignments);
        }
        StatementKind::Event(event) => demand_of_event(checker, event, place),
        StatementKind::Friction(friction) => {
            demand_of_friction(checker, friction, place);
        }
        StatementKind::Output(name, value) => {
            let value = named_value(checker, name, *value);
            checker.scope.insert(output_key(&name.text), value);
        }
        StatementKind::Reduce(reduction) => {
            demand_of_reduction(checker, reduction, place);
        }
        // These only concern other passes, or none: loops, bodies and functions with a formula no
        // longer exist.
        StatementKind::Parameters(_)
        | StatementKind::Inputs(_)
        | StatementKind::Constants(_)
        | StatementKind::Mode(_)
        | StatementKind::Quaternion(_)
        | StatementKind::Velocity(..)
        | StatementKind::Let(..)
        | StatementKind::LetTuple(..)
        | StatementKind::Function(_)
        | StatementKind::External(_)
        | StatementKind::Table(_)
        | StatementKind::Solve(_)
        | StatementKind::Constraint(..)
        | StatementKind::Emit(_)
        | StatementKind::Block(_)
        | StatementKind::Scene(_) => {}
    }
}

/// Requires that assigned values have the dimensions of their entries.
fn require_entries(checker: &mut Checker<'_>, assignments: &[Assignment], words: &str) {
    for assignment in assignments {
        let target = checker.value(assignment.target);
        let place = checker.expressions.origin(assignment.target);
        let reason = Grounds { words: words.to_owned(), place };
        require_start(checker, assignment.value, &target, &reason);
    }
}

fn energy(checker: &mut Checker<'_>, value: AstId, reason: &Grounds) {
    checker.require_dimension(value, &Dimension::of(ENERGY), reason);
}

/// Requires a force from the quantity along which it does work.
fn work(checker: &mut Checker<'_>, force: AstId, along: &Measure, reason: &Grounds) {
    let work = form(if along.has_rates { POWER } else { ENERGY });
    let expected = along.map(|form| work.over(form));
    checker.require(force, &expected, reason);
}

/// Requires the density of a noise to be the square of the noise times time.
fn demand_of_noise(checker: &mut Checker<'_>, Definition { name, value, .. }: &Definition) {
    let known = checker.scope.get(&name.text).cloned().unwrap_or_else(Measure::any);
    let density = known.map(|form| form.times(form).times(&self::form(TIME)));
    let reason = Grounds { words: messages::density_of(&name.text), place: Origin::from(name.span) };
    value.iter().for_each(|value| require_start(checker, *value, &density, &reason));
}

fn demand_of_event(checker: &mut Checker<'_>, event: &Event, place: Origin) {
    checker.value(event.value);
    match &event.action {
        Action::Stop | Action::Record => {}
        Action::Impact(restitution) => {
            let reason = Grounds { words: messages::RESTITUTION.to_owned(), place };
            checker.require_dimension(*restitution, &Dimension::NONE, &reason);
        }
        Action::Assign(assignments) => demand_of_assignments(checker, assignments),
    }
}

fn demand_of_assignments(checker: &mut Checker<'_>, assignments: &[Assignment]) {
    for assignment in assignments {
        let target = checker.value(assignment.target);
        let place = checker.expressions.origin(assignment.target);
        let reason = Grounds { words: messages::ASSIGNED.to_owned(), place };
        checker.require(assignment.value, &target, &reason);
    }
}

fn demand_of_friction(checker: &mut Checker<'_>, friction: &Friction, place: Origin) {
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

fn demand_of_reduction(checker: &mut Checker<'_>, reduction: &Reduction, place: Origin) {
    for item in &reduction.items {
        let coordinate = checker.scope.get(&item.coordinate.text).cloned().unwrap_or_else(Measure::any);
        let Some(value) = item.value.filter(|value| !is_of_numbers(checker.expressions, *value)) else {
            continue;
        };
        let reason = Grounds { words: messages::stands_for(&item.coordinate.text), place };
        checker.require(value, &coordinate, &reason);
    }
}

/// Returns the form of the rate of a coordinate.
fn rate(coordinate: &Exponents) -> Exponents {
    coordinate.times_power(&form(FREQUENCY), &Number::ONE)
}
