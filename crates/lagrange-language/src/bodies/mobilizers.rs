//! Joints with coordinates in the plane: they place a body like `origin` and `angle`.

use super::body::translate_body;
use super::expressions::{is_ground, mention, report_early};
use super::lines::report_no_object;
use super::mass_geometry::{fixed_vector, property};
use super::messages::{self, mobilizers as words};
use super::object::{Body, Energies, Object, WaitingBody};
use super::space::{coordinates_of, dampen};
use super::terms::Pair;
use super::translation::Translation;
use crate::syntax::ast::{self, AstId, Mobilizer, MobilizerKind, Name, Statement};

/// Origin and angle of a frame.
#[derive(Clone, Copy)]
struct PlaneFrame {
    origin: Pair,
    angle: AstId,
}

pub(super) fn translate_plane_mobilizer(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    statement: &Statement,
) {
    let coordinates = coordinates_of(translation, joint, statement);
    let carrier = carrier_frame(translation, &joint.inboard);
    let placed = waiting_body(translation, joint);
    let frame = carrier.map(|carrier| joint_frame(translation, joint, carrier));
    let frame = frame.and_then(|frame| moved(translation, joint, frame, &coordinates));
    dampen(translation, joint, &coordinates);
    let frame = frame.unwrap_or_else(|| {
        let invalid = translation.terms().invalid();
        PlaneFrame { origin: [invalid; 2], angle: invalid }
    });
    match placed {
        Some(WaitingBody::Body(body)) => {
            let origin = translation.terms().tuple(frame.origin);
            let body = ast::Body { origin: Some(origin), angle: Some(frame.angle), ..*body };
            translate_body(translation, &body);
        }
        Some(WaitingBody::Frame(name)) => declare_frame(translation, name, frame),
        None => {}
    }
}

/// Declares a frame, which is a body without mass.
fn declare_frame(translation: &mut Translation<'_>, name: Name, frame: PlaneFrame) {
    let mut terms = translation.terms();
    let (nothing, center) = (terms.number(0), terms.tuple(frame.origin));
    let PlaneFrame { origin, angle } = frame;
    let index = translation.bodies.len();
    translation.names.declare(&name.text, Object::Body(index));
    translation.bodies.push(Body {
        name,
        mass: nothing,
        inertia: nothing,
        center,
        centroid: [nothing; 2],
        origin,
        angle,
        radius: None,
        shape: None,
        energies: Energies::default(),
    });
}

fn carrier_frame(translation: &mut Translation<'_>, name: &Name) -> Option<PlaneFrame> {
    let ground = translation.terms().name(&name.text);
    if is_ground(translation, ground) {
        let mut terms = translation.terms();
        return Some(PlaneFrame { origin: terms.zero_pair(), angle: terms.number(0) });
    }
    if let Some(Object::Body(body)) = translation.names.find(&name.text) {
        let Body { origin, angle, .. } = translation.bodies[*body];
        return Some(PlaneFrame { origin, angle });
    }
    report_no_body(translation, name);
    None
}

fn report_no_body(translation: &mut Translation<'_>, name: &Name) {
    let found = translation.names.find(&name.text).map(Object::describe);
    report_no_object(translation, name, "a body", found, |object| matches!(object, Object::Body(_)));
}

/// Returns the body that waits for this joint; any other is reported.
fn waiting_body(translation: &mut Translation<'_>, joint: &Mobilizer) -> Option<WaitingBody> {
    let name = &joint.outboard;
    let waiting = translation.waiting.iter().position(|body| body.name().text == name.text);
    if let Some(place) = waiting.filter(|_| joint.inboard.text != name.text) {
        return Some(translation.waiting.remove(place));
    }
    let ground = translation.terms().name(&name.text);
    if is_ground(translation, ground) {
        translation.report.error(name.span, words::GROUND_IS_AT_REST).help(words::CLOSE_LOOP_HELP);
    } else if joint.inboard.text == name.text {
        let error = translation.report.error(name.span, words::joined_to_itself(&name.text));
        error.help(words::CLOSE_LOOP_HELP);
    } else if let Some(Object::Body(_)) = translation.names.find(&name.text) {
        let error = translation.report.error(name.span, words::placed_twice(&name.text));
        error.help(words::CLOSE_LOOP_HELP);
    } else if !report_early(translation, &name.text) {
        report_no_body(translation, name);
    }
    None
}

