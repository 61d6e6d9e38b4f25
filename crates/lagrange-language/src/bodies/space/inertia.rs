//! Mass and mass distribution of bodies in space.

use super::links::MassProperties;
use super::messages as words;
use super::numbers::is_no_vector;
use super::poses::named_vector;
use super::solids::{self, SolidInSpace};
use super::vectors::{Matrix, Tensor, Triple, minus, scale, unit, zero_triple};
use crate::bodies::changing_mass::{matter, may_change};
use crate::bodies::expressions::mention;
use crate::bodies::mass_geometry::property;
use crate::bodies::messages;
use crate::bodies::plain::{Obligation, Outline};
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId, Shape};
use crate::syntax::foreign;

/// Returns the stated mass properties of a body; for parts see [`super::compound`].
pub(super) fn mass_properties(
    translation: &mut Translation<'_>,
    statement: &ast::Body,
) -> (MassProperties, Vec<Outline>) {
    let name = &statement.name;
    let mass = crate::bodies::body::mass_of(translation, statement);
    let shape = statement.shape.as_ref().and_then(|shape| shape_of(translation, shape));
    let centroid = match (statement.centroid, &shape) {
        (Some(centroid), _) => fixed_triple(translation, centroid, &messages::centroid_of(&name.text)),
        (None, Some((solid, dimensions))) => {
            let centroid = (solid.centroid)(&mut translation.terms(), dimensions);
            named_vector(translation, &format!("{}_centroid", name.text), centroid)
        }
        (None, None) => zero_triple(&mut translation.terms()),
    };
    let stated = stated_tensor(translation, statement);
    let tensor = stated.or_else(|| {
        let Some((solid, dimensions)) = &shape else {
            // An unknown shape is reported.
            return statement.shape.as_ref().map(|_| [translation.terms().invalid(); 6]);
        };
        Some(tensor_of_solid(translation, solid, dimensions, mass))
    });
    if let Some(tensor) = tensor {
        oblige(translation, name, tensor);
    }
    let outline = shape.map(|shape| outline_around(translation, shape, centroid));
    let entries = tensor.iter().flatten().copied().collect();
    let changes = may_change(translation, name, mass, entries);
    (MassProperties { mass, centroid, tensor, changes }, outline.into_iter().collect())
}

/// Returns a solid whose centre of mass is the centroid of the body.
fn outline_around(
    translation: &mut Translation<'_>,
    (solid, dimensions): (&'static SolidInSpace, Vec<AstId>),
    centroid: Triple,
) -> Outline {
    let mut terms = translation.terms();
    let own = (solid.centroid)(&mut terms, &dimensions);
    let at = minus(&mut terms, centroid, own);
    let rotation = [0, 1, 2].map(|axis| unit(&mut terms, axis));
    outline_of(solid, dimensions, at, rotation)
}

/// Returns a solid at a position in the axes of the body, turned in them.
pub(super) fn outline_of(
    solid: &'static SolidInSpace,
    dimensions: Vec<AstId>,
    at: Triple,
    rotation: Matrix,
) -> Outline {
    let place = at.iter().chain(rotation.iter().flatten()).copied().collect();
    Outline { variant: solid.variant, dimensions, place, is_hole: false }
}

/// Returns the stated moments and products of inertia, or principal moments, of a body.
fn stated_tensor(translation: &mut Translation<'_>, statement: &ast::Body) -> Option<Tensor> {
    let what = words::tensor_of(&statement.name.text);
    if let Some(tensor) = statement.tensor {
        return Some(tensor.map(|component| matter(translation, component, &what)));
    }
    let stated = statement.inertia?;
    let moments = triple_of(translation, stated, &what);
    matter(translation, stated, &what);
    let zero = translation.terms().number(0);
    Some([moments[0], moments[1], moments[2], zero, zero, zero])
}

/// Requires that a tensor belongs to some distribution of mass.
pub(super) fn oblige(translation: &mut Translation<'_>, body: &ast::Name, tensor: Tensor) {
    translation.obligations.push(Obligation::Tensor { body: body.clone(), tensor });
}

/// Returns a known solid with its dimensions; anything else is reported.
pub(super) fn shape_of(
    translation: &mut Translation<'_>,
    shape: &Shape,
) -> Option<(&'static SolidInSpace, Vec<AstId>)> {
    let name = &shape.solid.text;
    let what = messages::dimension_of(name);
    let dimensions = shape.dimensions.iter().map(|&id| property(translation, id, &what)).collect::<Vec<_>>();
    let Some(solid) = solids::by_name(name) else {
        let known = foreign::solid(name).filter(|known| solids::by_name(known).is_some());
        let help = match known.or_else(|| solids::nearest(name)) {
            Some(known) => messages::did_you_mean(known),
            None => words::solids_are(),
        };
        translation.report.error(shape.solid.span, messages::unknown_solid(name)).help(help);
        return None;
    };
    if solid.dimensions.len() != dimensions.len() {
        if !translation.are_read(&shape.dimensions) {
            return None;
        }
        let message = messages::wrong_dimensions(name, dimensions.len());
        translation.report.error(shape.origin, message).help(messages::shape_usage(solid.usage()));
        return None;
    }
    Some((solid, dimensions))
}

/// Returns the principal moments of a solid as a tensor about its centre of mass.
pub(super) fn tensor_of_solid(
    translation: &mut Translation<'_>,
    solid: &SolidInSpace,
    dimensions: &[AstId],
    mass: AstId,
) -> Tensor {
    let mut terms = translation.terms();
    let moments = (solid.moments)(&mut terms, dimensions);
    let [x, y, z] = scale(&mut terms, mass, moments);
    let zero = terms.number(0);
    [x, y, z, zero, zero, zero]
}

/// Returns the components of a vector that does not change during the motion.
pub(in crate::bodies) fn fixed_triple(translation: &mut Translation<'_>, id: AstId, what: &str) -> Triple {
    let components = triple_of(translation, id, what);
    let value = mention(translation, id);
    translation.obligations.push(Obligation::Fixed { what: what.to_owned(), value });
    components
}

/// Returns the components of a vector in space.
pub(in crate::bodies) fn triple_of(translation: &mut Translation<'_>, id: AstId, what: &str) -> Triple {
    let value = mention(translation, id);
    translation.obligations.push(Obligation::SpaceVector { what: what.to_owned(), value });
    components_of(translation, value)
}

/// Returns the components of a vector in space; an expression that cannot be one is reported as a
/// whole.
pub(super) fn components_of(translation: &mut Translation<'_>, value: AstId) -> Triple {
    match is_no_vector(translation, value) {
        true => [translation.terms().invalid(); 3],
        false => translation.terms().triple(value),
    }
}
