//! Bodies and frames in space in expressions: their parts, points, vectors, rates and momenta.
//!
//! Vectors are in world axes. `v in name` gives the components in the axes of a body or frame. If v
//! belongs to that body itself, they are computed without a detour through world axes.

use super::frames::Pose;
use super::links::{Link, MassProperties};
use super::messages as words;
use super::poses::has_place;
use super::vectors::{Triple, apply, cross, matrix_of, minus, plus, zero_triple};
use crate::bodies::corners::corner;
use crate::bodies::messages;
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{AstId, Expression, Name};

/// Translates `arm.center`, `arm.origin`, `arm.mass`.
pub(in crate::bodies) fn part_of_link(
    translation: &mut Translation<'_>,
    link: usize,
    part: &str,
) -> Option<AstId> {
    let (inertia, pose) = link_in_place(translation, link);
    let point = match part {
        "center" => inertia?.centroid,
        "origin" => zero_triple(&mut translation.terms()),
        "mass" => return inertia.map(|inertia| inertia.mass),
        _ => return None,
    };
    Some(world_place(translation, &pose, point))
}

/// Returns the point denoted by the name of a link: the centre of mass of a body, the origin of a
/// frame.
pub(in crate::bodies) fn place_of_link(translation: &mut Translation<'_>, link: usize) -> AstId {
    let (inertia, pose) = link_in_place(translation, link);
    let point = centroid_or_origin(translation, inertia);
    world_place(translation, &pose, point)
}

fn centroid_or_origin(translation: &mut Translation<'_>, inertia: Option<MassProperties>) -> Triple {
    inertia.map_or_else(|| zero_triple(&mut translation.terms()), |inertia| inertia.centroid)
}

fn world_place(translation: &mut Translation<'_>, pose: &Pose, point: Triple) -> AstId {
    let mut terms = translation.terms();
    let place = pose.place_of(&mut terms, point);
    terms.vector(&place)
}

/// Returns the pose and properties of a link. A link without a place is reported, and all of its
/// properties are invalid.
fn link_in_place(translation: &mut Translation<'_>, link: usize) -> (Option<MassProperties>, Pose) {
    let pose = has_place(translation, link, translation.origin);
    let pose = pose.unwrap_or_else(|| Pose::invalid(&mut translation.terms()));
    let links = translation.space.as_ref().map(|space| &space.links[link]);
    (links.and_then(|link| link.inertia), pose)
}

/// Functions of links, with the minimum and maximum number of arguments after the link.
const OF_LINKS: [(&str, [usize; 2]); 7] = [
    ("point", [3, 3]),
    ("corner", [1, 1]),
    ("vector", [3, 3]),
    ("angular_velocity", [0, 0]),
    ("angular_acceleration", [0, 0]),
    ("linear_momentum", [0, 0]),
    ("angular_momentum", [0, 1]),
];

/// Translates a function of a link: `arm.point(X, Y, Z)`.
pub(in crate::bodies) fn call_of_link(
    translation: &mut Translation<'_>,
    link: usize,
    function: &Name,
    arguments: &[AstId],
) -> AstId {
    let Some((name, [least, most])) = OF_LINKS.iter().find(|(name, _)| *name == function.text) else {
        let message = words::no_function(&function.text);
        translation.report.error(function.span, message).help(words::FUNCTIONS_HELP);
        return translation.terms().invalid();
    };
    if !translation.are_read(arguments) {
        return translation.terms().invalid();
    }
    if !(*least..=*most).contains(&arguments.len()) {
        let message = messages::wrong_arguments(name, arguments.len());
        translation.report.error(translation.origin, message).help(words::usage(name));
        return translation.terms().invalid();
    }
    let (inertia, pose) = link_in_place(translation, link);
    if let ("corner", &[index]) = (*name, arguments) {
        let Some(own) = corner_of_link(translation, link, index) else {
            return translation.terms().invalid();
        };
        return world_place(translation, &pose, own);
    }
    if name.ends_with("momentum") {
        return momentum_of_link(translation, link, (inertia, pose), (name, arguments));
    }
    let mut terms = translation.terms();
    let vector = match (*name, arguments) {
        ("point", &[x, y, z]) => pose.place_of(&mut terms, [x, y, z]),
        (_, &[x, y, z]) => pose.in_world(&mut terms, [x, y, z]),
        ("angular_velocity", _) => pose.in_world(&mut terms, pose.spin),
        _ => {
            let rate = pose.spin.map(|component| terms.rate(component));
            pose.in_world(&mut terms, rate)
        }
    };
    terms.vector(&vector)
}

/// Translates `linear_momentum(arm)`, or `angular_momentum(arm, P)` with or without the point.
fn momentum_of_link(
    translation: &mut Translation<'_>,
    link: usize,
    (inertia, pose): (Option<MassProperties>, Pose),
    (function, arguments): (&str, &[AstId]),
) -> AstId {
    let Some(inertia) = inertia else {
        let name = translation.space.as_ref().map_or("", |space| space.name_of(link)).to_owned();
        let error = translation.report.error(translation.origin, words::mass_of_frame(&name));
        error.help(words::FRAME_HELP);
        return translation.terms().invalid();
    };
    let mut terms = translation.terms();
    let about = arguments.first().map(|&about| terms.triple(about));
    let momentum = match function {
        "linear_momentum" => linear_momentum(&mut terms, inertia, &pose),
        _ => angular_momentum(&mut terms, inertia, &pose, about),
    };
    terms.vector(&momentum)
}

