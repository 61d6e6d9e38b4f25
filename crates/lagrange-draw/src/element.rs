//! The elements of a picture, in world coordinates.

use crate::geometry::{Place, add, subtract, times, turned};
use crate::outline::Piece;
use crate::picture::{Colour, Point};
use lagrange_runtime::scene::Connector;

/// A shape in a picture, with its name, label and layer.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Element {
    /// Name in messages; identifies the element across the pictures of a film.
    pub(super) name: String,
    /// Label; empty if there is none.
    pub(super) label: String,
    pub(super) colour: Colour,
    pub(super) layer: Layer,
    pub(super) shape: Shape,
}

/// The layer of an element, from back to front.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) enum Layer {
    Ground,
    Body,
    Connector,
    Joint,
    Trace,
    Arrow,
    Sketch,
}

/// The shape of an element.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Shape {
    /// A body with its centre of mass; `place` maps from its own coordinates.
    Body { place: Place, center: Point, pieces: Vec<Piece> },
    /// A line with hatching on its right, drawn along `stretches` from a point on it, whose ends
    /// may be infinite. The points `seen` must be visible.
    Ground { place: Place, stretches: Vec<[f64; 2]>, seen: Vec<Point> },
    /// A curve with hatching on its right, as lines through the points of each piece. The points
    /// `seen` must be visible.
    Curve { pieces: Vec<Vec<Point>>, seen: Vec<Point> },
    /// A friction cone: its apex, the force along its axis, and the coefficient of friction.
    Cone { at: Point, normal: Point, coefficient: f64 },
    /// A spring or damper, `lane` lanes to the left of the line between its ends; a torsional one
    /// surrounds `lane` others.
    Connector { kind: Connector, ends: [Point; 2], lane: f64 },
    /// A pin between two moving bodies.
    Pin { at: Point },
    /// A pin between a body and the ground.
    Anchor { at: Point },
    /// A short line with hatching on its right, which holds a connector on its left.
    Wall { at: Point, angle: f64 },
    /// A point on a line.
    Slider { at: Point },
    /// An arrow from a point, or to it if it pushes.
    Arrow { from: Point, vector: Point, measure: Measure, is_push: bool },
    /// An arrow around a point, counterclockwise if positive, outside `ring` others.
    Turn { at: Point, moment: f64, ring: usize },
    /// A point.
    Dot { at: Point },
    /// A dashed line to a point, possibly far away, which is marked if it is in the picture.
    Ray { from: Point, to: Point },
    /// A straight line between two points.
    Segment { ends: [Point; 2], is_dashed: bool },
    /// A dashed straight line that extends to the borders.
    Through { points: [Point; 2] },
    /// A circle.
    Circle { center: Point, radius: f64, is_dashed: bool },
    /// An arc with an arrowhead from one angle to another.
    Angle { at: Point, from: f64, to: f64 },
    /// A line with arrowheads at both ends, on the left of two points.
    Dimension { ends: [Point; 2] },
    /// A line through points.
    Polyline { points: Vec<Point> },
    /// An area with these corners.
    Area { points: Vec<Point> },
    /// A text without a mark.
    Words { at: Point },
}

/// The meaning of an arrow's length.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Measure {
    /// A length in the world.
    World,
    /// A length in pixels.
    Pixels,
    Velocity,
    Acceleration,
    Force,
}

/// A place that must be visible.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Reach {
    /// Point in the world.
    pub(super) at: Point,
    /// Offset from the point in pixels, y upwards.
    pub(super) offset: Point,
    /// Margin on all sides in pixels.
    pub(super) room: f64,
}

/// Room around joints, connectors and bodies.
const ROOM: f64 = 9.0;
/// Room for hatching.
const GROUND: f64 = 16.0;
/// Room for arcs of moments and angles.
const ROUND: f64 = 30.0;
/// Distance between neighbouring connectors with the same ends.
pub(super) const LANE: f64 = 20.0;
/// Relative increase in radius from one connector about a point to the next.
pub(super) const WIDER: f64 = 0.6;
/// Distance between neighbouring arcs about a point.
pub(super) const RING: f64 = 8.0;

impl Element {
    /// Returns all numbers of the element, which must be finite.
    pub(super) fn numbers(&self) -> Vec<f64> {
        let mut numbers: Vec<f64> =
            self.reaches(&|_| 1.0).iter().flat_map(|r| [r.at, r.offset].concat()).collect();
        match &self.shape {
            Shape::Ground { place, .. } => numbers.extend([place.at[0], place.at[1], place.angle]),
            Shape::Curve { pieces, .. } => numbers.extend(pieces.iter().flatten().flatten()),
            Shape::Turn { moment, .. } => numbers.push(*moment),
            Shape::Ray { to, .. } => numbers.extend(to),
            Shape::Through { points } => numbers.extend(points.as_flattened()),
            Shape::Angle { from, to, .. } => numbers.extend([from, to]),
            Shape::Body { pieces, .. } => numbers.extend(pieces.iter().flat_map(Piece::rim).flatten()),
            _ => {}
        }
        numbers
    }

