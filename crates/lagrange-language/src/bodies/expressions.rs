//! Bodies, lines, springs and joints in expressions.

use super::kinematics::{of_body, of_line};
use super::messages::{self, mobilizers};
use super::object::{Body, Joint, Line, Object};
use super::plain::Obligation;
use super::space::{
    call_of_link, in_axes, is_no_vector, part_of_link, place_of_link, point_on_link, rate_of_link_point,
};
use super::translation::Translation;
use crate::syntax::ast::{AstId, Expression, IN_AXES, Name};
use crate::syntax::foreign;

/// Functions whose first argument is a body, with the names of their arguments; those in brackets
/// are optional.
const OF_BODIES: [(&str, &[&str]); 10] = [
    ("point", &["X", "Y"]),
    ("corner", &["i"]),
    ("vector", &["X", "Y"]),
    ("angular_velocity", &[]),
    ("angular_acceleration", &[]),
    ("instant_center", &[]),
    ("linear_momentum", &[]),
    ("angular_momentum", &["[P]"]),
    ("tangential_acceleration", &["Q", "[P]"]),
    ("radial_acceleration", &["Q", "[P]"]),
];
/// Functions whose first argument is a line.
const OF_LINES: [(&str, &[&str]); 2] = [("distance", &["P"]), ("along", &["P"])];
/// Functions of points, with the corresponding functions of the plain language.
const OF_POINTS: [(&str, &str); 2] = [("velocity", "dot"), ("acceleration", "ddot")];

/// Translates an expression into the plain language.
pub(super) fn plain_expression(translation: &mut Translation<'_>, root: AstId) -> AstId {
    let mut pending = vec![root];
    while let Some(&id) = pending.last() {
        let before = pending.len();
        if !translation.translated.contains(&id) {
            // In reverse order, so that errors are reported from left to right.
            let parts = parts_of(translation, id).into_iter().rev();
            pending.extend(parts.filter(|part| !translation.translated.contains(part)));
        }
        if pending.len() == before {
            pending.pop();
            if !translation.translated.contains(&id) {
                let plain = plain_node(translation, id);
                translation.translated.insert(id, plain);
            }
        }
    }
    translation.plain_of(root)
}

/// Translates an expression of the user, and records it so that errors are found even if it is not
/// needed.
pub(super) fn mention(translation: &mut Translation<'_>, id: AstId) -> AstId {
    let plain = plain_expression(translation, id);
    translation.mentioned.push(plain);
    plain
}

/// Translates a point; the name of a body denotes its centre of mass.
pub(super) fn translated_place(translation: &mut Translation<'_>, id: AstId) -> AstId {
    if let Some(link) = translation.link_named(id) {
        return place_of_link(translation, link);
    }
    match translation.body_named(id) {
        Some(body) => translation.bodies[body].center,
        None => plain_expression(translation, id),
    }
}

/// Translates a point with the dimension of the scene.
pub(super) fn scene_point(translation: &mut Translation<'_>, id: AstId, what: &str) -> AstId {
    let value = translated_place(translation, id);
    let what = what.to_owned();
    let is_in_space = translation.space.is_some();
    translation.obligations.push(match is_in_space {
        true => Obligation::SpaceVector { what, value },
        false => Obligation::PlaneVector { what, value },
    });
    match is_in_space && is_no_vector(translation, value) {
        true => translation.terms().invalid(),
        false => value,
    }
}

/// Translates an angle: that of a body, zero for the ground, or any expression other than a point.
pub(super) fn turning(translation: &mut Translation<'_>, id: AstId) -> AstId {
    if let Some(body) = translation.body_named(id) {
        return translation.bodies[body].angle;
    }
    if is_ground(translation, id) {
        return translation.terms().number(0);
    }
    if translation.link_named(id).is_some() {
        let origin = translation.expressions.origin(id);
        translation.report.error(origin, messages::ANGLE_OF_LINK).help(messages::ANGLE_OF_LINK_HELP);
        return translation.terms().invalid();
    }
    let angle = plain_expression(translation, id);
    match is_point(translation, id) {
        true => {
            let origin = translation.expressions.origin(id);
            translation.report.error(origin, messages::NO_ANGLE).help(messages::NO_ANGLE_HELP);
            translation.terms().invalid()
        }
        false => angle,
    }
}

/// True if the ground is meant: nothing other than a line has its name.
pub(super) fn is_ground(translation: &Translation<'_>, id: AstId) -> bool {
    let Expression::Name(name) = translation.expressions.get(id) else { return false };
    name == "ground" && !translation.names.is_declared(name)
}

/// True if an expression is a point according to its form.
fn is_point(translation: &Translation<'_>, id: AstId) -> bool {
    matches!(translation.expressions.get(id), Expression::Tuple(_)) || translation.body_of(id).is_some()
}

