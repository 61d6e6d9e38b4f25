//! Placement of labels that overlap neither each other nor lines.
//!
//! Each label stays on one of eight sides of its anchor throughout a film, so that it never jumps.
//! Labels are placed in turn, each at the least obstructive position. Labels of bodies come last,
//! and are omitted if there is no room.

use std::f64::consts::{PI, SQRT_2};

use crate::colour::{HATCHING, INK};
use crate::cut::contains;
use crate::geometry::{add, clipped, direction, flattened, length, mix, subtract};
use crate::picture::{Mark, Point, Segment};
use crate::tag::{FONT, Side, Tag};
use lagrange_plot::label::Anchor;
use lagrange_plot::lettering::CAPITALS;

/// A box: its corners with the smallest and the largest coordinates.
type Area = [Point; 2];

/// The labels of all elements at one moment, and the lines that they should avoid.
pub(super) struct Sheet {
    /// Tag of each element; none if it has no label.
    pub(super) tags: Vec<Option<Tag>>,
    pub(super) lines: Vec<[Point; 2]>,
    /// Areas covered by bodies, each with the index of its element.
    pub(super) areas: Vec<(usize, Vec<Point>)>,
}

/// Angles relative to the preferred direction, best first.
const ALONG: [f64; 8] = [0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0];
/// Angles from the horizontal if no direction is preferred, best first.
const AROUND: [f64; 8] = [0.25, 0.75, -0.25, -0.75, 0.0, 1.0, 0.5, -0.5];
/// Additional distances in pixels that are tried if no nearby place is free.
const FARTHER: [f64; 4] = [0.0, 7.0, 14.0, 21.0];
/// Number of distances; the last one is beyond the extent of the named element.
const RINGS: usize = FARTHER.len() + 1;
/// Index of the place on the anchor itself.
const ON_POINT: usize = AROUND.len() * RINGS;
/// Penalty for overlapping another label.
const ON_LABEL: f64 = 60.0;
/// Penalty for each pixel of shift into the picture.
const OUTSIDE: f64 = 0.1;
/// Penalty for a line across the label.
const CROSSED: f64 = 3.0;
/// Penalty for a less suitable side.
const WORSE: f64 = 0.2;
/// Average penalty above which an optional label is omitted.
const BEARABLE: f64 = 4.0;
/// Maximum number of moments of a film that are considered for placing labels.
const LOOKS: usize = 24;
/// Straight pieces per curve.
const PIECES: usize = 6;
/// Room around a label in pixels.
const ROOM: f64 = 1.5;

/// Returns the marks of labels at each moment; their number is the same at all moments.
pub(super) fn labels(film: &[Sheet], window: Area) -> Vec<Vec<Mark>> {
    let count = film.first().map_or(0, |sheet| sheet.tags.len());
    let every = film.len().div_ceil(LOOKS).max(1);
    let looked: Vec<&Sheet> = film.iter().step_by(every).collect();
    let mut placed: Vec<Vec<Area>> = looked.iter().map(|_| Vec::new()).collect();
    let may_hide = |index: usize| film.iter().any(|s| s.tags[index].as_ref().is_some_and(|tag| tag.may_hide));
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|index| may_hide(*index));
    let mut sides = vec![None; count];
    for index in order {
        // A free but more distant place is better than a forbidden one.
        let place = |side: usize| {
            let cost = cost(index, side, &looked, &placed, window);
            (may_hide(index) && cost > BEARABLE, cost + worse(index, side, &looked), side)
        };
        let places = (0..=ON_POINT).map(place);
        let best = places.min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let Some((false, _, side)) = best else { continue };
        sides[index] = Some(side);
        for (sheet, placed) in looked.iter().zip(&mut placed) {
            placed.extend(sheet.tags[index].as_ref().map(|tag| held(area(tag, side), window)));
        }
    }
    film.iter()
        .map(|sheet| sheet.tags.iter().zip(&sides).map(|(tag, side)| mark(tag, *side, window)).collect())
        .collect()
}

/// Returns the straight pieces of the dark lines among marks.
pub(super) fn lines(marks: &[Mark]) -> Vec<[Point; 2]> {
    let mut lines = Vec::new();
    for mark in marks {
        let Mark::Path { segments, style } = mark else { continue };
        // Labels may cover hatching.
        if style.stroke.is_none_or(|colour| colour == HATCHING) {
            continue;
        }
        let mut start = 0;
        for end in 1..=segments.len() {
            if end == segments.len() || matches!(segments[end], Segment::Move(_)) {
                let mut points = flattened(&segments[start..end], PIECES);
                if matches!(segments[end - 1], Segment::Close) {
                    points.extend(points.first().copied());
                }
                lines.extend(points.windows(2).map(|ends| [ends[0], ends[1]]));
                start = end;
            }
        }
    }
    lines
}

