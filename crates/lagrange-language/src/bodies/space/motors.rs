//! Forces and moments on joint coordinates: motors and damping.
//!
//! A load u on a coordinate q has the power u q̇. If a joint turns by q about e, the power is that
//! of the moments ±u e on the placed body and its carrier. If it moves by q along e, it is that of
//! the forces ±u e at the origin of the placed body. A screw does both at once, so neither is
//! known.

use super::frames::{FrameStep, JointAxis, Pose};
use super::links::{Link, Path};
use super::scene::LoadOnCoordinate;
use super::vectors::{Triple, scale};
use crate::bodies::drawing::{Load, draw_force, draw_moment, torque_on};
use crate::bodies::expressions::plain_expression;
use crate::bodies::plain::{Drawn, DrawnKind, LoadOrigin};
use crate::bodies::translation::Translation;
use crate::syntax::ast::{AstId, Expression, Mobilizer, StatementKind};

/// The effect of a coordinate at a joint.
struct JointMotion {
    /// True if it turns the placed link, false if it moves it.
    turns: bool,
    /// The axis in the world.
    axis: Triple,
    /// The origin of the placed link.
    at: Triple,
    /// The placed and the carrying link.
    sides: [Option<usize>; 2],
}

/// Draws `force q = u;`.
pub(in crate::bodies) fn draw_force_on_coordinate(
    translation: &mut Translation<'_>,
    coordinate: &str,
    load: AstId,
) {
    let name = format!("force on `{coordinate}`");
    let coordinate = translation.terms().name(coordinate);
    keep(translation, (name, LoadOrigin::Applied), [coordinate, load]);
}

/// Draws `torque u on q;`.
pub(in crate::bodies) fn draw_torque_on_angle(
    translation: &mut Translation<'_>,
    angle: AstId,
    moment: AstId,
) {
    let name = torque_on(translation, angle);
    keep(translation, (name, LoadOrigin::Applied), [angle, moment]);
}

/// Draws `damping: c;` of a joint: −c q̇, or −c ω in a ball joint, component by component.
pub(super) fn draw_damping(translation: &mut Translation<'_>, joint: &Mobilizer) {
    let Some(damping) = joint.damping.filter(|_| translation.is_drawn) else { return };
    let damping = plain_expression(translation, damping);
    let components = joint.quaternion.iter().flat_map(|quaternion| &quaternion.velocities);
    let is_ball = joint.quaternion.is_some();
    for name in components.chain(joint.coordinates.iter().filter(|_| !is_ball)) {
        let mut terms = translation.terms();
        let coordinate = terms.name(&name.text);
        let speed = if is_ball { coordinate } else { terms.rate(coordinate) };
        let product = terms.times(damping, speed);
        let load = terms.negative(product);
        let name = format!("damping of `{}`", name.text);
        keep(translation, (name, LoadOrigin::Connector), [coordinate, load]);
    }
}

fn keep(
    translation: &mut Translation<'_>,
    (name, cause): (String, LoadOrigin),
    [coordinate, load]: [AstId; 2],
) {
    let position = translation.loads.len();
    let Some(space) = &mut translation.space else { return };
    space.loads_on_coordinates.push(LoadOnCoordinate { position, name, cause, coordinate, load });
}

/// Inserts the postponed loads in their places among the others.
pub(super) fn draw_loads_on_coordinates(translation: &mut Translation<'_>) {
    let Some(space) = &mut translation.space else { return };
    // Starting with the last one, so that earlier places stay valid.
    for kept in std::mem::take(&mut space.loads_on_coordinates).into_iter().rev() {
        let behind = translation.loads.split_off(kept.position);
        match motion_by(translation, kept.coordinate) {
            Some(motion) => draw_on_both_sides(translation, &motion, (kept.cause, kept.load)),
            None => {
                let kind = DrawnKind::Omitted { name: kept.name };
                translation.loads.push(Drawn { kind, values: Vec::new(), needs: Vec::new() });
            }
        }
        translation.loads.extend(behind);
    }
}

