//! Bodies in space by their inertial parameters and the motion that multiplies them.

use super::accelerations::accelerations_on_path;
use super::links::MassProperties;
use super::poses::link_at;
use super::vectors::{Tensor, Triple, scale, tensor_of_point, tensor_sum};
use crate::bodies::plain::InertialBody;
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::AstId;

/// Returns all placed bodies, in the order of their declaration.
pub(in crate::bodies) fn inertial_bodies_in_space(translation: &mut Translation<'_>) -> Vec<InertialBody> {
    let count = translation.space.as_ref().map_or(0, |space| space.links.len());
    (0..count).filter_map(|link| inertial_body(translation, link)).collect()
}

fn inertial_body(translation: &mut Translation<'_>, index: usize) -> Option<InertialBody> {
    let link = link_at(translation, index)?;
    let MassProperties { mass, centroid, tensor, .. } = link.inertia?;
    translation.origin = link.name.span.into();
    let (pose, change) = *accelerations_on_path(translation, index)?.last()?;
    let mut terms = translation.terms();
    let tensor = tensor.unwrap_or_else(|| [terms.number(0); 6]);
    let [x, y, z] = pose.velocity;
    let [along_x, along_y, along_z] = change.origin;
    Some(InertialBody {
        body: link.name,
        parameters: inertial_parameters(&mut terms, mass, centroid, tensor),
        lagrangian: link.energies.lagrangian(&mut terms),
        twist: [x, y, z, pose.spin[0], pose.spin[1], pose.spin[2]],
        change: [along_x, along_y, along_z, change.spin[0], change.spin[1], change.spin[2]],
    })
}

/// Returns mass, first moments, and the tensor about the origin, from the tensor about the centre
/// of mass.
pub(in crate::bodies) fn inertial_parameters(
    terms: &mut TermWriter<'_>,
    mass: AstId,
    centroid: Triple,
    tensor: Tensor,
) -> [AstId; 10] {
    let [x, y, z] = scale(terms, mass, centroid);
    let shift = tensor_of_point(terms, mass, centroid);
    let [xx, yy, zz, xy, xz, yz] = tensor_sum(terms, tensor, shift);
    [mass, x, y, z, xx, yy, zz, xy, xz, yz]
}
