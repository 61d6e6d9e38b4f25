//! Springs and dampers between points and between angles.

use super::expressions::{is_ground, mention, scene_point, turning};
use super::messages;
use super::object::{Body, Connector, Object};
use super::plain::{Drawn, DrawnKind, LoadOrigin};
use super::terms::{Pair, TermWriter};
use super::translation::Translation;
use crate::syntax::ast::{self, AstId, ConnectorKind, StatementKind};

/// An end of a connector.
#[derive(Clone, Copy)]
struct End {
    /// A point, or an angle.
    at: AstId,
    /// The body it belongs to, if that shows.
    body: Option<usize>,
}

pub(super) fn translate_connector(translation: &mut Translation<'_>, statement: &ast::Connector) {
    let kind = statement.kind;
    let name = match &statement.name {
        Some(name) => name.text.clone(),
        None => translation.names.of_nameless(word(kind)),
    };
    let is_linear = matches!(kind, ConnectorKind::Spring | ConnectorKind::Damper);
    let ends = [("from", statement.from), ("to", statement.to)];
    let ends = ends.map(|(label, end)| end_of(translation, label, end, is_linear, kind));
    let is_spring = matches!(kind, ConnectorKind::Spring | ConnectorKind::TorsionSpring);
    let (label, factor) = match is_spring {
        true => ("stiffness", statement.stiffness),
        false => ("damping", statement.damping),
    };
    let factor = factor.map(|factor| mention(translation, factor));
    let rest = statement.rest.map(|rest| mention(translation, rest));
    if factor.is_none() {
        report_missing(translation, label, kind);
    }
    let (Some(from), Some(to), Some(factor)) = (ends[0], ends[1], factor) else {
        declare_broken(translation, statement);
        return;
    };
    if !is_linear && [from, to].iter().all(|end| translation.terms().is_zero(end.at)) {
        translation.report_no_turning(statement.to.unwrap_or(to.at), messages::TURNED_BY_SPRING);
    }
    let object = match is_linear {
        true => between_points(translation, kind, &name, [from, to], factor, rest),
        false => between_angles(translation, kind, &name, [from, to], factor, rest),
    };
    if let Some(name) = &statement.name {
        translation.names.declare(&name.text, Object::Connector(object));
    }
}

/// Declares a connector whose mistake was reported; its name is still known.
fn declare_broken(translation: &mut Translation<'_>, statement: &ast::Connector) {
    if let Some(name) = &statement.name {
        let invalid = translation.terms().invalid();
        let object = Connector { kind: statement.kind, length: invalid, tension: invalid };
        translation.names.declare(&name.text, Object::Connector(object));
    }
}

fn end_of(
    translation: &mut Translation<'_>,
    label: &str,
    end: Option<AstId>,
    is_linear: bool,
    kind: ConnectorKind,
) -> Option<End> {
    let Some(end) = end else {
        report_missing(translation, label, kind);
        return None;
    };
    let (body, at) = match is_linear {
        true if is_ground(translation, end) => {
            let error =
                translation.report.error(translation.expressions.origin(end), messages::GROUND_IS_NO_POINT);
            error.help(messages::GROUND_IS_NO_POINT_HELP);
            return None;
        }
        true => (translation.body_of(end), scene_point(translation, end, messages::END)),
        false => (translation.body_named(end), turning(translation, end)),
    };
    translation.mentioned.push(at);
    Some(End { at, body })
}

fn report_missing(translation: &mut Translation<'_>, label: &str, kind: ConnectorKind) {
    let message = messages::missing_label(word(kind), label);
    translation.report.error(translation.origin.start, message).help(messages::connector_help(kind));
}

/// ½ k (|d| − l)² or ½ c (d|d|/dt)² of the distance d of two points.
fn between_points(
    translation: &mut Translation<'_>,
    kind: ConnectorKind,
    name: &str,
    ends: [End; 2],
    factor: AstId,
    rest: Option<AstId>,
) -> Connector {
    let span = span_of(translation, name, ends);
    let length = translation.terms().call("norm", &[span]);
    if translation.space.is_some() {
        return between_points_in_space(translation, kind, factor, rest, [span, length]);
    }
    let mut terms = translation.terms();
    let spread = terms.pair(span);
    let stretch = rest.map_or(length, |rest| terms.minus(length, rest));
    let tension = tension_of(&mut terms, kind, factor, [stretch, length]);
    // Without a length at rest no root is needed, whose derivative would fail where both ends meet.
    let (strained, pull) = match kind == ConnectorKind::Spring && stretch == length {
        true => (span, terms.scale(factor, spread)),
        false => {
            let pull = pull_along(&mut terms, kind, [factor, tension, length], spread);
            (stretch, pull)
        }
    };
    push_energy(translation, kind, factor, strained);
    draw_connector(translation, kind, name, [ends[0].at, ends[1].at], tension);
    let pull = translation.terms().tuple(pull);
    add_pull(translation, name, ends, pull);
    Connector { kind, length, tension }
}

