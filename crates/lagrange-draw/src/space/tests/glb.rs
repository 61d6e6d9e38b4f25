//! glTF files, read back.

use serde_json::Value;

use super::Crane;
use super::page::{NAUGHTY, crane, walker};
use crate::geometry::{length, subtract};
use crate::space::surface::Surface;
use crate::space::vector::Vector;
use crate::{Drawing, Film};
use lagrange_runtime::scene::Spatial;

/// A parsed file.
struct File {
    json: Value,
    numbers: Vec<u8>,
}

fn word(bytes: &[u8], at: usize) -> usize {
    u32::from_le_bytes(bytes[at..at + 4].try_into().expect("has four bytes")) as usize
}

impl File {
    fn of(film: &Film<Spatial>) -> File {
        let bytes = film.glb().expect("is written");
        assert_eq!((&bytes[..4], word(&bytes, 4), word(&bytes, 8)), (&b"glTF"[..], 2, bytes.len()));
        let json = word(&bytes, 12);
        assert_eq!((&bytes[16..20], json % 4), (&b"JSON"[..], 0));
        let rest = &bytes[20 + json..];
        assert_eq!((&rest[4..8], word(rest, 0)), (&b"BIN\0"[..], rest.len() - 8));
        File {
            json: serde_json::from_slice(&bytes[20..20 + json]).expect("is JSON"),
            numbers: rest[8..].to_vec(),
        }
    }

    fn floats(&self, accessor: &Value) -> Vec<f64> {
        let accessor = &self.json["accessors"][index(accessor)];
        let view = &self.json["bufferViews"][index(&accessor["bufferView"])];
        let width = match accessor["type"].as_str() {
            Some("SCALAR") => 1,
            Some("VEC3") => 3,
            _ => 4,
        };
        let (start, count) = (index(&view["byteOffset"]), width * index(&accessor["count"]));
        assert_eq!(index(&view["byteLength"]), 4 * count);
        let number = |k: usize| f32::from_bits(word(&self.numbers, start + 4 * k) as u32);
        (0..count).map(|k| f64::from(number(k))).collect()
    }

    /// Returns the value of a node's property at a moment: from its channel, its own field, or the
    /// default.
    fn value(&self, node: usize, path: &str, moment: usize, default: &[f64]) -> Vec<f64> {
        let animation = &self.json["animations"][0];
        let mut channels = animation["channels"].as_array().into_iter().flatten();
        let is_of_node =
            |channel: &&Value| channel["target"]["node"] == node && channel["target"]["path"] == path;
        let channel = channels.find(is_of_node);
        assert!(channels.find(is_of_node).is_none(), "two channels change one {path}");
        let Some(channel) = channel else {
            let own = self.json["nodes"][node][path].as_array();
            return own.map_or(default.to_vec(), |own| own.iter().filter_map(Value::as_f64).collect());
        };
        let output = &animation["samplers"][index(&channel["sampler"])]["output"];
        self.floats(output)[default.len() * moment..][..default.len()].to_vec()
    }

    /// Returns the positions of the vertices of a node's primitive.
    fn places(&self, node: usize, primitive: usize, moment: usize) -> Vec<Vector> {
        let mesh = &self.json["meshes"][index(&self.json["nodes"][node]["mesh"])];
        let primitive = &mesh["primitives"][primitive];
        let positions = self.floats(&primitive["attributes"]["POSITION"]);
        let target = &primitive["targets"][0]["POSITION"];
        let moved = if target.is_null() { vec![0.0; positions.len()] } else { self.floats(target) };
        let weight = self.value(node, "weights", moment, &[0.0])[0];
        let scale = self.value(node, "scale", moment, &[1.0; 3]);
        let turn = self.value(node, "rotation", moment, &[0.0, 0.0, 0.0, 1.0]);
        let origin = self.value(node, "translation", moment, &[0.0; 3]);
        let place = |(at, by): (&[f64], &[f64])| {
            let own = [0, 1, 2].map(|k| scale[k] * (at[k] + weight * by[k]));
            let turned = turned(&turn, own);
            [0, 1, 2].map(|k| origin[k] + turned[k])
        };
        positions.chunks(3).zip(moved.chunks(3)).map(place).collect()
    }
}

