//! Vectors in the plane and in space; curves in the plane.

use std::array::from_fn;
use std::f64::consts::{FRAC_PI_2, TAU};

use crate::picture::{Point, Segment};

pub(super) fn add<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    from_fn(|k| a[k] + b[k])
}

pub(super) fn subtract<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    from_fn(|k| a[k] - b[k])
}

pub(super) fn times<const N: usize>(factor: f64, a: [f64; N]) -> [f64; N] {
    a.map(|component| factor * component)
}

pub(super) fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Returns the third component of a × b.
pub(super) fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Rotates by a right angle, from x towards y.
pub(super) fn turned(a: Point) -> Point {
    [-a[1], a[0]]
}

pub(super) fn length<const N: usize>(a: [f64; N]) -> f64 {
    a.into_iter().fold(0.0, f64::hypot)
}

pub(super) fn direction(angle: f64) -> Point {
    [angle.cos(), angle.sin()]
}

/// Returns the direction of a vector unless it is zero or not finite.
pub(super) fn unit<const N: usize>(a: [f64; N]) -> Option<[f64; N]> {
    let length = length(a);
    (length > 0.0 && length.is_finite()).then(|| times(1.0 / length, a))
}

pub(super) fn mix<const N: usize>(a: [f64; N], b: [f64; N], part: f64) -> [f64; N] {
    add(a, times(part, subtract(b, a)))
}

/// Returns the smallest and the largest coordinates of points along each axis; without points, ∞
/// and −∞.
pub(super) fn bounds<const N: usize>(points: impl IntoIterator<Item = [f64; N]>) -> [[f64; N]; 2] {
    points.into_iter().fold([[f64::INFINITY; N], [f64::NEG_INFINITY; N]], |[low, high], point| {
        [from_fn(|k| low[k].min(point[k])), from_fn(|k| high[k].max(point[k]))]
    })
}

/// Returns the largest extent of points along an axis; without points, zero.
pub(super) fn extent<const N: usize>(points: impl IntoIterator<Item = [f64; N]>) -> f64 {
    let [low, high] = bounds(points);
    subtract(high, low).into_iter().fold(0.0, f64::max)
}

/// A rotation followed by a shift.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Place {
    pub(super) at: Point,
    pub(super) angle: f64,
}

impl Place {
    pub(super) fn of(&self, p: Point) -> Point {
        let (sin, cos) = self.angle.sin_cos();
        add(self.at, [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1]])
    }
}

/// Maps the points of a line.
pub(super) fn moved(segments: &[Segment], to: impl Fn(Point) -> Point) -> Vec<Segment> {
    let moved = |segment: &Segment| match *segment {
        Segment::Move(p) => Segment::Move(to(p)),
        Segment::Line(p) => Segment::Line(to(p)),
        Segment::Curve(a, b, p) => Segment::Curve(to(a), to(b), to(p)),
        Segment::Close => Segment::Close,
    };
    segments.iter().map(moved).collect()
}

/// Returns a line through points, closed or open; without points, an empty one.
pub(super) fn polyline(points: impl IntoIterator<Item = Point>, is_closed: bool) -> Vec<Segment> {
    let mut points = points.into_iter();
    let mut segments: Vec<Segment> = points.next().map(Segment::Move).into_iter().collect();
    segments.extend(points.map(Segment::Line));
    if is_closed && !segments.is_empty() {
        segments.push(Segment::Close);
    }
    segments
}

/// Returns an arc of an ellipse about the origin, without its initial point. It consists of Bézier
/// curves of at most a right angle each, with control points 4/3 tan(δ/4) along the tangents.
/// Source: Goldapp, *Computer Aided Geometric Design* 8 (1991).
pub(super) fn arc(radii: Point, from: f64, to: f64) -> Vec<Segment> {
    let count = arc_pieces(to - from);
    let step = (to - from) / count as f64;
    let handle = 4.0 / 3.0 * (0.25 * step).tan();
    let scaled = |p: Point| [radii[0] * p[0], radii[1] * p[1]];
    let piece = |index: usize| {
        let (start, end) = (from + step * index as f64, from + step * (index + 1) as f64);
        let (a, b) = (direction(start), direction(end));
        let controls = [add(a, times(handle, turned(a))), subtract(b, times(handle, turned(b)))];
        Segment::Curve(scaled(controls[0]), scaled(controls[1]), scaled(b))
    };
    (0..count).map(piece).collect()
}

