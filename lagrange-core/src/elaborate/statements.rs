//! Dispatch of each statement to the function that handles it.

use super::carried::{MOTION, report_carried_rate};
use super::constraints::add_constraint;
use super::coordinates::{define_coordinate, define_quaternion, name_velocity};
use super::definitions::{define_abbreviation, define_abbreviations, define_constant, define_parameter};
use super::delays::define_delay;
use super::elaborator::Elaborator;
use super::events::{add_clock, add_event};
use super::expression::value_of;
use super::gibbs::add_gibbs;
use super::history::add_history;
use super::limits::add_limits;
use super::loads::{add_force_along, add_force_at, add_force_on, add_torque};
use super::messages;
use super::noise::define_noise;
use super::operand::Operand;
use super::rate_equations::add_rate_equation;
use super::reactions::add_friction;
use super::reductions::add_reduction;
use super::scope::NameKind;
use super::solve::define_unknowns;
use super::stabilisation::set_stabilisation;
use super::start::{add_declared_entry, add_start};
use super::states::{add_state_rate, define_mode, define_state};
use super::tables::define_table;
use crate::model::{Output, Product};
use lagrange_expr::diagnostics::nearest;
use lagrange_expr::expr::{Dependencies, ExprId, Graph};
use lagrange_expr::number::Number;
use lagrange_language::syntax::ast::{AstId, EmitItem, Name, Statement, StatementKind};

/// Methods that every system has; outputs must not use their names.
const GENERATED_METHODS: [&str; 9] = [
    "acceleration",
    "rhs",
    "multipliers",
    "constraints",
    "EQUATIONS_LATEX",
    "KERNEL_F32",
    "KERNEL_F64",
    "PARAMETERS",
    "STATEMENTS",
];

pub(super) fn add_statement(elaborator: &mut Elaborator<'_>, statement: &Statement) {
    let keyword = statement.origin.start;
    match &statement.kind {
        StatementKind::Parameters(list) => {
            list.iter().for_each(|d| define_parameter(elaborator, d, NameKind::Parameter));
        }
        StatementKind::Inputs(list) => {
            list.iter().for_each(|d| define_parameter(elaborator, d, NameKind::Input));
        }
        StatementKind::Noises(list) => list.iter().for_each(|d| define_noise(elaborator, d)),
        StatementKind::Constants(list) => list.iter().for_each(|d| define_constant(elaborator, d)),
        StatementKind::Coordinates(list) => {
            for definition in list {
                define_coordinate(elaborator, &definition.name);
                add_declared_entry(elaborator, definition);
            }
        }
        StatementKind::States(kind, list) => {
            for definition in list {
                define_state(elaborator, &definition.name, *kind);
                add_declared_entry(elaborator, definition);
            }
        }
        StatementKind::Mode(mode) => define_mode(elaborator, mode),
        StatementKind::History(list) => {
            list.iter().for_each(|assignment| add_history(elaborator, assignment));
        }
        StatementKind::Start(list) => list.iter().for_each(|assignment| add_start(elaborator, assignment)),
        StatementKind::Ranges(list) => list.iter().for_each(|entry| add_limits(elaborator, entry)),
        StatementKind::StateRate(name, value) => add_state_rate(elaborator, name, *value),
        StatementKind::RateEquation(difference) => add_rate_equation(elaborator, *difference),
        StatementKind::Quaternion(quaternion) => define_quaternion(elaborator, quaternion),
        StatementKind::Delay { name, signal, lag } => define_delay(elaborator, name, [*signal, *lag]),
        StatementKind::Velocity(name, value) => name_velocity(elaborator, name, *value),
        StatementKind::Let(name, value) => define_abbreviation(elaborator, name, *value),
        StatementKind::LetTuple(names, value) => define_abbreviations(elaborator, names, *value),
        StatementKind::Kinetic(value) => {
            let term = elaborator.term(*value, keyword, "the kinetic energy");
            report_carried_rate(&mut elaborator.evaluator, *value, MOTION);
            elaborator.kinetic.extend(term);
        }
        StatementKind::Potential(value) => {
            let term = elaborator.term(*value, keyword, "the potential energy");
            elaborator.potential.extend(term);
        }
        StatementKind::Lagrangian(value) => {
            let term = elaborator.term(*value, keyword, "the Lagrangian");
            report_carried_rate(&mut elaborator.evaluator, *value, MOTION);
            elaborator.lagrangian.extend(term);
        }
        StatementKind::Gibbs { function, stated } => add_gibbs(elaborator, *function, *stated, keyword),
        StatementKind::Dissipation(value) => {
            let term = elaborator.term(*value, keyword, "the dissipation function");
            report_carried_rate(&mut elaborator.evaluator, *value, Dependencies::VELOCITY);
            elaborator.dissipation.extend(term);
        }
        StatementKind::ForceOn(coordinate, value) => add_force_on(elaborator, coordinate, *value),
        StatementKind::ForceAt { force, point } => add_force_at(elaborator, *force, *point),
        StatementKind::ForceAlong { force, velocity } => add_force_along(elaborator, *force, *velocity),
        StatementKind::Torque { moment, angle } => add_torque(elaborator, *moment, *angle, keyword),
        StatementKind::Constraint(name, value) => add_constraint(elaborator, name, *value),
        StatementKind::Stabilise(rate) => set_stabilisation(elaborator, *rate, keyword),
        StatementKind::Event(event) => add_event(elaborator, event),
        StatementKind::Every(clock) => add_clock(elaborator, clock, keyword),
        StatementKind::Friction(friction) => add_friction(elaborator, friction),
        StatementKind::Output(name, value) => add_output(elaborator, name, *value),
        StatementKind::Emit(items) => items.iter().for_each(|item| add_product(elaborator, item)),
        StatementKind::Reduce(reduction) => add_reduction(elaborator, reduction),
        StatementKind::Table(table) => define_table(elaborator, table),
        StatementKind::Solve(unknowns) => define_unknowns(elaborator, unknowns),
        // Scenes were replaced by plain statements, calls by values, and loops by their statements.
        // Functions of the user's crate are already known.
        StatementKind::Scene(_)
        | StatementKind::Function(_)
        | StatementKind::External(_)
        | StatementKind::Block(_) => {}
    }
}

