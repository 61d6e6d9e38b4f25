//! The shapes of bodies as closed lines.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::geometry::{Place, arc, direction, ellipse, flattened, moved, polyline, times};
use crate::picture::{Point, Segment};
use lagrange_runtime::scalar::Scalar;
use lagrange_runtime::scene::{Outline, Part};

/// Inner end of the radius that shows a body's rotation, as a fraction of the radius. The middle
/// stays free for names.
const INNER: f64 = 0.4;
/// Inner end of this radius on rings, where it is short.
const NEAR_RIM: f64 = 0.8;

/// A part of a body in the body's own coordinates.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Piece {
    pub(super) form: Form,
    pub(super) place: Place,
    pub(super) is_hole: bool,
}

/// The shape of a body, in its own coordinates.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Form {
    /// A point without extent.
    Dot,
    /// A rod of this length, without thickness.
    Rod(f64),
    /// A circle of this radius, without thickness.
    Ring(f64),
    /// The area within closed lines, by the even–odd rule.
    Area(Vec<Vec<Segment>>),
    /// A round shape with part of a radius, between these distances from the middle, to show its
    /// rotation.
    Round(Vec<Vec<Segment>>, [f64; 2]),
}

impl Piece {
    pub(super) fn of<S: Scalar + Into<f64>>(part: &Part<'_, S>) -> Self {
        let place = Place { at: part.at.map(Into::into), angle: part.rotation.into() };
        Piece { form: form(part.shape), place, is_hole: part.is_hole }
    }

    /// Returns the lines in the body's own coordinates. Shapes without thickness are drawn with
    /// `thickness`.
    pub(super) fn rings(&self, thickness: f64) -> Vec<Vec<Segment>> {
        let half = 0.5 * thickness;
        let rings = match &self.form {
            Form::Dot => vec![ellipse([half, half])],
            Form::Rod(length) => vec![capsule(0.5 * length, half)],
            Form::Ring(radius) => [radius + half, radius - half].map(|r| ellipse([r, r])).into(),
            Form::Area(rings) | Form::Round(rings, _) => rings.clone(),
        };
        rings.iter().map(|ring| moved(ring, |p| self.place.of(p))).collect()
    }

    /// Returns points on the rim in the body's own coordinates.
    pub(super) fn rim(&self) -> impl Iterator<Item = Point> + '_ {
        const PIECES: usize = 8;
        self.rings(0.0).into_iter().flat_map(|ring| flattened(&ring, PIECES))
    }

    /// Returns the outer part of a radius, if it shows the rotation.
    pub(super) fn radius(&self) -> Option<[Point; 2]> {
        match self.form {
            Form::Round(_, ends) => Some(ends.map(|x| self.place.of([x, 0.0]))),
            Form::Ring(radius) => Some([NEAR_RIM * radius, radius].map(|x| self.place.of([x, 0.0]))),
            _ => None,
        }
    }
}

/// Returns a line of this half length along X and this half thickness.
fn capsule(half: f64, radius: f64) -> Vec<Segment> {
    let mut segments = vec![Segment::Move([half, -radius])];
    segments.extend(moved(&arc([radius, radius], -FRAC_PI_2, FRAC_PI_2), |[x, y]| [x + half, y]));
    segments.push(Segment::Line([-half, radius]));
    segments.extend(moved(&arc([radius, radius], FRAC_PI_2, 3.0 * FRAC_PI_2), |[x, y]| [x - half, y]));
    segments.push(Segment::Close);
    segments
}

fn form<S: Copy + Into<f64>>(outline: Outline<'_, S>) -> Form {
    let polygon = |corners: Vec<Point>| Form::Area(vec![polyline(corners, true)]);
    match outline {
        Outline::PointMass => Form::Dot,
        Outline::SlenderRod(length) => Form::Rod(length.into()),
        Outline::Disk(radius) => {
            let radius: f64 = radius.into();
            Form::Round(vec![circle(radius)], [INNER * radius, radius])
        }
        Outline::Annulus(inner, outer) => {
            Form::Round(vec![circle(outer), circle(inner)], [inner.into(), outer.into()])
        }
        Outline::Ring(radius) => Form::Ring(radius.into()),
        Outline::Ellipse(a, b) => Form::Area(vec![ellipse([a.into(), b.into()])]),
        Outline::SemicircularDisk(radius) => Form::Area(vec![sector(radius.into(), 0.0, PI)]),
        Outline::CircularSector(radius, angle) => {
            let half = 0.5 * angle.into();
            Form::Area(vec![sector(radius.into(), -half, half)])
        }
        Outline::Rectangle(a, b) => {
            let (x, y) = (0.5 * a.into(), 0.5 * b.into());
            polygon(vec![[-x, -y], [x, -y], [x, y], [-x, y]])
        }
        Outline::RightTriangle(a, b) => polygon(vec![[0.0, 0.0], [a.into(), 0.0], [0.0, b.into()]]),
        Outline::Triangle(a, b, c) => polygon(triangle(a.into(), b.into(), c.into())),
        Outline::RegularPolygon(n, radius) => polygon(regular_polygon(n.into(), radius.into())),
        Outline::Polygon(corners) => polygon(corners.iter().map(|corner| corner.map(Into::into)).collect()),
    }
}

fn circle<S: Into<f64>>(radius: S) -> Vec<Segment> {
    let radius = radius.into();
    ellipse([radius, radius])
}

fn sector(radius: f64, from: f64, to: f64) -> Vec<Segment> {
    let mut segments = vec![Segment::Move([0.0, 0.0]), Segment::Line(times(radius, direction(from)))];
    segments.extend(arc([radius, radius], from, to));
    segments.push(Segment::Close);
    segments
}

/// Returns a triangle, with its third corner by the law of cosines. It is NaN if no triangle has
/// these sides.
fn triangle(a: f64, b: f64, c: f64) -> Vec<Point> {
    let x = (a * a + c * c - b * b) / (2.0 * a);
    vec![[0.0, 0.0], [a, 0.0], [x, (c * c - x * x).sqrt()]]
}

/// Returns a regular polygon. It is NaN unless the number of corners is an integer of at least
/// three and at most `MAX_SIDES`.
fn regular_polygon(n: f64, radius: f64) -> Vec<Point> {
    const MAX_SIDES: f64 = 10_000.0;
    if n.fract() != 0.0 || !(3.0..=MAX_SIDES).contains(&n) {
        return vec![[f64::NAN; 2]];
    }
    let corner = |k: u32| times(radius, direction(2.0 * PI * f64::from(k) / n));
    (0..n as u32).map(corner).collect()
}