/// Returns the parts of an expression that are translated before it, except names of bodies where
/// these are expected.
fn parts_of(translation: &Translation<'_>, id: AstId) -> Vec<AstId> {
    let is_object = |id: &AstId| matches!(translation.expressions.get(*id), Expression::Name(name) if translation.names.find(name).is_some());
    match translation.expressions.get(id) {
        Expression::Call(function, arguments) if is_of_scene(&function.text) => {
            arguments.iter().copied().filter(|argument| !is_object(argument)).collect()
        }
        Expression::Component(of, _) if is_object(of) => Vec::new(),
        other => other.operands(),
    }
}

fn plain_node(translation: &mut Translation<'_>, id: AstId) -> AstId {
    let before = std::mem::replace(&mut translation.origin, translation.expressions.origin(id));
    let plain = match translation.expressions.get(id).clone() {
        Expression::Name(name) => plain_name(translation, &name, id),
        Expression::Component(of, part) => match object_named(translation, of) {
            Some((name, object)) => part_of(translation, &name, &object, &part),
            None => rebuilt(translation, id),
        },
        Expression::Call(function, arguments) if is_of_scene(&function.text) => {
            plain_call(translation, &function, &arguments, id)
        }
        _ => rebuilt(translation, id),
    };
    translation.origin = before;
    plain
}

/// Translates a name, which must have a value.
fn plain_name(translation: &mut Translation<'_>, name: &str, id: AstId) -> AstId {
    if let Some(object) = translation.names.find(name).filter(|object| !matches!(object, Object::Contact(_)))
    {
        let message = messages::no_value(name, object.describe());
        translation.report.error(translation.origin, message).help(messages::value_help(name, object));
        return translation.terms().invalid();
    }
    match report_early(translation, name) {
        true => translation.terms().invalid(),
        false => id,
    }
}

/// Reports a name that is declared further down.
pub(super) fn report_early(translation: &mut Translation<'_>, name: &str) -> bool {
    let Some(declared) = translation.names.anywhere(name).filter(|_| translation.names.find(name).is_none())
    else {
        return false;
    };
    let declared = declared.span;
    let is_waiting = translation.waiting.iter().any(|body| body.name().text == name);
    if !translation.early.insert(name.to_owned()) {
        return true;
    }
    let (message, help) = match is_waiting {
        true => (mobilizers::unplaced_yet(name), mobilizers::PLACE_FIRST_HELP),
        false => (messages::used_too_early(name), messages::ORDER_HELP),
    };
    let error = translation.report.error(translation.origin, message).help(help);
    error.related(declared.into(), messages::DECLARED_HERE);
    true
}

/// Returns a copy of the expression with its parts translated.
fn rebuilt(translation: &mut Translation<'_>, id: AstId) -> AstId {
    let expression = translation.expressions.get(id).clone();
    let parts = expression.operands();
    let plain = parts.iter().map(|&part| translation.plain_of(part)).collect::<Vec<_>>();
    if plain == parts {
        return id;
    }
    let expression = expression.with_operands(&plain);
    translation.terms().add_node(expression)
}

/// Returns the object that an expression names.
fn object_named(translation: &Translation<'_>, id: AstId) -> Option<(String, Object)> {
    let Expression::Name(name) = translation.expressions.get(id) else { return None };
    translation.names.find(name).map(|object| (name.clone(), object.clone()))
}

/// Translates `rod.center` and similar expressions.
fn part_of(translation: &mut Translation<'_>, name: &str, object: &Object, part: &Name) -> AstId {
    let found = match object {
        Object::Body(body) => part_of_body(translation, *body, &part.text),
        Object::Link { index, .. } => part_of_link(translation, *index, &part.text),
        Object::Line(line) => part_of_line(translation, *line, &part.text),
        Object::Connector(connector) => match part.text.as_str() {
            "length" => Some(connector.length),
            "force" => Some(connector.tension),
            _ => None,
        },
        Object::Joint(Joint { force, parts }) => {
            let found = match part.text.as_str() {
                "force" => Some(*force),
                part => parts.iter().find(|(name, _)| *name == part).map(|(_, id)| *id),
            };
            // An error for a joint that the coordinates fulfil identically is located here, not at
            // the joint.
            found.map(|force| translation.terms().repeated(force))
        }
        Object::Surface(_) => None,
        Object::Contact(contact) => {
            contact.parts.iter().find(|(name, _)| *name == part.text).map(|(_, value)| *value)
        }
    };
    found.unwrap_or_else(|| {
        let message = messages::no_part(name, object.describe(), &part.text);
        let meant = object.owner().and_then(|owner| foreign::part((owner, name), &part.text));
        let help = meant.map_or_else(|| messages::value_help(name, object), |part| messages::write(&part));
        translation.report.error(part.span, message).help(help);
        translation.terms().invalid()
    })
}

fn part_of_body(translation: &mut Translation<'_>, body: usize, part: &str) -> Option<AstId> {
    let Body { mass, inertia, center, origin, angle, .. } = translation.bodies[body].clone();
    match part {
        "mass" => Some(mass),
        "inertia" => Some(inertia),
        "center" => Some(center),
        "origin" => Some(translation.terms().tuple(origin)),
        "angle" => Some(angle),
        _ => None,
    }
}