fn index(value: &Value) -> usize {
    usize::try_from(value.as_u64().expect("is a whole number")).expect("fits")
}

/// Computes q r q* by the vector product: r + 2 w (v × r) + 2 v × (v × r).
fn turned(four: &[f64], r: Vector) -> Vector {
    let v = [four[0], four[1], four[2]];
    let cross = |a: Vector, b: Vector| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let (once, twice) = (cross(v, r), cross(v, cross(v, r)));
    [0, 1, 2].map(|k| r[k] + 2.0 * four[3] * once[k] + 2.0 * twice[k])
}

#[test]
fn corners_are_where_they_are_at_each_moment() {
    let film = crane(40);
    let file = File::of(&film);
    for (node, thing) in film.recording.recording.things.iter().enumerate() {
        assert_eq!(file.json["nodes"][node]["name"], thing.name);
        for moment in [0, 13, 39] {
            let placement = thing.track[moment];
            let of_faces: Vec<usize> =
                Surface::of(&thing.mesh).points.iter().map(|(corner, _)| *corner).collect::<Vec<_>>();
            let of_lines: Vec<usize> =
                (0..thing.mesh.corners.len()).filter(|_| !thing.mesh.lines.is_empty()).collect::<Vec<_>>();
            let parts = [of_faces, of_lines].into_iter().filter(|corners| !corners.is_empty());
            for (primitive, corners) in parts.enumerate() {
                let places = file.places(node, primitive, moment);
                assert_eq!(places.len(), corners.len());
                if placement.scale == 0.0 {
                    assert!(places.windows(2).all(|pair| pair[0] == pair[1]), "what is hidden has no size");
                    continue;
                }
                for (place, corner) in places.iter().zip(corners) {
                    let off = length(subtract(*place, placement.of(&thing.mesh.corners[corner])));
                    assert!(off < 1e-6, "{} is off by {off} at {moment}", thing.name);
                }
            }
        }
    }
}

#[test]
fn all_that_moves_has_the_times_of_the_film() {
    let film = walker();
    let file = File::of(film);
    let animation = &file.json["animations"][0];
    let samplers = animation["samplers"].as_array().expect("has samplers");
    let times = file.floats(&samplers[0]["input"]);
    assert_eq!(times.len(), 601);
    assert!(times.iter().zip(film.times()).all(|(a, b)| (a - b).abs() < 1e-6));
    assert!(samplers.iter().all(|sampler| sampler["input"] == samplers[0]["input"]));
    // The trunk, hips and joints do not rotate; thighs and shanks do.
    assert_eq!(samplers.len(), 13 + 8 + 12);
    let (things, traces) = (1 + 13 + 12, 4);
    assert_eq!(file.json["nodes"].as_array().map(Vec::len), Some(things + traces + 1));
}

#[test]
fn z_points_upwards() {
    let file = File::of(&crane(2));
    let root = &file.json["nodes"][index(&file.json["scenes"][0]["nodes"][0])];
    let four: Vec<f64> =
        root["rotation"].as_array().into_iter().flatten().filter_map(Value::as_f64).collect::<Vec<_>>();
    let up = turned(&four, [0.0, 0.0, 1.0]);
    assert!(length(subtract(up, [0.0, 1.0, 0.0])) < 1e-15, "{up:?}");
    assert_eq!(
        root["children"].as_array().map(Vec::len),
        file.json["nodes"].as_array().map(|nodes| nodes.len() - 1)
    );
}

#[test]
fn one_moment_is_a_model_without_a_motion_and_names_are_kept() {
    let drawing = Drawing::of(&Crane).title(NAUGHTY);
    let film = drawing.film_of([(0.0, [0.3, 1.0])]).expect("draws");
    let file = File::of(&film);
    assert!(file.json["animations"].is_null());
    let nodes = file.json["nodes"].as_array().expect("has nodes");
    assert_eq!(nodes.last().map(|root| &root["name"]), Some(&Value::from(NAUGHTY)));
}
