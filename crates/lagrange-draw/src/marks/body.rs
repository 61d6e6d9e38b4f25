//! Bodies: light areas with dark rims.

use crate::colour::{INK, PALE};
use crate::cut::{common, crosses, encloses, kept};
use crate::geometry::{Place, moved, polyline};
use crate::marks::{MEDIUM, THIN, dot, path, stroke};
use crate::outline::{Form, Piece};
use crate::picture::{Colour, Mark, Point, Segment, Style};
use crate::view::View;

/// Width of point masses in pixels.
const MASS: f64 = 11.0;
/// Width of rods in pixels.
const ROD: f64 = 6.0;

/// Returns the marks of a body. Rims are behind areas, so that only the outer boundary of the union
/// remains visible.
pub(super) fn marks(
    place: &Place,
    center: Point,
    pieces: &[Piece],
    colour: Colour,
    view: &View,
) -> Vec<Mark> {
    if pieces.is_empty() {
        return vec![dot(view.point(center), INK)];
    }
    let on_paper = |ring: &[Segment]| moved(ring, |p| view.point(place.of(p)));
    let rings = |piece: &Piece| piece.rings(view.of_pixels(thickness(&piece.form)));
    let all: Vec<(bool, Vec<Segment>)> =
        pieces.iter().flat_map(|piece| rings(piece).into_iter().map(|ring| (piece.is_hole, ring))).collect();
    let of = |wanted: bool| {
        let lines =
            all.iter().filter(|(is_hole, _)| *is_hole == wanted).map(|(_, ring)| rim(ring, wanted, &all));
        lines.flat_map(|line| on_paper(&line)).collect()
    };
    let mut marks = vec![path(of(false), stroke(INK, 2.0 * MEDIUM))];
    for (index, piece) in pieces.iter().enumerate().filter(|(_, piece)| !piece.is_hole) {
        let holes: Vec<_> = pieces[index..].iter().filter(|later| later.is_hole).flat_map(rings).collect();
        let mut area = rings(piece);
        if let Some(rim) = area.first().cloned() {
            area.extend(holes.iter().flat_map(|hole| common(&rim, hole)));
        }
        let fill = if piece.form == Form::Dot { INK } else { colour };
        let segments = area.iter().flat_map(|ring| on_paper(ring)).collect();
        marks.push(path(segments, Style { stroke: None, width: 0.0, dashes: &[], fill: Some(fill) }));
    }
    marks.push(path(of(true), stroke(INK, MEDIUM)));
    let radii = pieces.iter().filter(|piece| !piece.is_hole).filter_map(Piece::radius);
    let radii = radii.flat_map(|ends| on_paper(&polyline(ends, false))).collect();
    marks.push(path(radii, stroke(PALE, THIN)));
    marks
}

/// Returns the visible rim of a part outside holes, or of a hole inside parts.
fn rim(ring: &[Segment], is_hole: bool, all: &[(bool, Vec<Segment>)]) -> Vec<Segment> {
    let others = || all.iter().filter(|(other, _)| *other != is_hole).map(|(_, ring)| ring);
    let is_cut = others().any(|other| if is_hole { crosses(other, ring) } else { crosses(ring, other) });
    if !is_cut {
        return ring.to_vec();
    }
    // A rim within another part would be behind its area, but extend into the hole.
    let is_hidden = |p| {
        let same = all.iter().filter(|(other, line)| *other == is_hole && line != ring);
        same.into_iter().any(|(_, line)| encloses(line, p))
    };
    kept(ring, |p| others().any(|other| encloses(other, p)) == is_hole && !is_hidden(p))
}

fn thickness(form: &Form) -> f64 {
    match form {
        Form::Dot => MASS,
        _ => ROD,
    }
}
