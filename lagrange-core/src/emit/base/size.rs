//! Cost of emitted code to the compiler, and the limits for warnings and errors.
//!
//! Emitted methods are straight-line code, so the compiler's time and memory are proportional to
//! their size. The rates were measured with `tools/compile_time.py --large`; `docs/performance.md`
//! shows the measurements.

use super::messages;
use crate::derive::most_coupled;
use crate::model::{Model, Product};
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::limits::{
    MANY_OPERATIONS, MAX_CONSTRAINTS, MAX_CONTACT_PAIRS, MAX_CONTACTS, MAX_DEPENDENT_CONSTRAINTS, MAX_EVENTS,
    MAX_LOCATED, MAX_OPERATIONS, MAX_OUTPUTS, MAX_STATES, MAX_VELOCITIES,
};
use lagrange_language::syntax::ast::{Action, Declaration, Name, Statement, StatementKind};

/// Contacts and friction with an event of their own each; if there are more, they share one.
pub const MAX_CONTACT_EVENTS: usize = 64;
const _: () = assert!(MAX_EVENTS + MAX_CONTACT_EVENTS <= MAX_LOCATED);

/// Seconds that `cargo check` takes for a unit of size.
const SECONDS_TO_CHECK: f64 = 45e-6;
/// Additional seconds of an optimised build in which every method is called.
const SECONDS_TO_OPTIMISE: f64 = 200e-6;
/// Bytes that the compiler needs for a unit of size.
const BYTES: f64 = 3500.0;

/// Size of emitted code: the operations of all methods, and the numbers that they return.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub(in crate::emit) struct Size(usize);

impl Size {
    pub(in crate::emit) fn add(&mut self, counts: OperationCounts, results: usize) {
        self.0 += counts.total() + results;
    }

    /// True if the compiler cannot be expected to finish.
    pub(in crate::emit) fn is_hopeless(self) -> bool {
        self.0 > MAX_OPERATIONS
    }
}

/// Warns about a system that takes long to compile.
pub(in crate::emit) fn report_cost(declaration: &Declaration, Size(size): Size, report: &mut Report) {
    if size <= MANY_OPERATIONS {
        return;
    }
    let of_size = |rate: f64| rate * size as f64;
    let (checking, optimising) = (of_size(SECONDS_TO_CHECK), of_size(SECONDS_TO_OPTIMISE));
    let message = messages::expensive(size, checking, optimising, of_size(BYTES) / 1e9);
    report.expensive(declaration.name.span, message).help(messages::expensive_help(messages::SMALLER));
}

/// A kind of declared names whose number is limited.
struct Kind {
    plural: &'static str,
    /// The names of the kind that a statement declares.
    names: fn(&StatementKind) -> Vec<&Name>,
    most: usize,
    help: &'static str,
}

const KINDS: [Kind; 6] = [
    Kind { plural: "velocities", names: velocities, most: MAX_VELOCITIES, help: messages::FEWER_HELP },
    Kind { plural: "states", names: states, most: MAX_STATES, help: messages::FEWER_HELP },
    Kind { plural: "constraints", names: constraints, most: MAX_CONSTRAINTS, help: messages::FEWER_HELP },
    Kind { plural: "outputs", names: outputs, most: MAX_OUTPUTS, help: messages::FEWER_OUTPUTS_HELP },
    Kind { plural: "contacts", names: contacts, most: MAX_CONTACTS, help: messages::FEWER_CONTACTS_HELP },
    Kind { plural: "events", names: events, most: MAX_EVENTS, help: messages::FEWER_EVENTS_HELP },
];

/// Reports an excessive number of names of a kind, at the first one beyond the limit, before any
/// further processing.
pub fn report_too_many(declaration: &Declaration, report: &mut Report) -> Option<()> {
    for Kind { plural, names, most, help } in KINDS {
        let names = declaration.statements.iter().flat_map(|statement| names(&statement.kind));
        let names = names.collect::<Vec<_>>();
        let Some(first) = names.get(most) else { continue };
        let message = match plural {
            "events" => messages::too_many_events(most),
            _ => messages::too_many(names.len(), plural, most),
        };
        report.error(first.span, message).help(help);
        return None;
    }
    report_too_many_pairs(declaration, report)
}

