//! Auxiliary lines.

use crate::geometry::{add, length, polyline, subtract, times, unit};
use crate::marks::{DASHES, THIN, dot, path, stroke};
use crate::picture::{Colour, Mark, Point, Segment, Style};
use crate::view::View;

/// Distance from the previous point below which a point is omitted.
const CLOSE: f64 = 0.7;

/// Draws a dashed line to a point, and the point if it is in the window.
pub(super) fn ray(from: Point, to: Point, colour: Colour, view: &View) -> Vec<Mark> {
    let point = if view.holds(to) { dot(to, colour) } else { dot(from, colour).emptied() };
    vec![dashed(view.clipped([from, to]), colour), point]
}

/// Draws a dashed line from border to border.
pub(super) fn through([a, b]: [Point; 2], colour: Colour, view: &View) -> Mark {
    let along = unit(subtract(b, a));
    let [low, high] = view.window;
    let far = length(subtract(a, low)) + length(subtract(high, low));
    let ends = along.map(|along| [add(a, times(-far, along)), add(a, times(far, along))]);
    dashed(ends.and_then(|ends| view.clipped(ends)), colour)
}

fn dashed(ends: Option<[Point; 2]>, colour: Colour) -> Mark {
    let segments = polyline(ends.into_iter().flatten(), false);
    path(segments, Style { dashes: DASHES, ..stroke(colour, THIN) })
}

/// Returns a line without indistinguishable points; its last point stays.
pub(super) fn thinned(points: impl Iterator<Item = Point>) -> Vec<Segment> {
    let mut kept: Vec<Point> = Vec::new();
    let mut last = None;
    for point in points {
        last = Some(point);
        if kept.last().is_none_or(|before| length(subtract(point, *before)) >= CLOSE) {
            kept.push(point);
        }
    }
    if kept.last() != last.as_ref() {
        kept.extend(last);
    }
    polyline(kept, false)
}

#[cfg(test)]
mod tests {
    use super::thinned;
    use crate::picture::Segment;

    #[test]
    fn thinning_keeps_both_ends() {
        let points = (0..=1000).map(|k| [0.01 * f64::from(k), 0.0]);
        let line = thinned(points);
        assert!(line.len() < 20);
        assert_eq!(line.first(), Some(&Segment::Move([0.0, 0.0])));
        assert_eq!(line.last(), Some(&Segment::Line([10.0, 0.0])));
    }
}
