//! A motion in space as pictures: the visible parts of meshes, from back to front, with labels.

use super::camera::Camera;
use super::mesh::{Edges, normal};
use super::recording::{Kind, MovingMesh, Recording};
use super::sort::{Fragment, FragmentShape, back_to_front, is_convex};
use super::vector::Vector;
use crate::colour::{INK, PALE, SHADOW};
use crate::element::Reach;
use crate::error::DrawError;
use crate::geometry::{self, dot, length, polyline, subtract};
use crate::labels::{self, Sheet};
use crate::look::Look;
use crate::marks::arrow::NAMED;
use crate::paper::Paper;
use crate::picture::{Colour, Mark, Picture, Point, Segment, Style};
use crate::tag::{Side, Tag, extent};
use crate::view::{MARGIN, View};
use lagrange_plot::notation::formula;

/// Pictures of a motion, all with the same camera and scale.
#[derive(Clone, PartialEq, Debug)]
pub struct Projector {
    pub(super) recording: Recording,
    pub(super) look: Look,
    camera: Camera,
    view: View,
    paper: Paper,
    /// Edges of each thing, and true for a convex body.
    meshes: Vec<(Edges, bool)>,
    /// Length below which lengths count as zero.
    least: f64,
}

/// Width of edges.
pub(super) const EDGE: f64 = 0.8;
/// Width of separate lines.
pub(super) const LINE: f64 = 1.5;
/// Width of the line around a face that closes the gap to the next face.
const GAP: f64 = 0.6;
/// Fraction of ink in the edges of coloured faces.
pub(super) const DARK: f64 = 0.65;
/// Room for labels at the borders.
const ROOM: f64 = 14.0;
/// Distance from a point to its label.
const NEAR: f64 = 5.0;
const NOTHING: f64 = 1e-9;

impl Projector {
    pub(super) fn new(recording: Recording, look: Look) -> Result<Projector, DrawError> {
        let angles = [look.direction.azimuth, look.direction.elevation];
        if !angles.iter().all(|angle| angle.is_finite()) {
            return Err(DrawError::View(angles));
        }
        let (middle, radius) = recording.ball();
        let camera = Camera::new(look.direction, middle, radius);
        let paper = Paper::new(&look, &recording.note);
        let seen = |place| Reach { at: camera.seen(place).0, offset: [0.0, 0.0], room: 0.0 };
        let reaches: Vec<Reach> = recording.places().map(seen).collect();
        let view = View::new(paper.window(MARGIN + ROOM)?, [0.0; 3], &reaches)?;
        let least = NOTHING * radius;
        let meshes =
            recording.things.iter().map(|thing| (Edges::of(&thing.mesh), is_convex_body(thing, least)));
        let meshes = meshes.collect();
        Ok(Projector { recording, look, camera, view, paper, meshes, least })
    }

    /// Returns the pictures of some moments; labels keep their sides.
    pub(super) fn project(&self, moments: impl IntoIterator<Item = usize>) -> Vec<Picture> {
        self.paper.finished(moments.into_iter().map(|moment| self.scene(moment)).collect())
    }

    /// Returns the marks and labels of a moment.
    fn scene(&self, moment: usize) -> (Vec<Mark>, Sheet) {
        let things = &self.recording.things;
        let mut pieces: Vec<Fragment> = Vec::new();
        for index in 0..things.len() {
            pieces.extend(self.pieces(index, moment));
        }
        for (index, trace) in self.recording.traces.iter().enumerate() {
            let points: Vec<Vector> = trace.until(moment).collect();
            pieces.extend(lines(&points, things.len() + index, self.least));
        }
        let areas = pieces.iter().filter_map(|piece| self.area(piece)).collect();
        let mut convex: Vec<bool> = self.meshes.iter().map(|(_, is_convex)| *is_convex).collect();
        convex.resize(things.len() + self.recording.traces.len(), false);
        // Bodies do not hide the arrows that start inside them.
        let is_arrow =
            |piece: &Fragment| things.get(piece.thing).is_some_and(|thing| thing.kind == Kind::Arrow);
        let (arrows, scene): (Vec<Fragment>, Vec<Fragment>) = pieces.into_iter().partition(is_arrow);
        let mut marks = Vec::new();
        for pieces in [scene, arrows] {
            let sorted = back_to_front(pieces, &self.camera, &convex, self.least);
            sorted.iter().for_each(|piece| self.paint(piece, &mut marks));
        }
        let lines = labels::lines(&marks);
        let traces = self.recording.traces.iter().map(|trace| {
            let at = *trace.until(moment).last().as_ref()?;
            self.tag(&formula(&trace.label), at, Side::Around, trace.colour, false)
        });
        let tags = things.iter().map(|thing| self.label(thing, moment)).chain(traces).collect();
        (marks, Sheet { tags, lines, areas })
    }

