//! Shapes with their dimensions, moments of inertia and centroids, for bodies and for parts of
//! compounds.

use super::expressions::{mention, plain_expression};
use super::messages;
use super::plain::{Obligation, Outline};
use super::terms::{Pair, TermWriter};
use super::translation::Translation;
use crate::syntax::ast::{self, AstId, Shape};
use crate::syntax::foreign;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::solids::{self, Solid};

/// Distribution of the mass of a body.
pub(super) struct MassGeometry {
    pub(super) mass: AstId,
    /// `None` if it is not specified.
    pub(super) inertia: Option<AstId>,
    pub(super) centroid: Pair,
    /// True if mass and inertia may have rates.
    pub(super) changes: bool,
    pub(super) outlines: Vec<Outline>,
    pub(super) radius: Option<AstId>,
}

/// Translates a property of the mass distribution.
pub(super) fn property(translation: &mut Translation<'_>, id: AstId, what: &str) -> AstId {
    let value = mention(translation, id);
    translation.obligations.push(Obligation::Fixed { what: what.to_owned(), value });
    value
}

/// Returns a known solid with the correct number of dimensions; anything else is reported.
pub(super) fn shape_of(
    translation: &mut Translation<'_>,
    shape: &Shape,
) -> Option<(&'static Solid, Vec<AstId>)> {
    let what = messages::dimension_of(&shape.solid.text);
    let dimensions = shape.dimensions.iter().map(|&id| property(translation, id, &what)).collect::<Vec<_>>();
    let Some(solid) = solids::by_name(&shape.solid.text) else {
        let known = foreign::solid(&shape.solid.text).or_else(|| solids::nearest(&shape.solid.text));
        let help = match known {
            Some(known) => messages::did_you_mean(known),
            None => messages::solids_are(),
        };
        translation.report.error(shape.solid.span, messages::unknown_solid(&shape.solid.text)).help(help);
        return None;
    };
    if !solid.dimensions.accept(dimensions.len()) {
        if !translation.are_read(&shape.dimensions) {
            return None;
        }
        let message = messages::wrong_dimensions(&shape.solid.text, dimensions.len());
        translation.report.error(shape.origin, message).help(messages::shape_usage(solid.shape_usage()));
        return None;
    }
    Some((solid, dimensions))
}

/// Returns the call for the moment of inertia of a solid about its centre of mass, located at
/// `place`.
pub(super) fn inertia_of(
    translation: &mut Translation<'_>,
    solid: &Solid,
    mass: AstId,
    dimensions: &[AstId],
    place: Origin,
) -> AstId {
    let arguments = [&[mass], dimensions].concat();
    TermWriter::new(&mut translation.expressions, place).call(solid.name, &arguments)
}

/// Returns the centre of mass of a solid, under a separate name if it is computed.
pub(super) fn named_centroid(
    translation: &mut Translation<'_>,
    name: &str,
    shape: Option<&(&'static Solid, Vec<AstId>)>,
    place: Origin,
) -> Pair {
    let centroid = centroid_of(translation, shape, place);
    match *translation.expressions.get(centroid[0]) {
        ast::Expression::Component(center, _) => {
            let center = translation.bind(&format!("{name}_centroid"), center);
            translation.terms().pair(center)
        }
        _ => centroid,
    }
}

pub(super) fn outline_of(
    translation: &mut Translation<'_>,
    solid: &'static Solid,
    dimensions: Vec<AstId>,
) -> Outline {
    let mut terms = translation.terms();
    let (at, angle) = (terms.zero_pair(), terms.number(0));
    Outline { variant: solid.outline, dimensions, place: vec![terms.tuple(at), angle], is_hole: false }
}

/// Returns the components of a constant vector of body-fixed coordinates.
pub(super) fn fixed_vector(translation: &mut Translation<'_>, id: AstId, what: &str) -> Pair {
    let components = vector_of(translation, id, what);
    let value = plain_expression(translation, id);
    translation.obligations.push(Obligation::Fixed { what: what.to_owned(), value });
    components
}

/// Returns the components of a vector in the plane.
pub(super) fn vector_of(translation: &mut Translation<'_>, id: AstId, what: &str) -> Pair {
    let value = mention(translation, id);
    translation.obligations.push(Obligation::PlaneVector { what: what.to_owned(), value });
    translation.terms().pair(value)
}

/// Returns the centre of mass of a solid in its own coordinates, located at `place`.
pub(super) fn centroid_of(
    translation: &mut Translation<'_>,
    shape: Option<&(&'static Solid, Vec<AstId>)>,
    place: Origin,
) -> Pair {
    let center = shape.and_then(|(solid, dimensions)| Some((solid.center_function()?, dimensions)));
    let mut terms = TermWriter::new(&mut translation.expressions, place);
    match center {
        Some((function, dimensions)) => {
            let center = terms.call(&function, dimensions);
            terms.pair(center)
        }
        None => terms.zero_pair(),
    }
}