fn draw_on_both_sides(
    translation: &mut Translation<'_>,
    motion: &JointMotion,
    (cause, load): (LoadOrigin, AstId),
) {
    let name = match (cause, motion.turns) {
        (LoadOrigin::Connector, _) => "damping",
        (_, true) => "torque",
        (_, false) => "force",
    };
    let mut terms = translation.terms();
    let along = scale(&mut terms, load, motion.axis);
    let against = along.map(|component| terms.negative(component));
    let at = terms.vector(&motion.at);
    let vectors = [along, against].map(|vector| terms.vector(&vector));
    for (side, vector) in motion.sides.into_iter().zip(vectors) {
        let Some(space) = &translation.space else { return };
        let Some(body) = side.and_then(|link| space.loaded_link(link)) else { continue };
        let body = Some(space.name_of(body).to_owned());
        match motion.turns {
            true => draw_moment(translation, Load { name, cause, body }, [at, vector]),
            false => draw_force(translation, Load { name, cause, body }, [at, vector], &[]),
        }
    }
}

/// Returns the motion that a coordinate, or a velocity that is its rate, causes at a joint; `None`
/// unless it causes exactly one.
fn motion_by(translation: &mut Translation<'_>, coordinate: AstId) -> Option<JointMotion> {
    let name = coordinate_behind(translation, coordinate)?;
    let links = translation.space.as_ref()?.links.iter().enumerate();
    let (link, carrier, axis, frame, last) = links
        .filter_map(|(link, found)| {
            let Link { path: Some(Path { carrier, steps }), .. } = found else { return None };
            let (axis, frame) = step_by(translation, steps, &name)?;
            Some((link, *carrier, axis, frame, steps.last()?.1))
        })
        .next()?;
    let mut terms = translation.terms();
    let (turns, axis) = axis;
    let axis = frame.axis_in_world(&mut terms, axis);
    Some(JointMotion { turns, axis, at: last.origin, sides: [Some(link), carrier] })
}

/// Returns the step that a coordinate moves, true if it turns, and its axis in the frame after the
/// step. The axis is also at rest in the frame before.
fn step_by(
    translation: &Translation<'_>,
    steps: &[(FrameStep, Pose)],
    name: &str,
) -> Option<((bool, JointAxis), Pose)> {
    let name_of = |id: AstId| match translation.expressions.get(id) {
        Expression::Name(name) => Some(name.as_str()),
        _ => None,
    };
    let is_it = |id: AstId| name_of(id) == Some(name);
    // A screw moves by a multiple of its angle.
    let slides_by = |step: &FrameStep| match step {
        FrameStep::Slide(_, distance) => name_of(*distance).is_some(),
        _ => true,
    };
    if !steps.iter().all(|(step, _)| slides_by(step)) {
        return None;
    }
    steps.iter().find_map(|(step, behind)| {
        let motion = match step {
            FrameStep::Turn(axis, angle) if is_it(*angle) => (true, *axis),
            FrameStep::Slide(axis, distance) if is_it(*distance) => (false, *axis),
            FrameStep::Orientation(axes) => {
                (true, JointAxis::positive(axes.spin.into_iter().position(is_it)?))
            }
            _ => return None,
        };
        Some((motion, *behind))
    })
}

/// Returns the coordinate of a name, which may be its rate; the name itself if it is not known as a
/// rate.
fn coordinate_behind(translation: &Translation<'_>, id: AstId) -> Option<String> {
    let Expression::Name(wanted) = translation.expressions.get(id) else { return None };
    let rate = translation.statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Velocity(name, rate) if name.text == *wanted => Some(*rate),
        _ => None,
    });
    let of = match rate.map(|rate| translation.expressions.get(rate)) {
        Some(Expression::Call(function, arguments)) if function.text == "dot" => arguments.first(),
        _ => None,
    };
    match of.map(|&of| translation.expressions.get(of)) {
        Some(Expression::Name(name)) => Some(name.clone()),
        _ => Some(wanted.clone()),
    }
}
