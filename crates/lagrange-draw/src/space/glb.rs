//! A motion in space as one binary glTF 2.0 file. Source: *glTF 2.0 Specification*, Khronos Group
//! (2021).
//!
//! z points upwards here and y in glTF: a root node rotates one to the other. A stretched mesh is
//! scaled along its own z-axis, unless parts of it have a height independent of the stretch.
//! Arrows, whose heads keep their length, have a morph target for their stretch.

use super::mesh::Mesh;
use super::motion::{Motion, Quaternion, once};
use super::recording::{MovingMesh, Recording, Trace};
use super::store::{Purpose, Store};
use super::surface::Surface;
use super::vector::{NONE, Vector};
use crate::error::{DrawError, refusal};
use crate::film::page::{exact, list, quoted};
use crate::picture::Colour;
use lagrange_plot::colours::linear;
use lagrange_plot::label::Label;

/// The rotation that maps z to y and y to −z.
const UPWARDS: Quaternion = [-std::f64::consts::FRAC_1_SQRT_2, 0.0, 0.0, std::f64::consts::FRAC_1_SQRT_2];
/// Roughness of a matt surface, like paper.
const ROUGHNESS: f64 = 0.8;
/// Code of separate lines.
const LINES: u32 = 1;
/// Code of a connected line.
const LINE_STRIP: u32 = 3;
/// Code of triangles.
const TRIANGLES: u32 = 4;

/// Returns the file of a motion, with the times of its moments in seconds from its start.
pub(super) fn file(recording: &Recording, title: &str, elapsed: &[f64]) -> Result<Vec<u8>, DrawError> {
    let moments = Moments::of(elapsed);
    let mut model = Model { longest: longest(&recording.things), moments, ..Model::default() };
    recording.things.iter().for_each(|thing| model.thing(thing));
    recording.traces.iter().for_each(|trace| model.trace(trace));
    let title = Label::parse(title).plain();
    container(model.json(if title.is_empty() { "motion" } else { &title }))
}

/// Moments whose times are distinct in the precision of the file.
#[derive(Default)]
struct Moments {
    kept: Vec<usize>,
    times: Vec<[f64; 1]>,
    /// Accessor of the times, if anything moves.
    accessor: Option<usize>,
}

#[derive(Default)]
struct Model<'a> {
    moments: Moments,
    /// Largest stretch of meshes with a morph target, for which its weight is one.
    longest: f64,
    store: Store,
    nodes: Vec<String>,
    meshes: Vec<String>,
    known: Vec<(&'a Mesh, Colour, usize)>,
    materials: Vec<Colour>,
    samplers: Vec<String>,
    channels: Vec<String>,
}

/// The response of a mesh to stretches.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Stretch {
    None,
    /// All of the mesh is stretched in proportion.
    Scaled,
    /// Parts of the mesh keep their length.
    Morphed,
}

impl Stretch {
    fn of(mesh: &Mesh) -> Stretch {
        if mesh.corners.iter().all(|corner| corner.share == 0.0) {
            Stretch::None
        } else if mesh.corners.iter().all(|corner| corner.at[2] == 0.0) {
            Stretch::Scaled
        } else {
            Stretch::Morphed
        }
    }
}

impl Moments {
    fn of(elapsed: &[f64]) -> Moments {
        let mut moments = Moments::default();
        for (index, &time) in elapsed.iter().enumerate() {
            if moments.times.last().is_none_or(|[before]| *before < f64::from(time as f32)) {
                moments.kept.push(index);
                moments.times.push([f64::from(time as f32)]);
            }
        }
        moments
    }

    fn values<T: PartialEq + Copy>(&self, values: &[T]) -> Vec<T> {
        if values.len() == 1 {
            return values.to_vec();
        }
        once(self.kept.iter().map(|&index| values[index]).collect())
    }
}

