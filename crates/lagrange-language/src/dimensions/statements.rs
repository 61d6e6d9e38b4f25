//! Dimensions required by statements.

mod definitions;

use super::calls::total;
use super::checker::Checker;
use super::exponents::Exponents;
use super::kinds::{ENERGY, FORCE, FREQUENCY, GIBBS, LENGTH, POWER, TIME};
use super::labels::Label;
use super::measure::Measure;
use super::messages;
use super::quantities::is_of_numbers;
use super::solver::Grounds;
use crate::syntax::ast::{
    Action, ArrayShape, Assignment, AstId, Declaration, Definition, Event, Friction, Name, Reduction,
    Statement, StatementKind,
};
use definitions::{
    declared, define_table, define_unknowns, define_value, named_component, named_value, require_start,
    value_of,
};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::number::Number;
use lagrange_expr::units::Dimension;

fn form(exponents: [i8; 7]) -> Exponents {
    Exponents::from(Dimension::of(exponents))
}

/// The passes over plain statements, in this order. Between the last two, the dimensions of labels
/// are required.
#[derive(Clone, Copy, PartialEq, Eq)]
enum DimensionPass {
    /// Names whose dimensions are declared, or determined by their use.
    Declare,
    /// Names that stand for expressions, and named forces.
    Abbreviate,
    /// Conditions that statements impose on expressions.
    Require,
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
    let go_through = |checker: &mut Checker<'_>, pass| {
        let statements = declaration.statements.iter();
        let statements =
            statements.filter(|statement| pass == DimensionPass::Declare || !is_computed(statement));
        statements.for_each(|statement| visit(checker, statement, pass));
    };
    go_through(checker, DimensionPass::Declare);
    go_through(checker, DimensionPass::Abbreviate);
    for label in labels {
        let expected = Some(Exponents::from(label.unit.dimension.clone()));
        let expected = Measure::of(ArrayShape::Scalar, vec![expected; 3]);
        let reason =
            Grounds { words: messages::labelled(label.what), place: checker.expressions.origin(label.value) };
        checker.require(label.value, &expected, &reason);
    }
    go_through(checker, DimensionPass::Require);
}

