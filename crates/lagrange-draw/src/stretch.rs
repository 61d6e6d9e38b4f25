//! The extents of lines in a picture.
//!
//! Lines of a scene have no ends. However, if two of them cross, a floor ends at a wall, and a
//! plateau at the start of a slope. A line at rest is therefore cut at its crossings, and only the
//! stretches remain that an object touches at some time.

use std::collections::BTreeMap;

use crate::geometry::{add, direction, dot, extent, subtract, times, turned};
use crate::outline::Piece;
use crate::picture::Point;
use crate::snapshot::{Line, Snapshot};
use lagrange_runtime::scene::Joint;

/// Drawn stretches of each line, by its name.
pub(super) type Stretches = BTreeMap<String, Vec<[f64; 2]>>;

const ENDLESS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
/// Distance from a line, as a fraction of the scene's size, below which points touch it.
const TOUCHING: f64 = 1e-6;
/// Relative excess length of a moving line over the objects that touch it, if nothing else
/// determines its length.
const LONGER: f64 = 0.2;

/// Returns the drawn stretches of each line throughout a film.
pub(super) fn stretches(film: &[Snapshot]) -> Stretches {
    let centers = film.iter().flat_map(|snapshot| &snapshot.bodies).map(|body| body.motion.center);
    let joints = film.iter().flat_map(|snapshot| &snapshot.joints).map(|joint| joint.at);
    let close = TOUCHING * extent(centers.chain(joints));
    let mut stretches = Stretches::new();
    for line in film.iter().flat_map(|snapshot| &snapshot.lines) {
        if !stretches.contains_key(&line.name) {
            stretches.insert(line.name.clone(), of_line(line, film, close));
        }
    }
    stretches
}

/// Returns the visible part of a line without contacts: the part onto which bodies would fall.
pub(super) fn seen(line: &Line, snapshot: &Snapshot, stretches: &[[f64; 2]]) -> Vec<Point> {
    let has_contact = snapshot.joints.iter().any(|joint| matches!(joint.kind, Joint::Slide | Joint::Roll));
    if line.body.is_some() || has_contact {
        return Vec::new();
    }
    let along = snapshot.bodies.iter().map(|body| coordinates(line, body.motion.center)[0]);
    let drawn = along.filter(|s| stretches.iter().any(|[low, high]| (*low..=*high).contains(s)));
    drawn.map(|s| add(line.place.at, times(s, direction(line.place.angle)))).collect()
}

fn of_line(line: &Line, film: &[Snapshot], close: f64) -> Vec<[f64; 2]> {
    let now = |snapshot: &Snapshot| snapshot.lines.iter().find(|other| other.name == line.name).cloned();
    let is_at_rest = line.body.is_none() && film.iter().all(|s| now(s).is_some_and(|other| other == *line));
    let touched = |snapshot| now(snapshot).map(|line| contacts(&line, snapshot, close)).unwrap_or_default();
    let mut marks: Vec<f64> = film.iter().flat_map(touched).collect();
    if !is_at_rest {
        let (count, bodies) = (marks.len(), film.iter().filter_map(|s| Some((now(s)?, s))));
        marks.extend(bodies.flat_map(|(line, snapshot)| rim(&line, snapshot)));
        return vec![moving(&marks, marks.len() > count)];
    }
    if marks.is_empty() {
        let centers = film.iter().flat_map(|snapshot| &snapshot.bodies);
        marks.extend(centers.map(|body| coordinates(line, body.motion.center)[0]));
    }
    let mut ends = crossings(line, film);
    ends.extend(ENDLESS);
    ends.sort_by(f64::total_cmp);
    let pieces = ends.windows(2).map(|ends| [ends[0], ends[1]]);
    let inside = |[low, high]: &[f64; 2]| marks.iter().any(|s| (low + close..=high - close).contains(s));
    let kept: Vec<_> = pieces.filter(inside).collect();
    if kept.is_empty() { vec![ENDLESS] } else { kept }
}

