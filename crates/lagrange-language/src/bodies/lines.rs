//! Lines and their carriers.

use super::drawing::draw_surface;
use super::expressions::{mention, report_early};
use super::kinematics::point_of_body;
use super::mass_geometry::vector_of;
use super::messages;
use super::object::{Line, Object};
use super::translation::Translation;
use crate::syntax::ast::{self, SurfaceKind};

pub(super) fn translate_line(translation: &mut Translation<'_>, statement: ast::Surface) {
    let through = match statement.place {
        Some(through) => vector_of(translation, through, &messages::through_of(&statement.name.text)),
        None => translation.terms().zero_pair(),
    };
    let angle = match statement.direction {
        Some(angle) => mention(translation, angle),
        None => translation.terms().number(0),
    };
    let body = statement.on.as_ref().and_then(|on| carrier(translation, on));
    let (through, angle) = match body {
        Some(body) => {
            let turned = translation.bodies[body].angle;
            (point_of_body(translation, body, through), translation.terms().plus(turned, angle))
        }
        None => (through, angle),
    };
    let name = statement.name.text;
    let point = translation.terms().tuple(through);
    draw_surface(translation, &name, (SurfaceKind::Line, body), vec![point, angle], None);
    translation.names.declare(&name, Object::Line(translation.lines.len()));
    translation.lines.push(Line { body, through, angle });
}

/// Returns the body with this name; other names are reported.
pub(super) fn carrier(translation: &mut Translation<'_>, name: &ast::Name) -> Option<usize> {
    object(translation, name, "a body", |object| match object {
        Object::Body(body) => Some(*body),
        _ => None,
    })
}

/// Returns the line with this name; other names are reported.
pub(super) fn track(translation: &mut Translation<'_>, name: &ast::Name) -> Option<usize> {
    object(translation, name, "a line", |object| match object {
        Object::Line(line) => Some(*line),
        _ => None,
    })
}

/// Returns the index of the wanted object with this name; other names are reported.
fn object(
    translation: &mut Translation<'_>,
    name: &ast::Name,
    wanted: &str,
    index: impl Fn(&Object) -> Option<usize>,
) -> Option<usize> {
    let object = translation.names.find(&name.text);
    let (found, described) = (object.and_then(&index), object.map(Object::describe));
    if found.is_none() {
        report_no_object(translation, name, wanted, described, |object| index(object).is_some());
    }
    found
}

pub(super) fn report_no_object(
    translation: &mut Translation<'_>,
    name: &ast::Name,
    wanted: &str,
    found: Option<&str>,
    accept: impl Fn(&Object) -> bool,
) {
    let before = std::mem::replace(&mut translation.origin, name.span.into());
    if !report_early(translation, &name.text) {
        let help = match translation.names.nearest(&name.text, accept) {
            Some(nearest) => messages::did_you_mean(nearest),
            None => messages::declare_object(wanted),
        };
        let message = messages::other_object(&name.text, wanted, found);
        translation.report.error(name.span, message).help(help);
    }
    translation.origin = before;
}
