//! Contacts of cuboids and rods by their faces and edges, also with balls.
//!
//! The run time finds the contact points (`lagrange::manifold`). Each has a place p₁ in the first
//! block and p₂ in the second, in their axes. It also has a normal n and a number c. The gap is
//! n·(R₁ p₁ + x₁ − R₂ p₂ − x₂) + c. Closest points move at right angles to n. Its gradient for
//! fixed p₁, p₂ and n is therefore that of the distance. The rate of n is not a part of the
//! equations. Its effect on a step is of second order in the step.
//!
//! A cube with the side 1 lies on another one, with its centre at (0, 0, 1). Its corner p₁ = (½, ½,
//! −½) is on p₂ = (½, ½, ½), with n = (0, 0, 1) and c = 0. The gap is 1 − ½ − ½ = 0.

use super::geometry::ContactGeometry;
use crate::bodies::constants::number;
use crate::bodies::messages::contacts as words;
use crate::bodies::object::{Object, Surface};
use crate::bodies::plain::Outline;
use crate::bodies::space::vectors::{Triple, cross, inner, minus};
use crate::bodies::space::{place_on_link, vector_on_link};
use crate::bodies::surfaces::bind_vector;
use crate::bodies::touching::{Touching, motion_at};
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId, CONTACT_POINT, CONTACT_POINT_LENGTH, Expression, SurfaceKind};

/// Index of the first component of the tangent among the numbers of a contact point.
const TANGENT: usize = 9;

/// Returns the number of contact points of two such blocks.
fn point_count(shapes: &[Outline; 2]) -> usize {
    let fewest = shapes.iter().map(|shape| match shape.variant {
        "Cuboid" => 8,
        "SlenderRod" => 2,
        _ => 1,
    });
    fewest.min().unwrap_or_default()
}

/// True if a contact is one of the points in which two blocks touch.
pub(super) fn is_between_blocks(translation: &Translation<'_>, statement: &ast::Contact) -> bool {
    numbered(translation, statement).is_some()
}

/// The body and the number of a contact point.
fn numbered(translation: &Translation<'_>, statement: &ast::Contact) -> Option<[AstId; 2]> {
    match translation.expressions.get(statement.object) {
        Expression::Call(function, arguments) if function.text == CONTACT_POINT => {
            arguments[..].try_into().ok()
        }
        _ => None,
    }
}

/// The first block; `None` after a mistake.
pub(super) fn block_that_touches(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
) -> Option<Touching> {
    let name = &statement.name.text;
    let mistakes = [
        (translation.space.is_none(), words::faces_in_the_plane(name), words::FACES_IN_THE_PLANE_HELP),
        (statement.rim.is_some(), words::faces_with_rim(name), words::FACES_WITH_RIM_HELP),
        (statement.compliance.way().is_some(), words::compliant_faces(name), words::COMPLIANT_FACES_HELP),
        (
            statement.rolling.or(statement.spinning).is_some(),
            words::faces_that_turn(name),
            words::FACES_THAT_TURN_HELP,
        ),
        (statement.is_inside, words::inside_of_block(name), words::INSIDE_OF_BLOCK_HELP),
    ];
    if let Some((_, message, help)) = mistakes.into_iter().find(|(is_made, ..)| *is_made) {
        // Once for all points.
        if numbered(translation, statement).is_some_and(|[_, number]| place(translation, number) == Some(0)) {
            translation.report.error(statement.name.span, message).help(help);
        }
        return None;
    }
    let [body, _] = numbered(translation, statement)?;
    let body = translation.link_named(body)?;
    let center = [translation.terms().number(0); 3];
    let (velocity, spin) = motion_at(translation, body, center);
    Some(Touching { body, center, velocity, spin, radius: None })
}

/// The second block as a surface.
pub(super) fn surface_of_block(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
) -> Option<Surface> {
    let Some(Object::Link { index, .. }) = translation.names.find(&statement.surface.text).cloned() else {
        return None;
    };
    let zero = translation.terms().number(0);
    let [place, direction] = [[zero; 3]; 2];
    let (kind, carrier, tangents) = (SurfaceKind::Plane, Some(index), [place; 2]);
    let (length, height) = (None, None);
    Some(Surface { kind, carrier, place, direction, length, tangents, radius: zero, height, turning: zero })
}

