//! Surfaces of plane faces, and lines: the appearance of objects in space, in their own axes.
//!
//! A mesh is placed by a rotation and an origin. Springs and arrows, which reach from one point to
//! another, are also stretched along their own z-axis. Each corner has a share of the stretch, so
//! that arrows lengthen while their heads keep their size.

use std::collections::BTreeMap;

use super::vector::{Rotation, UPRIGHT, Vector, apply, axes_along, axes_near, cross};
use crate::geometry::{add, dot, length, subtract, times, unit};

/// A corner in the mesh's own axes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Corner {
    /// Position without stretch.
    pub(crate) at: Vector,
    /// Share of the stretch along z: 0 at the start of an arrow, 1 at its end.
    pub(crate) share: f64,
}

/// Faces and lines between corners.
#[derive(Clone, PartialEq, Debug, Default)]
pub(crate) struct Mesh {
    pub(crate) corners: Vec<Corner>,
    /// Plane convex polygons, counterclockwise as seen from outside.
    pub(crate) faces: Vec<Vec<usize>>,
    /// Lines through corners.
    pub(crate) lines: Vec<Vec<usize>>,
    /// True if the faces enclose a body, so that those facing away from the eye are hidden by
    /// others.
    pub(crate) is_closed: bool,
}

/// The placement of a mesh at one moment.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Placement {
    pub(crate) origin: Vector,
    /// Rotation from its own axes to those of the world.
    pub(crate) rotation: Rotation,
    /// Stretch along its own z-axis.
    pub(crate) stretch: f64,
    /// Scale of everything but the stretch; 0 hides it.
    pub(crate) scale: f64,
}

impl Placement {
    /// Creates a placement without stretch.
    pub(super) fn rigid(origin: Vector, rotation: Rotation) -> Placement {
        Placement { origin, rotation, stretch: 0.0, scale: 1.0 }
    }

    /// Returns placements stretched from a point along a vector at each moment, with the least
    /// possible rotation about the vector.
    pub(super) fn spanned(spans: impl IntoIterator<Item = [Vector; 2]>) -> Vec<Placement> {
        let mut before: Option<Rotation> = None;
        let placed = |[from, vector]: [Vector; 2]| {
            let rotation = match (before, unit(vector)) {
                (Some(before), Some(along)) => {
                    let first = before.map(|row| row[0]);
                    axes_near(first, along).unwrap_or_else(|| axes_along(along))
                }
                (None, Some(along)) => axes_along(along),
                (before, None) => before.unwrap_or(UPRIGHT),
            };
            before = unit(vector).map(|_| rotation).or(before);
            Placement { stretch: length(vector), ..Placement::rigid(from, rotation) }
        };
        spans.into_iter().map(placed).collect()
    }

    /// Returns the world position of a corner.
    pub(crate) fn of(&self, corner: &Corner) -> Vector {
        let [x, y, z] = times(self.scale, corner.at);
        add(self.origin, apply(&self.rotation, [x, y, z + corner.share * self.stretch]))
    }

    /// True if all numbers are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let rotation = self.rotation.as_flattened().iter();
        rotation.chain(&self.origin).chain([&self.stretch, &self.scale]).all(|number| number.is_finite())
    }
}

/// Cosine of the largest angle, 33°, at which edges between faces of a smooth surface are not
/// drawn, for balls with few faces. Edges of the silhouette are always drawn.
const SMOOTH: f64 = 0.84;

/// The edges of a mesh. Each side of each face has a neighbour, and is either sharp or smooth.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Edges {
    sides: Vec<Vec<Neighbour>>,
}

/// The neighbour across a side of a face.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Neighbour {
    /// Another face at a sharp angle.
    Sharp,
    /// The face with this index, which continues smoothly.
    Smooth(usize),
}

impl Neighbour {
    /// Returns the face that continues smoothly.
    pub(super) fn smooth(&self) -> Option<usize> {
        match self {
            Neighbour::Sharp => None,
            Neighbour::Smooth(other) => Some(*other),
        }
    }
}

impl Edges {
    pub(super) fn of(mesh: &Mesh) -> Edges {
        let mut owners: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for (index, face) in mesh.faces.iter().enumerate() {
            for side in sides(face) {
                owners.entry(side).or_default().push(index);
            }
        }
        let normals: Vec<_> = mesh.faces.iter().map(|face| normal(&own_points(mesh, face))).collect();
        let is_smooth = |a: usize, b: usize| match (normals[a], normals[b]) {
            (Some(a), Some(b)) => dot(a, b) > SMOOTH,
            _ => true,
        };
        let behind = |face: usize, side: [usize; 2]| {
            let other = owners[&side].iter().copied().find(|other| *other != face);
            other.filter(|other| is_smooth(face, *other)).map_or(Neighbour::Sharp, Neighbour::Smooth)
        };
        let of_face = |(index, face): (usize, &Vec<usize>)| {
            sides(face).map(|side| behind(index, side)).collect::<Vec<_>>()
        };
        Edges { sides: mesh.faces.iter().enumerate().map(of_face).collect() }
    }

