//! Fixed elements: lines with hatching, and pins on the ground.

use crate::colour::{HATCHING, INK, PAPER};
use crate::geometry::{Place, add, direction, length, polyline, subtract, times, turned, unit};
use crate::marks::{JOINT, MEDIUM, THIN, circle, path, stroke};
use crate::picture::{Mark, Point, Segment, Style};
use crate::view::View;

/// Spacing of hatching strokes along a line.
const SPACING: f64 = 8.0;
/// Depth of hatching strokes.
const DEPTH: f64 = 7.0;
/// Minimum length of a stroke at a border; shorter remainders are omitted.
const LEAST: f64 = 2.0;
/// Half the length of a wall.
const WALL: f64 = 14.0;
/// Height and half width of the triangle below a pin.
const TRIANGLE: (f64, f64) = (13.0, 8.0);

/// Draws a line with hatching on its right, along stretches from a point on it.
pub(super) fn marks(place: Place, stretches: &[[f64; 2]], view: &View) -> Vec<Mark> {
    let [x, y] = direction(place.angle);
    // On paper, y points downwards.
    let along = [x, -y];
    let start = view.point(place.at);
    // Far enough to leave the window on both sides, wherever the line starts.
    let far = length(subtract(start, view.window[0])) + length(subtract(view.window[1], view.window[0]));
    let piece = |stretch: &[f64; 2]| {
        let [from, to] = stretch.map(|end| view.length(end).clamp(-far, far));
        // Hatching of the first stroke does not extend beyond the start.
        (vec![add(start, times(from, along)), add(start, times(to, along))], from, DEPTH)
    };
    hatched(stretches.iter().map(piece), view)
}

/// Draws the pieces of a curve, through their points, with hatching on the right.
pub(super) fn curve(pieces: &[Vec<Point>], view: &View) -> Vec<Mark> {
    let on_paper = |piece: &Vec<Point>| piece.iter().map(|point| view.point(*point)).collect();
    hatched(pieces.iter().map(|piece| (on_paper(piece), 0.0, 0.0)), view)
}

/// Draws lines through points with hatching on their right. Each has the length along it at its
/// first point, and the length from there to the first stroke.
fn hatched(lines: impl IntoIterator<Item = (Vec<Point>, f64, f64)>, view: &View) -> Vec<Mark> {
    let (mut edges, mut hatching) = (Vec::new(), Vec::new());
    for (points, mut from, room) in lines {
        let mut next = (from + room) / SPACING;
        for ends in points.windows(2) {
            let way = subtract(ends[1], ends[0]);
            let Some(along) = unit(way) else { continue };
            edges.extend(view.clipped([ends[0], ends[1]]).into_iter().flat_map(|ends| polyline(ends, false)));
            let to = from + length(way);
            let at = |s: f64| add(ends[0], times(s - from, along));
            hatching.extend(hatches(at, along, [next.ceil(), (to / SPACING).floor()], view));
            // A stroke at the common point of two pieces is drawn once.
            next = next.max((to / SPACING).floor() + 1.0);
            from = to;
        }
    }
    vec![path(hatching, stroke(HATCHING, THIN)), path(joined(edges), stroke(INK, MEDIUM))]
}

/// Leaves out movements to the current point.
fn joined(segments: Vec<Segment>) -> Vec<Segment> {
    let mut last = None;
    let mut is_new = |segment: &Segment| match *segment {
        Segment::Move(to) => last != Some(to),
        Segment::Line(to) => {
            last = Some(to);
            true
        }
        _ => true,
    };
    segments.into_iter().filter(|segment| is_new(segment)).collect()
}

/// Draws a short line with hatching on its right, centred at a point.
pub(super) fn wall(place: Place, view: &View) -> Vec<Mark> {
    let half = view.of_pixels(WALL);
    marks(place, &[[-half, half]], view)
}

/// Returns strokes with numbers in a range, to the right of a line and backwards.
fn hatches(at: impl Fn(f64) -> Point, along: Point, [first, last]: [f64; 2], view: &View) -> Vec<Segment> {
    // On paper, a quarter turn from x to y is clockwise.
    let stroke = times(DEPTH, subtract(turned(along), along));
    let count = (last - first + 1.0).max(0.0) as u32;
    let ends = |k: u32| {
        let start = at(SPACING * (first + f64::from(k)));
        let ends = view.clipped([start, add(start, stroke)])?;
        (length(subtract(ends[1], ends[0])) > LEAST).then_some(ends)
    };
    (0..count).filter_map(ends).flat_map(|ends| polyline(ends, false)).collect()
}

/// Draws a pin on the ground: a triangle with hatching below it.
pub(super) fn anchor(at: Point) -> Vec<Mark> {
    let (height, half) = TRIANGLE;
    let foot = |x: f64| add(at, [x, height]);
    let triangle = polyline([at, foot(-half), foot(half)], true);
    let mut hatching = polyline([foot(-1.5 * half), foot(1.5 * half)], false);
    for k in -2..=3 {
        let start = foot(0.5 * half * f64::from(k));
        hatching.extend(polyline([start, add(start, [-0.5 * half, 0.6 * DEPTH])], false));
    }
    let paper = Style { fill: Some(PAPER), ..stroke(INK, MEDIUM) };
    vec![
        path(hatching, stroke(HATCHING, THIN)),
        path(triangle, paper.clone()),
        path(circle(at, JOINT), paper),
    ]
}

#[cfg(test)]
mod tests {
    use super::marks;
    use crate::element::Reach;
    use crate::geometry::{Place, subtract};
    use crate::picture::{Mark, Segment};
    use crate::view::View;

    #[test]
    fn hatching_lies_on_the_right_and_within_the_window() {
        let reach = |at| Reach { at, offset: [0.0, 0.0], room: 0.0 };
        let window = [[0.0, 0.0], [200.0, 100.0]];
        let view = View::new(window, [0.0; 3], &[reach([-1.0, 0.0]), reach([1.0, 1.0])]).expect("fits");
        let place = Place { at: [0.0, 0.5], angle: 0.0 };
        let drawn = marks(place, &[[f64::NEG_INFINITY, f64::INFINITY]], &view);
        let [Mark::Path { segments: hatching, .. }, Mark::Path { segments: edge, .. }] = &drawn[..] else {
            panic!("two marks: {drawn:?}")
        };
        assert_eq!(edge[..], [Segment::Move([0.0, 50.0]), Segment::Line([200.0, 50.0])]);
        let strokes: Vec<_> = hatching.chunks(2).collect();
        assert!(strokes.len() > 20);
        for stroke in strokes {
            let [Segment::Move(from), Segment::Line(to)] = stroke else { panic!("{stroke:?}") };
            // Strokes that would start beyond the border begin below the line.
            assert!(from[1] > 50.0 - 1e-9 && to[1] > from[1], "below a line to the right");
            let [x, y] = subtract(*to, *from);
            assert!(x < 0.0 && (x + y).abs() < 1e-9, "backwards");
        }
    }
}
