//! Poses and motions of bodies and frames in world axes, as emitted code returns them.
//!
//! Motions are those of the recursion in body-fixed axes, rotated to world axes. Twists are written
//! joint by joint along the path to a frame. A turn by θ about the axis e through the point o adds
//! θ̇ e to ω. It also adds θ̇ e × (r − o) to the velocity of the origin r. A move by s along e adds
//! ṡ e to the velocity. The coefficients of the rates are thus the geometric Jacobian, independent
//! of the recursion.
//!
//! Source: Siciliano, Sciavicco, Villani, Oriolo, *Robotics: Modelling, Planning and Control*,
//! §3.1.

use super::frames::{FrameStep, Pose};
use super::links::{Link, MassProperties, Path};
use super::vectors::{Triple, cross, minus, plus, scale, zero_triple};
use crate::bodies::plain::{FramePose, FrameTwist, SpatialKinematics, SpatialMotion};
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::Declaration;

/// The kinematics that a declaration requests.
#[derive(Clone, Copy)]
pub(in crate::bodies) struct Asked {
    motions: bool,
    frames: bool,
    twists: bool,
}

impl Asked {
    pub(in crate::bodies) fn of(declaration: &Declaration) -> Asked {
        let asks_for = |products: &[&str]| products.iter().any(|product| declaration.asks_for(product));
        let motions =
            ["motion", "drawing", "center_of_mass", "centroidal_momentum", "centroidal_momentum_matrix"];
        let [motions, frames, twists] = [&motions[..], &["frames"], &["frame_jacobians"]].map(asks_for);
        Asked { motions, frames, twists }
    }
}

/// Returns the requested kinematics; empty after an error, or in the plane.
pub(in crate::bodies) fn kinematics_asked_for(
    translation: &mut Translation<'_>,
    asked: Asked,
) -> SpatialKinematics {
    let mut found = SpatialKinematics::default();
    let Some(space) = translation.space.as_ref().filter(|_| !translation.report.has_errors()) else {
        return found;
    };
    for link in space.links.clone() {
        let Some((pose, _)) = link.placed else { continue };
        translation.origin = link.name.span.into();
        let (name, Pose { axes, origin, .. }) = (link.name.clone(), pose);
        if asked.motions
            && let Some(inertia) = link.inertia
        {
            found.motions.push(motion(translation, &link, pose, inertia));
        }
        if asked.frames {
            found.frames.push(FramePose { name: name.clone(), axes, origin });
        }
        if asked.twists {
            let [spin, velocity] = twist(translation, &link, origin);
            found.twists.push(FrameTwist { name, spin, velocity });
        }
    }
    found
}

fn motion(
    translation: &mut Translation<'_>,
    link: &Link,
    pose: Pose,
    MassProperties { mass, centroid, tensor, .. }: MassProperties,
) -> SpatialMotion {
    let mut terms = translation.terms();
    let tensor = tensor.unwrap_or_else(|| [terms.number(0); 6]);
    let center = pose.place_of(&mut terms, centroid);
    let [velocity, acceleration] = match link.path {
        Some(_) => rates_of_point(&mut terms, &pose, centroid),
        None => [
            center.map(|component| terms.rate(component)),
            center.map(|component| terms.second_rate(component)),
        ],
    };
    let change = pose.spin.map(|component| terms.rate(component));
    SpatialMotion {
        body: link.name.clone(),
        mass,
        tensor,
        centroid,
        axes: pose.axes,
        center: [center, velocity, acceleration],
        turning: [pose.spin, change].map(|own| pose.in_world(&mut terms, own)),
    }
}

/// Returns velocity and acceleration of a point that is fixed in a frame, in the world. With v its
/// velocity in body-fixed axes, its acceleration in these is v̇ + ω × v.
fn rates_of_point(terms: &mut TermWriter<'_>, pose: &Pose, point: Triple) -> [Triple; 2] {
    let velocity = pose.velocity_of(terms, point);
    let rate = velocity.map(|component| terms.rate(component));
    let turning = cross(terms, pose.spin, velocity);
    let acceleration = plus(terms, rate, turning);
    [velocity, acceleration].map(|own| pose.in_world(terms, own))
}

/// Returns angular velocity and velocity of a point that moves with a link, from all joints on its
/// path.
fn twist(translation: &mut Translation<'_>, link: &Link, place: Triple) -> [Triple; 2] {
    let mut twist = [zero_triple(&mut translation.terms()); 2];
    let mut next = Some(link.clone());
    while let Some(Link { placed: Some((pose, _)), path, .. }) = next {
        let Some(Path { carrier, steps }) = path else {
            return twist_by_hand(&mut translation.terms(), twist, &pose, place);
        };
        let carrier =
            carrier.and_then(|link| translation.space.as_ref().map(|space| space.links[link].clone()));
        let mut terms = translation.terms();
        let placed = carrier.as_ref().and_then(|carrier| carrier.placed);
        let mut before = placed.map_or_else(|| Pose::at_rest(&mut terms), |(pose, _)| pose);
        for (step, behind) in steps {
            twist = with_step(&mut terms, twist, [&before, &behind], step, place);
            before = behind;
        }
        next = carrier;
    }
    twist
}

/// Adds the contribution of a step to the angular velocity and to the velocity of a point.
fn with_step(
    terms: &mut TermWriter<'_>,
    [spin, velocity]: [Triple; 2],
    [before, behind]: [&Pose; 2],
    step: FrameStep,
    place: Triple,
) -> [Triple; 2] {
    match step {
        FrameStep::Shift(_) | FrameStep::Reorientation(_) => [spin, velocity],
        FrameStep::Turn(about, angle) => {
            let (axis, rate) = (before.axis_in_world(terms, about), terms.rate(angle));
            let [turned, moved] = turning_about(terms, axis, before.origin, place)
                .map(|direction| scale(terms, rate, direction));
            [plus(terms, spin, turned), plus(terms, velocity, moved)]
        }
        FrameStep::Orientation(axes) => {
            let turning = behind.in_world(terms, axes.spin);
            let [turned, moved] = turning_about(terms, turning, behind.origin, place);
            [plus(terms, spin, turned), plus(terms, velocity, moved)]
        }
        FrameStep::Slide(along, distance) => {
            let (axis, rate) = (before.axis_in_world(terms, along), terms.rate(distance));
            let moved = scale(terms, rate, axis);
            [spin, plus(terms, velocity, moved)]
        }
    }
}

/// Returns an angular velocity, and the velocity of a place that turns with it about a point.
fn turning_about(terms: &mut TermWriter<'_>, turning: Triple, point: Triple, place: Triple) -> [Triple; 2] {
    let arm = minus(terms, place, point);
    [turning, cross(terms, turning, arm)]
}

/// Returns the contribution of the first link of the path, whose motion uses rates of the user's
/// expressions: ω and ṙ_O + ω × (r − r_O).
fn twist_by_hand(
    terms: &mut TermWriter<'_>,
    [spin, velocity]: [Triple; 2],
    pose: &Pose,
    place: Triple,
) -> [Triple; 2] {
    let turning = pose.in_world(terms, pose.spin);
    let rate = pose.origin.map(|component| terms.rate(component));
    let arm = match place == pose.origin {
        true => zero_triple(terms),
        false => minus(terms, place, pose.origin),
    };
    let moved = cross(terms, turning, arm);
    let velocity = plus(terms, velocity, moved);
    [plus(terms, spin, turning), plus(terms, velocity, rate)]
}
