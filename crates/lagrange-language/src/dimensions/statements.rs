//! Dimensions required by statements, in three passes: names are declared, then abbreviations are
//! followed, then conditions are imposed. Between the last two, the dimensions of labels are
//! required.

mod abbreviate;
mod declare;
mod definitions;
mod require;

use self::abbreviate::{abbreviate, abbreviate_components, abbreviate_force, abbreviate_friction};
use self::declare::{
    declare_constants, declare_external, declare_mode, declare_quaternion, declare_variables,
};
use self::definitions::{define_table, define_unknowns, define_value};
use self::require::{
    require_assignments, require_densities, require_entries, require_event, require_force_at,
    require_force_on, require_friction, require_output, require_ranges, require_rate, require_reduction,
    require_starts, require_work,
};
use super::checker::Checker;
use super::exponents::Exponents;
use super::kinds::{ENERGY, FREQUENCY, GIBBS, POWER, TIME};
use super::labels::Label;
use super::measure::Measure;
use super::messages;
use super::solver::Grounds;
use crate::syntax::ast::{Action, ArrayShape, AstId, Declaration, Statement, StatementKind};
use lagrange_expr::diagnostics::Origin;
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
    statements().for_each(|statement| visit(checker, statement, Pass::Declare));
    written().for_each(|statement| visit(checker, statement, Pass::Abbreviate));
    for label in labels {
        let expected = Some(Exponents::from(label.unit.dimension.clone()));
        let expected = Measure::of(ArrayShape::Scalar, vec![expected; 3]);
        let reason =
            Grounds { words: messages::labelled(label.what), place: checker.expressions.origin(label.value) };
        checker.require(label.value, &expected, &reason);
    }
    written().for_each(|statement| visit(checker, statement, Pass::Require));
}

/// A pass over all statements.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// Declares names whose dimensions are declared, or determined by their use.
    Declare,
    /// Determines the dimensions of names that stand for expressions, and of named forces.
    Abbreviate,
    /// Requires the conditions that statements impose on expressions.
    Require,
}

