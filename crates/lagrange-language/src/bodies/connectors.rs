//! Springs and dampers between points and between angles.

use super::drawing::{Load, draw_force, draw_moment, owner_of_point};
use super::expressions::{is_ground, mention, scene_point, turning};
use super::messages;
use super::object::{Connector, Object};
use super::plain::{Drawn, DrawnKind, LoadOrigin};
use super::terms::TermWriter;
use super::translation::Translation;
use crate::syntax::ast::{self, AstId, ConnectorKind, StatementKind};

/// An end of a connector.
#[derive(Clone)]
struct End {
    /// A point, or an angle.
    at: AstId,
    /// The body whose angle it is.
    body: Option<usize>,
    /// The name of the body that it belongs to, if known.
    owner: Option<String>,
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
    let [from, to] = ends;
    let (Some(from), Some(to), Some(factor)) = (from, to, factor) else {
        declare_broken(translation, statement);
        return;
    };
    if !is_linear && [&from, &to].iter().all(|end| translation.terms().is_zero(end.at)) {
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

/// Declares a connector with a reported error, so that its name remains known.
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
    let (body, owner, at) = match is_linear {
        true if is_ground(translation, end) => {
            let error =
                translation.report.error(translation.expressions.origin(end), messages::GROUND_IS_NO_POINT);
            error.help(messages::GROUND_IS_NO_POINT_HELP);
            return None;
        }
        true => {
            let at = scene_point(translation, end, messages::END);
            (None, owner_of_point(translation, end), at)
        }
        false => {
            let body = translation.body_named(end);
            (body, owner_of_point(translation, end).filter(|_| body.is_some()), turning(translation, end))
        }
    };
    translation.mentioned.push(at);
    Some(End { at, body, owner })
}

fn report_missing(translation: &mut Translation<'_>, label: &str, kind: ConnectorKind) {
    let message = messages::missing_label(word(kind), label);
    translation.report.error(translation.origin.start, message).help(messages::connector_help(kind));
}

/// Adds ½ k (|d| − l)² or ½ c (d|d|/dt)² for the distance |d| of two points.
fn between_points(
    translation: &mut Translation<'_>,
    kind: ConnectorKind,
    name: &str,
    ends: [End; 2],
    factor: AstId,
    rest: Option<AstId>,
) -> Connector {
    let span = span_of(translation, name, &ends);
    let dimension = translation.dimension();
    let mut terms = translation.terms();
    let length = terms.call("norm", &[span]);
    let spread = terms.components_of(dimension, span);
    let stretch = rest.map_or(length, |rest| terms.minus(length, rest));
    let tension = tension_of(&mut terms, kind, factor, [stretch, length]);
    // Without a rest length, no root is needed, whose derivative would fail where both ends meet.
    let (strained, pull) = match kind == ConnectorKind::Spring && stretch == length {
        true => (span, spread.iter().map(|&component| terms.times(factor, component)).collect()),
        false => {
            let pull = pull_along(&mut terms, kind, [factor, tension, length], &spread);
            (stretch, pull)
        }
    };
    push_energy(translation, kind, factor, strained);
    draw_connector(translation, kind, name, [ends[0].at, ends[1].at], tension);
    let pull = translation.terms().vector(&pull);
    add_pull(translation, name, ends, pull);
    Connector { kind, length, tension }
}

/// Returns k (l − l₀) or c l̇.
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

/// Returns the vector from one end to the other, under a separate name.
fn span_of(translation: &mut Translation<'_>, name: &str, ends: &[End; 2]) -> AstId {
    let dimension = translation.dimension();
    let mut terms = translation.terms();
    let span = terms.difference(dimension, [ends[1].at, ends[0].at]);
    let span = terms.vector(&span);
    translation.bind(&format!("{name}_span"), span)
}

/// Adds ½ k (φ − φ₀)² or ½ c φ̇² for the angle φ between two directions.
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

/// Adds the forces on both ends.
fn add_pull(translation: &mut Translation<'_>, name: &str, ends: [End; 2], pull: AstId) {
    let back = translation.terms().negative(pull);
    for (end, force) in ends.into_iter().zip([pull, back]) {
        if end.owner.is_some() {
            let load = Load { name, cause: LoadOrigin::Connector, body: end.owner };
            draw_force(translation, load, [end.at, force], &[]);
        }
    }
}

/// Adds the moments on both ends, each drawn at the centre of its body. The place where two bodies
/// meet is unknown, so the connector is drawn at the origin of one of them.
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
            let center = translation.bodies[body].center;
            let load = Load { name, cause: LoadOrigin::Connector, body: end.owner };
            draw_moment(translation, load, [center, moment]);
        }
    }
}

/// Returns the force along the vector between both ends with which they attract each other. For a
/// damper, it has a limit where the ends meet.
fn pull_along(
    terms: &mut TermWriter<'_>,
    kind: ConnectorKind,
    [factor, tension, length]: [AstId; 3],
    spread: &[AstId],
) -> Vec<AstId> {
    let mut pull_of = |&component: &AstId| {
        let along = terms.divide(component, length);
        let pull = terms.times(tension, along);
        if kind != ConnectorKind::Damper {
            return pull;
        }
        let speed = terms.rate(component);
        let limit = terms.times(factor, speed);
        terms.if_positive(length, pull, limit)
    };
    spread.iter().map(&mut pull_of).collect()
}

/// Returns the keyword of the statement.
pub(super) fn word(kind: ConnectorKind) -> &'static str {
    match kind {
        ConnectorKind::Spring => "spring",
        ConnectorKind::Damper => "damper",
        ConnectorKind::TorsionSpring => "torsion_spring",
        ConnectorKind::TorsionDamper => "torsion_damper",
    }
}
