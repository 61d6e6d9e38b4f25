//! Rims: circles of bodies that touch planes.
//!
//! A circle of radius R about c has the axis a. On a plane with the normal n, its lowest point is c
//! − R d with d = a × (n × a)/s. Here s = |n × a| is the sine of its inclination. A tube of radius
//! r around the circle makes it a torus. The gap is n·(c − p) − R s − r.
//!
//! A circle that is flat on the plane has no lowest point. Therefore, √(s² + ε²) with ε = 10⁻⁹
//! replaces s. As the circle becomes parallel, it touches below its centre, at the height R ε. At
//! the inclination s, the gap is too small by R ε²/2 s, which is less than rounding for s above
//! 0.01.
//!
//! When the axis passes through the normal, d reverses instantly. Since there are no events, the
//! motion continues as under a smooth constraint, which does no work. No restitution occurs.
//!
//! For R = 0.5 and an axis inclined by 30°, the centre is 0.25 above the plane.

use super::coefficients::{Coefficient, is_in_range, oblige};
use super::geometry::ContactGeometry;
use crate::bodies::constants::number;
use crate::bodies::mass_geometry::property;
use crate::bodies::messages::contacts as words;
use crate::bodies::object::Surface;
use crate::bodies::plain::Outline;
use crate::bodies::space::vector_on_link;
use crate::bodies::space::vectors::{Triple, cross, inner, minus, plus, scale};
use crate::bodies::surfaces::{bind_vector, unit_direction};
use crate::bodies::touching::{Touching, motion_at};
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId, END, Expression, SurfaceKind};

/// The number 1/ε².
const FLATNESS: i64 = 1_000_000_000_000_000_000;

/// Computes the lowest point of a rim, and the geometry of its contact; `None` after an error.
pub(super) fn on_rim(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    (rim, tube): (OwnRim, Option<AstId>),
    (touching, surface): (Touching, &Surface),
) -> Option<(Touching, ContactGeometry)> {
    check_surface(translation, statement, surface)?;
    let axis = vector_on_link(translation, touching.body, rim.axis);
    let rim = Rim { center: touching.center, size: rim.size, axis };
    let (lowest, lift) = lowest(translation, &statement.name.text, &rim, surface);
    let mut terms = translation.terms();
    let arm = minus(&mut terms, rim.center, surface.place);
    let height = inner(&mut terms, surface.direction, arm);
    let radius = tube.unwrap_or_else(|| terms.number(0));
    let above = terms.minus(height, lift);
    let gap = terms.minus(above, radius);
    let (normal, tangents) = (surface.direction, surface.tangents);
    let (velocity, spin) = motion_at(translation, touching.body, lowest);
    let touching = Touching { center: lowest, velocity, spin, ..touching };
    let geometry = ContactGeometry { center: lowest, radius, gap, normal, tangents, rising: None };
    Some((touching, geometry))
}

/// The radius of a rim, and its axis in the coordinates of the body.
pub(super) struct OwnRim {
    size: AstId,
    axis: Triple,
}

/// Returns the rim that a contact states with the labels `rim` and `axis`; `None` after an error.
pub(super) fn stated_rim(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    written: AstId,
) -> Option<OwnRim> {
    if translation.space.is_none() {
        let origin = translation.expressions.origin(written);
        let error = translation.report.error(origin, words::rim_in_the_plane(&statement.name.text));
        error.help(words::RIM_IN_THE_PLANE_HELP);
        return None;
    }
    let size = rim_radius(translation, statement, written)?;
    let own = unit_direction(translation, &statement.name, "axis", statement.axis)?;
    if let Some(length) = own.length {
        let zero = translation.terms().number(0);
        oblige(translation, statement, words::LENGTH_OF_AXIS.to_owned(), length, (zero, false));
    }
    Some(OwnRim { size, axis: own.unit })
}

/// Returns the rim that the shape of a disk, ring or cylinder has, its link and its centre.
pub(super) fn rim_of_shape(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
) -> Option<(OwnRim, usize, Triple)> {
    if statement.radius.or(statement.rim).is_some() {
        return None;
    }
    let (body, end) = match translation.expressions.get(statement.object) {
        Expression::Call(function, arguments) if function.text == END => (arguments[0], Some(arguments[1])),
        _ => (statement.object, None),
    };
    let link = translation.link_named(body)?;
    let Outline { variant, dimensions, place, .. } = translation.space.as_ref()?.links[link].shape.clone()?;
    let end = end.and_then(|end| number(&translation.expressions, translation.names.constants(), end));
    let mut terms = translation.terms();
    let (size, height) = match (variant, &dimensions[..], end) {
        ("Disk" | "Ring", &[size], None) => (size, terms.number(0)),
        ("Cylinder", &[size, height], Some(_)) | ("HollowCylinder", &[_, size, height], Some(_)) => {
            (size, height)
        }
        _ => return None,
    };
    let (axis, half) = ([5, 8, 11].map(|entry| place[entry]), terms.half());
    let mut along = terms.times(half, height);
    if end == Some(0.0) {
        along = terms.negative(along);
    }
    let arm = scale(&mut terms, along, axis);
    let center = plus(&mut terms, [place[0], place[1], place[2]], arm);
    Some((OwnRim { size, axis }, link, center))
}

/// A circle in the world.
struct Rim {
    center: Triple,
    size: AstId,
    axis: Triple,
}

/// Returns the lowest point over a plane, and its depth R √(s² + ε²) below the centre.
fn lowest(translation: &mut Translation<'_>, name: &str, rim: &Rim, surface: &Surface) -> (Triple, AstId) {
    let axis = bind_vector(translation, &format!("{name}_axis"), rim.axis);
    let across = cross(&mut translation.terms(), surface.direction, axis);
    let across = bind_vector(translation, &format!("{name}_across"), across);
    let mut terms = translation.terms();
    let square = inner(&mut terms, across, across);
    let (one, flatness) = (terms.number(1), terms.number(FLATNESS));
    let least = terms.divide(one, flatness);
    let square = terms.plus(square, least);
    let inclination = terms.call("sqrt", &[square]);
    let inclination = translation.bind(&format!("{name}_inclination"), inclination);
    let mut terms = translation.terms();
    let uphill = cross(&mut terms, axis, across);
    let share = terms.divide(rim.size, inclination);
    let arm = scale(&mut terms, share, uphill);
    let lowest = minus(&mut terms, rim.center, arm);
    let lift = terms.times(rim.size, inclination);
    (bind_vector(translation, &format!("{name}_lowest"), lowest), lift)
}

fn check_surface(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    surface: &Surface,
) -> Option<()> {
    let name = &statement.name.text;
    if surface.kind != SurfaceKind::Plane {
        let message = words::rim_on_round(name, &statement.surface.text, surface.kind.described());
        translation.report.error(statement.surface.span, message).help(words::RIM_ON_ROUND_HELP);
        return None;
    }
    Some(())
}

fn rim_radius(translation: &mut Translation<'_>, statement: &ast::Contact, written: AstId) -> Option<AstId> {
    let value = property(translation, written, &words::rim_of(&statement.name.text));
    let words = (words::rim_not_positive(&statement.name.text), words::RIM_HELP);
    let radius = Coefficient { written, value };
    is_in_range(translation, statement, ("rim", radius), false, words).then_some(value)
}
