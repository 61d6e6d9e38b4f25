//! Statements that declare springs and dampers.

use super::ast::{AstId, Connector, ConnectorKind};
use super::blocks::BlockLabels;
use super::cursor::Cursor;
use super::messages::forms::form;
use super::parser::{Parsed, Parser};

const SPRING: &[&str] = &["from", "to", "stiffness", "rest"];
const DAMPER: &[&str] = &["from", "to", "damping"];

impl Parser<'_> {
    /// Reads `name { from: e; to: e; … }`, with or without the name.
    pub(super) fn connector(&mut self, kind: ConnectorKind, cursor: &mut Cursor) -> Parsed<Connector> {
        let help = form(kind.name());
        let name = match cursor.ident() {
            None => None,
            Some(_) => Some(self.scene_name(help, cursor)?),
        };
        let start = cursor.here();
        let group = self.braces(help, cursor)?;
        let mut connector =
            Connector { kind, name, from: None, to: None, stiffness: None, rest: None, damping: None };
        let labels = BlockLabels::new(owner(kind), labels(kind));
        let complete = self.values(&group, labels, &mut connector, value_at);
        if !complete {
            let origin = connector.name.as_ref().map_or(start, |name| name.span.into());
            let Connector { from, to, stiffness, damping, .. } = &mut connector;
            let constant = if is_spring(kind) { stiffness } else { damping };
            [from, to, constant].into_iter().for_each(|value| self.missing(value, origin));
        }
        Ok(connector)
    }
}

/// Returns the place for the value of a label.
fn value_at<'a>(connector: &'a mut Connector, label: &'static str) -> &'a mut Option<AstId> {
    match label {
        "from" => &mut connector.from,
        "to" => &mut connector.to,
        "stiffness" => &mut connector.stiffness,
        "rest" => &mut connector.rest,
        _ => &mut connector.damping,
    }
}

fn is_spring(kind: ConnectorKind) -> bool {
    matches!(kind, ConnectorKind::Spring | ConnectorKind::TorsionSpring)
}

/// Returns the labels in the description of a connector.
fn labels(kind: ConnectorKind) -> &'static [&'static str] {
    if is_spring(kind) { SPRING } else { DAMPER }
}

fn owner(kind: ConnectorKind) -> &'static str {
    match kind {
        ConnectorKind::Spring => "a spring",
        ConnectorKind::Damper => "a damper",
        ConnectorKind::TorsionSpring => "a torsion spring",
        ConnectorKind::TorsionDamper => "a torsion damper",
    }
}