/// Returns the coordinates of a point along and across a line.
pub(super) fn coordinates(line: &Line, p: Point) -> [f64; 2] {
    let (along, from) = (direction(line.place.angle), subtract(p, line.place.at));
    [dot(along, from), dot(turned(along), from)]
}

fn contacts(line: &Line, snapshot: &Snapshot, close: f64) -> Vec<f64> {
    let touching = snapshot.joints.iter().filter(|joint| matches!(joint.kind, Joint::Slide | Joint::Roll));
    let places = touching.map(|joint| coordinates(line, joint.at));
    places.filter(|[_, across]| across.abs() <= close).map(|[along, _]| along).collect()
}

/// Returns the coordinates along a line at which the rim of its carrier lies.
fn rim(line: &Line, snapshot: &Snapshot) -> Vec<f64> {
    let Some(body) = line.body.as_deref().and_then(|name| snapshot.body(name)) else { return Vec::new() };
    let points = body.pieces.iter().flat_map(Piece::rim);
    points.map(|p| coordinates(line, body.place().of(p))[0]).collect()
}

/// Returns the extent of a moving line, determined by the points on it.
fn moving(marks: &[f64], has_body: bool) -> [f64; 2] {
    let (low, high) =
        marks.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(*s), h.max(*s)));
    let more = if has_body { 0.0 } else { LONGER * (high - low) };
    if low < high { [low - more, high + more] } else { ENDLESS }
}

/// Returns the points at which other lines at rest cross a line.
fn crossings(line: &Line, film: &[Snapshot]) -> Vec<f64> {
    const PARALLEL: f64 = 1e-9;
    let others = film.first().into_iter().flat_map(|snapshot| &snapshot.lines);
    let along = direction(line.place.angle);
    let crossing = |other: &Line| {
        let normal = turned(direction(other.place.angle));
        let slope = dot(normal, along);
        let away = dot(normal, subtract(other.place.at, line.place.at));
        (slope.abs() > PARALLEL).then(|| away / slope)
    };
    others.filter(|other| other.body.is_none() && other.name != line.name).filter_map(crossing).collect()
}

#[cfg(test)]
mod tests {

    use super::{ENDLESS, stretches};
    use crate::geometry::Place;
    use crate::snapshot::{Joint, Line, Snapshot};
    use lagrange_runtime::scene;

    fn line(name: &str, angle: f64) -> Line {
        Line { name: name.to_string(), body: None, place: Place { at: [0.0, 0.0], angle } }
    }

    fn slide(at: [f64; 2]) -> Joint {
        Joint { name: "foot".to_string(), kind: scene::Joint::Slide, at }
    }

    #[test]
    fn a_floor_and_a_wall_end_where_they_meet() {
        let lines = vec![line("floor", 0.0), line("wall", -std::f64::consts::FRAC_PI_2)];
        let scene =
            Snapshot { lines, joints: vec![slide([1.0, 0.0]), slide([0.0, 2.0])], ..Snapshot::default() };
        let found = stretches(&[scene]);
        let [[low, high]] = found["floor"][..] else { panic!("{found:?}") };
        assert!(low.abs() < 1e-12 && high == f64::INFINITY);
        let [[low, high]] = found["wall"][..] else { panic!("{found:?}") };
        assert!(low == f64::NEG_INFINITY && high.abs() < 1e-12, "its direction is downwards");
    }

    #[test]
    fn a_line_that_is_touched_on_both_sides_of_a_crossing_goes_on() {
        let lines = vec![line("floor", 0.0), line("other", 1.0)];
        let joints = vec![slide([1.0, 0.0]), slide([-1.0, 0.0])];
        let found = stretches(&[Snapshot { lines, joints, ..Snapshot::default() }]);
        assert_eq!(found["floor"].len(), 2);
        assert_eq!(found["other"], [ENDLESS], "nothing is known about it");
    }
}
