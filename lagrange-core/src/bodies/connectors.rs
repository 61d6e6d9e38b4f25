//! Springs and dampers between points and between angles.

use super::messages;
use super::object::{Body, Connector, Object};
use super::plain::{Drawn, DrawnKind, LoadOrigin};
use super::terms::{Pair, TermWriter};
use super::translation::Translation;
use crate::syntax::ast;
use crate::syntax::ast::{AstId, ConnectorKind, StatementKind};

/// An end of a connector.
#[derive(Clone, Copy)]
struct End {
    /// A point, or an angle.
    at: AstId,
    /// The body it belongs to, if that shows.
    body: Option<usize>,
}

impl Translation<'_> {
    pub(super) fn connector(&mut self, statement: &ast::Connector) {
        let kind = statement.kind;
        let name = match &statement.name {
            Some(name) => name.text.clone(),
            None => self.names.of_nameless(word(kind)),
        };
        let is_linear = matches!(kind, ConnectorKind::Spring | ConnectorKind::Damper);
        let ends = [("from", statement.from), ("to", statement.to)];
        let ends = ends.map(|(label, end)| self.end(label, end, is_linear, kind));
        let is_spring = matches!(kind, ConnectorKind::Spring | ConnectorKind::TorsionSpring);
        let (label, factor) = match is_spring {
            true => ("stiffness", statement.stiffness),
            false => ("damping", statement.damping),
        };
        let factor = factor.map(|factor| self.mention(factor));
        let rest = statement.rest.map(|rest| self.mention(rest));
        if factor.is_none() {
            self.report_missing(label, kind);
        }
        let (Some(from), Some(to), Some(factor)) = (ends[0], ends[1], factor) else {
            self.declare_broken(statement);
            return;
        };
        if !is_linear && [from, to].iter().all(|end| self.terms().is_zero(end.at)) {
            self.report_no_turning(statement.to.unwrap_or(to.at), messages::TURNED_BY_SPRING);
        }
        let object = match is_linear {
            true => self.between_points(kind, &name, [from, to], factor, rest),
            false => self.between_angles(kind, &name, [from, to], factor, rest),
        };
        if let Some(name) = &statement.name {
            self.names.declare(&name.text, Object::Connector(object));
        }
    }

    /// What is wrong with it was reported; its name is still known.
    fn declare_broken(&mut self, statement: &ast::Connector) {
        if let Some(name) = &statement.name {
            let invalid = self.terms().invalid();
            let object = Connector { kind: statement.kind, length: invalid, tension: invalid };
            self.names.declare(&name.text, Object::Connector(object));
        }
    }

    fn end(&mut self, label: &str, end: Option<AstId>, is_linear: bool, kind: ConnectorKind) -> Option<End> {
        let Some(end) = end else {
            self.report_missing(label, kind);
            return None;
        };
        let (body, at) = match is_linear {
            true if self.is_ground(end) => {
                let error = self.report.error(self.expressions.origin(end), messages::GROUND_IS_NO_POINT);
                error.help(messages::GROUND_IS_NO_POINT_HELP);
                return None;
            }
            true => (self.body_of(end), self.plane_point(end, messages::END)),
            false => (self.body_named(end), self.turning(end)),
        };
        self.mentioned.push(at);
        Some(End { at, body })
    }

    fn report_missing(&mut self, label: &str, kind: ConnectorKind) {
        let message = messages::missing_label(word(kind), label);
        self.report.error(self.origin.start, message).help(messages::connector_help(kind));
    }

    /// ½ k (|d| − l)² or ½ c (d|d|/dt)² of the distance d of two points.
    fn between_points(
        &mut self,
        kind: ConnectorKind,
        name: &str,
        ends: [End; 2],
        factor: AstId,
        rest: Option<AstId>,
    ) -> Connector {
        let span = self.span(name, ends);
        let mut terms = self.terms();
        let (length, spread) = (terms.call("norm", &[span]), terms.pair(span));
        let stretch = rest.map_or(length, |rest| terms.minus(length, rest));
        let tension = match kind {
            ConnectorKind::Spring => terms.times(factor, stretch),
            _ => {
                let rate = terms.call("dot", &[length]);
                terms.times(factor, rate)
            }
        };
        // Without a length at rest no root is needed, whose derivative would fail where both ends meet.
        let (strained, pull) = match kind == ConnectorKind::Spring && stretch == length {
            true => (span, terms.scale(factor, spread)),
            false => {
                let pull = pull_along(&mut terms, kind, [factor, tension, length], spread);
                (stretch, pull)
            }
        };
        self.push_energy(kind, factor, strained);
        self.draw_connector(kind, name, [ends[0].at, ends[1].at], tension);
        let pull = self.terms().tuple(pull);
        self.pull(name, ends, pull);
        Connector { kind, length, tension }
    }

    /// The vector from one end to the other, under a name of its own.
    fn span(&mut self, name: &str, ends: [End; 2]) -> AstId {
        let mut terms = self.terms();
        let (from, to) = (terms.pair(ends[0].at), terms.pair(ends[1].at));
        let span = terms.minus_pair(to, from);
        let span = terms.tuple(span);
        self.bind(&format!("{name}_span"), span)
    }

    /// ½ k (φ − φ₀)² or ½ c φ̇² of the angle φ between two directions.
    fn between_angles(
        &mut self,
        kind: ConnectorKind,
        name: &str,
        ends: [End; 2],
        factor: AstId,
        rest: Option<AstId>,
    ) -> Connector {
        let mut terms = self.terms();
        let angle = terms.minus(ends[1].at, ends[0].at);
        let strained = rest.map_or(angle, |rest| terms.minus(angle, rest));
        let tension = match kind {
            ConnectorKind::TorsionSpring => terms.times(factor, strained),
            _ => {
                let rate = terms.rate(angle);
                terms.times(factor, rate)
            }
        };
        self.push_energy(kind, factor, strained);
        self.twist(kind, name, ends, tension);
        Connector { kind, length: angle, tension }
    }

    fn push_energy(&mut self, kind: ConnectorKind, factor: AstId, strained: AstId) {
        let mut terms = self.terms();
        let statement = match kind {
            ConnectorKind::Spring | ConnectorKind::TorsionSpring => {
                StatementKind::Potential(terms.call("spring_energy", &[factor, strained]))
            }
            ConnectorKind::Damper | ConnectorKind::TorsionDamper => {
                let rate = terms.call("dot", &[strained]);
                let (half, square) = (terms.half(), terms.square(rate));
                let weighed = terms.times(half, factor);
                StatementKind::Dissipation(terms.times(weighed, square))
            }
        };
        self.push(statement);
    }

    fn draw_connector(&mut self, kind: ConnectorKind, name: &str, [from, to]: [AstId; 2], tension: AstId) {
        let kind = DrawnKind::Connector { name: name.to_owned(), kind };
        self.drawing.push(Drawn { kind, values: vec![from, to, tension], needs: Vec::new() });
    }

    /// The forces on both ends.
    fn pull(&mut self, name: &str, ends: [End; 2], pull: AstId) {
        let back = self.terms().negative(pull);
        for (end, force) in ends.into_iter().zip([pull, back]) {
            if let Some(body) = end.body {
                let body = Some(self.bodies[body].name.text.clone());
                let kind = DrawnKind::Force { name: name.to_owned(), cause: LoadOrigin::Connector, body };
                self.loads.push(Drawn { kind, values: vec![end.at, force], needs: Vec::new() });
            }
        }
    }

    /// The moments on both ends, each drawn at the centre of its body. Where two bodies meet is not said; the connector is drawn
    /// where the own coordinates of one begin.
    fn twist(&mut self, kind: ConnectorKind, name: &str, ends: [End; 2], tension: AstId) {
        let Some(body) = ends[1].body.or(ends[0].body) else { return };
        let origin = self.bodies[body].origin;
        let at = self.terms().tuple(origin);
        self.draw_connector(kind, name, [at, at], tension);
        let back = self.terms().negative(tension);
        for (end, moment) in ends.into_iter().zip([tension, back]) {
            if let Some(body) = end.body {
                let Body { name: carrier, center, .. } = self.bodies[body].clone();
                let body = Some(carrier.text);
                let kind = DrawnKind::Moment { name: name.to_owned(), cause: LoadOrigin::Connector, body };
                self.loads.push(Drawn { kind, values: vec![center, moment], needs: Vec::new() });
            }
        }
    }
}

/// The force along the vector between both ends, with which each draws the other. A damper has a limit where they meet.
fn pull_along(
    terms: &mut TermWriter<'_>,
    kind: ConnectorKind,
    [factor, tension, length]: [AstId; 3],
    spread: Pair,
) -> Pair {
    let along = spread.map(|component| terms.divide(component, length));
    let pull = terms.scale(tension, along);
    if kind != ConnectorKind::Damper {
        return pull;
    }
    let speed = terms.rate_pair(spread);
    let limit = terms.scale(factor, speed);
    terms.if_positive(length, pull, limit)
}

/// The word that begins the statement.
pub(super) fn word(kind: ConnectorKind) -> &'static str {
    match kind {
        ConnectorKind::Spring => "spring",
        ConnectorKind::Damper => "damper",
        ConnectorKind::TorsionSpring => "torsion_spring",
        ConnectorKind::TorsionDamper => "torsion_damper",
    }
}
