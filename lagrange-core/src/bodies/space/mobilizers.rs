//! Joints that make coordinates: where they put the body or frame behind them, and how it moves with them.
//!
//! A joint is a frame that is fixed in its carrier, and one to three elementary motions after it ([`super::poses`]). An axis that is none
//! of the coordinate axes is made one by turning the frame, and what follows the motion back.

use super::bodies::settle;
use super::inertia::fixed_triple;
use super::links::has_place;
use super::messages as words;
use super::numbers::{coordinate_axis, frame_along, orientation, triple_of_numbers, written};
use super::poses::{JointAxis, Pose, named_vector, reoriented, shifted, slid, turned};
use super::vectors::{Matrix, Triple, transposed};
use crate::bodies::expressions::{mention, report_early};
use crate::bodies::mass_geometry::property;
use crate::bodies::messages::{self, mobilizers as joints};
use crate::bodies::object::Object;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{AstId, Mobilizer, MobilizerKind, Name, Statement, StatementKind};

/// A turn about the z-axis of the joint's frame, or a move along it, unless an axis says otherwise.
const Z: usize = 2;

pub(in crate::bodies) fn translate_spatial_mobilizer(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    statement: Statement,
) {
    let coordinates = coordinates_of(translation, joint, statement);
    let carrier = carrier_of(translation, joint);
    let placed = placed_of(translation, joint);
    let frame = carrier.map(|pose| joint_frame(translation, joint, pose));
    let pose = frame.and_then(|frame| moved(translation, joint, frame, &coordinates));
    dampen(translation, joint, &coordinates);
    if let Some(link) = placed {
        let pose = pose.unwrap_or_else(|| Pose::invalid(&mut translation.terms()));
        settle(translation, link, pose, None);
    }
}

/// Declares the coordinates; their expressions.
pub(in crate::bodies) fn coordinates_of(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    statement: Statement,
) -> Vec<AstId> {
    if !joint.coordinates.is_empty() {
        let kind = StatementKind::Coordinates(joint.coordinates.clone());
        translation.statements.push(Statement { kind, ..statement });
    }
    joint.coordinates.iter().map(|name| translation.terms().name(&name.text)).collect()
}

/// ½ c q̇²
pub(in crate::bodies) fn dampen(translation: &mut Translation<'_>, joint: &Mobilizer, coordinates: &[AstId]) {
    let (Some(damping), [coordinate]) = (joint.damping, coordinates) else { return };
    let damping = mention(translation, damping);
    let mut terms = translation.terms();
    let (half, rate) = (terms.half(), terms.rate(*coordinate));
    let (weighed, square) = (terms.times(half, damping), terms.square(rate));
    let dissipation = terms.times(weighed, square);
    translation.push(StatementKind::Dissipation(dissipation));
}

/// The pose of what carries a joint.
fn carrier_of(translation: &mut Translation<'_>, joint: &Mobilizer) -> Option<Pose> {
    let name = &joint.inboard;
    if is_ground(translation, name) {
        return Some(Pose::at_rest(&mut translation.terms()));
    }
    let link = link_of(translation, name)?;
    has_place(translation, link, name.span.into())
}

fn is_ground(translation: &Translation<'_>, name: &Name) -> bool {
    name.text == "ground" && !translation.names.is_declared(&name.text)
}

/// The body or frame of a name; anything else is reported.
fn link_of(translation: &mut Translation<'_>, name: &Name) -> Option<usize> {
    if let Some(Object::Link { index, .. }) = translation.names.find(&name.text) {
        return Some(*index);
    }
    let found = translation.names.find(&name.text).map(Object::describe);
    let before = std::mem::replace(&mut translation.origin, name.span.into());
    if !report_early(translation, &name.text) {
        let nearest = translation.names.nearest(&name.text, |object| matches!(object, Object::Link { .. }));
        let help = match nearest {
            Some(nearest) => messages::did_you_mean(nearest),
            None => words::DECLARE_LINK_HELP.to_owned(),
        };
        translation.report.error(name.span, words::no_link(&name.text, found)).help(help);
    }
    translation.origin = before;
    None
}

/// The link that a joint places, unless it has its place already.
fn placed_of(translation: &mut Translation<'_>, joint: &Mobilizer) -> Option<usize> {
    let name = &joint.outboard;
    if is_ground(translation, name) {
        translation.report.error(name.span, joints::GROUND_IS_AT_REST).help(joints::CLOSE_LOOP_HELP);
        return None;
    }
    let link = link_of(translation, name)?;
    if joint.inboard.text == name.text {
        let error = translation.report.error(name.span, joints::joined_to_itself(&name.text));
        error.help(joints::CLOSE_LOOP_HELP);
        return None;
    }
    let before = translation.space.as_ref()?.links[link].placed;
    if let Some((_, first)) = before {
        let error = translation.report.error(name.span, joints::placed_twice(&name.text));
        error.related(first, joints::PLACED_HERE).help(joints::CLOSE_LOOP_HELP);
        return None;
    }
    Some(link)
}

