//! Marks of elements on paper.

pub(super) mod arrow;
mod body;
mod connector;
mod ground;
mod line;

use crate::colour::{INK, PALE, PAPER, light};
use crate::element::{Element, Measure, Shape, cone_rim};
use crate::geometry::{Place, add, ellipse, moved, polyline};
use crate::picture::{Colour, Mark, Point, Segment, Style};
use crate::view::View;

/// Width of thin lines in pixels.
const THIN: f64 = 1.0;
/// Width of medium lines in pixels.
const MEDIUM: f64 = 1.4;
/// Lengths of dashes and gaps.
const DASHES: &[f64] = &[5.0, 4.0];
/// Lengths of dashes and gaps of friction cones.
const CONE: &[f64] = &[3.0, 3.0];
/// Fraction of the background colour in the colour of friction cones.
const CONE_PALE: f64 = 0.35;
/// Radius of joints.
const JOINT: f64 = 4.0;
/// Radius of points.
const DOT: f64 = 2.6;

/// Returns the marks of an element; elements of the same kind have the same number of marks.
pub(super) fn marks(element: &Element, view: &View) -> Vec<Mark> {
    let colour = element.colour;
    match &element.shape {
        Shape::Body { place, center, pieces } => body::marks(place, *center, pieces, colour, view),
        Shape::Ground { place, stretches, .. } => ground::marks(*place, stretches, view),
        Shape::Curve { pieces, .. } => ground::curve(pieces, view),
        Shape::Cone { at, normal, coefficient } => {
            let rim = cone_rim(view.vector(*normal, Measure::Force), *coefficient);
            let [left, right] = rim.map(|end| add(view.point(*at), end));
            let style = Style { dashes: CONE, ..stroke(colour.mixed(PAPER, CONE_PALE), THIN) };
            vec![path(polyline([left, view.point(*at), right], false), style)]
        }
        Shape::Connector { kind, ends, lane } => {
            vec![line(connector::segments(*kind, ends.map(|p| view.point(p)), *lane), INK)]
        }
        Shape::Pin { at } => vec![joint(view.point(*at))],
        Shape::Anchor { at } => ground::anchor(view.point(*at)),
        Shape::Wall { at, angle } => ground::wall(Place { at: *at, angle: *angle }, view),
        Shape::Slider { at } => vec![dot(view.point(*at), INK)],
        Shape::Arrow { from, vector, measure, is_push } => {
            let vector = view.vector(*vector, *measure);
            vec![filled(arrow::straight(arrow::start(view.point(*from), vector, *is_push), vector), colour)]
        }
        Shape::Turn { at, moment, ring } => round(arrow::turn(view.point(*at), *moment, *ring), colour),
        Shape::Dot { at } => vec![dot(view.point(*at), colour)],
        Shape::Ray { from, to } => line::ray(view.point(*from), view.point(*to), colour, view),
        Shape::Segment { ends, is_dashed } => {
            let style = stroke(colour, MEDIUM);
            let dashes = if *is_dashed { DASHES } else { &[] };
            vec![path(polyline(ends.map(|p| view.point(p)), false), Style { dashes, ..style })]
        }
        Shape::Through { points } => vec![line::through(points.map(|p| view.point(p)), colour, view)],
        Shape::Circle { center, radius, is_dashed } => {
            let dashes = if *is_dashed { DASHES } else { &[] };
            let segments = circle(view.point(*center), view.length(*radius));
            vec![path(segments, Style { dashes, ..stroke(colour, MEDIUM) })]
        }
        Shape::Angle { at, from, to } => round(arrow::angle(view.point(*at), *from, *to), colour),
        Shape::Dimension { ends } => {
            let [thin, segments] = arrow::dimension(ends.map(|p| view.point(p)));
            vec![
                path(thin, stroke(PALE, THIN)),
                path(segments, Style { fill: Some(colour), ..stroke(colour, THIN) }),
            ]
        }
        Shape::Polyline { points } => {
            vec![path(line::thinned(points.iter().map(|p| view.point(*p))), stroke(colour, MEDIUM))]
        }
        Shape::Area { points } => {
            let segments = polyline(points.iter().map(|p| view.point(*p)), true);
            vec![path(segments, Style { fill: Some(light(colour)), ..stroke(colour, THIN) })]
        }
        Shape::Words { .. } => Vec::new(),
    }
}

fn path(segments: Vec<Segment>, style: Style) -> Mark {
    Mark::Path { segments, style }
}

fn stroke(colour: Colour, width: f64) -> Style {
    Style { stroke: Some(colour), width, dashes: &[], fill: None }
}

fn line(segments: Vec<Segment>, colour: Colour) -> Mark {
    path(segments, stroke(colour, MEDIUM))
}

/// Returns a line whose closed parts, such as arrowheads, are filled.
fn filled(segments: Vec<Segment>, colour: Colour) -> Mark {
    path(segments, Style { fill: Some(colour), ..stroke(colour, MEDIUM) })
}

/// Returns an unfilled arc and its filled arrowhead.
fn round([arc, head]: [Vec<Segment>; 2], colour: Colour) -> Vec<Mark> {
    vec![line(arc, colour), filled(head, colour)]
}

fn dot(at: Point, colour: Colour) -> Mark {
    path(circle(at, DOT), Style { stroke: None, width: 0.0, dashes: &[], fill: Some(colour) })
}

fn joint(at: Point) -> Mark {
    path(circle(at, JOINT), Style { fill: Some(PAPER), ..stroke(INK, MEDIUM) })
}

fn circle(at: Point, radius: f64) -> Vec<Segment> {
    moved(&ellipse([radius, radius]), |[x, y]| [at[0] + x, at[1] - y])
}
