//! Springs and dampers.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::element::{LANE, WIDER};
use crate::geometry::{add, arc, direction, length, moved, polyline, subtract, times, turned};
use crate::picture::{Point, Segment};
use lagrange_runtime::scene::Connector;

/// Windings of a spring.
const WINDINGS: usize = 8;
/// Half width of a spring.
const AMPLITUDE: f64 = 6.0;
/// Length of the straight piece at either end in pixels, and its maximum fraction of the length.
const STRAIGHT: (f64, f64) = (10.0, 0.15);
/// Length at either end of an offset connector that is on the line between its ends, and its
/// maximum fraction of the length.
const INSET: (f64, f64) = (8.0, 0.12);
/// Length and half width of the cylinder of a damper.
const CYLINDER: (f64, f64) = (22.0, 6.0);
/// Position of the piston in the cylinder.
const PISTON: f64 = 0.4;
/// Radius of a spiral.
const SPIRAL: f64 = 15.0;
/// Turns of a spiral.
const TURNS: f64 = 2.25;
/// Number of pieces of a spiral.
const POINTS: usize = 54;

/// Returns the distance of two points, and a map from coordinates along and across their line. If
/// the points coincide, the line is horizontal.
fn frame(from: Point, to: Point) -> (f64, impl Fn([f64; 2]) -> Point) {
    let along = subtract(to, from);
    let size = length(along);
    let along = if size > 0.0 { times(1.0 / size, along) } else { [1.0, 0.0] };
    (size, move |[x, y]: [f64; 2]| add(from, add(times(x, along), times(y, turned(along)))))
}

/// Returns the lines of a connector: `lane` lanes to the left of the line between its ends or,
/// about a point, around `lane` others.
pub(super) fn segments(kind: Connector, ends: [Point; 2], lane: f64) -> Vec<Segment> {
    match kind {
        Connector::Spring => beside(ends, lane, coil),
        Connector::Damper => beside(ends, lane, dashpot),
        Connector::TorsionSpring => spiral(ends[0], lane),
        Connector::TorsionDamper => drum(ends[0], lane),
    }
}

/// Returns a zigzag that stretches with the distance.
fn coil(from: Point, to: Point) -> Vec<Segment> {
    let (size, place) = frame(from, to);
    let straight = STRAIGHT.0.min(STRAIGHT.1 * size);
    let step = (size - 2.0 * straight) / (2 * WINDINGS) as f64;
    let side = |k: usize| if k.is_multiple_of(2) { AMPLITUDE } else { -AMPLITUDE };
    let mut points = vec![[0.0, 0.0], [straight, 0.0]];
    points.extend((0..2 * WINDINGS).map(|k| [straight + (k as f64 + 0.5) * step, side(k)]));
    points.extend([[size - straight, 0.0], [size, 0.0]]);
    polyline(points.into_iter().map(place), false)
}

/// Returns a cylinder at the first end and a piston at the second.
fn dashpot(from: Point, to: Point) -> Vec<Segment> {
    let (size, place) = frame(from, to);
    let (cylinder, half) = CYLINDER;
    let cylinder = cylinder.min(0.6 * size);
    let bottom = 0.5 * (size - cylinder);
    let piston = bottom + PISTON * cylinder;
    let top = bottom + cylinder;
    let lines = [
        vec![[0.0, 0.0], [bottom, 0.0]],
        vec![[top, half], [bottom, half], [bottom, -half], [top, -half]],
        vec![[piston, 0.7 * half], [piston, -0.7 * half]],
        vec![[piston, 0.0], [size, 0.0]],
    ];
    lines.into_iter().flat_map(|line| polyline(line.into_iter().map(&place), false)).collect()
}

/// Offsets a connector by `lane` lanes to the left of the line between its ends, and joins it to
/// both.
fn beside(
    [from, to]: [Point; 2],
    lane: f64,
    connector: impl Fn(Point, Point) -> Vec<Segment>,
) -> Vec<Segment> {
    if lane == 0.0 {
        return connector(from, to);
    }
    let (size, place) = frame(from, to);
    // On paper, y points downwards.
    let (inset, aside) = (INSET.0.min(INSET.1 * size), -LANE * lane);
    let [start, end] = [inset, size - inset].map(|x| [[x, 0.0], [x, aside]].map(&place));
    let mut segments = polyline([from, start[0], start[1]], false);
    segments.extend(connector(start[1], end[1]));
    segments.extend(polyline([end[1], end[0], to], false));
    segments
}

