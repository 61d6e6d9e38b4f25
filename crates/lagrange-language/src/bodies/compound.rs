//! Bodies of several parts, including holes.
//!
//! M = Σ ±mᵢ, M r_S = Σ ±mᵢ rᵢ, J = Σ ±(Jᵢ + mᵢ |rᵢ − r_S|²) by Steiner's theorem, with the lower
//! sign for holes.

use super::mass_geometry::{MassGeometry, fixed_vector, inertia_of, named_centroid, property, shape_of};
use super::messages;
use super::plain::Outline;
use super::terms::Pair;
use super::translation::Translation;
use crate::syntax::ast::{self, AstId, Part};
use lagrange_expr::solids::Solid;

/// A part and its known properties.
struct CompoundPart {
    is_hole: bool,
    mass: AstId,
    /// Moment of inertia about its own centre of mass.
    inertia: AstId,
    /// Centre of mass in the body's coordinates.
    centroid: Pair,
    outline: Outline,
}

pub(super) fn compound_geometry(translation: &mut Translation<'_>, statement: &ast::Body) -> MassGeometry {
    report_beside_compound(translation, statement);
    let pieces = statement
        .parts
        .iter()
        .map(|part| compound_part(translation, &statement.name.text, part))
        .collect::<Vec<_>>();
    let Some(pieces) = pieces.into_iter().collect::<Option<Vec<_>>>() else {
        let invalid = translation.terms().invalid();
        let (centroid, outlines) = ([invalid, invalid], Vec::new());
        let inertia = Some(invalid);
        return MassGeometry { mass: invalid, inertia, centroid, changes: false, outlines, radius: None };
    };
    let name = &statement.name.text;
    let mass = sum_of(translation, &pieces, |_, piece| piece.mass);
    let mass = translation.bind(&format!("{name}_mass"), mass);
    translation.obligations.push(super::Obligation::PositiveMass { body: statement.name.clone(), mass });
    let centroid = common_centroid(translation, name, &pieces, mass);
    let inertia = sum_of(translation, &pieces, |translation, piece| {
        let mut terms = translation.terms();
        let arm = terms.minus_pair(piece.centroid, centroid);
        let square = terms.squared_length(arm);
        let moved = terms.times(piece.mass, square);
        terms.plus(piece.inertia, moved)
    });
    let inertia = translation.bind(&format!("{name}_inertia"), inertia);
    let outlines = pieces.into_iter().map(|piece| piece.outline).collect();
    MassGeometry { mass, inertia: Some(inertia), centroid, changes: false, outlines, radius: None }
}

pub(super) fn report_beside_compound(translation: &mut Translation<'_>, statement: &ast::Body) {
    let given = [("mass", statement.mass), ("inertia", statement.inertia), ("centroid", statement.centroid)];
    for (label, id) in given.into_iter().filter_map(|(label, id)| Some((label, id?))) {
        let error =
            translation.report.error(translation.expressions.origin(id), messages::beside_compound(label));
        error.help(messages::BESIDE_COMPOUND_HELP);
    }
    let tensor = statement.tensor.map(|tensor| ("inertia", translation.expressions.origin(tensor[0])));
    let shape = statement.shape.as_ref().map(|shape| ("shape", shape.origin));
    for (label, origin) in tensor.into_iter().chain(shape) {
        let error = translation.report.error(origin, messages::beside_compound(label));
        error.help(messages::BESIDE_COMPOUND_HELP);
    }
}

/// Returns the outlines of a body for display.
pub(super) fn visual_outlines(translation: &mut Translation<'_>, visuals: &[Part]) -> Vec<Outline> {
    report_masses(translation, visuals);
    let placed = visuals.iter().map(|part| placed_solid(translation, part)).collect::<Vec<_>>();
    placed.into_iter().flatten().map(|placed| placed.outline).collect()
}

/// Reports masses of parts that are only visible.
pub(super) fn report_masses(translation: &mut Translation<'_>, visuals: &[Part]) {
    for mass in visuals.iter().filter_map(|part| part.mass) {
        let error = translation.report.error(translation.expressions.origin(mass), messages::VISUAL_MASS);
        error.help(messages::VISUAL_MASS_HELP);
    }
}

