//! Surfaces for graphics processors: triangles between points with normals, and the drawn edges.

use std::collections::{BTreeMap, BTreeSet};

use super::mesh::{Edges, Mesh, Neighbour, normal};
use super::vector::{Vector, cross};
use crate::geometry::{add, dot, length, subtract, times, unit};

/// The faces and edges of a mesh. Normals hold for any stretch, since the sides of stretched parts
/// are along it.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Surface {
    /// A corner and a surface normal at it; corners at edges occur several times.
    pub(super) points: Vec<(usize, Vector)>,
    /// Indices of points, counterclockwise as seen from outside.
    pub(super) triangles: Vec<[usize; 3]>,
    /// Normals of faces.
    pub(super) flat: Vec<Vector>,
    /// Edges that are always drawn, each by its two corners.
    pub(super) sharp: Vec<[usize; 2]>,
    /// Edges that are drawn only on the silhouette, each by its corners and the faces on both
    /// sides.
    pub(super) smooth: Vec<[usize; 4]>,
}

/// Cosine of the angle, 50°, beyond which a smoothed normal is replaced by that of the face, as at
/// the tip of a cone.
const POINTED: f64 = 0.64;

impl Surface {
    pub(super) fn of(mesh: &Mesh) -> Surface {
        let mut surface = Surface { flat: flat(mesh), ..Surface::default() };
        let edges = Edges::of(mesh);
        let mut known: BTreeMap<(usize, [i64; 3]), usize> = BTreeMap::new();
        let around = faces_around(mesh);
        for (face, corners) in mesh.faces.iter().enumerate() {
            let points: Vec<usize> = corners
                .iter()
                .map(|&corner| {
                    let normal = surface.smoothed(mesh, &edges, &around[corner], face, corner);
                    let rounded = normal.map(|part| (1e6 * part).round() as i64);
                    *known.entry((corner, rounded)).or_insert_with(|| {
                        surface.points.push((corner, normal));
                        surface.points.len() - 1
                    })
                })
                .collect();
            surface.triangles.extend(points[1..].windows(2).map(|pair| [points[0], pair[0], pair[1]]));
        }
        surface.trace(mesh, &edges);
        surface
    }

    /// Returns the normal at a corner of a face: the mean of the faces that continue smoothly
    /// there, weighted by their angles. Source: Thürmer, Wüthrich, *Computing Vertex Normals from
    /// Polygonal Facets*, Journal of Graphics Tools 3 (1998).
    fn smoothed(&self, mesh: &Mesh, edges: &Edges, around: &[usize], face: usize, corner: usize) -> Vector {
        let mut fan = vec![face];
        let mut next = 0;
        while let Some(&one) = fan.get(next) {
            next += 1;
            let has_corner = |other: &usize| around.contains(other);
            let new: Vec<usize> =
                edges.behind(one).iter().filter_map(Neighbour::smooth).filter(has_corner).collect();
            for other in new {
                if !fan.contains(&other) {
                    fan.push(other);
                }
            }
        }
        let part = |&face: &usize| times(angle(mesh, &mesh.faces[face], corner), self.flat[face]);
        let mean = unit(fan.iter().map(part).fold([0.0; 3], add));
        mean.filter(|mean| dot(*mean, self.flat[face]) > POINTED).unwrap_or(self.flat[face])
    }

    /// Collects each edge once.
    fn trace(&mut self, mesh: &Mesh, edges: &Edges) {
        let mut known = BTreeSet::new();
        for (face, corners) in mesh.faces.iter().enumerate() {
            for (side, behind) in edges.behind(face).iter().enumerate() {
                let ends = [corners[side], corners[(side + 1) % corners.len()]];
                match behind {
                    Neighbour::Sharp if known.insert([ends[0].min(ends[1]), ends[0].max(ends[1])]) => {
                        self.sharp.push(ends);
                    }
                    Neighbour::Smooth(other) if face < *other => {
                        self.smooth.push([ends[0], ends[1], face, *other]);
                    }
                    _ => {}
                }
            }
        }
    }
}