/// Returns the areas covered by the marks of a body.
pub(super) fn areas(marks: &[Mark]) -> Vec<Vec<Point>> {
    let area = |mark: &Mark| match mark {
        Mark::Path { segments, style } if style.fill.is_some() && style.stroke.is_none() => {
            Some(flattened(segments, PIECES))
        }
        _ => None,
    };
    marks.iter().filter_map(area).collect()
}

/// Returns the penalty of a side, averaged over the moments at which there is a label.
fn cost(index: usize, side: usize, looked: &[&Sheet], placed: &[Vec<Area>], window: Area) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for (sheet, placed) in looked.iter().zip(placed) {
        let Some(tag) = &sheet.tags[index] else { continue };
        let wished = area(tag, side);
        let area = held(wished, window);
        let on_labels = placed.iter().filter(|other| overlap(area, **other)).count();
        let crossings = sheet.lines.iter().filter(|ends| clipped(**ends, area).is_some()).count();
        sum += ON_LABEL * on_labels as f64 + CROSSED * (crossings as f64).sqrt();
        sum += OUTSIDE * length(subtract(area[0], wished[0]));
        sum += if tag.may_hide && is_elsewhere(index, middle(tag, side), sheet) { ON_LABEL } else { 0.0 };
        count += 1.0;
    }
    if count > 0.0 { sum / count } else { 0.0 }
}

/// Returns the additional penalty of a side over the best one, regardless of other marks.
fn worse(index: usize, side: usize, looked: &[&Sheet]) -> f64 {
    let is_within = looked.iter().any(|s| s.tags[index].as_ref().is_some_and(|tag| tag.side == Side::Within));
    match side {
        ON_POINT if is_within => 0.0,
        ON_POINT => f64::INFINITY,
        _ => WORSE * (side + 1) as f64,
    }
}

/// True if a place is on a different body.
fn is_elsewhere(index: usize, place: Point, sheet: &Sheet) -> bool {
    sheet.areas.iter().any(|(body, area)| *body != index && contains(area, place))
}

/// Returns the centre of a label at one of its places: on its anchor, if possible, or on one of
/// eight sides.
fn middle(tag: &Tag, place: usize) -> Point {
    let (side, ring) = (place % AROUND.len(), place / AROUND.len());
    let angle = match tag.side {
        Side::Within if place == ON_POINT => return tag.at,
        Side::Within | Side::Around => -AROUND[side] * PI,
        Side::Along([x, y]) => y.atan2(x) + ALONG[side] * PI,
    };
    let gap = match FARTHER.get(ring) {
        Some(farther) => tag.gap + farther,
        None => tag.gap.max(tag.reach) + tag.gap,
    };
    let towards = direction(angle);
    // In the direction of a corner of the text, all of it is beyond its anchor.
    let shift =
        |axis: usize| gap * towards[axis] + tag.half[axis] * (SQRT_2 * towards[axis]).clamp(-1.0, 1.0);
    add(tag.at, [shift(0), shift(1)])
}

fn area(tag: &Tag, side: usize) -> Area {
    let [x, y] = middle(tag, side);
    let [width, height] = tag.half.map(|half| half + ROOM);
    [[x - width, y - height], [x + width, y + height]]
}

/// Shifts an area into the window if it extends beyond it.
fn held([low, high]: Area, window: Area) -> Area {
    let shift = |k: usize| (window[0][k] - low[k]).max(0.0) + (window[1][k] - high[k]).min(0.0);
    let by = [shift(0), shift(1)];
    [add(low, by), add(high, by)]
}

fn overlap(a: Area, b: Area) -> bool {
    (0..2).all(|axis| a[0][axis] < b[1][axis] && b[0][axis] < a[1][axis])
}

/// Returns the mark of a label; without a label or a place for it, the mark is empty.
fn mark(tag: &Option<Tag>, side: Option<usize>, window: Area) -> Mark {
    let size = tag.as_ref().map_or(FONT, |tag| tag.size);
    let (at, text, colour) = match (tag, side) {
        (Some(tag), Some(side)) => {
            let [low, high] = held(area(tag, side), window);
            (mix(low, high, 0.5), tag.text.clone(), tag.colour.text())
        }
        (tag, _) => {
            let known = tag.as_ref().map(|tag| (tag.at, tag.colour.text()));
            let (at, colour) = known.unwrap_or(([0.0, 0.0], INK));
            (at, Default::default(), colour)
        }
    };
    // The baseline is half a capital below the middle.
    let at = add(at, [0.0, 0.5 * CAPITALS * size]);
    Mark::Text { at, text, size, anchor: Anchor::Middle, colour }
}

