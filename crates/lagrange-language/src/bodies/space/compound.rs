//! Bodies in space of several parts, including holes.
//!
//! M = Σ ±mᵢ, M r_S = Σ ±mᵢ rᵢ, J = Σ ±(Rᵢ Jᵢ Rᵢᵀ + mᵢ (dᵢ² 1 − dᵢ dᵢᵀ)) with dᵢ = rᵢ − r_S
//! (Steiner, Huygens). The lower sign is for holes.

use super::inertia::{fixed_triple, oblige, outline_of, shape_of, tensor_of_solid};
use super::links::MassProperties;
use super::messages as words;
use super::orientations::orientation;
use super::poses::named_vector;
use super::solids::SolidInSpace;
use super::vectors::{
    Matrix, Tensor, Triple, apply, minus, plus, scale, tensor_of_point, tensor_sum, turned_tensor, unit,
    zero_triple,
};
use crate::bodies::compound::{mass_of_part, report_beside_compound, report_masses};
use crate::bodies::messages;
use crate::bodies::plain::{Obligation, Outline};
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId, Part};

/// A part, and its known properties in the axes of the body.
struct SpatialPart {
    is_hole: bool,
    mass: AstId,
    centroid: Triple,
    /// Tensor about its own centre of mass.
    tensor: Tensor,
    outline: Outline,
}

/// Returns the common mass, centre of mass and tensor, and the parts to draw; `None` after an
/// error.
pub(super) fn compound_properties(
    translation: &mut Translation<'_>,
    statement: &ast::Body,
) -> Option<(MassProperties, Vec<Outline>)> {
    report_beside_compound(translation, statement);
    let parts = statement.parts.iter().map(|part| spatial_part(translation, part)).collect::<Vec<_>>();
    let parts = parts.into_iter().collect::<Option<Vec<_>>>()?;
    let name = &statement.name.text;
    let (mass, moment) = common_mass(&mut translation.terms(), &parts);
    let mass = translation.bind(&format!("{name}_mass"), mass);
    translation.obligations.push(Obligation::PositiveMass { body: statement.name.clone(), mass });
    let mut terms = translation.terms();
    let centroid = moment.map(|component| terms.divide(component, mass));
    let centroid = named_vector(translation, &format!("{name}_centroid"), centroid);
    let tensor = common_tensor(&mut translation.terms(), &parts, centroid);
    let tensor = named_tensor(translation, name, tensor);
    oblige(translation, &statement.name, tensor);
    let outlines = parts.into_iter().map(|part| part.outline).collect();
    Some((MassProperties { mass, centroid, tensor: Some(tensor), changes: false }, outlines))
}

/// Returns Σ ±mᵢ and Σ ±mᵢ rᵢ.
fn common_mass(terms: &mut TermWriter<'_>, parts: &[SpatialPart]) -> (AstId, Triple) {
    let mut mass = terms.number(0);
    let mut moment = zero_triple(terms);
    for part in parts {
        let signed = signed_mass(terms, part);
        mass = terms.plus(mass, signed);
        let share = scale(terms, signed, part.centroid);
        moment = plus(terms, moment, share);
    }
    (mass, moment)
}

/// Returns Σ ±(Jᵢ + mᵢ (dᵢ² 1 − dᵢ dᵢᵀ)).
fn common_tensor(terms: &mut TermWriter<'_>, parts: &[SpatialPart], centroid: Triple) -> Tensor {
    let mut tensor = [terms.number(0); 6];
    for part in parts {
        let signed = signed_mass(terms, part);
        let arm = minus(terms, part.centroid, centroid);
        let moved = tensor_of_point(terms, signed, arm);
        let own = match part.is_hole {
            true => part.tensor.map(|component| terms.negative(component)),
            false => part.tensor,
        };
        let share = tensor_sum(terms, own, moved);
        tensor = tensor_sum(terms, tensor, share);
    }
    tensor
}

fn signed_mass(terms: &mut TermWriter<'_>, part: &SpatialPart) -> AstId {
    if part.is_hole { terms.negative(part.mass) } else { part.mass }
}

fn named_tensor(translation: &mut Translation<'_>, name: &str, tensor: Tensor) -> Tensor {
    let [xx, yy, zz, xy, xz, yz] = tensor;
    let moments = named_vector(translation, &format!("{name}_moments"), [xx, yy, zz]);
    let products = named_vector(translation, &format!("{name}_products"), [xy, xz, yz]);
    [moments[0], moments[1], moments[2], products[0], products[1], products[2]]
}

/// Returns the outlines of a body for display.
pub(super) fn visual_outlines(translation: &mut Translation<'_>, visuals: &[Part]) -> Vec<Outline> {
    report_masses(translation, visuals);
    let placed = visuals.iter().map(|part| placed_solid(translation, part)).collect::<Vec<_>>();
    placed.into_iter().flatten().map(|placed| placed.outline).collect()
}

/// A solid with its place in the axes of the body.
struct PlacedSolid {
    solid: &'static SolidInSpace,
    dimensions: Vec<AstId>,
    at: Triple,
    /// `None` if it is not turned.
    rotation: Option<Matrix>,
    outline: Outline,
}

fn placed_solid(translation: &mut Translation<'_>, part: &Part) -> Option<PlacedSolid> {
    let shape = shape_of(translation, &part.shape);
    let at = match part.at {
        Some(at) => fixed_triple(translation, at, messages::PLACE_OF_PART),
        None => zero_triple(&mut translation.terms()),
    };
    if let Some(angle) = part.angle {
        let origin = translation.expressions.origin(angle);
        translation.report.error(origin, words::PART_ANGLE).help(words::PART_ANGLE_HELP);
    }
    let rotation = part.turned.map(|turned| orientation(translation, turned, words::ORIENTATION_OF_PART));
    let (solid, dimensions) = shape?;
    let mut terms = translation.terms();
    let axes = rotation.unwrap_or_else(|| [0, 1, 2].map(|axis| unit(&mut terms, axis)));
    let outline = Outline { is_hole: part.is_hole, ..outline_of(solid, dimensions.clone(), at, axes) };
    Some(PlacedSolid { solid, dimensions, at, rotation, outline })
}

fn spatial_part(translation: &mut Translation<'_>, part: &Part) -> Option<SpatialPart> {
    let placed = placed_solid(translation, part);
    let mass = mass_of_part(translation, part);
    let PlacedSolid { solid, dimensions, at, rotation, outline } = placed?;
    let mass = mass?;
    let own = tensor_of_solid(translation, solid, &dimensions, mass);
    let mut terms = translation.terms();
    let center = (solid.centroid)(&mut terms, &dimensions);
    let (arm, tensor) = match rotation {
        Some(rotation) => (apply(&mut terms, rotation, center), turned_tensor(&mut terms, rotation, own)),
        None => (center, own),
    };
    let centroid = plus(&mut terms, at, arm);
    Some(SpatialPart { is_hole: part.is_hole, mass, centroid, tensor, outline })
}