    /// Returns the neighbours across each side of a face.
    pub(super) fn behind(&self, face: usize) -> &[Neighbour] {
        &self.sides[face]
    }

    /// Returns the sides of a face that are drawn for these visible faces.
    pub(super) fn drawn(&self, face: usize, is_seen: &[bool]) -> Vec<bool> {
        let is_drawn = |side: &Neighbour| match side {
            Neighbour::Sharp => true,
            Neighbour::Smooth(other) => !is_seen[*other],
        };
        self.sides[face].iter().map(is_drawn).collect()
    }
}

/// Returns the sides of a face, each by its corners in rising order.
fn sides(face: &[usize]) -> impl Iterator<Item = [usize; 2]> + '_ {
    (0..face.len()).map(|index| {
        let (a, b) = (face[index], face[(index + 1) % face.len()]);
        [a.min(b), a.max(b)]
    })
}

/// Returns the corners of a face, with a stretch of one.
fn own_points(mesh: &Mesh, face: &[usize]) -> Vec<Vector> {
    face.iter()
        .map(|&index| mesh.corners[index])
        .map(|Corner { at: [x, y, z], share }| [x, y, z + share])
        .collect()
}

/// Returns the direction from which a plane polygon is counterclockwise, if it has an area. Source:
/// Newell's method; Sutherland, Sproull, Schumacker, *A Characterization of Ten Hidden-Surface
/// Algorithms* (1974).
pub(super) fn normal(points: &[Vector]) -> Option<Vector> {
    let first = points.first()?;
    let arms: Vec<Vector> = points.iter().map(|point| subtract(*point, *first)).collect();
    let sum = arms.windows(2).map(|pair| cross(pair[0], pair[1])).fold([0.0; 3], add);
    unit(sum)
}

impl Mesh {
    /// Places the mesh; corners keep their shares of the stretch.
    pub(super) fn placed(mut self, origin: Vector, rotation: &Rotation) -> Mesh {
        for corner in &mut self.corners {
            corner.at = add(origin, apply(rotation, corner.at));
        }
        self
    }

    /// Combines two meshes.
    pub(super) fn with(mut self, other: Mesh) -> Mesh {
        let start = self.corners.len();
        let shifted = |part: Vec<usize>| part.into_iter().map(|index| index + start).collect::<Vec<_>>();
        let have_faces = [&self, &other].map(|mesh| !mesh.faces.is_empty());
        self.is_closed = (self.is_closed || !have_faces[0]) && (other.is_closed || !have_faces[1]);
        self.corners.extend(other.corners);
        self.faces.extend(other.faces.into_iter().map(shifted));
        self.lines.extend(other.lines.into_iter().map(shifted));
        self
    }

    /// Turns the faces inside out.
    pub(super) fn inverted(mut self) -> Mesh {
        self.faces.iter_mut().for_each(|face| face.reverse());
        self
    }

    /// Returns the sharp edges without the faces.
    pub(super) fn edges_only(self) -> Mesh {
        let edges = Edges::of(&self);
        let mut lines = Vec::new();
        for (face, owned) in self.faces.iter().zip(&edges.sides) {
            let sharp = (0..face.len()).filter(|&side| owned[side] == Neighbour::Sharp);
            lines.extend(sharp.map(|side| vec![face[side], face[(side + 1) % face.len()]]));
        }
        Mesh { faces: Vec::new(), lines, is_closed: false, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::Placement;
    use crate::geometry::{length, subtract};

    #[test]
    fn what_is_stretched_turns_about_itself_as_little_as_it_can() {
        // The end moves up and down through the xy-plane, sometimes by a rounding error, and back
        // upside down.
        let heights = [0.4, 0.1, 1e-17, -1e-17, 0.0, -0.0, -0.1, -0.6];
        let ends = heights
            .map(|z| [[0.0; 3], [1.0, 0.2, z]])
            .into_iter()
            .chain([[[0.0; 3]; 2], [[0.0; 3], [0.8, 0.0, -0.6]]]);
        let track = Placement::spanned(ends);
        for pair in track.windows(2) {
            let [before, now] = [pair[0], pair[1]].map(|placement| placement.rotation.map(|row| row[0]));
            assert!(length(subtract(before, now)) < 0.6, "{before:?} {now:?}");
        }
    }
}