/// A solid with its place in the coordinates of the body.
struct PlacedShape {
    solid: &'static Solid,
    dimensions: Vec<AstId>,
    at: Pair,
    angle: AstId,
    outline: Outline,
}

fn placed_solid(translation: &mut Translation<'_>, part: &Part) -> Option<PlacedShape> {
    let shape = shape_of(translation, &part.shape);
    let at = match part.at {
        Some(at) => fixed_vector(translation, at, messages::PLACE_OF_PART),
        None => translation.terms().zero_pair(),
    };
    if let Some(turned) = part.turned {
        let origin = translation.expressions.origin(turned);
        translation
            .report
            .error(origin, messages::TURNED_IN_THE_PLANE)
            .help(messages::TURNED_IN_THE_PLANE_HELP);
    }
    let angle = match part.angle {
        Some(angle) => property(translation, angle, messages::ANGLE_OF_PART),
        None => translation.terms().number(0),
    };
    let (solid, dimensions) = shape?;
    let place = vec![translation.terms().tuple(at), angle];
    let outline =
        Outline { variant: solid.outline, dimensions: dimensions.clone(), place, is_hole: part.is_hole };
    Some(PlacedShape { solid, dimensions, at, angle, outline })
}

fn compound_part(translation: &mut Translation<'_>, body: &str, part: &Part) -> Option<CompoundPart> {
    let placed = placed_solid(translation, part);
    let mass = mass_of_part(translation, part);
    let PlacedShape { solid, dimensions, at, angle, outline } = placed?;
    let place = part.shape.origin;
    let (mass, inertia) = (mass?, inertia_of(translation, solid, mass?, &dimensions, place));
    let name = format!("{body}_{}", solid.name);
    let own = named_centroid(translation, &name, Some(&(solid, dimensions)), place);
    let centroid = placed_point(translation, &name, own, at, angle);
    Some(CompoundPart { is_hole: part.is_hole, mass, inertia, centroid, outline })
}

/// Returns the centre of mass of a part in the body's coordinates, under a separate name if the
/// part is turned.
fn placed_point(translation: &mut Translation<'_>, name: &str, own: Pair, at: Pair, angle: AstId) -> Pair {
    let mut terms = translation.terms();
    let arm = terms.turned(own, angle);
    let centroid = terms.plus_pair(at, arm);
    if arm == own {
        return centroid;
    }
    let centroid = terms.tuple(centroid);
    let centroid = translation.bind(&format!("{name}_center"), centroid);
    translation.terms().pair(centroid)
}

pub(super) fn mass_of_part(translation: &mut Translation<'_>, part: &Part) -> Option<AstId> {
    let Some(mass) = part.mass else {
        let error = translation.report.error(part.origin, messages::PART_WITHOUT_MASS);
        error.help(messages::PART_WITHOUT_MASS_HELP);
        return None;
    };
    let body = part.shape.solid.clone();
    let mass = property(translation, mass, &messages::mass_of(&body.text));
    translation.obligations.push(super::Obligation::PositiveMass { body, mass });
    Some(mass)
}

/// Returns Σ ± over the parts.
fn sum_of(
    translation: &mut Translation<'_>,
    pieces: &[CompoundPart],
    mut term: impl FnMut(&mut Translation<'_>, &CompoundPart) -> AstId,
) -> AstId {
    let mut sum = translation.terms().number(0);
    for piece in pieces {
        let term = term(translation, piece);
        let mut terms = translation.terms();
        sum = if piece.is_hole { terms.minus(sum, term) } else { terms.plus(sum, term) };
    }
    sum
}

/// Returns the common centre of mass, each component under a separate name unless it is zero.
fn common_centroid(
    translation: &mut Translation<'_>,
    name: &str,
    pieces: &[CompoundPart],
    mass: AstId,
) -> Pair {
    [("x", 0), ("y", 1)].map(|(axis, index)| {
        let moment = sum_of(translation, pieces, |translation, piece| {
            translation.terms().times(piece.mass, piece.centroid[index])
        });
        if translation.terms().is_zero(moment) {
            return moment;
        }
        let quotient = translation.terms().divide(moment, mass);
        translation.bind(&format!("{name}_centroid_{axis}"), quotient)
    })
}
