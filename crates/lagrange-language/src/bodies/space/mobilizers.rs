//! Joints that create coordinates: the pose of the placed body or frame, and its motion.
//!
//! A joint is a frame that is fixed in its carrier, and one to three elementary motions after it
//! ([`super::poses`]). Turning the frame makes any other axis a coordinate axis; the frame is
//! turned back after the motion.

use super::bodies::settle;
use super::drawing::draw_mobilizer;
use super::frames::{FrameStep, JointAxis, Pose, TurningAxes};
use super::inertia::fixed_triple;
use super::links::Path;
use super::messages as words;
use super::motors::draw_damping;
use super::numbers::{coordinate_axis, frame_along, triple_of_numbers, written};
use super::orientations::orientation;
use super::poses::{behind, has_place, named_vector};
use super::vectors::{Matrix, Triple, transposed, zero_triple};
use crate::bodies::expressions::{mention, report_early};
use crate::bodies::mass_geometry::property;
use crate::bodies::messages::{self, mobilizers as joints};
use crate::bodies::object::Object;
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{
    AstId, Definition, ElementaryMotion, JointLine, Mobilizer, MobilizerKind, Name, Statement, StatementKind,
};

/// The z-axis of the joint's frame, which is the default axis of turns and moves.
const Z: usize = 2;

pub(in crate::bodies) fn translate_spatial_mobilizer(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    statement: &Statement,
) {
    let placed = placed_of(translation, joint);
    if joint.kind == MobilizerKind::Free && !is_first(translation, &joint.outboard) {
        // A second one would declare the same names.
        return;
    }
    let coordinates = coordinates_of(translation, joint, statement);
    let carrier = carrier_of(translation, joint);
    let steps = steps_of(translation, joint, &coordinates);
    let way =
        carrier.zip(steps).map(|((carrier, pose), steps)| walk(translation, joint, carrier, pose, steps));
    dampen(translation, joint, &coordinates);
    draw_damping(translation, joint);
    if let Some(link) = placed {
        let (pose, path) = match way {
            Some((pose, path)) => (pose, Some(path)),
            None => (Pose::invalid(&mut translation.terms()), None),
        };
        let center_velocity = velocity_of_free_center(translation, joint, link, &coordinates);
        settle(translation, link, (pose, path), center_velocity);
    }
}

/// Returns the world velocity of the centre of mass of a free body, if it is the origin of the
/// body-fixed axes.
fn velocity_of_free_center(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    link: usize,
    coordinates: &[AstId],
) -> Option<AstId> {
    let inertia = translation.space.as_ref()?.links[link].inertia?;
    let mut terms = translation.terms();
    let is_central = inertia.centroid.iter().all(|&component| terms.is_zero(component));
    (is_central && joint.kind == MobilizerKind::Free).then(|| {
        let place = terms.vector(coordinates);
        terms.call("dot", &[place])
    })
}

/// True for the first `free` statement of a body, which is then recorded.
fn is_first(translation: &mut Translation<'_>, body: &Name) -> bool {
    translation.space.as_mut().is_none_or(|space| space.freed.insert(body.text.clone()))
}

/// Returns the frames after the steps of a joint, one after another.
fn walk(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    carrier: Option<usize>,
    mut pose: Pose,
    steps: Vec<FrameStep>,
) -> (Pose, Path) {
    let name = &joint.outboard.text;
    let last = steps.len().saturating_sub(1);
    let before = pose;
    let mut path = Path { carrier, steps: Vec::with_capacity(steps.len()) };
    for (index, step) in steps.into_iter().enumerate() {
        let wish = if index == last { name.clone() } else { format!("{name}_joint") };
        pose = behind(translation, &wish, pose, step);
        path.steps.push((step, pose));
    }
    draw_mobilizer(translation, joint, &before, &path);
    (pose, path)
}

/// Declares the coordinates of a joint and its other state variables; returns the expressions of
/// the coordinates.
pub(in crate::bodies) fn coordinates_of(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    statement: &Statement,
) -> Vec<AstId> {
    let mut push = |kind: StatementKind| translation.statements.push(Statement { kind, ..statement.clone() });
    if !joint.coordinates.is_empty() {
        push(StatementKind::Coordinates(joint.coordinates.iter().cloned().map(Definition::of).collect()));
    }
    joint
        .quaternion
        .iter()
        .for_each(|quaternion| push(StatementKind::Quaternion(Box::new(quaternion.clone()))));
    for (speed, coordinate) in joint.speeds.iter().zip(&joint.coordinates) {
        let coordinate = translation.terms().name(&coordinate.text);
        let kind = StatementKind::Velocity(speed.clone(), translation.terms().rate(coordinate));
        translation.statements.push(Statement { kind, ..statement.clone() });
    }
    joint.coordinates.iter().map(|name| translation.terms().name(&name.text)).collect()
}

