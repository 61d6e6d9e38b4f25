//! Parts, before they are placed.

use std::collections::BTreeSet;
use std::rc::Rc;

use super::complaints::Complaints;
use super::messages;
use super::scopes::Interior;
use crate::syntax::ast::{
    Block, Expression, Expressions, MobilizerKind, Name, Nested, PartDefinition, SceneStatement, Statement,
    StatementKind, nested,
};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::diagnostics::{Origin, nearest};

/// A declared part, with the names in it.
#[derive(Clone)]
pub(super) struct Part<'d> {
    pub(super) definition: &'d PartDefinition,
    pub(super) interior: Rc<Interior>,
}

/// The parts of a declaration by name.
#[derive(Default)]
pub(super) struct Parts<'d>(OrderedMap<String, Part<'d>>);

impl<'d> Parts<'d> {
    /// Collects the parts that statements declare; errors in their heads are reported.
    pub(super) fn of(
        statements: &'d [Statement],
        expressions: &Expressions,
        complaints: &mut Complaints<'_>,
    ) -> Parts<'d> {
        let mut parts = Parts::default();
        for statement in statements {
            match &statement.kind {
                StatementKind::Block(Block::Part(part)) => parts.add(part, expressions, complaints),
                StatementKind::Block(block) => {
                    block.bodies().iter().for_each(|body| refuse(body, complaints));
                }
                _ => {}
            }
        }
        parts
    }

    /// Returns the part with this name.
    pub(super) fn find(&self, name: &str) -> Option<&Part<'d>> {
        self.0.get(&name.to_owned())
    }

    /// Returns all parts in the order of their declaration.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Part<'d>> {
        self.0.iter().map(|(_, part)| part)
    }

    /// Returns the name of the part that was probably intended.
    pub(super) fn nearest(&self, name: &str) -> Option<&str> {
        nearest(name, self.0.iter().map(|(known, _)| known.as_str()))
    }

    fn add(&mut self, part: &'d PartDefinition, expressions: &Expressions, complaints: &mut Complaints<'_>) {
        let name = &part.name;
        if let Some(first) = self.0.get(&name.text) {
            let first = Origin::from(first.definition.name.span);
            let error = complaints.report.error(name.span, messages::part_twice(&name.text));
            error.related(first, messages::FIRST_DECLARED).help(messages::OTHER_NAME_HELP);
            return;
        }
        if complaints.names.contains(&name.text) {
            let error = complaints.report.error(name.span, messages::part_and_declared(&name.text));
            error.help(messages::OTHER_NAME_HELP);
        }
        let mut interior = interior(part);
        check_arguments(part, expressions, complaints);
        for Nested { statement, .. } in nested(&part.body) {
            check_statement(statement, &interior, complaints);
        }
        // Errors about these are not repeated wherever the part is placed.
        let Interior { arguments, declared, .. } = &mut interior;
        declared.retain(|name| !arguments.contains(name));
        let part = Part { definition: part, interior: Rc::new(interior) };
        self.0.insert(name.text.clone(), part);
    }
}

/// Reports parts in loops, conditions and other parts.
fn refuse(statements: &[Statement], complaints: &mut Complaints<'_>) {
    for Nested { statement, .. } in nested(statements) {
        match &statement.kind {
            StatementKind::Block(Block::Part(part)) => {
                let error = complaints.report.error(part.name.span, messages::PART_INSIDE);
                error.help(messages::PART_INSIDE_HELP);
            }
            StatementKind::Block(Block::Include(path)) => {
                let error = complaints.report.error(path.span, messages::INCLUDE_INSIDE);
                error.help(messages::INCLUDE_INSIDE_HELP);
            }
            _ => {}
        }
    }
}