impl<'a> Model<'a> {
    fn thing(&mut self, thing: &'a MovingMesh) {
        let stretch = Stretch::of(&thing.mesh);
        let mesh = self.mesh(&thing.mesh, thing.colour, stretch);
        let Motion { origins, rotations, .. } = Motion::of(thing);
        let origins = self.moments.values(&origins);
        let rotations = self.moments.values(&rotations);
        let scales: Vec<Vector> = thing
            .track
            .iter()
            .map(|placement| {
                let (scale, stretch_now) = (placement.scale, placement.stretch);
                // Hidden meshes have zero scale in all directions.
                let along = if stretch == Stretch::Scaled && scale > 0.0 { stretch_now } else { scale };
                [scale, scale, along]
            })
            .collect();
        let scales = self.moments.values(&once(scales));
        let mut node = format!("\"name\":{},\"mesh\":{mesh}", quoted(&thing.name));
        node += &self.animated("translation", &origins, NONE);
        node += &self.animated("rotation", &rotations, [0.0, 0.0, 0.0, 1.0]);
        node += &self.animated("scale", &scales, [1.0; 3]);
        if stretch == Stretch::Morphed {
            let weight =
                |(scale, stretch): (f64, f64)| if scale > 0.0 { stretch / scale / self.longest } else { 0.0 };
            let weights = thing.track.iter().map(|p| [weight((p.scale, p.stretch))]);
            let weights = self.moments.values(&once(weights.collect()));
            node += &self.animated("weights", &weights, [0.0]);
        }
        self.nodes.push(format!("{{{node}}}"));
    }

    fn trace(&mut self, trace: &Trace) {
        let points: Vec<Vector> = trace.past.iter().chain(&trace.points).copied().collect();
        if points.len() < 2 {
            return;
        }
        let positions = self.store.floats(&points, Purpose::Positions);
        let material = self.material(trace.colour);
        self.meshes.push(format!(
            "{{\"primitives\":[{{\"attributes\":{{\"POSITION\":{positions}}},\"material\":{material},\"mode\":{LINE_STRIP}}}]}}"
        ));
        let name = quoted(&trace.label);
        self.nodes.push(format!("{{\"name\":{name},\"mesh\":{}}}", self.meshes.len() - 1));
    }

    /// Writes a field of the next node with its first value, and a channel if it changes. Writes
    /// nothing for the default value.
    fn animated<const N: usize>(&mut self, path: &str, values: &[[f64; N]], default: [f64; N]) -> String {
        let Some(first) = values.first().filter(|_| *values != [default]) else { return String::new() };
        if values.len() > 1 {
            let store = &mut self.store;
            let times = &self.moments.times;
            let input = *self.moments.accessor.get_or_insert_with(|| store.floats(times, Purpose::Times));
            let output = self.store.floats(values, Purpose::Track);
            let (sampler, node) = (self.samplers.len(), self.nodes.len());
            self.samplers.push(format!("{{\"input\":{input},\"output\":{output}}}"));
            self.channels.push(format!(
                "{{\"sampler\":{sampler},\"target\":{{\"node\":{node},\"path\":\"{path}\"}}}}"
            ));
        }
        format!(",\"{path}\":{}", list(first.map(exact)))
    }

    fn mesh(&mut self, mesh: &'a Mesh, colour: Colour, stretch: Stretch) -> usize {
        let known = self.known.iter().find(|(known, of, _)| *of == colour && **known == *mesh);
        if let Some((.., index)) = known {
            return *index;
        }
        let material = self.material(colour);
        let mut primitives = Vec::new();
        if !mesh.faces.is_empty() {
            let surface = Surface::of(mesh);
            let normals: Vec<Vector> = surface.points.iter().map(|(_, normal)| *normal).collect();
            let vertices: Vec<usize> = surface.points.iter().map(|(corner, _)| *corner).collect();
            let positions = self.positions(mesh, &vertices, stretch);
            let normals = self.store.floats(&normals, Purpose::Attributes);
            let indices = self.store.indices(surface.triangles.into_iter().flatten());
            primitives.push(primitive(&positions, Some(normals), indices, material, TRIANGLES));
        }
        if !mesh.lines.is_empty() {
            let vertices: Vec<usize> = (0..mesh.corners.len()).collect();
            let positions = self.positions(mesh, &vertices, stretch);
            let ends = mesh.lines.iter().flat_map(|line| line.windows(2)).flatten();
            let indices = self.store.indices(ends.copied());
            primitives.push(primitive(&positions, None, indices, material, LINES));
        }
        self.meshes.push(format!("{{\"primitives\":{}}}", list(primitives)));
        self.known.push((mesh, colour, self.meshes.len() - 1));
        self.meshes.len() - 1
    }

