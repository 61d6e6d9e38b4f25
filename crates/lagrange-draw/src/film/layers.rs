//! The composition of a film: marks and their changes.
//!
//! Most marks of a film either stay, such as the ground, or move rigidly, such as bodies; few are
//! deformed. A layer stores a mark once, together with its changes only.

use std::cmp::Ordering;

use crate::film::motion::{Pose, rigid_motion};
use crate::geometry::{length, mix, subtract};
use crate::picture::{Mark, Picture, Point, Segment};
use crate::svg;

/// A mark of a film and its change.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Layer {
    /// The mark as first shown. A moving mark is in its own coordinates; a growing one has its
    /// final length.
    pub(super) mark: Mark,
    pub(super) change: Change,
}

/// The change of a layer from picture to picture. Pictures without the layer have no entry.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Change {
    /// The mark only appears and vanishes.
    Shows(Vec<bool>),
    /// The mark rotates and moves.
    Moves(Vec<Option<Pose>>),
    /// The mark is drawn up to this length in pixels.
    Grows(Vec<Option<f64>>),
    /// The points of the mark move, but the kinds of its pieces stay the same.
    Bends(Vec<Option<Vec<Segment>>>),
}

impl Change {
    /// Returns for each picture whether the layer is shown.
    pub(super) fn shown(&self) -> Vec<bool> {
        match self {
            Change::Shows(shown) => shown.clone(),
            Change::Moves(poses) => poses.iter().map(Option::is_some).collect(),
            Change::Grows(lengths) => lengths.iter().map(Option::is_some).collect(),
            Change::Bends(shapes) => shapes.iter().map(Option::is_some).collect(),
        }
    }
}

/// Returns the layers of pictures with the same marks, from back to front.
pub(super) fn layers(pictures: &[Picture]) -> Vec<Layer> {
    let count = pictures.first().map_or(0, |picture| picture.marks.len());
    let of_mark = |index| {
        let marks: Vec<Option<&Mark>> = pictures
            .iter()
            .map(|picture| Some(&picture.marks[index]).filter(|mark| !svg::is_empty(mark)))
            .collect();
        growing(&marks).map_or_else(|| by_look(&marks), |layer| vec![layer])
    };
    (0..count).flat_map(of_mark).collect()
}

/// Maximum distance of the end of a growing line from its drawn position, in pixels. Points of
/// lines are thinned, so the last point of one picture may be missing in the next.
const TOLERANCE: f64 = 0.5;

/// Returns the layer of a line that only grows, such as the path of a point; none for other marks.
fn growing(marks: &[Option<&Mark>]) -> Option<Layer> {
    let length = |mark: &&Mark| lengths(segments(mark)).last().copied().unwrap_or(0.0);
    let size = |mark: &&Mark| (segments(mark).len(), length(mark));
    let by_size = |a: &&Mark, b: &&Mark| size(a).partial_cmp(&size(b)).unwrap_or(Ordering::Equal);
    let longest = marks.iter().flatten().copied().max_by(by_size)?;
    let Mark::Path { segments: all, style } = longest else { return None };
    let is_open = matches!(all.as_slice(), [Segment::Move(_), rest @ ..] if rest.iter().all(is_line));
    let is_plain = style.fill.is_none() && style.dashes.is_empty();
    let grows = marks.iter().flatten().any(|mark| segments(mark).len() < all.len());
    if !(is_open && is_plain && grows) {
        return None;
    }
    let lengths = lengths(all);
    let drawn = |mark: &&Mark| match mark {
        Mark::Path { segments, style: own } if own == style => drawn(segments, all, &lengths),
        _ => None,
    };
    let drawn: Option<Vec<_>> = marks.iter().map(|mark| mark.as_ref().map(drawn)).map(known).collect();
    Some(Layer { mark: longest.clone(), change: Change::Grows(drawn?) })
}

/// Returns a requested item that was found, or nothing if it was not requested; none if it was
/// requested and not found.
fn known<T>(asked: Option<Option<T>>) -> Option<Option<T>> {
    match asked {
        Some(found) => found.map(Some),
        None => Some(None),
    }
}

