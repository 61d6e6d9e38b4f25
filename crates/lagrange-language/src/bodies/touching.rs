//! Round bodies and points of bodies in contact, with their motion.

use super::corners::corner_count;
use super::expressions::{plain_expression, scene_point};
use super::kinematics::point_of_body;
use super::messages;
use super::messages::contacts as words;
use super::object::{Body, Object, Surface};
use super::plain::Outline;
use super::space::vectors::{Triple, cross, minus, plus};
use super::space::{origin_motion, place_on_link, point_on_link, spin_of_link, velocity_on_link};
use super::translation::Translation;
use crate::syntax::ast::{AstId, Contact, Expression, Name, SurfaceKind};

/// A touching point of a body with the radius around it. Vectors in the plane have a third
/// component of zero.
pub(super) struct Touching {
    /// The body, or in space the link.
    pub(super) body: usize,
    pub(super) center: Triple,
    /// Velocity of the point of the body at the centre.
    pub(super) velocity: Triple,
    pub(super) spin: Triple,
    /// Radius of the body, if its shape is round.
    pub(super) radius: Option<AstId>,
}

/// Returns the touching point of a body; a point without a body is reported.
pub(super) fn touching(translation: &mut Translation<'_>, contact: &Contact) -> Option<Touching> {
    let (name, object) = (&contact.name, contact.object);
    let mistakes = translation.report.diagnostics().len();
    report_without_corners(translation, name, object);
    let touching = match translation.space {
        Some(_) => touching_link(translation, object),
        None => touching_body(translation, object),
    };
    if touching.is_none() && translation.report.diagnostics().len() == mistakes {
        plain_expression(translation, object);
    }
    if touching.is_none() && translation.report.diagnostics().len() == mistakes {
        report_no_body(translation, name, object);
    }
    if let Some(Touching { radius: None, .. }) = touching
        && contact.radius.or(contact.rim).is_none()
    {
        report_without_radius(translation, contact);
    }
    touching.filter(|_| translation.report.diagnostics().len() == mistakes)
}

/// Reports a body that denotes its centre although it has a shape.
fn report_without_radius(translation: &mut Translation<'_>, contact: &Contact) {
    let Contact { name: contact, object, surface, .. } = contact;
    let object = *object;
    let Expression::Name(name) = translation.expressions.get(object).clone() else { return };
    let Some(shape) = shape_named(translation, object).filter(|shape| shape.variant != "PointMass") else {
        return;
    };
    let is_on_round = round_named(translation, &surface.text);
    let (message, help) = match corner_count(translation, Some(&shape)) {
        0 => {
            let help = match translation.space {
                Some(_) => words::NO_OUTLINE_IN_SPACE_HELP,
                None => words::NO_OUTLINE_HELP,
            };
            (words::no_outline(&contact.text, &name), help.to_owned())
        }
        _ if is_on_round => (
            words::edges_on_round(&contact.text, &name, &surface.text),
            words::EDGES_ON_ROUND_HELP.to_owned(),
        ),
        count => (words::corners_of_another(&contact.text, &name), words::loop_over_corners(count)),
    };
    let origin = translation.expressions.origin(object);
    translation.report.error(origin, message).help(help);
}

/// True if this is a round body.
fn round_named(translation: &mut Translation<'_>, name: &str) -> bool {
    match translation.names.find(name) {
        Some(&Object::Link { index, .. } | &Object::Body(index)) => round_of(translation, index).is_some(),
        _ => false,
    }
}

/// Returns the shape of the body with this name.
fn shape_named(translation: &Translation<'_>, object: AstId) -> Option<Outline> {
    match &translation.space {
        Some(space) => space.links[translation.link_named(object)?].shape.clone(),
        None => translation.bodies[translation.body_named(object)?].shape.clone(),
    }
}

fn report_no_body(translation: &mut Translation<'_>, contact: &Name, object: AstId) {
    let is_body = |object: &Object| matches!(object, Object::Body(_) | Object::Link { .. });
    let nearest = match translation.expressions.get(object) {
        Expression::Name(name) => translation.names.nearest(name, is_body),
        _ => None,
    };
    let help = nearest.map_or_else(|| words::NO_BODY_TOUCHES_HELP.to_owned(), messages::did_you_mean);
    let origin = translation.expressions.origin(object);
    translation.report.error(origin, words::no_body_touches(&contact.text)).help(help);
}

/// Reports `case.corners` of a body without corners, or of a body and a contact that are not in the
/// same part.
fn report_without_corners(translation: &mut Translation<'_>, contact: &Name, object: AstId) {
    let Expression::Component(body, part) = translation.expressions.get(object).clone() else { return };
    let is_body = translation.body_named(body).is_some() || translation.link_named(body).is_some();
    if let Expression::Name(name) = translation.expressions.get(body).clone()
        && is_body
        && part.text == "corners"
    {
        let shape = shape_named(translation, body);
        let (message, help) = match corner_count(translation, shape.as_ref()) {
            0 => (messages::no_corners(&name), messages::NO_CORNERS_HELP.to_owned()),
            count => (words::corners_of_another(&contact.text, &name), words::loop_over_corners(count)),
        };
        translation.report.error(part.span, message).help(help);
    }
}