/// Returns the number of Bézier curves, limited for large angles. A right angle may be slightly
/// exceeded due to rounding.
fn arc_pieces(angle: f64) -> usize {
    ((angle.abs() / FRAC_PI_2 - 1e-9).ceil().max(1.0) as usize).min(64)
}

/// Returns an ellipse about the origin.
pub(super) fn ellipse(radii: Point) -> Vec<Segment> {
    let mut segments = vec![Segment::Move([radii[0], 0.0])];
    segments.extend(arc(radii, 0.0, TAU));
    segments.push(Segment::Close);
    segments
}

/// Returns the points of a line, each curve cut into this many straight pieces.
pub(super) fn flattened(segments: &[Segment], pieces: usize) -> Vec<Point> {
    let mut points: Vec<Point> = Vec::new();
    for segment in segments {
        match *segment {
            Segment::Move(p) | Segment::Line(p) => points.push(p),
            Segment::Curve(a, b, end) => {
                let start = points.last().copied().unwrap_or(a);
                points.extend((1..=pieces).map(|k| bezier([start, a, b, end], k as f64 / pieces as f64)));
            }
            Segment::Close => {}
        }
    }
    points
}

/// Evaluates a Bézier curve by de Casteljau's construction.
fn bezier([a, b, c, d]: [Point; 4], s: f64) -> Point {
    let (ab, bc, cd) = (mix(a, b, s), mix(b, c, s), mix(c, d, s));
    mix(mix(ab, bc, s), mix(bc, cd, s), s)
}

/// Returns the part of a segment inside a box, if there is one (Liang, Barsky, *ACM Transactions on
/// Graphics* 3, 1984).
pub(super) fn clipped([a, b]: [Point; 2], [low, high]: [Point; 2]) -> Option<[Point; 2]> {
    let along = subtract(b, a);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        for (speed, room) in [(-along[axis], a[axis] - low[axis]), (along[axis], high[axis] - a[axis])] {
            if speed == 0.0 && room < 0.0 {
                return None;
            }
            if speed < 0.0 {
                enter = enter.max(room / speed);
            } else if speed > 0.0 {
                leave = leave.min(room / speed);
            }
        }
    }
    (enter <= leave).then(|| [mix(a, b, enter), mix(a, b, leave)])
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::{arc, clipped, direction, ellipse, flattened, length, times};
    use crate::picture::Segment;

    #[test]
    fn arcs_keep_their_distance_from_the_middle() {
        let mut line = vec![Segment::Move(times(2.0, direction(0.3)))];
        line.extend(arc([2.0, 2.0], 0.3, 0.3 + 1.5 * PI));
        for p in flattened(&line, 16) {
            assert!((length(p) - 2.0).abs() < 1e-3, "{p:?}");
        }
        let turn = flattened(&ellipse([3.0, 1.0]), 16);
        assert!(turn.iter().all(|[x, y]| ((x / 3.0).hypot(*y) - 1.0).abs() < 5e-4));
        assert_eq!(turn.len(), 1 + 4 * 16, "four pieces make a turn");
    }

    #[test]
    fn segments_end_where_the_box_ends() {
        let window = [[0.0, 0.0], [2.0, 1.0]];
        assert_eq!(clipped([[-1.0, 0.5], [3.0, 0.5]], window), Some([[0.0, 0.5], [2.0, 0.5]]));
        assert_eq!(clipped([[0.5, -1.0], [0.5, 0.5]], window), Some([[0.5, 0.0], [0.5, 0.5]]));
        assert_eq!(clipped([[-1.0, 2.0], [3.0, 2.0]], window), None);
        assert_eq!(clipped([[3.0, 0.0], [4.0, 1.0]], window), None);
    }
}