/// Returns the length up to which a line covers another from its start; none if it is not an
/// initial part.
fn drawn(line: &[Segment], all: &[Segment], lengths: &[f64]) -> Option<f64> {
    let (last, before) = line.split_last()?;
    if !all.starts_with(before) {
        return None;
    }
    let index = before.len();
    let (Segment::Move(wanted) | Segment::Line(wanted), Some(Segment::Move(end) | Segment::Line(end))) =
        (last, all.get(index))
    else {
        return None;
    };
    let Some(Segment::Move(start) | Segment::Line(start)) = before.last() else {
        return (wanted == end).then_some(0.0);
    };
    let full = lengths[index] - lengths[index - 1];
    let step = length(subtract(*wanted, *start)).min(full);
    let part = if full > 0.0 { step / full } else { 0.0 };
    (length(subtract(*wanted, mix(*start, *end, part))) <= TOLERANCE).then_some(lengths[index - 1] + step)
}

fn segments(mark: &Mark) -> &[Segment] {
    match mark {
        Mark::Path { segments, .. } => segments,
        Mark::Text { .. } => &[],
    }
}

fn is_line(segment: &Segment) -> bool {
    matches!(segment, Segment::Line(_))
}

/// Returns the lengths of an open line up to the end of each of its pieces.
pub(super) fn lengths(line: &[Segment]) -> Vec<f64> {
    let mut total = 0.0;
    let mut last: Option<Point> = None;
    let until = |segment: &Segment| {
        if let Segment::Move(end) | Segment::Line(end) = *segment {
            total += last.map_or(0.0, |start| length(subtract(end, start)));
            last = Some(end);
        }
        total
    };
    line.iter().map(until).collect()
}

/// Returns a layer for each look of a mark, which is its style and kinds of pieces, or its text.
fn by_look(marks: &[Option<&Mark>]) -> Vec<Layer> {
    let mut looks: Vec<(&Mark, Vec<Option<&Mark>>)> = Vec::new();
    for (index, mark) in marks.iter().enumerate() {
        let Some(mark) = mark else { continue };
        // The most recent look is the most likely one.
        let known = looks.iter().rposition(|(look, _)| are_alike(look, mark)).unwrap_or_else(|| {
            looks.push((mark, vec![None; marks.len()]));
            looks.len() - 1
        });
        looks[known].1[index] = Some(mark);
    }
    looks.into_iter().map(|(first, marks)| layer(first, &marks)).collect()
}

fn are_alike(one: &Mark, other: &Mark) -> bool {
    match (one, other) {
        (Mark::Path { segments: a, style: p }, Mark::Path { segments: b, style: q }) => {
            p == q && a.iter().map(kind).eq(b.iter().map(kind))
        }
        (Mark::Text { .. }, Mark::Text { .. }) => at_origin(one) == at_origin(other),
        _ => false,
    }
}

/// Returns the letter of a piece in SVG path data.
pub(super) fn kind(segment: &Segment) -> char {
    match segment {
        Segment::Move(_) => 'M',
        Segment::Line(_) => 'L',
        Segment::Curve(..) => 'C',
        Segment::Close => 'Z',
    }
}

/// Returns the letters of the pieces of a mark.
pub(super) fn kinds(mark: &Mark) -> String {
    segments(mark).iter().map(kind).collect()
}

fn at_origin(mark: &Mark) -> Mark {
    let mut mark = mark.clone();
    if let Mark::Text { at, .. } = &mut mark {
        *at = [0.0; 2];
    }
    mark
}

fn layer(first: &Mark, marks: &[Option<&Mark>]) -> Layer {
    if marks.iter().flatten().all(|mark| *mark == first) {
        let shown = marks.iter().map(Option::is_some).collect();
        return Layer { mark: first.clone(), change: Change::Shows(shown) };
    }
    let Mark::Path { style, .. } = first else {
        let place = |mark: &&Mark| match mark {
            Mark::Text { at, .. } => Some(Pose { at: *at, angle: 0.0 }),
            Mark::Path { .. } => None,
        };
        let poses = marks.iter().map(|mark| mark.as_ref().and_then(place)).collect();
        return Layer { mark: at_origin(first), change: Change::Moves(poses) };
    };
    let shapes: Vec<Option<&[Segment]>> = marks.iter().map(|mark| mark.map(segments)).collect();
    match rigid_motion(segments(first), &shapes) {
        Some((own, poses)) => {
            let mark = Mark::Path { segments: own, style: style.clone() };
            Layer { mark, change: Change::Moves(poses) }
        }
        None => {
            let shapes = shapes.into_iter().map(|shape| shape.map(<[Segment]>::to_vec)).collect();
            Layer { mark: first.clone(), change: Change::Bends(shapes) }
        }
    }
}