/// Returns a spiral about a point, around `lane` others.
fn spiral(at: Point, lane: f64) -> Vec<Segment> {
    let radius = SPIRAL * (1.0 + WIDER * lane);
    let point = |k: usize| {
        let part = k as f64 / POINTS as f64;
        add(at, times(radius * part, direction(-TURNS * TAU * part)))
    };
    polyline((0..=POINTS).map(point), false)
}

/// Returns two arcs about a point, one within the other, around `lane` others.
fn drum(at: Point, lane: f64) -> Vec<Segment> {
    let mut segments = Vec::new();
    let wide = SPIRAL * (1.0 + WIDER * lane);
    for (radius, from, to) in [(wide, FRAC_PI_2, TAU), (0.7 * wide, -FRAC_PI_2, PI)] {
        segments.push(Segment::Move(times(radius, direction(from))));
        segments.extend(arc([radius, radius], from, to));
    }
    moved(&segments, |[x, y]| [at[0] + x, at[1] - y])
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::{LANE, beside, coil, dashpot};
    use crate::geometry::{direction, dot, flattened, length, subtract, times, turned, unit};
    use crate::picture::{Point, Segment};

    #[test]
    fn springs_and_dampers_reach_from_end_to_end_however_long() {
        for to in [[100.0, 0.0], [3.0, 4.0], [-50.0, 80.0], [0.0, 0.0]] {
            for drawn in [coil([0.0, 0.0], to), dashpot([0.0, 0.0], to)] {
                let points = flattened(&drawn, 1);
                let ends = [points[0], points[points.len() - 1]];
                assert_eq!(ends[0], [0.0, 0.0]);
                assert!(length(subtract(ends[1], to)) < 1e-9, "{ends:?}");
                assert!(points.iter().flatten().all(|x| x.is_finite()));
            }
        }
        assert_eq!(coil([0.0, 0.0], [9.0, 0.0]).len(), coil([0.0, 0.0], [99.0, 7.0]).len());
    }

    /// Two connectors between opposite points keep a distance and extend from end to end. If one is
    /// reversed, they swap sides, in any direction and with coincident ends.
    #[test]
    fn connectors_beside_each_other_do_not_touch() {
        let around = (0..24).map(|k| direction(TAU * f64::from(k) / 24.0));
        let all = around.flat_map(|along| [100.0, 40.0, 12.0, 1e-3].map(|size| times(size, along)));
        for to in all.chain([[0.0, 0.0]]) {
            let ends = [[3.0, -2.0], [3.0 + to[0], to[1] - 2.0]];
            let normal = turned(unit(to).unwrap_or([1.0, 0.0]));
            // The distances of a connector from the line between its ends, apart from its bars.
            let across = |ends: [Point; 2], lane: f64, connector: fn(Point, Point) -> Vec<Segment>| {
                let points = flattened(&beside(ends, lane, connector), 1);
                assert_eq!(points[0], ends[0]);
                assert!(length(subtract(points[points.len() - 1], ends[1])) < 1e-9, "{points:?}");
                let offsets = points[2..points.len() - 2].iter().map(|p| dot(subtract(*p, ends[0]), normal));
                offsets.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| [low.min(y), high.max(y)])
            };
            let spring = across(ends, 0.5, coil);
            let against = if to == [0.0, 0.0] { -0.5 } else { 0.5 };
            for damper in [across(ends, -0.5, dashpot), across([ends[1], ends[0]], against, dashpot)] {
                assert!(damper[0] - spring[1] >= LANE - 12.0 - 1e-9, "{to:?} {spring:?} {damper:?}");
            }
            assert_eq!(beside(ends, 0.0, coil), coil(ends[0], ends[1]));
        }
    }
}
