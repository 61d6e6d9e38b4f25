//! Points and directions that are fixed in bodies and frames: their world coordinates and motion.

use super::frames::Pose;
use super::links::Link;
use super::poses::{has_place, named_vector};
use super::vectors::{Matrix, Triple, apply, cross, plus, transposed};
use crate::bodies::translation::Translation;

/// Returns the pose of a link; one without a place is reported.
fn pose_of(translation: &mut Translation<'_>, link: usize) -> Pose {
    let pose = has_place(translation, link, translation.origin);
    pose.unwrap_or_else(|| Pose::invalid(&mut translation.terms()))
}

/// Returns the world position of a point of a link.
pub(in crate::bodies) fn place_on_link(
    translation: &mut Translation<'_>,
    link: usize,
    own: Triple,
) -> Triple {
    pose_of(translation, link).place_of(&mut translation.terms(), own)
}

/// Returns the world components of a vector given in a link.
pub(in crate::bodies) fn vector_on_link(
    translation: &mut Translation<'_>,
    link: usize,
    own: Triple,
) -> Triple {
    pose_of(translation, link).in_world(&mut translation.terms(), own)
}

/// Returns the angular velocity of a link in the world.
pub(in crate::bodies) fn spin_of_link(translation: &mut Translation<'_>, link: usize) -> Triple {
    let pose = pose_of(translation, link);
    pose.in_world(&mut translation.terms(), pose.spin)
}

/// Returns the world velocity of a point of a link: that of the origin plus Ṙ p. Here p is a vector
/// of numbers or parameters, so all points share Ṙ, its rate and its derivatives. The origin of a
/// free body moves at the rates of its coordinates, without any rotation.
pub(in crate::bodies) fn velocity_on_link(
    translation: &mut Translation<'_>,
    link: usize,
    own: Triple,
) -> Triple {
    let pose = pose_of(translation, link);
    let is_free = is_free(translation, link);
    let mut terms = translation.terms();
    let of_origin = match is_free {
        true => pose.origin.map(|component| terms.rate(component)),
        false => pose.in_world(&mut terms, pose.velocity),
    };
    if own.iter().all(|&component| terms.is_zero(component)) {
        return of_origin;
    }
    let rates = rotation_rates(translation, link, &pose);
    let mut terms = translation.terms();
    let turning = apply(&mut terms, rates, own);
    plus(&mut terms, of_origin, turning)
}

/// Returns Ṙ in rows: u × ω for each world axis u in the axes of the link.
fn rotation_rates(translation: &mut Translation<'_>, link: usize, pose: &Pose) -> Matrix {
    let Some(space) = &translation.space else { return pose.axes };
    if let Some(rates) = space.rotation_rates.get(&link) {
        return *rates;
    }
    let name = space.links[link].name.text.clone();
    let mut terms = translation.terms();
    let rows = transposed(pose.axes).map(|axis| cross(&mut terms, axis, pose.spin));
    let [x, y, z] = rows;
    let rates = [("x", x), ("y", y), ("z", z)]
        .map(|(axis, row)| named_vector(translation, &format!("{name}_R_rate_{axis}"), row));
    if let Some(space) = &mut translation.space {
        space.rotation_rates.insert(link, rates);
    }
    rates
}

fn is_free(translation: &Translation<'_>, link: usize) -> bool {
    translation.space.as_ref().is_some_and(|space| {
        let Link { name, path, .. } = &space.links[link];
        path.is_some() && space.freed.contains(&name.text)
    })
}

/// Returns the origin of a link, its velocity and the angular velocity, in the world.
pub(in crate::bodies) fn origin_motion(
    translation: &mut Translation<'_>,
    link: usize,
) -> (Triple, Triple, Triple) {
    let zero = [translation.terms().number(0); 3];
    let origin = pose_of(translation, link).origin;
    (origin, velocity_on_link(translation, link, zero), spin_of_link(translation, link))
}
