//! A motion in space as one HTML file with a rotatable view. The file contains the meshes, their
//! positions as integers, and a WebGL viewer.

use super::camera::{DISTANCE, LIGHT, SHADE};
use super::mesh::{Corner, Mesh};
use super::motion::{Motion, once};
use super::projector::{DARK, EDGE, LINE, Projector};
use super::recording::{Kind, MovingMesh, Recording, Trace};
use super::surface::Surface;
use super::vector::Vector;
use crate::colour::{INK, PALE, PAPER, SHADOW};
use crate::film::page::{Page, SCHEME, exact, list};
use crate::geometry::{subtract, times};
use crate::look::Look;
use crate::picture::{Colour, Picture};
use crate::timeline::Timeline;
use lagrange_plot::characters::escaped;
use lagrange_plot::label::Label;
use lagrange_plot::notation::formula;

pub(super) const STYLE: &str = include_str!("page/space.css");
pub(super) const VIEWER: &str = concat!(
    include_str!("page/viewer.js"),
    include_str!("page/camera.js"),
    include_str!("page/painter.js"),
    include_str!("page/labels.js")
);
/// Help text after the word "Drag".
pub(super) const KEYS: &str = "to turn, with two fingers or the right button to shift; wheel or pinch to zoom; double click for the first \
                    view. With the picture in focus, arrow keys turn, + and − zoom, 0 is the first view.";

/// Integer for the radius of the scene.
const FINE: f64 = 20_000.0;
/// Integer for the size of a mesh.
const MESH: f64 = 5_000.0;
/// Integer for one.
const ONE: f64 = 10_000.0;
/// Width of floors and paths in pixels.
const AROUND: f64 = 1.0;
/// Integer for the length of a normal.
const NORMAL: f64 = 100.0;

/// Returns the page of a motion.
pub(super) fn html(projector: &Projector, timeline: &Timeline) -> String {
    let (picture, space) = parts(projector);
    let page = Page {
        title: &projector.look.title,
        timeline,
        style: STYLE,
        picture,
        shown: format!("\"space\":{space}"),
        viewer: &[SCHEME, VIEWER].concat(),
        keys: &[" Drag ", KEYS].concat(),
    };
    page.html()
}

/// Returns the elements and the JSON object for the viewer.
pub(super) fn parts(projector: &Projector) -> (String, String) {
    let Projector { recording, look, .. } = projector;
    let scene = Scene { recording, look, frame: Frame::of(recording) };
    (scene.elements(&projector.project(0..1)), scene.json())
}

/// Integer coordinates: the origin is `middle`, and the unit of length is `unit`.
struct Frame {
    middle: Vector,
    radius: f64,
    unit: f64,
}

struct Scene<'a> {
    recording: &'a Recording,
    look: &'a Look,
    frame: Frame,
}

impl Frame {
    fn of(recording: &Recording) -> Frame {
        let (middle, radius) = recording.ball();
        Frame { middle, radius, unit: radius / FINE }
    }

    fn place(&self, place: Vector) -> String {
        whole(&times(1.0 / self.unit, subtract(place, self.middle)))
    }
}