    /// Returns the area covered by a face of a body.
    fn area(&self, piece: &Fragment) -> Option<(usize, Vec<Point>)> {
        let is_face = matches!(piece.shape, FragmentShape::Face { .. });
        let is_body = self.recording.things.get(piece.thing).is_some_and(|thing| thing.kind == Kind::Body);
        let points = || piece.corners().iter().map(|corner| self.point(*corner)).collect();
        (is_face && is_body).then(|| (piece.thing, points()))
    }

    /// Returns the visible faces of a thing, and its lines.
    fn pieces(&self, index: usize, moment: usize) -> Vec<Fragment> {
        let (thing, (edges, _)) = (&self.recording.things[index], &self.meshes[index]);
        let placement = thing.track[moment];
        if placement.scale <= 0.0 {
            return Vec::new();
        }
        let places: Vec<Vector> = thing.mesh.corners.iter().map(|corner| placement.of(corner)).collect();
        let at = |corners: &[usize]| corners.iter().map(|&corner| places[corner]).collect::<Vec<_>>();
        let faces = thing.mesh.faces.iter().map(|face| at(face));
        let seen: Vec<Option<(Vec<Vector>, Vector)>> =
            faces.map(|corners| self.seen(corners, thing.mesh.is_closed)).collect();
        let is_seen: Vec<bool> = seen.iter().map(Option::is_some).collect();
        let mut pieces = Vec::new();
        for (face, seen) in seen.into_iter().enumerate() {
            if let Some((corners, normal)) = seen {
                let drawn = edges.drawn(face, &is_seen);
                pieces.push(Fragment { shape: FragmentShape::Face { corners, drawn, normal }, thing: index });
            }
        }
        pieces.extend(thing.mesh.lines.iter().flat_map(|line| lines(&at(line), index, self.least)));
        pieces
    }

    /// Returns a face with its normal, unless it has no area or belongs to a closed surface and
    /// faces away from the eye.
    fn seen(&self, corners: Vec<Vector>, is_closed: bool) -> Option<(Vec<Vector>, Vector)> {
        let normal = normal(&corners)?;
        let is_seen = !is_closed || dot(normal, self.camera.towards(corners[0])) > 0.0;
        is_seen.then_some((corners, normal))
    }

    fn paint(&self, piece: &Fragment, marks: &mut Vec<Mark>) {
        let colour = self.colour(piece.thing);
        match &piece.shape {
            FragmentShape::Face { corners, drawn, normal } => {
                let points: Vec<Point> = corners.iter().map(|corner| self.point(*corner)).collect();
                let fill = SHADOW.mixed(colour, self.camera.brightness(*normal));
                let segments = polyline(points.iter().copied(), true);
                marks.push(path(segments, Some((fill, GAP)), Some(fill)));
                let sides = outline(&points, drawn);
                if !sides.is_empty() {
                    marks.push(path(sides, Some((colour.mixed(INK, DARK), EDGE)), None));
                }
            }
            FragmentShape::Line(ends) => {
                let segments = polyline(ends.map(|end| self.point(end)), false);
                let kind = self.recording.things.get(piece.thing).map(|thing| thing.kind);
                let (colour, width) = match kind {
                    Some(Kind::Surroundings) => (colour, EDGE),
                    // Only edges of holes have lines.
                    Some(Kind::Body) => (colour.mixed(INK, DARK), EDGE),
                    _ => (colour, LINE),
                };
                match marks.last_mut() {
                    // Consecutive pieces of a line form one mark.
                    Some(Mark::Path { segments: before, style })
                        if style.fill.is_none() && style.stroke == Some(colour) && style.width == width =>
                    {
                        before.extend(segments);
                    }
                    _ => marks.push(path(segments, Some((colour, width)), None)),
                }
            }
        }
    }