/// Adds ½ c q̇², or ½ c ω² with the angular velocity ω in a ball joint.
pub(in crate::bodies) fn dampen(translation: &mut Translation<'_>, joint: &Mobilizer, coordinates: &[AstId]) {
    let Some(damping) = joint.damping else { return };
    let damping = mention(translation, damping);
    let mut terms = translation.terms();
    let speeds = match (&joint.quaternion, coordinates) {
        (Some(quaternion), _) => quaternion.velocities.iter().map(|name| terms.name(&name.text)).collect(),
        (None, [coordinate]) => vec![terms.rate(*coordinate)],
        _ => return,
    };
    let half = terms.half();
    let weight = terms.times(half, damping);
    let squares = speeds.into_iter().map(|speed| terms.square(speed)).collect::<Vec<_>>();
    let Some(sum) = squares.into_iter().reduce(|sum, square| terms.plus(sum, square)) else { return };
    let dissipation = terms.times(weight, sum);
    translation.push(StatementKind::Dissipation(dissipation));
}

/// Returns the link that carries a joint, unless it is the ground, and its pose.
fn carrier_of(translation: &mut Translation<'_>, joint: &Mobilizer) -> Option<(Option<usize>, Pose)> {
    let name = &joint.inboard;
    if is_ground(translation, name) {
        return Some((None, Pose::at_rest(&mut translation.terms())));
    }
    if name.text == joint.outboard.text {
        // This is reported for the link that it places.
        return None;
    }
    let link = link_of(translation, name)?;
    let pose = has_place(translation, link, name.span.into())?;
    Some((Some(link), pose))
}

fn is_ground(translation: &Translation<'_>, name: &Name) -> bool {
    name.text == "ground" && !translation.names.is_declared(&name.text)
}