    /// Returns the positions of vertices, and their displacements for the largest stretch.
    fn positions(&mut self, mesh: &Mesh, vertices: &[usize], stretch: Stretch) -> Vec<usize> {
        let corners = vertices.iter().map(|&vertex| mesh.corners[vertex]);
        let scaled = if stretch == Stretch::Scaled { 1.0 } else { 0.0 };
        let places: Vec<Vector> = corners
            .clone()
            .map(|corner| [corner.at[0], corner.at[1], corner.at[2] + scaled * corner.share])
            .collect();
        let mut accessors = vec![self.store.floats(&places, Purpose::Positions)];
        if stretch == Stretch::Morphed {
            let moved: Vec<Vector> = corners.map(|corner| [0.0, 0.0, self.longest * corner.share]).collect();
            accessors.push(self.store.floats(&moved, Purpose::Positions));
        }
        accessors
    }

    fn material(&mut self, colour: Colour) -> usize {
        let known = self.materials.iter().position(|other| *other == colour);
        known.unwrap_or_else(|| {
            self.materials.push(colour);
            self.materials.len() - 1
        })
    }

    fn json(self, title: &str) -> (String, Vec<u8>) {
        let children = list((0..self.nodes.len()).map(|node| node.to_string()));
        let root = format!(
            "{{\"name\":{},\"rotation\":{},\"children\":{children}}}",
            quoted(title),
            list(UPWARDS.map(exact))
        );
        let top = self.nodes.len();
        let animations = if self.channels.is_empty() {
            String::new()
        } else {
            let (samplers, channels) = (list(self.samplers), list(self.channels));
            format!(
                ",\"animations\":[{{\"name\":\"motion\",\"samplers\":{samplers},\"channels\":{channels}}}]"
            )
        };
        let bytes = self.store.bytes().to_vec();
        let json = format!(
            "{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"lagrange\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[{top}]}}],\
             \"nodes\":{},\"meshes\":{},\"materials\":{}{animations},{}}}",
            list(self.nodes.into_iter().chain([root])),
            list(self.meshes),
            list(self.materials.into_iter().map(material)),
            self.store.json(),
        );
        (json, bytes)
    }
}

/// Returns the largest stretch of meshes with a morph target, relative to their scale.
fn longest(things: &[MovingMesh]) -> f64 {
    let arrows = things.iter().filter(|thing| matches!(Stretch::of(&thing.mesh), Stretch::Morphed));
    let shown = arrows.flat_map(|thing| &thing.track).filter(|placement| placement.scale > 0.0);
    let longest = shown.map(|placement| placement.stretch / placement.scale).fold(0.0, f64::max);
    if longest > 0.0 { longest } else { 1.0 }
}

fn primitive(
    positions: &[usize],
    normals: Option<usize>,
    indices: usize,
    material: usize,
    mode: u32,
) -> String {
    let normals = normals.map(|normals| format!(",\"NORMAL\":{normals}")).unwrap_or_default();
    let target = positions.get(1).map(|moved| format!(",\"targets\":[{{\"POSITION\":{moved}}}]"));
    format!(
        "{{\"attributes\":{{\"POSITION\":{}{normals}}},\"indices\":{indices},\"material\":{material},\"mode\":{mode}{}}}",
        positions[0],
        target.unwrap_or_default(),
    )
}

fn material(Colour { light: [red, green, blue], .. }: Colour) -> String {
    let colour =
        list([red, green, blue].map(|channel| exact(linear(channel))).into_iter().chain(["1".into()]));
    format!(
        "{{\"pbrMetallicRoughness\":{{\"baseColorFactor\":{colour},\"metallicFactor\":0,\"roughnessFactor\":{ROUGHNESS}}}}}"
    )
}

/// Returns the file: a header, then JSON and numbers, each padded to a multiple of four bytes.
fn container((json, numbers): (String, Vec<u8>)) -> Result<Vec<u8>, DrawError> {
    let mut json = json.into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut numbers = numbers;
    numbers.resize(numbers.len().next_multiple_of(4), 0);
    let length =
        |count: usize| u32::try_from(count).map_err(|_| refusal("a glTF file has at most four gigabytes"));
    let whole = length(12 + 8 + json.len() + 8 + numbers.len())?;
    let mut file = Vec::with_capacity(whole as usize);
    file.extend(b"glTF");
    file.extend(2_u32.to_le_bytes());
    file.extend(whole.to_le_bytes());
    for (kind, chunk) in [(b"JSON", json), (b"BIN\0", numbers)] {
        file.extend(length(chunk.len())?.to_le_bytes());
        file.extend(kind);
        file.extend(chunk);
    }
    Ok(file)
}