/// Returns the names in a part.
fn interior(part: &PartDefinition) -> Interior {
    let arguments = part.arguments.iter().map(|argument| argument.name.text.clone()).collect();
    let (mut declared, mut placed, mut external) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    for nested in nested(&part.body) {
        match &nested.statement.kind {
            StatementKind::Block(Block::Place(placement)) => {
                placed.insert(placement.name.text.clone());
            }
            StatementKind::External(function) => {
                external.insert(function.name.text.clone());
            }
            kind => {
                for (name, suffix) in nested.lasting_names() {
                    declared.insert(format!("{}{suffix}", name.text));
                    if !is_free(kind) {
                        declared.insert(name.text.clone());
                    }
                }
            }
        }
    }
    Interior { name: part.name.clone(), arguments, declared, placed, external }
}

/// True for a joint that names its coordinates after its body.
fn is_free(kind: &StatementKind) -> bool {
    matches!(kind, StatementKind::Scene(SceneStatement::Mobilizer(joint)) if joint.kind == MobilizerKind::Free)
}

fn check_arguments(part: &PartDefinition, expressions: &Expressions, complaints: &mut Complaints<'_>) {
    for (number, argument) in part.arguments.iter().enumerate() {
        let name = &argument.name;
        let (before, further) = part.arguments.split_at(number);
        if let Some(first) = before.iter().find(|other| other.name.text == name.text) {
            let error = complaints.report.error(name.span, messages::repeated_argument(&name.text));
            let first = Origin::from(first.name.span);
            error.related(first, messages::FIRST_DECLARED).help(messages::OTHER_NAME_HELP);
        }
        // Only earlier arguments are valid, so that no value depends on itself.
        for id in argument.default.into_iter().flat_map(|default| expressions.parts(default)) {
            let Expression::Name(used) = expressions.get(id) else { continue };
            if further.iter().any(|other| other.name.text == *used)
                && let Some(error) =
                    complaints.once(id, expressions.origin(id), messages::late_argument(used))
            {
                error.help(messages::late_argument_help(used));
            }
        }
    }
}

/// Reports a statement that is invalid in a part.
fn check_statement(statement: &Statement, interior: &Interior, complaints: &mut Complaints<'_>) {
    let kind = &statement.kind;
    let word = match kind {
        StatementKind::Emit(_) => Some("emit"),
        StatementKind::Reduce(_) => Some("reduce"),
        StatementKind::Stabilise(_) => Some("stabilise"),
        StatementKind::Block(Block::Include(_)) => Some("include"),
        StatementKind::Scene(SceneStatement::Gravity(_)) => Some("gravity"),
        StatementKind::Scene(SceneStatement::Contacts(_)) => Some("contacts"),
        _ => None,
    };
    if let Some(word) = word {
        let error = complaints.report.error(statement.origin, messages::outside_statement(word));
        error.help(messages::outside_statement_help(word));
    }
    if let StatementKind::Block(Block::Part(part)) = kind {
        let error = complaints.report.error(part.name.span, messages::PART_INSIDE);
        error.help(messages::PART_INSIDE_HELP);
    }
    let placed = match kind {
        StatementKind::Block(Block::Place(placement)) => Some(&placement.name),
        _ => None,
    };
    let declared = kind.written_names().into_iter().map(|(name, _)| name).chain(placed);
    for name in declared.filter(|name| interior.arguments.contains(&name.text)).take(1) {
        let (message, help) = match is_free(kind) {
            true => (messages::free_argument(&name.text), messages::free_argument_help(&name.text)),
            false => (
                messages::argument_as_name(&name.text, &interior.name.text),
                messages::OTHER_NAME_HELP.to_owned(),
            ),
        };
        complaints.report.error(name.span, message).help(help);
    }
    check_placed(placed, interior, complaints);
}

/// Reports a placed part with the name of something else in the same part.
fn check_placed(placed: Option<&Name>, interior: &Interior, complaints: &mut Complaints<'_>) {
    if let Some(name) = placed.filter(|name| interior.declared.contains(&name.text)) {
        let error = complaints.report.error(name.span, messages::part_and_name(&name.text));
        error.help(messages::OTHER_NAME_HELP);
    }
}