fn joint_frame(translation: &mut Translation<'_>, joint: &Mobilizer, carrier: PlaneFrame) -> PlaneFrame {
    let kind = joint.kind.name();
    let at = match joint.at {
        Some(at) => fixed_vector(translation, at, &words::at_of(kind)),
        None => translation.terms().zero_pair(),
    };
    let turned = joint.turned.map(|turned| property(translation, turned, &words::turned_of(kind)));
    let frame = moved_by(translation, carrier, at);
    match turned {
        Some(turned) => turned_by(translation, frame, turned),
        None => frame,
    }
}

fn moved_by(translation: &mut Translation<'_>, frame: PlaneFrame, by: Pair) -> PlaneFrame {
    let mut terms = translation.terms();
    let arm = terms.turned(by, frame.angle);
    PlaneFrame { origin: terms.plus_pair(frame.origin, arm), ..frame }
}

fn turned_by(translation: &mut Translation<'_>, frame: PlaneFrame, by: AstId) -> PlaneFrame {
    PlaneFrame { angle: translation.terms().plus(frame.angle, by), ..frame }
}

/// Returns the frame after the motions of a joint.
fn moved(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    frame: PlaneFrame,
    coordinates: &[AstId],
) -> Option<PlaneFrame> {
    match (joint.kind, coordinates) {
        (MobilizerKind::Weld, _) => Some(frame),
        (MobilizerKind::Revolute, &[angle]) => {
            if let Some(axis) = joint.axis {
                mention(translation, axis);
                let origin = translation.expressions.origin(axis);
                translation.report.error(origin, words::AXIS_IN_THE_PLANE).help(words::LEADS_OUT_HELP);
            }
            Some(turned_by(translation, frame, angle))
        }
        (MobilizerKind::Prismatic, &[distance]) => {
            let direction = direction(translation, joint)?;
            let by = translation.terms().scale(distance, direction);
            Some(moved_by(translation, frame, by))
        }
        (MobilizerKind::Planar, &[x, y, angle]) => {
            let frame = moved_by(translation, frame, [x, y]);
            Some(turned_by(translation, frame, angle))
        }
        _ => None,
    }
}

/// Returns the unit vector along which a joint moves; x by default.
fn direction(translation: &mut Translation<'_>, joint: &Mobilizer) -> Option<Pair> {
    let Some(axis) = joint.axis else {
        let mut terms = translation.terms();
        return Some([terms.number(1), terms.number(0)]);
    };
    let components = fixed_vector(translation, axis, &words::axis_of(joint.kind.name()));
    let mut terms = translation.terms();
    if components.iter().all(|&component| terms.is_zero(component)) {
        let origin = translation.expressions.origin(axis);
        translation.report.error(origin, words::AXIS_ZERO).help(words::AXIS_IN_THE_PLANE_HELP);
        return None;
    }
    let vector = terms.tuple(components);
    let length = terms.call("norm", &[vector]);
    Some(components.map(|component| terms.divide(component, length)))
}

/// Reports bodies and frames that no joint has placed.
pub(super) fn report_waiting(translation: &mut Translation<'_>) {
    if translation.report.has_errors() {
        return;
    }
    for waiting in &translation.waiting {
        let (what, name) = (waiting.kind(), waiting.name());
        let error = translation.report.error(name.span, words::unplaced(what, &name.text));
        error.help(match waiting {
            WaitingBody::Body(_) => messages::ONE_PLACE_HELP,
            WaitingBody::Frame(_) => words::FRAME_PLACE_HELP,
        });
    }
}