/// Returns the body or frame with this name; anything else is reported.
pub(in crate::bodies) fn link_of(translation: &mut Translation<'_>, name: &Name) -> Option<usize> {
    if let Some(Object::Link { index, .. }) = translation.names.find(&name.text) {
        return Some(*index);
    }
    let found = translation.names.find(&name.text).map(Object::describe);
    let before = std::mem::replace(&mut translation.origin, name.span.into());
    if !translation.unreadable.contains(&name.text) && !report_early(translation, &name.text) {
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

/// Returns the link that a joint places, unless it is already placed.
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
    if let Some((pose, first)) = before {
        if pose.is_invalid(&translation.expressions) {
            return None;
        }
        let error = translation.report.error(name.span, joints::placed_twice(&name.text));
        error.related(first, joints::PLACED_HERE).help(joints::CLOSE_LOOP_HELP);
        return None;
    }
    Some(link)
}

/// Returns the steps from the carrier of a joint to the link that it places; `None` after an error.
fn steps_of(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    coordinates: &[AstId],
) -> Option<Vec<FrameStep>> {
    let kind = joint.kind.name();
    let mut steps = Vec::new();
    if let Some(at) = joint.at {
        steps.push(FrameStep::Shift(fixed_triple(translation, at, &joints::at_of(kind))));
    } else if joint.kind.motions() == [ElementaryMotion::Orientation] {
        // This is the frame that does not turn with the body.
        steps.push(FrameStep::Shift(zero_triple(&mut translation.terms())));
    }
    if let Some(turned) = joint.turned {
        steps.push(FrameStep::Reorientation(orientation(translation, turned, &joints::turned_of(kind))));
    }
    steps.extend(motions_of(translation, joint, coordinates)?);
    Some(steps)
}

/// Returns the motions of a joint in its frame.
fn motions_of(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    coordinates: &[AstId],
) -> Option<Vec<FrameStep>> {
    let motions = joint.kind.motions();
    let (own, aligned) = match joint.kind.labels().contains(&"axis") {
        true => axis_of(translation, joint)?,
        false => (JointAxis::positive(Z), None),
    };
    let along = |line| match line {
        JointLine::Own => own,
        JointLine::Frame(axis) => JointAxis::positive(axis),
    };
    let mut rest = coordinates.iter().copied();
    let mut steps = Vec::with_capacity(motions.len());
    for motion in motions {
        steps.push(match motion {
            ElementaryMotion::Turn(line) => FrameStep::Turn(along(*line), rest.next()?),
            ElementaryMotion::Slide(line) => FrameStep::Slide(along(*line), rest.next()?),
            ElementaryMotion::Advance => {
                FrameStep::Slide(own, advance(translation, joint, *coordinates.first()?)?)
            }
            ElementaryMotion::Orientation => turning(translation, joint)?,
        });
    }
    if let Some(aligned) = aligned {
        steps.insert(0, FrameStep::Reorientation(aligned));
        steps.push(FrameStep::Reorientation(transposed(aligned)));
    }
    Some(steps)
}

/// Returns axes turned by the quaternion of a joint.
fn turning(translation: &mut Translation<'_>, joint: &Mobilizer) -> Option<FrameStep> {
    let quaternion = joint.quaternion.as_ref()?;
    let mut terms = translation.terms();
    let components = quaternion.positions.each_ref().map(|name| terms.name(&name.text));
    let spin = quaternion.velocities.each_ref().map(|name| terms.name(&name.text));
    let rows = rotation_of(&mut terms, components);
    let matrix = [("x", rows[0]), ("y", rows[1]), ("z", rows[2])]
        .map(|(axis, row)| named_vector(translation, &format!("{}_R_{axis}", quaternion.name.text), row));
    Some(FrameStep::Orientation(TurningAxes { matrix, spin }))
}

/// Returns the rotation of a quaternion with the vector part v: 1 + 2 w v× + 2 v× v× (Featherstone,
/// *Rigid Body Dynamics Algorithms*, eq. 4.11).
fn rotation_of(terms: &mut TermWriter<'_>, [w, x, y, z]: [AstId; 4]) -> Matrix {
    let (one, two) = (terms.number(1), terms.number(2));
    let vector = [x, y, z];
    [0, 1, 2].map(|row| {
        let (next, last) = ((row + 1) % 3, (row + 2) % 3);
        let mut entries = [one; 3];
        let squares = [next, last].map(|axis| terms.square(vector[axis]));
        let sum = terms.plus(squares[0], squares[1]);
        let doubled = terms.times(two, sum);
        entries[row] = terms.minus(one, doubled);
        for (column, third, is_negative) in [(next, last, true), (last, next, false)] {
            let (product, turning) =
                (terms.times(vector[row], vector[column]), terms.times(w, vector[third]));
            let entry =
                if is_negative { terms.minus(product, turning) } else { terms.plus(product, turning) };
            entries[column] = terms.times(two, entry);
        }
        entries
    })
}

/// Returns the axis of a joint in its frame or, if it is oblique and numeric, z in a frame that is
/// turned to it.
fn axis_of(translation: &mut Translation<'_>, joint: &Mobilizer) -> Option<(JointAxis, Option<Matrix>)> {
    let Some(axis) = joint.axis else { return Some((JointAxis::positive(Z), None)) };
    let direction = fixed_triple(translation, axis, &joints::axis_of(joint.kind.name()));
    let Some(numbers) = triple_of_numbers(translation, direction) else {
        return Some((normalised(translation, joint, direction), None));
    };
    if numbers == [0.0; 3] {
        let origin = translation.expressions.origin(axis);
        translation.report.error(origin, joints::AXIS_ZERO).help(words::AXIS_HELP);
        return None;
    }
    if let Some((axis, is_negative)) = coordinate_axis(numbers) {
        return Some((JointAxis::Coordinate { axis, is_negative }, None));
    }
    let aligned = written(&mut translation.terms(), frame_along(numbers));
    Some((JointAxis::positive(Z), Some(aligned)))
}

/// Returns a direction with parameters as a unit vector, under separate names.
fn normalised(translation: &mut Translation<'_>, joint: &Mobilizer, direction: Triple) -> JointAxis {
    let mut terms = translation.terms();
    let vector = terms.vector(&direction);
    let length = terms.call("norm", &[vector]);
    let unit = direction.map(|component| terms.divide(component, length));
    JointAxis::Direction(named_vector(translation, &format!("{}_axis", joint.outboard.text), unit))
}

/// Returns the advance of a screw: p q / 2π.
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
