//! Cost of emitted code to the compiler, and from where on it is worth a warning or too much.
//!
//! Emitted methods are straight-line code, so that the compiler's time and memory are proportional
//! to their size. The rates were measured with `tools/compile_time.py --large`;
//! `docs/performance.md` shows from what.

use super::messages;
use crate::derive::most_coupled;
use crate::model::{Model, Product};
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::limits::{
    MANY_OPERATIONS, MAX_CONSTRAINTS, MAX_DEPENDENT_CONSTRAINTS, MAX_EVENTS, MAX_OPERATIONS, MAX_OUTPUTS,
    MAX_STATES, MAX_VELOCITIES,
};
use lagrange_language::syntax::ast::{Declaration, Name, StatementKind};

/// Seconds of an unoptimised `cargo check` for a unit of size.
const SECONDS_TO_CHECK: f64 = 45e-6;
/// Seconds that an optimised build takes in addition if every method is called.
const SECONDS_TO_OPTIMISE: f64 = 200e-6;
/// Bytes that the compiler needs.
const BYTES: f64 = 3500.0;

/// Size of emitted code: the operations of all methods, and the numbers that they return.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub(in crate::emit) struct Size(usize);

impl Size {
    pub(in crate::emit) fn add(&mut self, counts: OperationCounts, results: usize) {
        self.0 += counts.total() + results;
    }

    /// True if the compiler could not be expected to finish.
    pub(in crate::emit) fn is_hopeless(self) -> bool {
        self.0 > MAX_OPERATIONS
    }
}

/// Warns of a system that takes long to compile.
pub(in crate::emit) fn report_cost(declaration: &Declaration, Size(size): Size, report: &mut Report) {
    if size <= MANY_OPERATIONS {
        return;
    }
    let of_size = |rate: f64| rate * size as f64;
    let message =
        messages::expensive(size, of_size(SECONDS_TO_CHECK), of_size(SECONDS_TO_OPTIMISE), of_size(BYTES));
    report.expensive(declaration.name.span, message).help(messages::expensive_help());
}

/// Reports more of a kind than can be derived, at the first one too many, before anything is found
/// out about them.
pub fn report_too_many(declaration: &Declaration, report: &mut Report) -> Option<()> {
    let names = |of: fn(&StatementKind) -> Vec<&Name>| {
        declaration.statements.iter().flat_map(|statement| of(&statement.kind)).collect::<Vec<_>>()
    };
    let kinds = [
        (names(velocities), "velocities", MAX_VELOCITIES, messages::FEWER_HELP),
        (names(states), "states", MAX_STATES, messages::FEWER_HELP),
        (names(constraints), "constraints", MAX_CONSTRAINTS, messages::FEWER_HELP),
        (names(outputs), "outputs", MAX_OUTPUTS, messages::FEWER_OUTPUTS_HELP),
        (names(events), "events", MAX_EVENTS, messages::FEWER_EVENTS_HELP),
    ];
    let excess = kinds.into_iter().find(|(names, _, most, _)| names.len() > *most);
    let Some((names, kind, most, help)) = excess else { return Some(()) };
    let message = match kind {
        "events" => messages::too_many_events(most),
        _ => messages::too_many(names.len(), kind, most),
    };
    report.error(names[most].span, message).help(help);
    None
}

fn velocities(kind: &StatementKind) -> Vec<&Name> {
    match kind {
        StatementKind::Coordinates(list) => list.iter().map(|definition| &definition.name).collect(),
        StatementKind::Quaternion(quaternion) => quaternion.velocities.iter().collect(),
        _ => Vec::new(),
    }
}

fn states(kind: &StatementKind) -> Vec<&Name> {
    match kind {
        StatementKind::States(list) => list.iter().map(|definition| &definition.name).collect(),
        _ => Vec::new(),
    }
}

fn constraints(kind: &StatementKind) -> Vec<&Name> {
    match kind {
        StatementKind::Constraint(name, _) => vec![name],
        _ => Vec::new(),
    }
}

fn outputs(kind: &StatementKind) -> Vec<&Name> {
    match kind {
        StatementKind::Output(name, _) => vec![name],
        _ => Vec::new(),
    }
}

/// Friction that sticks and slips is an event, too.
fn events(kind: &StatementKind) -> Vec<&Name> {
    match kind {
        StatementKind::Event(event) => vec![&event.name],
        StatementKind::Friction(friction) if friction.width.is_none() => vec![&friction.name],
        _ => Vec::new(),
    }
}

/// Reports a model that requires more code than can be emitted, before anything is derived from it.
/// `None` if there is no point in deriving. Estimates are:
/// - for methods, about as many operations as energies have expressions;
/// - for Jacobians, an entry for each row and column;
/// - for mass matrices, an entry for every two velocities that move the same part.
pub fn report_hopeless_model(declaration: &Declaration, model: &Model, report: &mut Report) -> Option<()> {
    let excess = model.constraints.len().saturating_sub(model.speeds.len());
    if excess > MAX_DEPENDENT_CONSTRAINTS {
        let message =
            messages::too_many(excess, "constraints more than velocities", MAX_DEPENDENT_CONSTRAINTS);
        report.error(declaration.name.span, message).help(messages::FEWER_CONSTRAINTS_HELP);
        return None;
    }
    let (state, fields) =
        (model.coordinates.len() + model.speeds.len(), model.parameters.len() + model.inputs.len());
    let jacobians = [
        (Product::Jacobian, state),
        (Product::TangentJacobian, state),
        (Product::ParameterJacobian, fields),
        (Product::SystemMatrix, state + model.inputs.len()),
    ];
    let wanted = jacobians.into_iter().filter(|(product, _)| model.products.contains(product));
    let entries = wanted.map(|(_, columns)| state.saturating_mul(columns)).fold(0, usize::saturating_add);
    let has_matrix = model.products.contains(&Product::MassMatrix);
    let entries = entries.saturating_add(if has_matrix { coupled_by_one_square(model) } else { 0 });
    if Size(model.graph.len().max(entries)).is_hopeless() {
        report_hopeless(declaration, report);
        return None;
    }
    Some(())
}

/// A lower bound of the entries of the mass matrix.
fn coupled_by_one_square(model: &Model) -> usize {
    most_coupled(model, MAX_OPERATIONS.isqrt() + 1).pow(2)
}

/// Reports a system that is too large to be compiled.
pub(in crate::emit) fn report_hopeless(declaration: &Declaration, report: &mut Report) {
    report.error(declaration.name.span, messages::hopeless(MAX_OPERATIONS)).help(messages::smaller());
}