/// The same in space, where nothing is drawn.
fn between_points_in_space(
    translation: &mut Translation<'_>,
    kind: ConnectorKind,
    factor: AstId,
    rest: Option<AstId>,
    [span, length]: [AstId; 2],
) -> Connector {
    let mut terms = translation.terms();
    let stretch = rest.map_or(length, |rest| terms.minus(length, rest));
    let tension = tension_of(&mut terms, kind, factor, [stretch, length]);
    let is_root_needed = kind != ConnectorKind::Spring || stretch != length;
    push_energy(translation, kind, factor, if is_root_needed { stretch } else { span });
    Connector { kind, length, tension }
}

/// k (l − l₀) or c l̇
fn tension_of(
    terms: &mut TermWriter<'_>,
    kind: ConnectorKind,
    factor: AstId,
    [stretch, length]: [AstId; 2],
) -> AstId {
    match kind {
        ConnectorKind::Spring => terms.times(factor, stretch),
        _ => {
            let rate = terms.call("dot", &[length]);
            terms.times(factor, rate)
        }
    }
}

/// The vector from one end to the other, under a name of its own.
fn span_of(translation: &mut Translation<'_>, name: &str, ends: [End; 2]) -> AstId {
    let dimension = translation.dimension();
    let mut terms = translation.terms();
    let span = terms.difference(dimension, [ends[1].at, ends[0].at]);
    let span = terms.vector(&span);
    translation.bind(&format!("{name}_span"), span)
}

/// ½ k (φ − φ₀)² or ½ c φ̇² of the angle φ between two directions.
fn between_angles(
    translation: &mut Translation<'_>,
    kind: ConnectorKind,
    name: &str,
    ends: [End; 2],
    factor: AstId,
    rest: Option<AstId>,
) -> Connector {
    let mut terms = translation.terms();
    let angle = terms.minus(ends[1].at, ends[0].at);
    let strained = rest.map_or(angle, |rest| terms.minus(angle, rest));
    let tension = match kind {
        ConnectorKind::TorsionSpring => terms.times(factor, strained),
        _ => {
            let rate = terms.rate(angle);
            terms.times(factor, rate)
        }
    };
    push_energy(translation, kind, factor, strained);
    add_twist(translation, kind, name, ends, tension);
    Connector { kind, length: angle, tension }
}

fn push_energy(translation: &mut Translation<'_>, kind: ConnectorKind, factor: AstId, strained: AstId) {
    let mut terms = translation.terms();
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
    translation.push(statement);
}

fn draw_connector(
    translation: &mut Translation<'_>,
    kind: ConnectorKind,
    name: &str,
    [from, to]: [AstId; 2],
    tension: AstId,
) {
    let kind = DrawnKind::Connector { name: name.to_owned(), kind };
    translation.drawing.push(Drawn { kind, values: vec![from, to, tension], needs: Vec::new() });
}

/// The forces on both ends.
fn add_pull(translation: &mut Translation<'_>, name: &str, ends: [End; 2], pull: AstId) {
    let back = translation.terms().negative(pull);
    for (end, force) in ends.into_iter().zip([pull, back]) {
        if let Some(body) = end.body {
            let body = Some(translation.bodies[body].name.text.clone());
            let kind = DrawnKind::Force { name: name.to_owned(), cause: LoadOrigin::Connector, body };
            translation.loads.push(Drawn { kind, values: vec![end.at, force], needs: Vec::new() });
        }
    }
}

/// The moments on both ends, each drawn at the centre of its body. Where two bodies meet is not said; the connector is drawn
/// where the own coordinates of one begin.
fn add_twist(
    translation: &mut Translation<'_>,
    kind: ConnectorKind,
    name: &str,
    ends: [End; 2],
    tension: AstId,
) {
    let Some(body) = ends[1].body.or(ends[0].body) else { return };
    let origin = translation.bodies[body].origin;
    let at = translation.terms().tuple(origin);
    draw_connector(translation, kind, name, [at, at], tension);
    let back = translation.terms().negative(tension);
    for (end, moment) in ends.into_iter().zip([tension, back]) {
        if let Some(body) = end.body {
            let Body { name: carrier, center, .. } = translation.bodies[body].clone();
            let body = Some(carrier.text);
            let kind = DrawnKind::Moment { name: name.to_owned(), cause: LoadOrigin::Connector, body };
            translation.loads.push(Drawn { kind, values: vec![center, moment], needs: Vec::new() });
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