/// The frame of a joint in its carrier.
fn joint_frame(translation: &mut Translation<'_>, joint: &Mobilizer, carrier: Pose) -> Pose {
    let kind = joint.kind.name();
    let name = frame_name(joint);
    let pose = match joint.at {
        Some(at) => {
            let at = fixed_triple(translation, at, &joints::at_of(kind));
            shifted(translation, &name, carrier, at)
        }
        None => carrier,
    };
    let rotation = joint.turned.and_then(|turned| orientation(translation, turned, &joints::turned_of(kind)));
    match rotation {
        Some(rotation) => reoriented(translation, &name, pose, rotation),
        None => pose,
    }
}

fn frame_name(joint: &Mobilizer) -> String {
    match joint.kind {
        MobilizerKind::Weld => joint.outboard.text.clone(),
        _ => format!("{}_joint", joint.outboard.text),
    }
}

/// The frame behind the motions of a joint.
fn moved(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    frame: Pose,
    coordinates: &[AstId],
) -> Option<Pose> {
    let name = joint.outboard.text.clone();
    let steps =
        |translation: &mut Translation<'_>, pose: Pose, axis: JointAxis| match (joint.kind, coordinates) {
            (MobilizerKind::Revolute, &[angle]) => Some(turned(translation, &name, pose, axis, angle)),
            (MobilizerKind::Prismatic, &[distance]) => Some(slid(translation, &name, pose, axis, distance)),
            (MobilizerKind::Cylindrical, &[angle, distance]) => {
                let turned = turned(translation, &frame_name(joint), pose, axis, angle);
                Some(slid(translation, &name, turned, axis, distance))
            }
            (MobilizerKind::Screw, &[angle]) => {
                let distance = advance(translation, joint, angle)?;
                let turned = turned(translation, &frame_name(joint), pose, axis, angle);
                Some(slid(translation, &name, turned, axis, distance))
            }
            _ => None,
        };
    match (joint.kind, coordinates) {
        (MobilizerKind::Weld, _) => Some(frame),
        (MobilizerKind::Universal, &[first, second]) => {
            let (x, y) = (JointAxis::positive(0), JointAxis::positive(1));
            let fork = turned(translation, &frame_name(joint), frame, x, first);
            Some(turned(translation, &name, fork, y, second))
        }
        (MobilizerKind::Planar, &[x, y, angle]) => {
            let along = |axis: usize| JointAxis::positive(axis);
            let moved = slid(translation, &frame_name(joint), frame, along(0), x);
            let moved = slid(translation, &frame_name(joint), moved, along(1), y);
            Some(turned(translation, &name, moved, along(Z), angle))
        }
        _ => along_axis(translation, joint, frame, steps),
    }
}

/// Motion about or along the axis of a joint.
fn along_axis(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    frame: Pose,
    steps: impl Fn(&mut Translation<'_>, Pose, JointAxis) -> Option<Pose>,
) -> Option<Pose> {
    let Some(axis) = joint.axis else { return steps(translation, frame, JointAxis::positive(Z)) };
    let direction = fixed_triple(translation, axis, &joints::axis_of(joint.kind.name()));
    let Some(numbers) = triple_of_numbers(translation, direction) else {
        let axis = normalised(translation, joint, direction);
        return steps(translation, frame, axis);
    };
    if numbers == [0.0; 3] {
        let origin = translation.expressions.origin(axis);
        translation.report.error(origin, joints::AXIS_ZERO).help(words::AXIS_HELP);
        return None;
    }
    if let Some((axis, is_negative)) = coordinate_axis(numbers) {
        return steps(translation, frame, JointAxis::Coordinate { axis, is_negative });
    }
    let aligned = written(&mut translation.terms(), frame_along(numbers));
    turned_there_and_back(translation, joint, frame, aligned, steps)
}

/// The motion in a frame whose z-axis is the axis, and back.
fn turned_there_and_back(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    frame: Pose,
    aligned: Matrix,
    steps: impl Fn(&mut Translation<'_>, Pose, JointAxis) -> Option<Pose>,
) -> Option<Pose> {
    let name = frame_name(joint);
    let there = reoriented(translation, &name, frame, aligned);
    let moved = steps(translation, there, JointAxis::positive(Z))?;
    Some(reoriented(translation, &joint.outboard.text, moved, transposed(aligned)))
}

/// A direction with parameters, of length one under names of its own.
fn normalised(translation: &mut Translation<'_>, joint: &Mobilizer, direction: Triple) -> JointAxis {
    let mut terms = translation.terms();
    let vector = terms.vector(&direction);
    let length = terms.call("norm", &[vector]);
    let unit = direction.map(|component| terms.divide(component, length));
    JointAxis::Direction(named_vector(translation, &format!("{}_axis", joint.outboard.text), unit))
}

/// How far a screw has come: p q / 2π.
fn advance(translation: &mut Translation<'_>, joint: &Mobilizer, angle: AstId) -> Option<AstId> {
    let Some(pitch) = joint.pitch else {
        translation.report.error(joint.outboard.span, words::PITCH_MISSING).help(words::PITCH_HELP);
        return None;
    };
    let pitch = property(translation, pitch, words::PITCH);
    let mut terms = translation.terms();
    let (two, pi) = (terms.number(2), terms.name("pi"));
    let turn = terms.times(two, pi);
    let lead = terms.divide(pitch, turn);
    Some(terms.times(lead, angle))
}
