//! Arrows, straight and round.

use std::f64::consts::FRAC_PI_2;

use crate::element::RING;
use crate::geometry::{add, arc, direction, length, mix, moved, polyline, subtract, times, turned, unit};
use crate::picture::{Point, Segment};

/// Length and half width of an arrowhead.
const HEAD: (f64, f64) = (9.0, 3.2);
/// Length below which an arrow has no label. It would be on the body that the arrow starts in, and
/// there is hardly an arrow to read it with.
pub(crate) const NAMED: f64 = HEAD.0;
/// Maximum fraction of an arrow's length for its head.
const SHARE: f64 = 0.6;
/// Length below which an arrow has no visible direction.
const LEAST: f64 = 1.0;
/// Radius and angle of the arrow of a moment.
const TURN: (f64, f64) = (20.0, 3.0 * FRAC_PI_2);
/// Radius of the arc of an angle.
pub(crate) const ANGLE: f64 = 26.0;
/// Distance of a dimension line from its two points.
pub(crate) const BESIDE: f64 = 18.0;

/// Returns the start of an arrow that belongs to a point. It is the point itself, or, for a pushing
/// arrow, the start from which it ends there.
pub(crate) fn start(at: Point, vector: Point, is_push: bool) -> Point {
    if is_push { subtract(at, vector) } else { at }
}

/// Returns an arrow from a point, or nothing if it is too short.
pub(super) fn straight(from: Point, vector: Point) -> Vec<Segment> {
    let size = length(vector);
    if size < LEAST {
        return Vec::new();
    }
    let tip = add(from, vector);
    let head = HEAD.0.min(SHARE * size);
    let mut segments = polyline([from, mix(tip, from, head / size)], false);
    segments.extend(arrowhead(tip, times(1.0 / size, vector), head));
    segments
}

fn arrowhead(tip: Point, along: Point, size: f64) -> Vec<Segment> {
    let half = HEAD.1 * size / HEAD.0;
    let back = subtract(tip, times(size, along));
    polyline([tip, add(back, times(half, turned(along))), subtract(back, times(half, turned(along)))], true)
}

/// Returns an arrow around a point, counterclockwise if positive, outside `ring` others.
pub(super) fn turn(at: Point, moment: f64, ring: usize) -> [Vec<Segment>; 2] {
    if moment == 0.0 {
        return [Vec::new(), Vec::new()];
    }
    let (radius, sweep) = (TURN.0 + RING * ring as f64, TURN.1);
    let from = FRAC_PI_2 - 0.5 * moment.signum() * sweep;
    around(at, radius, from, from + moment.signum() * sweep)
}

/// Returns an arc with an arrowhead from one angle to another.
pub(super) fn angle(at: Point, from: f64, to: f64) -> [Vec<Segment>; 2] {
    if from == to { [Vec::new(), Vec::new()] } else { around(at, ANGLE, from, to) }
}

/// Returns an arc and its head.
fn around(at: Point, radius: f64, from: f64, to: f64) -> [Vec<Segment>; 2] {
    let head = HEAD.0.min(SHARE * radius * (to - from).abs());
    let sign = (to - from).signum();
    // The head is on the chord of the arc that it replaces.
    let neck = to - sign * head / radius;
    let mut segments = Vec::from([Segment::Move(times(radius, direction(from)))]);
    segments.extend(arc([radius, radius], from, neck));
    let (tip, back) = (times(radius, direction(to)), times(radius, direction(neck)));
    let along = unit(subtract(tip, back)).unwrap_or([0.0, 0.0]);
    let head = arrowhead(tip, along, head);
    [segments, head].map(|part| moved(&part, |[x, y]| [at[0] + x, at[1] - y]))
}

/// Returns a line with arrowheads on the left of two points, and thin lines to both of them.
pub(super) fn dimension(ends: [Point; 2]) -> [Vec<Segment>; 2] {
    const BEYOND: f64 = 4.0;
    let Some(along) = unit(subtract(ends[1], ends[0])) else { return [Vec::new(), Vec::new()] };
    // On paper, a quarter turn from x to y is clockwise.
    let left = times(-1.0, turned(along));
    let [a, b] = ends.map(|end| add(end, times(BESIDE, left)));
    let head = HEAD.0.min(0.5 * SHARE * length(subtract(b, a)));
    let mut segments = polyline([add(a, times(head, along)), subtract(b, times(head, along))], false);
    segments.extend(arrowhead(a, times(-1.0, along), head));
    segments.extend(arrowhead(b, along, head));
    let beyond = |end: Point| polyline([end, add(end, times(BESIDE + BEYOND, left))], false);
    [ends.into_iter().flat_map(beyond).collect(), segments]
}

#[cfg(test)]
mod tests {
    use super::{angle, straight, turn};
    use crate::geometry::{flattened, length, subtract};

    #[test]
    fn arrows_end_at_their_tips() {
        for vector in [[30.0, 0.0], [3.0, -4.0], [0.0, 200.0]] {
            let points = flattened(&straight([10.0, 10.0], vector), 1);
            let tip = [10.0 + vector[0], 10.0 + vector[1]];
            assert_eq!(points[0], [10.0, 10.0]);
            assert!(points.iter().any(|p| length(subtract(*p, tip)) < 1e-9));
        }
        assert!(straight([0.0, 0.0], [0.0, 0.0]).is_empty(), "no direction, no arrow");
    }

    #[test]
    fn a_positive_moment_turns_from_right_to_left_over_the_top() {
        let points = flattened(&turn([0.0, 0.0], 2.0, 0)[0], 8);
        assert!(points[0][0] > 0.0 && points[24][0] < 0.0 && points[12][1] < -15.0, "{points:?}");
        let mirrored = flattened(&turn([0.0, 0.0], -2.0, 0)[0], 8);
        assert!(mirrored[0][0] < 0.0);
        assert_eq!(turn([0.0, 0.0], 0.0, 0).concat(), []);
    }

    #[test]
    fn an_arc_goes_to_its_angle() {
        let points = flattened(&angle([0.0, 0.0], 0.0, 1.0)[1], 8);
        let end = [super::ANGLE * 1.0_f64.cos(), -super::ANGLE * 1.0_f64.sin()];
        assert!(points.iter().any(|p| length(subtract(*p, end)) < 1e-9));
    }
}