/// Returns the corners of a mesh in a stretch that is long relative to its size.
pub(super) fn stretched(mesh: &Mesh) -> Vec<Vector> {
    let longest = mesh.corners.iter().flat_map(|corner| corner.at).fold(0.0, |a: f64, b| a.max(b.abs()));
    let stretch = if longest > 0.0 { 8.0 * longest } else { 1.0 };
    mesh.corners.iter().map(|corner| add(corner.at, [0.0, 0.0, stretch * corner.share])).collect()
}

fn flat(mesh: &Mesh) -> Vec<Vector> {
    let places = stretched(mesh);
    let of_face = |face: &Vec<usize>| {
        let corners: Vec<Vector> = face.iter().map(|&corner| places[corner]).collect();
        normal(&corners).unwrap_or([0.0, 0.0, 1.0])
    };
    mesh.faces.iter().map(of_face).collect()
}

fn faces_around(mesh: &Mesh) -> Vec<Vec<usize>> {
    let mut around = vec![Vec::new(); mesh.corners.len()];
    for (index, face) in mesh.faces.iter().enumerate() {
        face.iter().for_each(|&corner| around[corner].push(index));
    }
    around
}

/// Returns the angle of a face at one of its corners.
fn angle(mesh: &Mesh, face: &[usize], corner: usize) -> f64 {
    let Some(at) = face.iter().position(|other| *other == corner) else { return 0.0 };
    let place = |index: usize| {
        let corner = &mesh.corners[face[index % face.len()]];
        add(corner.at, [0.0, 0.0, corner.share])
    };
    let here = place(at);
    let [a, b] = [at + 1, at + face.len() - 1].map(|index| subtract(place(index), here));
    length(cross(a, b)).atan2(dot(a, b))
}

#[cfg(test)]
mod tests {
    use super::Surface;
    use crate::geometry::{dot, length, unit};
    use crate::space::solids::{arrow, ball, cuboid, cylinder};

    #[test]
    fn the_normals_of_a_ball_point_away_from_its_middle() {
        let mesh = ball(0.3);
        let surface = Surface::of(&mesh);
        assert_eq!(surface.points.len(), mesh.corners.len(), "no corner has two normals");
        for (corner, normal) in &surface.points {
            let away = unit(mesh.corners[*corner].at).expect("is not the middle");
            assert!(dot(*normal, away) > 0.99, "{normal:?} at {away:?}");
        }
        assert!(surface.sharp.is_empty());
    }

    #[test]
    fn the_normals_of_a_cuboid_are_those_of_its_faces() {
        let surface = Surface::of(&cuboid([1.0, 2.0, 3.0]));
        assert_eq!((surface.points.len(), surface.triangles.len()), (24, 12));
        assert_eq!((surface.sharp.len(), surface.smooth.len()), (12, 0));
        assert!(surface.points.iter().all(|(_, normal)| surface.flat.contains(normal)));
    }

    #[test]
    fn a_cylinder_is_round_between_two_rims() {
        let surface = Surface::of(&cylinder(1.0, [0.0, 2.0], 12));
        assert_eq!((surface.points.len(), surface.sharp.len(), surface.smooth.len()), (48, 24, 12));
        assert_eq!(surface.triangles.len(), 2 * 12 + 2 * 10);
        let side = surface.points.iter().filter(|(_, normal)| normal[2].abs() < 0.5);
        assert!(side.clone().count() == 24 && side.into_iter().all(|(_, normal)| normal[2].abs() < 1e-12));
    }

    #[test]
    fn the_shaft_of_a_thick_arrow_is_not_inside_out() {
        // The head is longer than a stretch of one.
        let mesh = arrow(1.0);
        for (corner, normal) in Surface::of(&mesh).points {
            let [x, y, _] = mesh.corners[corner].at;
            assert!(length(normal) > 0.999 && (normal[0] * x + normal[1] * y) > -1e-12);
        }
    }
}