    /// Returns the places that must be in the picture, where `pixels` gives the pixels per unit of
    /// a measure.
    pub(super) fn reaches(&self, pixels: &dyn Fn(Measure) -> f64) -> Vec<Reach> {
        let point = |at: Point, room: f64| Reach { at, offset: [0.0, 0.0], room };
        let all = |points: &[Point]| points.iter().map(|at| point(*at, ROOM)).collect();
        match &self.shape {
            Shape::Body { place, center, pieces } => body(place, *center, pieces),
            Shape::Ground { seen, .. } | Shape::Curve { seen, .. } => {
                seen.iter().map(|at| point(*at, GROUND)).collect()
            }
            Shape::Through { .. } => Vec::new(),
            Shape::Connector { kind: Connector::Spring | Connector::Damper, ends, lane } => {
                ends.map(|at| point(at, ROOM + LANE * lane.abs())).into()
            }
            Shape::Connector { ends, lane, .. } => vec![point(ends[0], ROUND * (1.0 + WIDER * lane))],
            Shape::Pin { at } | Shape::Dot { at } | Shape::Words { at } => vec![point(*at, ROOM)],
            Shape::Anchor { at } | Shape::Wall { at, .. } | Shape::Slider { at } => vec![point(*at, GROUND)],
            Shape::Angle { at, .. } => vec![point(*at, ROUND)],
            Shape::Turn { at, ring, .. } => vec![point(*at, ROUND + RING * *ring as f64)],
            Shape::Arrow { from, vector, measure: Measure::World, .. } => all(&[*from, add(*from, *vector)]),
            Shape::Arrow { from, vector, measure, is_push } => {
                let sign = if *is_push { -1.0 } else { 1.0 };
                let offset = vector.map(|part| sign * pixels(*measure) * part);
                vec![point(*from, ROOM), Reach { at: *from, offset, room: GROUND }]
            }
            Shape::Cone { at, normal, coefficient } => {
                let rim = cone_rim(times(pixels(Measure::Force), *normal), *coefficient);
                rim.map(|offset| Reach { at: *at, offset, room: ROOM }).into()
            }
            Shape::Ray { from, .. } => vec![point(*from, ROOM)],
            Shape::Segment { ends, .. } => all(ends),
            Shape::Dimension { ends } => ends.iter().map(|at| point(*at, ROUND)).collect(),
            Shape::Circle { center: [x, y], radius: r, .. } => all(&[[x - r, y - r], [x + r, y + r]]),
            Shape::Polyline { points } | Shape::Area { points } => all(points),
        }
    }
}

impl Shape {
    /// Names the kind of element in errors about non-finite numbers, and identifies the element
    /// within its kind.
    pub(super) fn what(&self) -> &'static str {
        match self {
            Shape::Body { .. } => "position or shape",
            Shape::Ground { .. } => "line",
            Shape::Curve { .. } => "surface",
            Shape::Cone { .. } => "friction cone",
            Shape::Connector { kind: Connector::Spring | Connector::Damper, .. } => "end",
            Shape::Connector { .. } => "place",
            Shape::Wall { .. } => "anchor",
            Shape::Pin { .. } | Shape::Anchor { .. } | Shape::Slider { .. } => "position of the joint",
            Shape::Arrow { measure: Measure::Velocity, .. } => "velocity",
            Shape::Arrow { measure: Measure::Acceleration, .. } => "acceleration",
            Shape::Arrow { measure: Measure::Force, .. } => "force",
            Shape::Arrow { .. } => "arrow",
            Shape::Turn { .. } => "moment",
            Shape::Dot { .. } => "point",
            Shape::Ray { .. } => "instantaneous centre",
            Shape::Segment { .. } => "segment",
            Shape::Through { .. } => "straight line",
            Shape::Circle { .. } => "circle",
            Shape::Angle { .. } => "angle",
            Shape::Dimension { .. } => "dimension",
            Shape::Polyline { .. } => "path",
            Shape::Area { .. } => "area",
            Shape::Words { .. } => "place of the text",
        }
    }
}

/// Returns the ends of a friction cone relative to its apex.
pub(super) fn cone_rim(normal: Point, coefficient: f64) -> [Point; 2] {
    let aside = times(coefficient, turned(normal));
    [add(normal, aside), subtract(normal, aside)]
}

fn body(place: &Place, center: Point, pieces: &[Piece]) -> Vec<Reach> {
    let rim = pieces.iter().filter(|piece| !piece.is_hole).flat_map(Piece::rim).map(|p| place.of(p));
    rim.chain([center]).map(|at| Reach { at, offset: [0.0, 0.0], room: ROOM }).collect()
}
