//! Corners of bodies, numbered like the elements of arrays of contacts.
//!
//! The corners of a cuboid (a, b, c) are at (±a/2, ±b/2, ±c/2) from its centre. X changes fastest:
//! number 5 = 1 + 4 has the signs (+, −, +). A rectangle has the first four. The corners of
//! polygons and right triangles are in the order of their declaration, and a rod has its two ends.

use super::constants::number;
use super::messages;
use super::plain::Outline;
use super::terms::TermWriter;
use super::translation::Translation;
use crate::syntax::ast::AstId;

/// Returns the corner with this number in the body's coordinates, in the plane with a third
/// component of zero; errors are reported.
pub(super) fn corner(
    translation: &mut Translation<'_>,
    name: &str,
    shape: Option<&Outline>,
    index: AstId,
) -> Option<[AstId; 3]> {
    let corners = corners_of(&mut translation.terms(), shape);
    let number = number(&translation.expressions, translation.names.constants(), index);
    let found = number.and_then(|number| position(number, corners.len()));
    if found.is_none() && translation.are_read(&[index]) {
        let origin = translation.expressions.origin(index);
        let (message, help) = match corners.len() {
            0 => (messages::no_corners(name), messages::NO_CORNERS_HELP.to_owned()),
            count => (messages::no_corner(name), messages::corners_are(name, count - 1)),
        };
        translation.report.error(origin, message).help(help);
    }
    found.map(|position| corners[position])
}

/// Returns the number of corners of a shape.
pub(super) fn corner_count(translation: &mut Translation<'_>, shape: Option<&Outline>) -> usize {
    corners_of(&mut translation.terms(), shape).len()
}

/// Returns the index of the corner with this number, if there are enough corners.
fn position(number: f64, count: usize) -> Option<usize> {
    (0..count).find(|&position| position as f64 == number)
}

fn corners_of(terms: &mut TermWriter<'_>, shape: Option<&Outline>) -> Vec<[AstId; 3]> {
    let Some(Outline { variant, dimensions, place, .. }) = shape else { return Vec::new() };
    let zero = terms.number(0);
    let center = match place[..] {
        [x, y, z, ..] => [x, y, z],
        _ => [zero; 3],
    };
    match (*variant, &dimensions[..]) {
        ("Cuboid", &[a, b, c]) => around(terms, center, [Some(a), Some(b), Some(c)]),
        ("Rectangle", &[a, b]) => around(terms, center, [Some(a), Some(b), None]),
        ("SlenderRod", &[l]) => around(terms, center, [Some(l), None, None]),
        ("RightTriangle", &[a, b]) => vec![[zero; 3], [a, zero, zero], [zero, b, zero]],
        ("Polygon", corners) => {
            let corners = corners.iter().map(|&corner| terms.pair(corner));
            corners.map(|[x, y]| [x, y, zero]).collect()
        }
        _ => Vec::new(),
    }
}

/// Returns the points at half of the sides on both sides of the centre.
fn around(terms: &mut TermWriter<'_>, center: [AstId; 3], sides: [Option<AstId>; 3]) -> Vec<[AstId; 3]> {
    let mut corners = vec![center];
    for (axis, side) in sides.into_iter().enumerate() {
        let Some(side) = side else { continue };
        let half = terms.half();
        let arm = terms.times(half, side);
        let moved = |terms: &mut TermWriter<'_>, corner: &[AstId; 3], arm| {
            let mut corner = *corner;
            corner[axis] = terms.plus(corner[axis], arm);
            corner
        };
        let back = terms.negative(arm);
        corners = [back, arm]
            .iter()
            .flat_map(|&arm| corners.iter().map(move |corner| (corner, arm)))
            .map(|(corner, arm)| moved(terms, corner, arm))
            .collect();
    }
    corners
}