/// The geometry of a contact point of two blocks.
pub(super) fn between_blocks(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    (touching, surface): (Touching, &Surface),
    radius: Option<AstId>,
) -> Option<(Touching, ContactGeometry)> {
    let name = &statement.name.text;
    let (first, second) = (touching.body, surface.carrier?);
    let [_, index] = numbered(translation, statement)?;
    let index = place(translation, index)?;
    let zero = translation.terms().number(0);
    let shapes = [shape_of(translation, first)?, shape_of(translation, second)?];
    let count = point_count(&shapes) * CONTACT_POINT_LENGTH;
    let radius = radius.or(radius_of(&shapes[0])).unwrap_or(zero);
    let other = radius_of(&shapes[1]).unwrap_or(zero);
    let mut blocks = Vec::new();
    for (link, shape, around) in [(first, &shapes[0], radius), (second, &shapes[1], other)] {
        blocks.extend(numbers_of(translation, name, (link, shape)));
        blocks.push(around);
    }
    let has_friction = statement.friction.or(statement.kinetic).is_some();
    let point = std::array::from_fn::<_, CONTACT_POINT_LENGTH, _>(|i| {
        let mut terms = translation.terms();
        let mut arguments =
            [index * CONTACT_POINT_LENGTH + i, count].map(|n| terms.number(n as i64)).to_vec();
        arguments.extend(&blocks);
        let value = terms.call(CONTACT_POINT, &arguments);
        // Only friction needs the tangent.
        if i >= TANGENT && !has_friction {
            return value;
        }
        translation.bind(&format!("{name}_number"), value)
    });
    let [a, b, normal, tangent] =
        [0, 3, 6, TANGENT].map(|from| [point[from], point[from + 1], point[from + 2]]);
    let [a, b] = [(first, &shapes[0], a), (second, &shapes[1], b)].map(|(link, shape, own)| {
        let place = placed(translation, shape, own);
        place_on_link(translation, link, place)
    });
    let center = bind_vector(translation, &format!("{name}_center"), a);
    let mut terms = translation.terms();
    let between = minus(&mut terms, center, b);
    let apart = inner(&mut terms, normal, between);
    let gap = terms.plus(apart, point[12]);
    let tangents = [tangent, cross(&mut terms, normal, tangent)];
    let (velocity, spin) = motion_at(translation, first, center);
    let touching = Touching { center, velocity, spin, ..touching };
    Some((touching, ContactGeometry { center, radius, gap, normal, tangents, rising: None }))
}

/// A number of a loop.
fn place(translation: &Translation<'_>, id: AstId) -> Option<usize> {
    let value = number(&translation.expressions, translation.names.constants(), id)?;
    (value >= 0.0).then_some(value as usize)
}

fn shape_of(translation: &Translation<'_>, link: usize) -> Option<Outline> {
    translation.space.as_ref()?.links[link].shape.clone()
}

/// Centre, axes and half sizes of a block in the world.
fn numbers_of(translation: &mut Translation<'_>, name: &str, (link, shape): (usize, &Outline)) -> Vec<AstId> {
    let place = &shape.place;
    let axes = [0, 1, 2].map(|axis| [place[3 + axis], place[6 + axis], place[9 + axis]]);
    let center = place_on_link(translation, link, [place[0], place[1], place[2]]);
    let mut numbers = bind_vector(translation, &format!("{name}_block"), center).to_vec();
    for axis in axes {
        let axis = vector_on_link(translation, link, axis);
        numbers.extend(bind_vector(translation, &format!("{name}_block_axis"), axis));
    }
    let mut terms = translation.terms();
    for axis in 0..3 {
        numbers.push(match shape.dimensions.get(axis) {
            Some(&size) if radius_of(shape).is_none() => {
                let half = terms.half();
                terms.times(half, size)
            }
            _ => terms.number(0),
        });
    }
    numbers
}

/// The radius of a ball.
fn radius_of(shape: &Outline) -> Option<AstId> {
    shape.dimensions.first().copied().filter(|_| shape.variant == "Sphere")
}

/// The place on a link of coordinates of its shape.
fn placed(translation: &mut Translation<'_>, shape: &Outline, own: Triple) -> Triple {
    let place = &shape.place;
    let mut terms = translation.terms();
    [0, 1, 2].map(|row| {
        let turned = inner(&mut terms, [3, 4, 5].map(|column| place[3 * row + column]), own);
        terms.plus(place[row], turned)
    })
}
