//! Bodies as needed by the regressor of inverse dynamics: their motion in body-fixed axes and their
//! ten inertial parameters about the body-fixed origin.
//!
//! A body in the plane is treated as one in space that turns about its third axis.

use super::object::Body;
use super::plain::InertialBody;
use super::space::{inertial_bodies_in_space, inertial_parameters};
use super::translation::Translation;

/// Returns all bodies; none after an error.
pub(super) fn inertial_bodies(translation: &mut Translation<'_>) -> Vec<InertialBody> {
    if translation.report.has_errors() {
        return Vec::new();
    }
    if translation.space.is_some() {
        return inertial_bodies_in_space(translation);
    }
    let bodies = translation.bodies.clone();
    bodies.into_iter().filter_map(|body| in_plane(translation, body)).collect()
}

/// Returns a body in the plane; `None` for a frame.
fn in_plane(translation: &mut Translation<'_>, body: Body) -> Option<InertialBody> {
    translation.origin = body.name.span.into();
    let gravity = translation.gravity.map(|(gravity, _)| gravity);
    let mut terms = translation.terms();
    if terms.is_zero(body.mass) {
        return None;
    }
    let zero = terms.number(0);
    let gravity = gravity.unwrap_or([zero; 2]);
    let axes = terms.axes(body.angle);
    let rate = body.origin.map(|component| terms.rate(component));
    let second = body.origin.map(|component| terms.second_rate(component));
    let felt = terms.minus_pair(second, gravity);
    let [velocity, acceleration] = [rate, felt].map(|world| axes.map(|axis| terms.inner(axis, world)));
    let (spin, change) = (terms.rate(body.angle), terms.second_rate(body.angle));
    let [x, y] = body.centroid;
    let tensor = [zero, zero, body.inertia, zero, zero, zero];
    Some(InertialBody {
        body: body.name,
        parameters: inertial_parameters(&mut terms, body.mass, [x, y, zero], tensor),
        lagrangian: body.energies.lagrangian(&mut terms),
        twist: [velocity[0], velocity[1], zero, zero, zero, spin],
        change: [acceleration[0], acceleration[1], zero, zero, zero, change],
    })
}