fn add_output(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId) {
    let value =
        value_of(&mut elaborator.evaluator, syntax).filter(|value| is_shown(elaborator, syntax, value));
    let mut methods = Product::ALL.iter().filter(|product| product.is_method());
    if methods.any(|method| method.name() == name.text) || GENERATED_METHODS.contains(&name.text.as_str()) {
        let error = elaborator.evaluator.report.error(name.span, messages::reserved_output(&name.text));
        error.help(messages::OTHER_NAME_HELP);
    }
    elaborator.declare(name, NameKind::Output, None);
    let Some(value) = value else { return };
    let graph = &elaborator.evaluator.graph;
    let uses = |kind| value.components().iter().any(|&c| graph.dependencies(c).intersects(kind));
    let uses_accelerations = uses(Dependencies::ACCELERATION);
    let uses_multipliers = uses(Dependencies::MULTIPLIER);
    let uses_reactions = uses(Dependencies::REACTION);
    let graph = &mut elaborator.evaluator.graph;
    let components = value.components().iter().map(|&component| displayed(graph, component, name)).collect();
    elaborator.outputs.push(Output {
        name: name.text.clone(),
        components,
        uses_accelerations,
        uses_multipliers,
        uses_reactions,
        description: None,
    });
}

/// True for scalars and vectors; matrices are reported.
fn is_shown(elaborator: &mut Elaborator<'_>, syntax: AstId, value: &Operand) -> bool {
    let is_matrix = matches!(value, Operand::Matrix(..));
    if is_matrix {
        let message = messages::matrix_output(value.kind());
        elaborator.evaluator.refuse::<()>(syntax, message, messages::MATRIX_OUTPUT_HELP);
    }
    !is_matrix
}

/// Converts an output to the unit after its name.
fn displayed(graph: &mut Graph, value: ExprId, name: &Name) -> ExprId {
    let Some(unit) = name.unit.as_ref().filter(|unit| !unit.is_coherent()) else { return value };
    let (scale, pi) = (graph.number(unit.scale.number.clone()), graph.pi());
    let below = graph.number(-&unit.offset);
    let value = graph.add(value, below);
    let factors = [(value, 1), (scale, -1), (pi, -unit.scale.pi)];
    graph.product(factors.map(|(factor, exponent)| (factor, Number::from(i64::from(exponent)))))
}

fn add_product(elaborator: &mut Elaborator<'_>, item: &EmitItem) {
    let name = item.product.text.as_str();
    if let Some(product) = Product::by_name(name) {
        elaborator.wanted.push((product, item.wanted, item.product.span));
        return;
    }
    let help = match nearest(name, Product::ALL.iter().map(|product| product.name())) {
        Some(nearest) => messages::names::did_you_mean(nearest),
        None => messages::products(),
    };
    elaborator.evaluator.report.error(item.product.span, messages::unknown_product(name)).help(help);
}
