//! The drawing of a scene in space: bodies, frames and joints.

use super::frames::{FrameStep, JointAxis, Pose};
use super::links::{Link, MassProperties, Path};
use super::motors::draw_loads_on_coordinates;
use super::vectors::{transposed, unit, zero_triple};
use crate::bodies::plain::{Drawn, DrawnKind, SpatialJointForm};
use crate::bodies::translation::Translation;
use crate::syntax::ast::{AstId, ElementaryMotion, JointLine, Mobilizer};

/// Draws bodies and frames in the order of their declaration, and loads on coordinates in their
/// places among the others. Nothing is drawn unless requested.
pub(in crate::bodies) fn draw_scene(translation: &mut Translation<'_>) {
    if translation.space.is_none() {
        return;
    }
    if !translation.is_drawn {
        (translation.drawing, translation.loads) = (Vec::new(), Vec::new());
    } else if !translation.report.has_errors() {
        draw_loads_on_coordinates(translation);
        draw_links(translation);
    }
}

fn draw_links(translation: &mut Translation<'_>) {
    let Some(space) = &translation.space else { return };
    let placed = space.links.clone().into_iter().filter_map(|link| Some((link.placed?.0, link)));
    let mut body = 0;
    for (pose, Link { name, inertia, outlines, .. }) in placed {
        let (kind, values) = match inertia {
            Some(_) => {
                body += 1;
                (DrawnKind::Body { body: body - 1, outlines }, Vec::new())
            }
            None => {
                let rotation = transposed(pose.axes);
                let values = rotation.iter().flatten().chain(&pose.origin).copied().collect();
                (DrawnKind::Frame { name: name.text }, values)
            }
        };
        translation.drawing.push(Drawn { kind, values, needs: Vec::new() });
    }
}

/// Draws a joint that creates coordinates, at its frame on the carrier.
pub(super) fn draw_mobilizer(
    translation: &mut Translation<'_>,
    joint: &Mobilizer,
    carrier: &Pose,
    path: &Path,
) {
    if !translation.is_drawn {
        return;
    }
    let mut frame = carrier;
    let moves = path.steps.iter().find(|(step, behind)| {
        if step.is_fixed() {
            frame = behind;
        }
        !step.is_fixed()
    });
    let has_axis = !matches!(joint.kind.motions(), [ElementaryMotion::Slide(JointLine::Frame(_)), ..]);
    let axis = match moves {
        Some((FrameStep::Turn(axis, _) | FrameStep::Slide(axis, _), _)) if has_axis => *axis,
        _ => JointAxis::positive(2),
    };
    let mut terms = translation.terms();
    let (at, axis) = (terms.vector(&frame.origin), frame.axis_in_world(&mut terms, axis));
    let axis = terms.vector(&axis);
    let quaternion = joint.quaternion.as_ref().map(|quaternion| &quaternion.name);
    let name = quaternion.or(joint.coordinates.first()).unwrap_or(&joint.outboard).text.clone();
    let inboard = path.carrier.map(|_| joint.inboard.text.clone());
    let links = [inboard, Some(joint.outboard.text.clone())];
    let kind = DrawnKind::SpatialJoint { name, kind: SpatialJointForm::Mobilizer(joint.kind), links };
    translation.drawing.push(Drawn { kind, values: vec![at, axis], needs: Vec::new() });
}

/// Draws two points that are held together.
pub(in crate::bodies) fn draw_pin(
    translation: &mut Translation<'_>,
    name: &str,
    at: AstId,
    links: [Option<usize>; 2],
) {
    let links = links.map(|link| Some(translation.space.as_ref()?.name_of(link?).to_owned()));
    let mut terms = translation.terms();
    let axis = unit(&mut terms, 2);
    let axis = terms.vector(&axis);
    let kind = DrawnKind::SpatialJoint { name: name.to_owned(), kind: SpatialJointForm::Pin, links };
    translation.drawing.push(Drawn { kind, values: vec![at, axis], needs: Vec::new() });
}

/// Returns the body of a load on a link, with its centre. The body is the link itself or, for a
/// frame, the body in which it is fixed.
pub(super) fn loaded_body(translation: &mut Translation<'_>, link: usize) -> Option<(String, AstId)> {
    let space = translation.space.as_ref()?;
    let Link { name, inertia, placed, .. } = space.links[space.loaded_link(link)?].clone();
    let mut terms = translation.terms();
    let own = inertia.map_or_else(|| zero_triple(&mut terms), |MassProperties { centroid, .. }| centroid);
    let center = placed?.0.place_of(&mut terms, own);
    Some((name.text, terms.vector(&center)))
}