fn part_of_line(translation: &mut Translation<'_>, line: usize, part: &str) -> Option<AstId> {
    let Line { angle, .. } = translation.lines[line];
    let mut terms = translation.terms();
    let [tangent, normal] = terms.axes(angle);
    match part {
        "tangent" => Some(terms.tuple(tangent)),
        "normal" => Some(terms.tuple(normal)),
        "angle" => Some(angle),
        _ => None,
    }
}

fn plain_call(translation: &mut Translation<'_>, function: &Name, arguments: &[AstId], id: AstId) -> AstId {
    if let (IN_AXES, &[vector, link]) = (function.text.as_str(), arguments) {
        return components_in(translation, vector, link);
    }
    if let Some((_, plain)) = OF_POINTS.iter().find(|(name, _)| *name == function.text) {
        if let [point] = arguments
            && translation.is_at_rest(*point)
        {
            let message = messages::point_at_rest(&function.text);
            translation.report.error(translation.origin, message).help(messages::POINT_AT_REST_HELP);
            return translation.terms().invalid();
        }
        if let [point] = arguments
            && let Some((link, own)) = point_on_link(translation, *point)
        {
            let (pose, own) = rate_of_link_point(translation, &function.text, link, own);
            return pose.world_vector(&mut translation.terms(), own);
        }
        let arguments =
            arguments.iter().map(|&point| translated_place(translation, point)).collect::<Vec<_>>();
        return translation.terms().call(plain, &arguments);
    }
    if let Some(link) = arguments.first().and_then(|&first| translation.link_named(first)) {
        let places = arguments[1..].iter().map(|&id| translated_place(translation, id)).collect::<Vec<_>>();
        return call_of_link(translation, link, function, &places);
    }
    let row = OF_BODIES.iter().chain(&OF_LINES).find(|(name, _)| *name == function.text);
    let Some((_, wanted)) = row else { return rebuilt(translation, id) };
    let Some((first, rest)) = arguments.split_first() else {
        return wrong_count(translation, function, wanted, 0);
    };
    let needed = wanted.iter().filter(|name| !name.starts_with('[')).count();
    if !(needed..=wanted.len()).contains(&rest.len()) && translation.are_read(rest) {
        return wrong_count(translation, function, wanted, rest.len());
    }
    if !translation.are_read(rest) {
        return translation.terms().invalid();
    }
    let is_of_lines = OF_LINES.iter().any(|(name, _)| *name == function.text);
    match object_named(translation, *first) {
        Some((_, Object::Body(body))) if !is_of_lines => {
            let places = rest.iter().map(|&point| translated_place(translation, point)).collect::<Vec<_>>();
            of_body(translation, body, &function.text, &places)
        }
        Some((_, Object::Line(line))) if is_of_lines => {
            let point = translated_place(translation, rest[0]);
            of_line(translation, line, &function.text, point)
        }
        _ => not_an_object(translation, function, *first, is_of_lines),
    }
}

/// Translates `v in link`.
fn components_in(translation: &mut Translation<'_>, vector: AstId, axes: AstId) -> AstId {
    let Some(link) = translation.link_named(axes) else {
        let origin = translation.expressions.origin(axes);
        translation.report.error(origin, messages::NO_AXES).help(messages::NO_AXES_HELP);
        return translation.terms().invalid();
    };
    let plain = translated_place(translation, vector);
    in_axes(translation, vector, plain, link)
}

fn wrong_count(translation: &mut Translation<'_>, function: &Name, wanted: &[&str], count: usize) -> AstId {
    let message = messages::wrong_arguments(&function.text, count);
    translation.report.error(translation.origin, message).help(messages::usage(&function.text, wanted));
    translation.terms().invalid()
}

/// Reports `point` and similar functions of something other than a body.
fn not_an_object(
    translation: &mut Translation<'_>,
    function: &Name,
    first: AstId,
    is_of_lines: bool,
) -> AstId {
    let what = if is_of_lines { "a line" } else { "a body" };
    let name = match translation.expressions.get(first) {
        Expression::Name(name) => Some(name.clone()),
        _ => None,
    };
    let was_reported =
        matches!(translation.expressions.get(translation.plain_of(first)), Expression::Invalid);
    if !was_reported {
        let accept = |object: &Object| matches!(object, Object::Line(_)) == is_of_lines;
        let nearest = name.as_ref().and_then(|name| translation.names.nearest(name, accept));
        let help = messages::object_help(&function.text, what, nearest);
        let message = messages::not_an_object(&function.text, what, name.as_deref());
        translation.report.error(translation.expressions.origin(first), message).help(help);
    }
    translation.terms().invalid()
}

fn is_of_scene(function: &str) -> bool {
    let rows = OF_BODIES.iter().chain(&OF_LINES).map(|(name, _)| *name);
    rows.chain(OF_POINTS.iter().map(|(name, _)| *name)).chain([IN_AXES]).any(|name| name == function)
}