    fn colour(&self, thing: usize) -> Colour {
        let things = &self.recording.things;
        match things.get(thing) {
            Some(thing) => thing.colour,
            None => self.recording.traces[thing - things.len()].colour,
        }
    }

    fn point(&self, place: Vector) -> Point {
        self.view.point(self.camera.seen(place).0)
    }

    fn label(&self, thing: &MovingMesh, moment: usize) -> Option<Tag> {
        let (label, placement) = (thing.label.as_ref()?, thing.track[moment]);
        if placement.scale <= 0.0 {
            return None;
        }
        let at = placement.of(&label.at);
        let size = self.view.length(length(subtract(at, placement.origin)));
        if thing.kind == Kind::Arrow && size < NAMED {
            return None;
        }
        let along = subtract(self.point(at), self.point(placement.origin));
        // The tip of an arrow or axis.
        let is_tip = label.at.share == 1.0;
        let side = geometry::unit(along).filter(|_| is_tip).map_or(Side::Around, Side::Along);
        let colour = if thing.kind == Kind::Arrow && thing.colour != PALE { thing.colour } else { INK };
        let may_hide = matches!(thing.kind, Kind::Body | Kind::Connector);
        let reach = if thing.kind == Kind::Body { self.reach(thing, moment, at) } else { 0.0 };
        self.tag(&label.text, at, side, colour, may_hide).map(|tag| Tag { reach, ..tag })
    }

    /// Returns the distance in pixels from a point to the farthest corner of a thing.
    fn reach(&self, thing: &MovingMesh, moment: usize, place: Vector) -> f64 {
        let at = self.point(place);
        let corners = thing.mesh.corners.iter().map(|corner| self.point(thing.track[moment].of(corner)));
        corners.map(|corner| length(subtract(corner, at))).fold(0.0, f64::max)
    }

    fn tag(&self, text: &str, at: Vector, side: Side, colour: Colour, may_hide: bool) -> Option<Tag> {
        if text.is_empty() {
            return None;
        }
        let (size, half) = extent(text, self.look.size[0]);
        let (text, at) = (text.to_owned(), self.point(at));
        Some(Tag { text, at, side, gap: NEAR, colour, may_hide, reach: 0.0, size, half })
    }
}

fn is_convex_body(thing: &MovingMesh, least: f64) -> bool {
    let Some(placement) = thing.track.iter().find(|placement| placement.scale > 0.0) else { return false };
    let faces = thing.mesh.faces.iter().filter_map(|face| {
        let corners: Vec<Vector> =
            face.iter().map(|&corner| placement.of(&thing.mesh.corners[corner])).collect();
        let normal = normal(&corners)?;
        Some((corners, normal))
    });
    thing.mesh.is_closed && thing.mesh.lines.is_empty() && is_convex(&faces.collect::<Vec<_>>(), least)
}

/// Returns the pieces of a line through points.
fn lines(points: &[Vector], thing: usize, least: f64) -> impl Iterator<Item = Fragment> + use<> {
    let ends: Vec<[Vector; 2]> = points.windows(2).map(|ends| [ends[0], ends[1]]).collect();
    let is_long = move |ends: &[Vector; 2]| length(subtract(ends[1], ends[0])) > least;
    ends.into_iter().filter(is_long).map(move |ends| Fragment { shape: FragmentShape::Line(ends), thing })
}

/// Returns the drawn sides of a polygon.
fn outline(points: &[Point], drawn: &[bool]) -> Vec<Segment> {
    let mut segments = Vec::new();
    for index in (0..points.len()).filter(|&index| drawn[index]) {
        let is_going_on = index > 0 && drawn[index - 1];
        if !is_going_on {
            segments.push(Segment::Move(points[index]));
        }
        segments.push(Segment::Line(points[(index + 1) % points.len()]));
    }
    segments
}

fn path(segments: Vec<Segment>, stroke: Option<(Colour, f64)>, fill: Option<Colour>) -> Mark {
    let (stroke, width) = stroke.map_or((None, 0.0), |(colour, width)| (Some(colour), width));
    Mark::Path { segments, style: Style { stroke, width, dashes: &[], fill } }
}
