//! The places of labels relative to their elements.

use crate::colour::{INK, PALE};
use crate::element::{Element, LANE, RING, Shape, WIDER};
use crate::geometry::{add, direction, length, mix, subtract, times, turned, unit};
use crate::marks::arrow::{self, ANGLE, BESIDE, NAMED};
use crate::outline::Piece;
use crate::picture::{Colour, Point};
use crate::view::View;
use lagrange_plot::label::{Label, SUBSCRIPT};
use lagrange_plot::lettering::LEEWAY;
use lagrange_runtime::scene::Connector;

/// A label and its anchor.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Tag {
    pub(super) text: String,
    pub(super) at: Point,
    pub(super) side: Side,
    /// Distance from the anchor to the text.
    pub(super) gap: f64,
    pub(super) colour: Colour,
    /// True if the label may be omitted for lack of room.
    pub(super) may_hide: bool,
    /// Extent of the named element from the anchor.
    pub(super) reach: f64,
    /// Font size.
    pub(super) size: f64,
    /// Half width and half height of the text.
    pub(super) half: Point,
}

/// The preferred position of a label relative to its anchor.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Side {
    /// On any side.
    Around,
    /// On the anchor if there is room, else on any side.
    Within,
    /// In this direction if there is room.
    Along(Point),
}

/// Default font size of labels.
pub(super) const FONT: f64 = 15.0;
/// Maximum width of a label relative to the picture, unless this requires letters below the minimum
/// size.
const WIDEST: f64 = 0.5;
/// Minimum font size at which this limit applies.
const SMALLEST: f64 = 8.0;
/// Default distance from the anchor to the text.
const GAP: f64 = 4.0;
/// Distance from the middle of a body or connector.
const WIDE_GAP: f64 = 8.0;

/// Returns the label of an element, if it has one.
pub(super) fn tag(element: &Element, view: &View) -> Option<Tag> {
    if element.label.is_empty() {
        return None;
    }
    let (at, side, gap) = anchor(&element.shape, view)?;
    let is_thing = matches!(
        element.shape,
        Shape::Body { .. } | Shape::Connector { kind: Connector::Spring | Connector::Damper, .. }
    );
    let colour = match element.shape {
        Shape::Body { .. } => INK,
        _ if element.colour == PALE => INK,
        _ => element.colour,
    };
    let (size, half) = extent(&element.label, view.window[1][0] - view.window[0][0]);
    let reach = reach(&element.shape, view);
    Some(Tag { text: element.label.clone(), at, side, gap, colour, may_hide: is_thing, reach, size, half })
}

/// Returns the font size of a label in a picture of a width, and half the label's width and height.
pub(super) fn extent(label: &str, room: f64) -> (f64, Point) {
    // Subscripts extend below the baseline.
    let has_subscript = Label::parse(label).has_subscript();
    let (size, width) = fitting(label, room);
    let height = if has_subscript { size * (1.0 + SUBSCRIPT.1) } else { size };
    (size, [0.5 * width, 0.5 * height])
}

/// Returns the distance in pixels from the centre of a body to the farthest point of its rim.
fn reach(shape: &Shape, view: &View) -> f64 {
    let Shape::Body { place, center, pieces } = shape else { return 0.0 };
    let rim = pieces.iter().flat_map(Piece::rim).map(|p| subtract(place.of(p), *center));
    view.length(rim.map(length).fold(0.0, f64::max))
}

/// Returns the font size of a label and its width. The size is reduced if the label would exceed
/// its part of the room.
fn fitting(label: &str, room: f64) -> (f64, f64) {
    let width = Label::parse(label).width(1.0);
    let size = FONT.min((WIDEST * room / width).max(SMALLEST)).min(room / (LEEWAY * width));
    (size, size * width)
}

fn anchor(shape: &Shape, view: &View) -> Option<(Point, Side, f64)> {
    let middle = |ends: &[Point; 2]| {
        let ends = ends.map(|p| view.point(p));
        let normal = unit(turned(subtract(ends[1], ends[0])));
        // Labels are above rather than below.
        let normal = normal.map(|n| if n[1] > 0.0 { times(-1.0, n) } else { n });
        (mix(ends[0], ends[1], 0.5), normal.map_or(Side::Around, Side::Along))
    };
    let around = |at: &Point| Some((view.point(*at), Side::Around, GAP));
    match shape {
        Shape::Body { center, .. } => Some((view.point(*center), Side::Within, WIDE_GAP)),
        Shape::Connector { kind: Connector::Spring | Connector::Damper, ends: [from, to], lane } => {
            let (at, side) = middle(&[*from, *to]);
            let left = unit(subtract(view.point(*to), view.point(*from)))
                .map(|along| times(-LANE * lane, turned(along)));
            let aside = left.filter(|_| *lane != 0.0);
            let outwards = aside.and_then(unit).map(Side::Along);
            Some((add(at, aside.unwrap_or_default()), outwards.unwrap_or(side), WIDE_GAP))
        }
        Shape::Connector { ends, lane, .. } => {
            Some((view.point(ends[0]), Side::Around, ANGLE * (1.0 + WIDER * lane)))
        }
        // Without an arrow there is no label.
        Shape::Turn { moment: 0.0, .. } => None,
        Shape::Turn { at, ring, .. } => Some((view.point(*at), Side::Around, ANGLE + RING * *ring as f64)),
        Shape::Arrow { from, vector, measure, is_push } => {
            let vector = view.vector(*vector, *measure);
            (length(vector) >= NAMED).then_some(())?;
            let start = arrow::start(view.point(*from), vector, *is_push);
            let (end, outwards) =
                if *is_push { (start, times(-1.0, vector)) } else { (add(start, vector), vector) };
            Some((end, Side::Along(unit(outwards)?), GAP))
        }
        Shape::Ray { to, .. } => view.holds(view.point(*to)).then(|| around(to))?,
        Shape::Segment { ends, .. } => {
            let (at, side) = middle(ends);
            Some((at, side, GAP))
        }
        Shape::Dimension { ends } => {
            let ends = ends.map(|p| view.point(p));
            let left = times(-1.0, turned(unit(subtract(ends[1], ends[0]))?));
            Some((add(mix(ends[0], ends[1], 0.5), times(BESIDE, left)), Side::Along(left), GAP))
        }
        Shape::Angle { at, from, to } => {
            let [x, y] = direction(0.5 * (from + to));
            let outwards = [x, -y];
            Some((add(view.point(*at), times(ANGLE, outwards)), Side::Along(outwards), GAP))
        }
        Shape::Words { at } => Some((view.point(*at), Side::Within, GAP)),
        Shape::Pin { at } | Shape::Anchor { at } | Shape::Slider { at } | Shape::Dot { at } => around(at),
        Shape::Circle { center, radius, .. } => around(&add(*center, times(*radius, direction(0.8)))),
        Shape::Polyline { points } | Shape::Area { points } => points.last().and_then(around),
        Shape::Through { points } => around(&points[0]),
        Shape::Ground { .. } | Shape::Curve { .. } | Shape::Cone { .. } | Shape::Wall { .. } => None,
    }
}