/// Returns the link and the link coordinates of an expression that is written as a point of a link.
pub(in crate::bodies) fn point_on_link(
    translation: &mut Translation<'_>,
    id: AstId,
) -> Option<(usize, Triple)> {
    match translation.expressions.get(id).clone() {
        Expression::Name(name) => {
            let space = translation.space.as_ref()?;
            if let Some(point) = space.points.get(&name) {
                return Some(*point);
            }
            let link = translation.link_named(id)?;
            let inertia = translation.space.as_ref()?.links[link].inertia;
            Some((link, centroid_or_origin(translation, inertia)))
        }
        Expression::Component(of, part) => {
            let link = translation.link_named(of)?;
            let Link { inertia, .. } = translation.space.as_ref()?.links[link];
            match part.text.as_str() {
                "center" => Some((link, inertia?.centroid)),
                "origin" => Some((link, zero_triple(&mut translation.terms()))),
                _ => None,
            }
        }
        Expression::Call(function, arguments) if function.text == "corner" => match arguments[..] {
            [body, index] => {
                let link = translation.link_named(body)?;
                Some((link, corner_of_link(translation, link, index)?))
            }
            _ => None,
        },
        Expression::Call(function, arguments) if function.text == "point" => match arguments[..] {
            [body, x, y, z] => {
                // A point that moves in a body is not fixed in it.
                let is_fixed = [x, y, z].into_iter().all(|component| translation.is_at_rest(component));
                let own = [x, y, z].map(|component| translation.plain_of(component));
                Some((translation.link_named(body).filter(|_| is_fixed)?, own))
            }
            _ => None,
        },
        _ => None,
    }
}

fn corner_of_link(translation: &mut Translation<'_>, link: usize, index: AstId) -> Option<Triple> {
    let Link { name, shape, .. } = translation.space.as_ref()?.links[link].clone();
    corner(translation, &name.text, shape.as_ref(), index)
}

/// Returns the velocity or acceleration of a point that is fixed in a link, in body-fixed axes.
///
/// With v the velocity of the point in body-fixed axes, the acceleration is v̇ + ω × v.
pub(in crate::bodies) fn rate_of_link_point(
    translation: &mut Translation<'_>,
    function: &str,
    link: usize,
    point: Triple,
) -> (Pose, Triple) {
    let (_, pose) = link_in_place(translation, link);
    let mut terms = translation.terms();
    let velocity = pose.velocity_of(&mut terms, point);
    if function == "velocity" {
        return (pose, velocity);
    }
    let rate = velocity.map(|component| terms.rate(component));
    let turning = cross(&mut terms, pose.spin, velocity);
    (pose, plus(&mut terms, rate, turning))
}

/// Translates `v in link`: the components of a vector in the axes of a link.
pub(in crate::bodies) fn in_axes(
    translation: &mut Translation<'_>,
    vector: AstId,
    plain: AstId,
    link: usize,
) -> AstId {
    let own = own_components(translation, vector, link);
    let (_, pose) = link_in_place(translation, link);
    let mut terms = translation.terms();
    let own = own.unwrap_or_else(|| {
        let world = terms.triple(plain);
        pose.in_own_axes(&mut terms, world)
    });
    terms.vector(&own)
}

/// Returns the components of a vector of the link itself.
fn own_components(translation: &mut Translation<'_>, vector: AstId, link: usize) -> Option<Triple> {
    let Expression::Call(function, arguments) = translation.expressions.get(vector).clone() else {
        return None;
    };
    let first = *arguments.first()?;
    if let "velocity" | "acceleration" = function.text.as_str() {
        let (of, point) = point_on_link(translation, first)?;
        return (of == link).then(|| rate_of_link_point(translation, &function.text, link, point).1);
    }
    if translation.link_named(first) != Some(link) {
        return None;
    }
    let (inertia, pose) = link_in_place(translation, link);
    let mut terms = translation.terms();
    match (function.text.as_str(), &arguments[1..]) {
        ("angular_velocity", []) => Some(pose.spin),
        ("angular_acceleration", []) => Some(pose.spin.map(|component| terms.rate(component))),
        ("vector", &[x, y, z]) => Some([x, y, z].map(|component| translation.plain_of(component))),
        ("linear_momentum", []) => {
            let velocity = pose.velocity_of(&mut terms, inertia?.centroid);
            Some(velocity.map(|component| terms.times(inertia.map_or(component, |i| i.mass), component)))
        }
        _ => None,
    }
}

/// Returns m v_S.
fn linear_momentum(terms: &mut TermWriter<'_>, inertia: MassProperties, pose: &Pose) -> Triple {
    let velocity = pose.velocity_of(terms, inertia.centroid);
    let velocity = pose.in_world(terms, velocity);
    velocity.map(|component| terms.times(inertia.mass, component))
}

/// Returns m (r_S − r_P) × v_S + R J ω.
fn angular_momentum(
    terms: &mut TermWriter<'_>,
    inertia: MassProperties,
    pose: &Pose,
    about: Option<Triple>,
) -> Triple {
    let own = match inertia.tensor {
        Some(tensor) => apply(terms, matrix_of(tensor), pose.spin),
        None => zero_triple(terms),
    };
    let spin = pose.in_world(terms, own);
    let momentum = linear_momentum(terms, inertia, pose);
    let center = pose.place_of(terms, inertia.centroid);
    let about = about.unwrap_or_else(|| zero_triple(terms));
    let arm = minus(terms, center, about);
    let moment = cross(terms, arm, momentum);
    plus(terms, moment, spin)
}
