//! Surfaces named in contacts.

use crate::bodies::corners::corner_count;
use crate::bodies::expressions::{is_ground, report_early};
use crate::bodies::messages;
use crate::bodies::messages::contacts as words;
use crate::bodies::object::{Line, Object, Surface};
use crate::bodies::plain::{Drawn, DrawnKind};
use crate::bodies::space::vectors::{unit, zero_triple};
use crate::bodies::surfaces::draw_if_wanted;
use crate::bodies::touching::{rate_of, surface_of};
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, SurfaceKind};

/// Returns the surface of a contact; other names are reported.
pub(super) fn surface_named(translation: &mut Translation<'_>, statement: &ast::Contact) -> Option<Surface> {
    let name = &statement.surface;
    let surface = match translation.names.find(&name.text).cloned() {
        None => ground_or_unknown(translation, statement)?,
        Some(Object::Line(line)) => surface_of_line(translation, line),
        Some(Object::Surface(surface)) => *surface,
        Some(Object::Body(index) | Object::Link { index, .. }) => match surface_of(translation, index) {
            Some(surface) => surface,
            None => {
                let message = words::not_round(&statement.name.text, &name.text);
                let help = match translation.space {
                    Some(_) => words::FACE_HELP,
                    None => words::NO_SURFACE_HELP,
                };
                translation.report.error(name.span, message).help(help);
                return None;
            }
        },
        Some(other) => {
            let message = words::no_surface(&statement.name.text, &name.text, other.describe());
            translation.report.error(name.span, message).help(words::NO_SURFACE_HELP);
            return None;
        }
    };
    let is_open = matches!(surface.kind, SurfaceKind::Line | SurfaceKind::Plane | SurfaceKind::Terrain);
    if is_open && statement.is_inside {
        let message = words::inside_of_open(&statement.name.text, &name.text);
        translation.report.error(name.span, message).help(words::INSIDE_OF_OPEN_HELP);
        return None;
    }
    Some(surface)
}

/// True if this is a link whose shape has corners.
pub(super) fn is_block(translation: &mut Translation<'_>, name: &str) -> bool {
    let Some(Object::Link { index, .. }) = translation.names.find(name) else { return false };
    let shape = translation.space.as_ref().and_then(|space| space.links[*index].shape.clone());
    corner_count(translation, shape.as_ref()) > 0
}

/// Returns the line y = 0, or the plane z = 0 in space; other names are reported.
fn ground_or_unknown(translation: &mut Translation<'_>, statement: &ast::Contact) -> Option<Surface> {
    let name = &statement.surface;
    let ground = translation.terms().name(&name.text);
    if is_ground(translation, ground) {
        let is_spatial = translation.space.is_some();
        let mut terms = translation.terms();
        let [x, y, z] = [0, 1, 2].map(|axis| unit(&mut terms, axis));
        let down = z.map(|component| terms.negative(component));
        let (kind, direction, tangents) = match is_spatial {
            true => (SurfaceKind::Plane, z, [x, y]),
            false => (SurfaceKind::Line, y, [x, down]),
        };
        let (place, radius) = (zero_triple(&mut terms), terms.number(0));
        let (carrier, turning, height) = (None, radius, None);
        let length = None;
        let ground = Surface { kind, carrier, place, direction, length, tangents, radius, height, turning };
        if !has_drawn(translation, &name.text) {
            draw_if_wanted(translation, &name.text, &ground);
        }
        return Some(ground);
    }
    let before = std::mem::replace(&mut translation.origin, name.span.into());
    if !translation.unreadable.contains(&name.text) && !report_early(translation, &name.text) {
        let accept =
            |object: &Object| !matches!(object, Object::Connector(_) | Object::Joint(_) | Object::Contact(_));
        let help = match translation.names.nearest(&name.text, accept) {
            Some(nearest) => messages::did_you_mean(nearest),
            None => words::NO_SURFACE_HELP.to_owned(),
        };
        let message = words::unknown_surface(&statement.name.text, &name.text);
        translation.report.error(name.span, message).help(help);
    }
    translation.origin = before;
    None
}

/// True if a surface of this name has been drawn.
fn has_drawn(translation: &Translation<'_>, name: &str) -> bool {
    let is_it =
        |drawn: &Drawn| matches!(&drawn.kind, DrawnKind::Surface { name: known, .. } if known == name);
    translation.drawing.iter().any(is_it)
}

fn surface_of_line(translation: &mut Translation<'_>, line: usize) -> Surface {
    let Line { body, through: [x, y], angle } = translation.lines[line].clone();
    let turning = rate_of(translation, angle);
    let mut terms = translation.terms();
    let zero = terms.number(0);
    let [tangent, normal] = terms.axes(angle).map(|[x, y]| [x, y, zero]);
    let down = unit(&mut terms, 2).map(|component| terms.negative(component));
    let (place, tangents) = ([x, y, zero], [tangent, down]);
    let (kind, length, height) = (SurfaceKind::Line, None, None);
    Surface { kind, carrier: body, place, direction: normal, length, tangents, radius: zero, height, turning }
}