impl Scene<'_> {
    /// Returns the elements for the viewer, and the first picture, which is displayed without it.
    fn elements(&self, pictures: &[Picture]) -> String {
        let (look, recording) = (self.look, self.recording);
        let labels =
            recording.things.iter().filter_map(label_of).chain(recording.traces.iter().map(trace_label));
        let element = |(index, (text, colour)): (usize, (String, Colour))| {
            format!(
                "<span id=\"label-{index}\" style=\"color:light-dark({})\" hidden>{}</span>",
                colour.text().pair().join(","),
                Label::parse(&text).html()
            )
        };
        let labels: String = labels.enumerate().map(element).collect();
        let caption = |class: &str, text: &str| {
            if text.is_empty() {
                String::new()
            } else {
                format!("<p class=\"{class}\">{}</p>", Label::parse(text).html())
            }
        };
        let name =
            if look.title.is_empty() { "Motion in space".into() } else { Label::parse(&look.title).plain() };
        format!(
            "<div id=\"space\" hidden><canvas id=\"canvas\" tabindex=\"0\" role=\"img\" aria-label=\"{}\"></canvas>\
             <div id=\"labels\" aria-hidden=\"true\">{labels}</div>{}{}\
             <button id=\"reset\" type=\"button\" title=\"First view\">Reset view</button></div>\n\
             <div id=\"flat\">{}</div>\n\
             <p id=\"no-space\" hidden>This browser does not support WebGL 2, so this is a still picture.</p>",
            escaped(&name),
            caption("title", &look.title),
            caption("note", &recording.note),
            pictures.first().map(Picture::svg).unwrap_or_default(),
        )
    }

    fn json(&self) -> String {
        let recording = self.recording;
        let mut meshes: Vec<&Mesh> = Vec::new();
        let mut label = 0;
        let things: Vec<String> =
            recording.things.iter().map(|t| self.thing(t, &mut meshes, &mut label)).collect();
        let traces: Vec<String> =
            recording.traces.iter().enumerate().map(|(k, t)| self.trace(t, label + k)).collect();
        let direction = self.look.direction;
        let near = if direction.is_perspective { 1.0 / DISTANCE } else { 0.0 };
        format!(
            "{{\"unit\":{:e},\"view\":[{},{}],\"near\":{near},\"light\":{},\"shade\":{SHADE},\"shadow\":{},\"ground\":{},\"edge\":{EDGE},\n\
             \"meshes\":[\n{}],\n\"things\":[\n{}],\n\"traces\":[\n{}]}}",
            1.0 / FINE,
            exact(direction.azimuth),
            exact(direction.elevation),
            list(LIGHT.map(exact)),
            colour(SHADOW),
            colour(PAPER),
            meshes.into_iter().map(|one| mesh(one, self.frame.radius)).collect::<Vec<_>>().join(",\n"),
            things.join(",\n"),
            traces.join(",\n"),
        )
    }

    /// Returns the JSON of a thing; a new mesh is added to the known ones.
    fn thing<'m>(&self, thing: &'m MovingMesh, meshes: &mut Vec<&'m Mesh>, label: &mut usize) -> String {
        let known = meshes.iter().position(|mesh| **mesh == thing.mesh);
        let index = known.unwrap_or_else(|| {
            meshes.push(&thing.mesh);
            meshes.len() - 1
        });
        let Motion { origins, rotations, stretches, scales } = Motion::of(thing);
        let stretches: Vec<f64> = stretches.iter().map(|stretch| stretch / self.frame.unit).collect();
        let edge = thing.colour.mixed(INK, DARK);
        let (line, width) = match thing.kind {
            // Only edges of holes have lines.
            Kind::Body => (edge, EDGE),
            Kind::Surroundings => (thing.colour, AROUND),
            _ => (thing.colour, LINE),
        };
        let numbers = [
            track(origins.iter().map(|origin| self.frame.place(*origin)).collect()),
            track(rotations.iter().map(|four| whole(&four.map(|part| ONE * part))).collect()),
            track(stretches.iter().map(|stretch| whole(&[*stretch])).collect()),
            track(scales.iter().map(|scale| whole(&[ONE * scale])).collect()),
        ];
        let [at, turn, stretch, scale] = numbers;
        format!(
            "{{\"mesh\":{index},\"colour\":{},\"edge\":{},\"line\":{},\"width\":{width},\"above\":{},\"label\":{},\
             \"at\":{at},\"turn\":{turn},\"stretch\":{stretch},\"scale\":{scale}}}",
            colour(thing.colour),
            colour(edge),
            colour(line),
            thing.kind == Kind::Arrow,
            self.place_of_label(thing, label),
        )
    }

    /// Returns the place of a thing's label, with its index among all labels.
    fn place_of_label(&self, thing: &MovingMesh, next: &mut usize) -> String {
        let Some(label) = &thing.label else { return "null".to_owned() };
        let number = *next;
        *next += 1;
        let Corner { at, share } = label.at;
        let [x, y, z] = times(1.0 / self.frame.radius, at);
        format!(
            "{{\"number\":{number},\"at\":{},\"tip\":{}}}",
            list([x, y, z, share].map(exact)),
            share == 1.0
        )
    }

    fn trace(&self, trace: &Trace, label: usize) -> String {
        let places = |places: &[Vector]| list(places.iter().map(|place| self.frame.place(*place)));
        let label = if trace.label.is_empty() { "null".to_owned() } else { label.to_string() };
        let [past, points] = [&trace.past, &trace.points].map(|points| places(points));
        let colour = colour(trace.colour);
        format!(
            "{{\"colour\":{colour},\"width\":{LINE},\"label\":{label},\"past\":{past},\"points\":{points}}}"
        )
    }
}

fn label_of(thing: &MovingMesh) -> Option<(String, Colour)> {
    let is_coloured = thing.kind == Kind::Arrow && thing.colour != PALE;
    thing.label.as_ref().map(|label| (label.text.clone(), if is_coloured { thing.colour } else { INK }))
}

fn trace_label(trace: &Trace) -> (String, Colour) {
    (formula(&trace.label), trace.colour)
}

/// Returns a mesh in numbers of its own unit.
fn mesh(mesh: &Mesh, radius: f64) -> String {
    let size = mesh.corners.iter().flat_map(|corner| corner.at).fold(0.0, |a: f64, b| a.max(b.abs()));
    let unit = if size > 0.0 { size / MESH } else { 1.0 };
    let corner =
        |Corner { at: [x, y, z], share }: &Corner| whole(&[x / unit, y / unit, z / unit, ONE * share]);
    let surface = Surface::of(mesh);
    let pairs = mesh.lines.iter().flat_map(|line| line.windows(2).map(indices));
    format!(
        "{{\"unit\":{:e},\"corners\":{},\n\"points\":{},\n\"triangles\":{},\n\"flat\":{},\n\"sharp\":{},\"smooth\":{},\"lines\":{}}}",
        unit / radius,
        list(mesh.corners.iter().map(corner)),
        list(surface.points.iter().map(|(corner, n)| format!("{corner},{}", whole(&times(NORMAL, *n))))),
        list(surface.triangles.iter().map(|corners| indices(corners))),
        list(surface.flat.iter().map(|normal| whole(&times(NORMAL, *normal)))),
        list(surface.sharp.iter().map(|ends| indices(ends))),
        list(surface.smooth.iter().map(|ends| indices(ends))),
        list(pairs),
    )
}

/// Returns the values of all moments in order, or one if it is constant.
fn track(values: Vec<String>) -> String {
    list(once(values))
}

fn indices(indices: &[usize]) -> String {
    indices.iter().map(ToString::to_string).collect::<Vec<_>>().join(",")
}

fn whole(values: &[f64]) -> String {
    let number = |value: &f64| format!("{}", value.round() + 0.0);
    values.iter().map(number).collect::<Vec<_>>().join(",")
}

/// Returns a colour on paper and on a dark ground.
fn colour(colour: Colour) -> String {
    list(colour.pair().map(|css| format!("\"{css}\"")))
}