/// Performs a pass for a statement.
fn visit(checker: &mut Checker<'_>, statement: &Statement, pass: DimensionPass) {
    let place = Origin::from(statement.origin.start);
    let said = |words: &str| Grounds { words: words.to_owned(), place };
    match (&statement.kind, pass) {
        (StatementKind::Parameters(list) | StatementKind::Inputs(list), DimensionPass::Declare) => {
            list.iter().for_each(|definition| define_value(checker, definition));
        }
        (StatementKind::Constants(list), DimensionPass::Declare) => {
            list.iter().for_each(|definition| define_value(checker, definition));
            let values = list.iter().filter_map(|definition| Some((&definition.name, definition.value?)));
            values.for_each(|(name, value)| checker.define_constant(&name.text, value));
        }
        (
            StatementKind::Coordinates(list) | StatementKind::States(_, list) | StatementKind::Noises(list),
            DimensionPass::Declare,
        ) => {
            for Definition { name, .. } in list {
                let form = declared(checker, name);
                checker.scope.insert(name.text.clone(), Measure::known(form));
            }
        }
        (StatementKind::Mode(mode), DimensionPass::Declare) => {
            for Name { text, .. } in [&mode.name].into_iter().chain(&mode.values) {
                checker.scope.insert(text.clone(), Measure::known(form([0; 7])));
            }
        }
        (StatementKind::Noises(list), DimensionPass::Require) => {
            list.iter().for_each(|definition| demand_of_noise(checker, definition));
        }
        (StatementKind::Coordinates(list) | StatementKind::States(_, list), DimensionPass::Require) => {
            for Definition { name, range, nominal, value } in list {
                let known = checker.scope.get(&name.text).cloned().unwrap_or_else(Measure::any);
                let limits = range.limits().map(|limit| limit.value);
                for value in limits.chain(*nominal).chain(*value) {
                    require_start(checker, value, &known, &value_of(name));
                }
            }
        }
        (StatementKind::Start(assignments), DimensionPass::Require) => {
            require_entries(checker, assignments, messages::STARTS);
        }
        (StatementKind::History(assignments), DimensionPass::Require) => {
            require_entries(checker, assignments, messages::HISTORIES);
        }
        (StatementKind::Ranges(entries), DimensionPass::Require) => {
            for entry in entries {
                let target = checker.value(entry.target);
                let place = checker.expressions.origin(entry.target);
                let reason = Grounds { words: messages::RANGES.to_owned(), place };
                entry.values().for_each(|value| require_start(checker, value, &target, &reason));
            }
        }
        (StatementKind::Quaternion(quaternion), DimensionPass::Declare) => {
            for name in &quaternion.positions {
                checker.scope.insert(name.text.clone(), Measure::known(Exponents::plain()));
            }
            for name in &quaternion.velocities {
                checker.scope.insert(name.text.clone(), Measure::known(form(FREQUENCY)).with_rates(true));
            }
        }
        (StatementKind::External(function), DimensionPass::Declare) => {
            let columns = function.parameters.iter().chain([&function.name]);
            let columns = columns.map(|name| declared(checker, name)).collect();
            checker.callables.insert(function.name.text.clone(), columns);
        }
        (StatementKind::Table(table), DimensionPass::Declare) => define_table(checker, table),
        (
            StatementKind::Let(name, value) | StatementKind::Velocity(name, value),
            DimensionPass::Abbreviate,
        ) => {
            let value = named_value(checker, name, *value);
            checker.scope.insert(name.text.clone(), value);
        }
        (StatementKind::Delay { name, signal, .. }, DimensionPass::Abbreviate) => {
            let value = named_value(checker, name, *signal);
            checker.scope.insert(name.text.clone(), value);
        }
        (StatementKind::Delay { lag, .. }, DimensionPass::Require) => {
            checker.require_dimension(*lag, &Dimension::of(TIME), &said(messages::LAG));
        }
        (StatementKind::Solve(unknowns), DimensionPass::Abbreviate) => define_unknowns(checker, unknowns),
        (kind @ StatementKind::LetTuple(names, value), DimensionPass::Abbreviate) => {
            let parts = kind.named_expressions(checker.expressions);
            let whole = checker.value(*value);
            for (i, name) in names.iter().enumerate() {
                let value = match parts.get(i) {
                    Some((_, part)) => named_value(checker, name, *part),
                    None => named_component(checker, name, *value, whole.entry(&[i])),
                };
                checker.scope.insert(name.text.clone(), value.with_rates(whole.has_rates));
            }
        }
        (StatementKind::Constraint(name, value), DimensionPass::Abbreviate) => {
            let value = checker.value(*value);
            name_force(checker, name, &value);
        }
        (
            StatementKind::Event(Event { name, value, action: Action::Impact(_), .. }),
            DimensionPass::Abbreviate,
        ) => {
            let gap = checker.value(*value);
            name_force(checker, name, &gap);
        }
        (StatementKind::Friction(Friction { name, slip, .. }), DimensionPass::Abbreviate) => {
            let slip = checker.value(*slip).with_rates(true);
            name_force(checker, name, &slip);
            if !slip.is_scalar() {
                let force = slip.map(form_of_force);
                checker.scope.insert(name.text.clone(), Measure::vector(force.components));
            }
        }
        (StatementKind::Kinetic(value), DimensionPass::Require) => {
            energy(checker, *value, &said(messages::KINETIC));
        }
        (StatementKind::Potential(value), DimensionPass::Require) => {
            energy(checker, *value, &said(messages::POTENTIAL));
        }
        (StatementKind::Lagrangian(value), DimensionPass::Require) => {
            energy(checker, *value, &said(messages::LAGRANGIAN));
        }
        (StatementKind::Gibbs { function, stated }, DimensionPass::Require) => {
            checker.require_dimension(*function, &Dimension::of(GIBBS), &said(messages::GIBBS));
            energy(checker, *stated, &said(messages::LAGRANGIAN));
        }
        (StatementKind::Dissipation(value), DimensionPass::Require) => {
            checker.require_dimension(*value, &Dimension::of(POWER), &said(messages::DISSIPATION));
        }
        (StatementKind::StateRate(name, value), DimensionPass::Require) => {
            let state = checker.scope.get(&name.text).cloned().unwrap_or_else(Measure::any);
            checker.require(*value, &state.map(rate), &said(&messages::rate_of(&name.text)));
        }
        (StatementKind::RateEquation(difference), DimensionPass::Require) => {
            checker.value(*difference);
        }
        (StatementKind::Stabilise(rate), DimensionPass::Require) => {
            checker.require_dimension(*rate, &Dimension::of(FREQUENCY), &said(messages::STABILISE));
        }
        (StatementKind::ForceOn(name, force), DimensionPass::Require) => {
            let along = checker.scope.get(&name.text).cloned().unwrap_or_else(Measure::any);
            work(checker, *force, &along, &said(&messages::force_on(&name.text)));
        }
        (StatementKind::ForceAt { force, point }, DimensionPass::Require) => {
            let each = |exponents| Measure::vector(vec![Some(form(exponents)); 3]);
            checker.require(*point, &each(LENGTH), &said(messages::POINT));
            checker.require(*force, &each(FORCE), &said(messages::FORCE));
        }
        (StatementKind::ForceAlong { force, velocity }, DimensionPass::Require) => {
            let along = checker.value(*velocity).with_rates(true);
            work(checker, *force, &along, &said(messages::FORCE_ALONG));
        }
        (StatementKind::Torque { moment, angle }, DimensionPass::Require) => {
            let along = checker.value(*angle);
            work(checker, *moment, &along, &said(messages::TORQUE));
        }
        (StatementKind::Every(clock), DimensionPass::Require) => {
            checker.require_dimension(clock.period, &Dimension::of(TIME), &said(messages::PERIOD));
            demand_of_assignments(checker, &clock.assignments);
        }
        (StatementKind::Event(event), DimensionPass::Require) => demand_of_event(checker, event, place),
        (StatementKind::Friction(friction), DimensionPass::Require) => {
            demand_of_friction(checker, friction, place);
        }
        (StatementKind::Output(name, value), DimensionPass::Require) => {
            let value = named_value(checker, name, *value);
            checker.scope.insert(output_key(&name.text), value);
        }
        (StatementKind::Reduce(reduction), DimensionPass::Require) => {
            demand_of_reduction(checker, reduction, place);
        }
        // These only concern other passes, or none: loops, bodies and functions with a formula no
        // longer exist.
        (
            StatementKind::Parameters(_)
            | StatementKind::Inputs(_)
            | StatementKind::Constants(_)
            | StatementKind::Quaternion(_)
            | StatementKind::External(_)
            | StatementKind::Table(_),
            DimensionPass::Abbreviate | DimensionPass::Require,
        )
        | (
            StatementKind::Let(..)
            | StatementKind::Velocity(..)
            | StatementKind::Solve(_)
            | StatementKind::LetTuple(..)
            | StatementKind::Constraint(..),
            DimensionPass::Declare | DimensionPass::Require,
        )
        | (
            StatementKind::Kinetic(_)
            | StatementKind::Potential(_)
            | StatementKind::Lagrangian(_)
            | StatementKind::Gibbs { .. }
            | StatementKind::Dissipation(_)
            | StatementKind::StateRate(..)
            | StatementKind::RateEquation(_)
            | StatementKind::Stabilise(_)
            | StatementKind::ForceOn(..)
            | StatementKind::ForceAt { .. }
            | StatementKind::ForceAlong { .. }
            | StatementKind::Torque { .. }
            | StatementKind::Event(_)
            | StatementKind::Every(_)
            | StatementKind::Output(..)
            | StatementKind::Reduce(_),
            DimensionPass::Declare | DimensionPass::Abbreviate,
        )
        | (
            StatementKind::Coordinates(_) | StatementKind::States(..) | StatementKind::Noises(_),
            DimensionPass::Abbreviate,
        )
        | (StatementKind::Mode(_), DimensionPass::Abbreviate | DimensionPass::Require)
        | (
            StatementKind::Start(_) | StatementKind::History(_) | StatementKind::Ranges(_),
            DimensionPass::Declare | DimensionPass::Abbreviate,
        )
        | (StatementKind::Friction(_) | StatementKind::Delay { .. }, DimensionPass::Declare)
        | (
            StatementKind::Function(_)
            | StatementKind::Block(_)
            | StatementKind::Scene(_)
            | StatementKind::Emit(_),
            _,
        ) => {}
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

/// Names the force of a constraint, a contact or friction. The quantity on which it does work is
/// known.
fn name_force(checker: &mut Checker<'_>, name: &Name, along: &Measure) {
    let work = form(if along.has_rates { POWER } else { ENERGY });
    let force = along.form().map(|form| work.over(&form));
    checker.scope.insert(name.text.clone(), Measure::scalar(force));
}

/// Returns the key of an output; outputs have separate names.
pub(super) fn output_key(name: &str) -> String {
    format!("output {name}")
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

/// Returns the form of a force along a slip velocity.
fn form_of_force(slip: &Exponents) -> Exponents {
    form(POWER).over(slip)
}

/// Returns the form of the rate of a coordinate.
fn rate(coordinate: &Exponents) -> Exponents {
    coordinate.times_power(&form(FREQUENCY), &Number::ONE)
}
