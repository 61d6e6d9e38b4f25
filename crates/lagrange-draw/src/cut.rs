//! Holes: intersections of two areas.

use crate::geometry::{dot, flattened, mix, polyline, subtract, turned};
use crate::picture::{Point, Segment};

/// Straight pieces per curve for partially overlapping areas.
const PIECES: usize = 16;

/// Returns the outlines of the intersection of a hole with a part: the hole itself if it is inside,
/// nothing if it is outside.
///
/// Otherwise one of the two must be convex. Its sides clip the other one in turn (Sutherland,
/// Hodgman, *Communications of the ACM* 17, 1974). If neither is convex, the result is smaller than
/// the intersection.
pub(super) fn common(part: &[Segment], hole: &[Segment]) -> Vec<Vec<Segment>> {
    let (outer, inner) = (flattened(part, PIECES), flattened(hole, PIECES));
    if inner.iter().all(|p| contains(&outer, *p)) {
        return vec![hole.to_vec()];
    }
    let cut = if is_convex(&outer) { within(inner, &outer) } else { within(outer, &inner) };
    if cut.len() < 3 { Vec::new() } else { vec![polyline(cut, true)] }
}

/// True if a hole and a part overlap, but the hole is not inside.
pub(super) fn crosses(part: &[Segment], hole: &[Segment]) -> bool {
    let (outer, inner) = (flattened(part, PIECES), flattened(hole, PIECES));
    let inside = inner.iter().filter(|p| contains(&outer, **p)).count();
    (1..inner.len()).contains(&inside) || (inside == 0 && outer.iter().any(|p| contains(&inner, *p)))
}

/// Returns the pieces of a line whose midpoints `keep` accepts.
pub(super) fn kept(ring: &[Segment], keep: impl Fn(Point) -> bool) -> Vec<Segment> {
    const FINE: u32 = 48;
    let corners = flattened(ring, FINE as usize);
    let is_curved = ring.iter().any(|segment| matches!(segment, Segment::Curve(..)));
    let count = if is_curved { 4 } else { FINE };
    let part = |k: u32| f64::from(k) / f64::from(count);
    let pieces = sides(&corners)
        .flat_map(|(a, b)| (0..count).map(move |k| [mix(a, b, part(k)), mix(a, b, part(k + 1))]));
    let kept = pieces.filter(|[a, b]| keep(mix(*a, *b, 0.5)));
    kept.flat_map(|ends| polyline(ends, false)).collect()
}

/// True if a point lies inside a closed line.
pub(super) fn encloses(ring: &[Segment], p: Point) -> bool {
    contains(&flattened(ring, PIECES), p)
}

/// True if a point is in the polygon, by the parity of crossings with a ray.
pub(super) fn contains(polygon: &[Point], p: Point) -> bool {
    let mut is_inside = false;
    for (a, b) in sides(polygon) {
        if (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
            is_inside = !is_inside;
        }
    }
    is_inside
}

fn sides(polygon: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    polygon.iter().copied().zip(polygon.iter().copied().cycle().skip(1))
}

fn is_convex(polygon: &[Point]) -> bool {
    let bends = sides(polygon).zip(sides(polygon).collect::<Vec<_>>().into_iter().cycle().skip(1));
    let bends: Vec<f64> = bends.map(|((a, b), (c, d))| dot(turned(subtract(b, a)), subtract(d, c))).collect();
    let size = bends.iter().fold(0.0_f64, |most, bend| most.max(bend.abs()));
    let rounding = 1e-9 * size;
    bends.iter().all(|bend| *bend > -rounding) || bends.iter().all(|bend| *bend < rounding)
}

fn area(polygon: &[Point]) -> f64 {
    sides(polygon).map(|(a, b)| dot(turned(a), b)).sum()
}

/// Clips a polygon to a convex one.
fn within(mut polygon: Vec<Point>, convex: &[Point]) -> Vec<Point> {
    let side = area(convex).signum();
    for (a, b) in sides(convex) {
        let inside = |p: Point| side * dot(turned(subtract(b, a)), subtract(p, a));
        let mut kept = Vec::new();
        for (p, q) in sides(&polygon) {
            let (at_p, at_q) = (inside(p), inside(q));
            if at_p >= 0.0 {
                kept.push(p);
            }
            if (at_p >= 0.0) != (at_q >= 0.0) {
                kept.push(mix(p, q, at_p / (at_p - at_q)));
            }
        }
        polygon = kept;
    }
    polygon
}

#[cfg(test)]
mod tests {

    use super::{area, common};
    use crate::geometry::{ellipse, flattened, moved, polyline};
    use crate::picture::{Point, Segment};

    fn square(low: Point, side: f64) -> Vec<Segment> {
        let [x, y] = low;
        polyline([[x, y], [x + side, y], [x + side, y + side], [x, y + side]], true)
    }

    fn total(rings: &[Vec<Segment>]) -> f64 {
        rings.iter().map(|ring| 0.5 * area(&flattened(ring, 16)).abs()).sum()
    }

    #[test]
    fn a_hole_inside_a_part_is_cut_out_as_it_is() {
        let hole = moved(&ellipse([0.2, 0.2]), |[x, y]| [x + 0.5, y + 0.5]);
        assert_eq!(common(&square([0.0, 0.0], 1.0), &hole), [hole]);
    }

    #[test]
    fn a_hole_outside_a_part_cuts_nothing() {
        assert!(common(&square([0.0, 0.0], 1.0), &square([2.0, 0.0], 1.0)).is_empty());
    }

    #[test]
    fn a_hole_across_the_rim_cuts_what_both_share() {
        let cut = common(&square([0.0, 0.0], 1.0), &square([0.5, 0.5], 1.0));
        assert!((total(&cut) - 0.25).abs() < 1e-12);
        let angle = polyline([[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]], true);
        let cut = common(&angle, &square([0.5, 0.5], 1.0));
        assert!((total(&cut) - 0.75).abs() < 1e-12, "the part need not be convex");
    }
}
