//! The binary part of a glTF file: consecutive numbers, and their description in JSON.

use crate::film::page::list;

/// Numbers, divided by accessors.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Store {
    bytes: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
}

/// The purpose of numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Purpose {
    /// Positions of vertices, which include bounds.
    Positions,
    /// Other attributes of vertices.
    Attributes,
    /// Times, which include bounds.
    Times,
    /// A quantity that varies with time.
    Track,
}

/// Code of 32-bit floating-point numbers.
const FLOAT: u32 = 5126;
/// Code of 32-bit unsigned integers.
const UNSIGNED: u32 = 5125;
/// Code of vertex attributes.
const VERTICES: u32 = 34962;
/// Code of vertex indices.
const ELEMENTS: u32 = 34963;

impl Store {
    /// Stores numbers in groups of N, and returns the index of their accessor.
    pub(super) fn floats<const N: usize>(&mut self, values: &[[f64; N]], purpose: Purpose) -> usize {
        let values: Vec<[f32; N]> = values.iter().map(|group| group.map(|value| value as f32)).collect();
        let target = match purpose {
            Purpose::Positions | Purpose::Attributes => Some(VERTICES),
            Purpose::Times | Purpose::Track => None,
        };
        let bytes = values.as_flattened().iter().flat_map(|value| value.to_le_bytes()).collect();
        let kind = match N {
            1 => "SCALAR",
            3 => "VEC3",
            _ => "VEC4",
        };
        let bounds = match purpose {
            Purpose::Positions | Purpose::Times => bounds(&values),
            Purpose::Attributes | Purpose::Track => String::new(),
        };
        self.accessor(bytes, target, &format!("{FLOAT},\"type\":\"{kind}\"{bounds}"), values.len())
    }

    /// Stores indices of vertices, and returns the index of their accessor.
    pub(super) fn indices(&mut self, indices: impl IntoIterator<Item = usize>) -> usize {
        let mut count = 0;
        let mut bytes = Vec::new();
        for index in indices {
            // Files with this many vertices are rejected much earlier.
            bytes.extend(u32::try_from(index).unwrap_or(u32::MAX).to_le_bytes());
            count += 1;
        }
        self.accessor(bytes, Some(ELEMENTS), &format!("{UNSIGNED},\"type\":\"SCALAR\""), count)
    }

    fn accessor(&mut self, bytes: Vec<u8>, target: Option<u32>, kind: &str, count: usize) -> usize {
        let target = target.map(|target| format!(",\"target\":{target}")).unwrap_or_default();
        let (start, length) = (self.bytes.len(), bytes.len());
        self.views.push(format!("{{\"buffer\":0,\"byteOffset\":{start},\"byteLength\":{length}{target}}}"));
        let view = self.views.len() - 1;
        self.accessors.push(format!("{{\"bufferView\":{view},\"componentType\":{kind},\"count\":{count}}}"));
        self.bytes.extend(bytes);
        self.accessors.len() - 1
    }

    pub(super) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Returns the JSON fields that describe the store.
    pub(super) fn json(self) -> String {
        let length = self.bytes.len();
        let (views, accessors) = (list(self.views), list(self.accessors));
        format!("\"buffers\":[{{\"byteLength\":{length}}}],\"bufferViews\":{views},\"accessors\":{accessors}")
    }
}

fn bounds<const N: usize>(values: &[[f32; N]]) -> String {
    let bound = |start: f32, choose: fn(f32, f32) -> f32| {
        let of_axis = |axis: usize| values.iter().map(|group| group[axis]).fold(start, choose);
        list((0..N).map(|axis| format!("{:e}", f64::from(of_axis(axis)))))
    };
    format!(",\"min\":{},\"max\":{}", bound(f32::INFINITY, f32::min), bound(f32::NEG_INFINITY, f32::max))
}