/// Reports a system whose steps would take too much memory.
fn report_too_many_pairs(declaration: &Declaration, report: &mut Report) -> Option<()> {
    let all = |names: fn(&StatementKind) -> Vec<&Name>| -> Vec<_> {
        declaration.statements.iter().flat_map(|statement| names(&statement.kind)).collect()
    };
    let (contacts, velocities) = (all(contacts), all(velocities));
    if !shares_event(declaration) || contacts.len() * velocities.len() <= MAX_CONTACT_PAIRS {
        return Some(());
    }
    let message = messages::too_many_pairs(contacts.len(), velocities.len());
    report.error(contacts[0].span, message).help(messages::fewer_pairs_help(MAX_CONTACT_PAIRS));
    None
}

/// Drops statements beyond the limits. A rejected declaration may have many more names, and its
/// skeleton would have members for each of them.
pub(in crate::emit) fn drop_excess(statements: &mut Vec<Statement>) {
    let mut counts = KINDS.map(|_| 0);
    statements.retain(|statement| {
        let mut counted = KINDS.iter().zip(&mut counts);
        counted.all(|(kind, count)| {
            let (own, before) = ((kind.names)(&statement.kind).len(), *count);
            *count += own;
            own == 0 || before < kind.most
        })
    });
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
        StatementKind::States(_, list) => list.iter().map(|definition| &definition.name).collect(),
        StatementKind::Mode(mode) => vec![&mode.name],
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

/// True if contacts and friction share one event.
pub(in crate::emit) fn shares_event(declaration: &Declaration) -> bool {
    let counts = declaration.statements.iter().map(|statement| contacts(&statement.kind).len());
    counts.sum::<usize>() > MAX_CONTACT_EVENTS
}

/// Returns the names of events, except those of contacts.
fn events(kind: &StatementKind) -> Vec<&Name> {
    match kind {
        StatementKind::Event(event) if !matches!(event.action, Action::Impact(_)) => vec![&event.name],
        _ => Vec::new(),
    }
}

/// Returns the names of contacts, and of friction that sticks and slips.
fn contacts(kind: &StatementKind) -> Vec<&Name> {
    match kind {
        StatementKind::Event(event) if matches!(event.action, Action::Impact(_)) => vec![&event.name],
        StatementKind::Friction(friction) if friction.width.is_none() => vec![&friction.name],
        _ => Vec::new(),
    }
}

/// Reports a model that requires more code than can be emitted, before anything is derived from it.
/// `None` if derivation would be pointless. Estimates are:
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
    let velocities = model.speeds.len();
    let matrices = [
        (Product::Jacobian, [state, state]),
        (Product::TangentJacobian, [state, state]),
        (Product::ParameterJacobian, [state, fields]),
        (Product::SystemMatrix, [state, state + model.inputs.len()]),
        (Product::EventJacobian, [model.events.len(), state]),
        (Product::LagrangianHessian, [state, state]),
        (Product::InverseMassMatrix, [velocities, velocities]),
        (Product::InverseDynamicsJacobian, [velocities, state]),
        (Product::CoriolisMatrix, [velocities, velocities]),
    ];
    let wanted = matrices.into_iter().filter(|(product, _)| model.products.contains(product));
    let entries =
        wanted.map(|(_, [rows, columns])| rows.saturating_mul(columns)).fold(0, usize::saturating_add);
    let has_matrix = model.products.contains(&Product::MassMatrix);
    let entries = entries.saturating_add(if has_matrix { coupled_by_one_square(model) } else { 0 });
    if Size(model.graph.len().max(entries)).is_hopeless() {
        report_hopeless(declaration, report);
        return None;
    }
    Some(())
}

/// Returns a lower bound on the number of entries of the mass matrix.
fn coupled_by_one_square(model: &Model) -> usize {
    most_coupled(model, MAX_OPERATIONS.isqrt() + 1).pow(2)
}

/// Reports a system that is too large to be compiled.
pub(in crate::emit) fn report_hopeless(declaration: &Declaration, report: &mut Report) {
    report.error(declaration.name.span, messages::hopeless(MAX_OPERATIONS)).help(messages::SMALLER);
}