fn touching_body(translation: &mut Translation<'_>, object: AstId) -> Option<Touching> {
    let body = translation.body_of(object)?;
    let Body { origin, radius, .. } = translation.bodies[body].clone();
    let is_whole = translation.body_named(object).is_some();
    let radius = radius.filter(|_| is_whole);
    let center = match radius {
        Some(_) => origin,
        None => {
            let point = scene_point(translation, object, words::TOUCHING_POINT);
            translation.terms().pair(point)
        }
    };
    let zero = translation.terms().number(0);
    let center = [center[0], center[1], zero];
    let (velocity, spin) = motion_at(translation, body, center);
    Some(Touching { body, center, velocity, spin, radius })
}

fn touching_link(translation: &mut Translation<'_>, object: AstId) -> Option<Touching> {
    let named = translation.link_named(object);
    let ball = named.and_then(|link| Some((link, round_of(translation, link)?)));
    let (body, own, radius) = match ball {
        Some((link, (SurfaceKind::Sphere, center, radius))) => (link, center, Some(radius)),
        _ => {
            let (link, own) = point_on_link(translation, object)?;
            (link, own, None)
        }
    };
    Some(Touching { radius, ..touching_at(translation, body, own) })
}

/// Returns the touching point of a link at these coordinates.
pub(super) fn touching_at(translation: &mut Translation<'_>, body: usize, own: Triple) -> Touching {
    let center = place_on_link(translation, body, own);
    let velocity = velocity_on_link(translation, body, own);
    let spin = spin_of_link(translation, body);
    Touching { body, center, velocity, spin, radius: None }
}

/// Returns the velocity at a place of the body in the plane or the link in space, and the angular
/// velocity.
pub(super) fn motion_at(translation: &mut Translation<'_>, body: usize, place: Triple) -> (Triple, Triple) {
    let (origin, velocity, spin) = match translation.space {
        Some(_) => origin_motion(translation, body),
        None => plane_motion(translation, body),
    };
    let mut terms = translation.terms();
    let arm = match place[0] == origin[0] && place[1] == origin[1] {
        true => [terms.number(0); 3],
        false => minus(&mut terms, place, origin),
    };
    let turning = cross(&mut terms, spin, arm);
    (plus(&mut terms, velocity, turning), spin)
}

/// Returns the origin, its velocity and the angular velocity.
fn plane_motion(translation: &mut Translation<'_>, body: usize) -> (Triple, Triple, Triple) {
    let Body { origin: [x, y], angle, .. } = translation.bodies[body].clone();
    let zero = translation.terms().number(0);
    let [vx, vy, rate] = [x, y, angle].map(|value| rate_of(translation, value));
    ([x, y, zero], [vx, vy, zero], [zero, zero, rate])
}

/// Returns the rate of an expression that may be at rest.
pub(super) fn rate_of(translation: &mut Translation<'_>, value: AstId) -> AstId {
    match translation.is_at_rest(value) {
        true => translation.terms().number(0),
        false => translation.terms().rate(value),
    }
}

/// Returns the surface of a round body: its kind, centre and radius in its own coordinates.
pub(super) fn round_of(
    translation: &mut Translation<'_>,
    body: usize,
) -> Option<(SurfaceKind, Triple, AstId)> {
    let zero = translation.terms().number(0);
    let Some(space) = &translation.space else {
        let Body { radius, .. } = &translation.bodies[body];
        return Some((SurfaceKind::Circle, [zero; 3], (*radius)?));
    };
    let Outline { variant, dimensions, place, .. } = space.links[body].shape.as_ref()?;
    let (kind, radius) = match (*variant, &dimensions[..]) {
        ("Sphere", &[radius]) => (SurfaceKind::Sphere, radius),
        ("Cylinder", &[radius, _]) | ("HollowCylinder", &[_, radius, _]) => (SurfaceKind::Cylinder, radius),
        _ => return None,
    };
    Some((kind, [place[0], place[1], place[2]], radius))
}

/// Returns the surface of a round body in the world; `None` for any other body.
pub(super) fn surface_of(translation: &mut Translation<'_>, body: usize) -> Option<Surface> {
    let (kind, own, radius) = round_of(translation, body)?;
    let zero = translation.terms().number(0);
    let (place, direction) = match translation.space {
        None => {
            let [x, y] = point_of_body(translation, body, [zero; 2]);
            ([x, y, zero], [zero; 3])
        }
        Some(_) => {
            let one = translation.terms().number(1);
            let axis = super::space::vector_on_link(translation, body, [zero, zero, one]);
            (place_on_link(translation, body, own), axis)
        }
    };
    let tangents = [[zero; 3]; 2];
    let (carrier, length, height) = (Some(body), None, None);
    Some(Surface { kind, carrier, place, direction, length, tangents, radius, height, turning: zero })
}