#[cfg(test)]
mod tests {

    use super::{Sheet, area, labels, overlap};
    use crate::colour::INK;
    use crate::picture::Mark;
    use crate::tag::{FONT, Side, Tag};

    const WINDOW: [[f64; 2]; 2] = [[0.0, 0.0], [300.0, 200.0]];

    fn tag(at: [f64; 2], may_hide: bool) -> Option<Tag> {
        let side = Side::Around;
        Some(Tag {
            text: "P".into(),
            at,
            side,
            gap: 4.0,
            colour: INK,
            may_hide,
            reach: 0.0,
            size: FONT,
            half: [8.0, 7.0],
        })
    }

    fn middles(marks: &[Mark]) -> Vec<[f64; 2]> {
        let shown = |mark: &Mark| match mark {
            Mark::Text { at, text, .. } if !text.is_empty() => Some(*at),
            _ => None,
        };
        marks.iter().filter_map(shown).collect()
    }

    #[test]
    fn labels_of_one_place_take_different_sides() {
        let tags: Vec<_> = (0..8).map(|_| tag([100.0, 100.0], false)).collect();
        let film = [Sheet { tags, lines: Vec::new(), areas: Vec::new() }];
        let found = middles(&labels(&film, WINDOW)[0]);
        assert_eq!(found.len(), 8);
        let boxes = found.iter().map(|[x, y]| [[x - 8.0, y - 7.0], [x + 8.0, y + 7.0]]);
        let boxes: Vec<_> = boxes.collect();
        let clear = boxes.iter().skip(1).filter(|other| !overlap(boxes[0], **other)).count();
        assert!(clear >= 3, "at least the four corners are free: {found:?}");
    }

    #[test]
    fn a_label_keeps_off_a_line_at_every_moment() {
        let at = [100.0, 100.0];
        let line = |y: f64| vec![[[0.0, y], [300.0, y]]];
        // A line crosses above the anchor at first, later below. Only a label to its side is never
        // crossed.
        let film = [
            Sheet { tags: vec![tag(at, false)], lines: line(86.0), areas: Vec::new() },
            Sheet { tags: vec![tag(at, false)], lines: line(114.0), areas: Vec::new() },
        ];
        for marks in labels(&film, WINDOW) {
            let [[x, y]] = middles(&marks)[..] else { panic!("{marks:?}") };
            assert!((x - 100.0).abs() > 8.0 && (y - 105.0).abs() < 1.0, "{x} {y}");
        }
    }

    #[test]
    fn names_stay_away_where_there_is_no_room() {
        let full: Vec<_> =
            (0..40).map(|k| [[0.0, 5.0 * f64::from(k)], [300.0, 5.0 * f64::from(k)]]).collect();
        let film = |may_hide| {
            [Sheet { tags: vec![tag([100.0, 100.0], may_hide)], lines: crossed(&full), areas: Vec::new() }]
        };
        assert_eq!(middles(&labels(&film(true), WINDOW)[0]).len(), 0);
        assert_eq!(middles(&labels(&film(false), WINDOW)[0]).len(), 1);
        let free = tag([100.0, 100.0], true).map(|tag| area(&tag, 0)).expect("is there");
        assert!(free[0][0] > 100.0, "the best side is the right");
    }

    #[test]
    fn names_do_not_lie_on_other_bodies() {
        let right = vec![[100.0, 0.0], [300.0, 0.0], [300.0, 200.0], [100.0, 200.0]];
        let sheet = |body| {
            [Sheet {
                tags: vec![tag([100.0, 100.0], true)],
                lines: Vec::new(),
                areas: vec![(body, right.clone())],
            }]
        };
        let x = |body| middles(&labels(&sheet(body), WINDOW)[0])[0][0];
        assert!(x(0) > 100.0 && x(1) < 100.0);
    }

    /// Returns the lines and their transposes.
    fn crossed(lines: &[[[f64; 2]; 2]]) -> Vec<[[f64; 2]; 2]> {
        lines.iter().flat_map(|[a, b]| [[*a, *b], [[a[1], a[0]], [b[1], b[0]]]]).collect()
    }
}