/// Performs a pass over a statement.
fn visit(checker: &mut Checker<'_>, statement: &Statement, pass: Pass) {
    use Pass::{Abbreviate, Declare, Require};
    let place = Origin::from(statement.origin.start);
    let reason = |words: &str| Grounds { words: words.to_owned(), place };
    let mut during = |own: Pass, action: &dyn Fn(&mut Checker<'_>)| {
        if pass == own {
            action(checker);
        }
    };
    let of_dimension = |value: AstId, exponents: [i8; 7], words: &'static str| {
        move |c: &mut Checker<'_>| {
            c.require_dimension(value, &Dimension::of(exponents), &reason(words));
        }
    };
    match &statement.kind {
        StatementKind::Parameters(list) | StatementKind::Inputs(list) => {
            during(Declare, &|c| list.iter().for_each(|definition| define_value(c, definition)));
        }
        StatementKind::Constants(list) => during(Declare, &|c| declare_constants(c, list)),
        StatementKind::Coordinates(list) | StatementKind::States(_, list) => {
            during(Declare, &|c| declare_variables(c, list));
            during(Require, &|c| require_starts(c, list));
        }
        StatementKind::Noises(list) => {
            during(Declare, &|c| declare_variables(c, list));
            during(Require, &|c| require_densities(c, list));
        }
        StatementKind::Mode(mode) => during(Declare, &|c| declare_mode(c, mode)),
        StatementKind::Quaternion(quaternion) => during(Declare, &|c| declare_quaternion(c, quaternion)),
        StatementKind::External(function) => during(Declare, &|c| declare_external(c, function)),
        StatementKind::Table(table) => during(Declare, &|c| define_table(c, table)),
        StatementKind::Let(name, value) | StatementKind::Velocity(name, value) => {
            during(Abbreviate, &|c| abbreviate(c, name, *value));
        }
        StatementKind::LetTuple(names, value) => {
            during(Abbreviate, &|c| abbreviate_components(c, names, *value));
        }
        StatementKind::Delay { name, signal, lag } => {
            during(Abbreviate, &|c| abbreviate(c, name, *signal));
            during(Require, &of_dimension(*lag, TIME, messages::LAG));
        }
        StatementKind::Solve(unknowns) => during(Abbreviate, &|c| define_unknowns(c, unknowns)),
        StatementKind::Constraint(name, value) => during(Abbreviate, &|c| abbreviate_force(c, name, *value)),
        StatementKind::Event(event) => {
            if matches!(event.action, Action::Impact(_)) {
                during(Abbreviate, &|c| abbreviate_force(c, &event.name, event.value));
            }
            during(Require, &|c| require_event(c, event, place));
        }
        StatementKind::Every(clock) => {
            during(Require, &of_dimension(clock.period, TIME, messages::PERIOD));
            during(Require, &|c| require_assignments(c, &clock.assignments));
        }
        StatementKind::Friction(friction) => {
            during(Abbreviate, &|c| abbreviate_friction(c, friction));
            during(Require, &|c| require_friction(c, friction, place));
        }
        StatementKind::Start(entries) => during(Require, &|c| require_entries(c, entries, messages::STARTS)),
        StatementKind::History(entries) => {
            during(Require, &|c| require_entries(c, entries, messages::HISTORIES));
        }
        StatementKind::Ranges(entries) => during(Require, &|c| require_ranges(c, entries)),
        StatementKind::Kinetic(value) => during(Require, &of_dimension(*value, ENERGY, messages::KINETIC)),
        StatementKind::Potential(value) => {
            during(Require, &of_dimension(*value, ENERGY, messages::POTENTIAL));
        }
        StatementKind::Lagrangian(value) => {
            during(Require, &of_dimension(*value, ENERGY, messages::LAGRANGIAN));
        }
        StatementKind::Gibbs { function, stated } => {
            during(Require, &of_dimension(*function, GIBBS, messages::GIBBS));
            during(Require, &of_dimension(*stated, ENERGY, messages::LAGRANGIAN));
        }
        StatementKind::Dissipation(value) => {
            during(Require, &of_dimension(*value, POWER, messages::DISSIPATION));
        }
        StatementKind::Stabilise(rate) => {
            during(Require, &of_dimension(*rate, FREQUENCY, messages::STABILISE));
        }
        StatementKind::StateRate(name, value) => during(Require, &|c| require_rate(c, name, *value, place)),
        StatementKind::RateEquation(difference) => during(Require, &|c| drop(c.value(*difference))),
        StatementKind::ForceOn(name, force) => during(Require, &|c| require_force_on(c, name, *force, place)),
        StatementKind::ForceAt { force, point } => {
            during(Require, &|c| require_force_at(c, [*force, *point], place));
        }
        StatementKind::ForceAlong { force, velocity } => during(Require, &|c| {
            let along = c.value(*velocity).with_rates(true);
            require_work(c, *force, &along, &reason(messages::FORCE_ALONG));
        }),
        StatementKind::Torque { moment, angle } => during(Require, &|c| {
            let along = c.value(*angle);
            require_work(c, *moment, &along, &reason(messages::TORQUE));
        }),
        StatementKind::Output(name, value) => during(Require, &|c| require_output(c, name, *value)),
        StatementKind::Reduce(reduction) => during(Require, &|c| require_reduction(c, reduction, place)),
        // Statements without dimensions, and those that earlier phases replace: loops, bodies and
        // functions with a formula.
        StatementKind::Emit(_)
        | StatementKind::Function(_)
        | StatementKind::Block(_)
        | StatementKind::Scene(_) => {}
    }
}

/// Returns the key of an output; outputs have separate names.
pub(super) fn output_key(name: &str) -> String {
    format!("output {name}")
}

/// Returns the form of a force along a slip velocity.
fn form_of_force(slip: &Exponents) -> Exponents {
    form(POWER).over(slip)
}
