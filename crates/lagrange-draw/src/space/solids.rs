//! The surfaces of solids, and the shapes of springs, dampers and arrows.

use std::f64::consts::{PI, TAU};

use super::mesh::{Corner, Mesh};
use super::vector::Vector;
use lagrange_runtime::scene::Solid;

/// Number of corners of a circle.
const ROUND: usize = 28;
/// Number of rings of faces from pole to pole of a sphere.
const RINGS: usize = 12;
/// Number of corners of a circle on surroundings.
const LARGE_ROUND: usize = 48;
/// Number of rings of spheres around a scene.
const LARGE_RINGS: usize = 22;
/// Number of corners of a circle of small objects.
const SMALL_ROUND: usize = 12;
/// Number of rings of small spheres.
const SMALL_RINGS: usize = 6;
/// Windings of a spring.
const WINDINGS: usize = 10;
/// Straight fraction of a spring's length at each end.
const STRAIGHT: f64 = 0.12;

/// Returns the mesh of a solid; shapes without thickness get `thickness`.
pub(super) fn solid(solid: Solid<f64>, thickness: f64) -> Mesh {
    match solid {
        Solid::PointMass => ball(1.6 * thickness),
        Solid::SlenderRod(length) => rod_along_x(length, 0.5 * thickness),
        Solid::Sphere(radius) => ellipsoid([radius; 3], ROUND, RINGS),
        Solid::Ellipsoid(a, b, c) => ellipsoid([a, b, c], ROUND, RINGS),
        Solid::Cuboid(a, b, c) => cuboid([a, b, c]),
        Solid::Disk(radius) => cylinder(radius, [-0.25 * thickness, 0.25 * thickness], ROUND),
        Solid::Ring(radius) => tube([radius - 0.5 * thickness, radius + 0.5 * thickness], thickness),
        Solid::Cylinder(radius, height) => cylinder(radius, [-0.5 * height, 0.5 * height], ROUND),
        Solid::HollowCylinder(inner, outer, height) => tube([inner, outer], height),
        Solid::Cone(radius, height) => cone(radius, height),
    }
}

fn corner(at: Vector) -> Corner {
    Corner { at, share: 0.0 }
}

/// Returns corners on a circle about z.
fn circle(radius: f64, z: f64, share: f64, count: usize) -> impl Iterator<Item = Corner> {
    (0..count).map(move |index| {
        let (sin, cos) = (TAU * index as f64 / count as f64).sin_cos();
        Corner { at: [radius * cos, radius * sin, z], share }
    })
}

/// Adds quadrilaterals between two circles of corners, the second above the first as seen from
/// outside.
fn band(faces: &mut Vec<Vec<usize>>, [low, high]: [usize; 2], count: usize) {
    faces.extend((0..count).map(|index| {
        let next = (index + 1) % count;
        vec![low + index, low + next, high + next, high + index]
    }));
}

/// Returns a surface through circles about z with flat ends. Each circle is given by its radius,
/// height and share of the stretch.
fn turned(circles: &[(f64, f64, f64)], count: usize) -> Mesh {
    let corners = circles.iter().flat_map(|&(radius, z, share)| circle(radius, z, share, count)).collect();
    let mut faces = Vec::new();
    for index in 1..circles.len() {
        band(&mut faces, [(index - 1) * count, index * count], count);
    }
    let last = (circles.len() - 1) * count;
    faces.push((0..count).rev().collect());
    faces.push((last..last + count).collect());
    Mesh { corners, faces, lines: Vec::new(), is_closed: true }
}

pub(super) fn cylinder(radius: f64, [low, high]: [f64; 2], count: usize) -> Mesh {
    turned(&[(radius, low, 0.0), (radius, high, 0.0)], count)
}

fn cone(radius: f64, height: f64) -> Mesh {
    pointed(&[(radius, 0.0, 0.0)], (height, 0.0), ROUND)
}

/// Returns a surface through circles about z, with a tip after the last one. The tip has a height
/// and a share of the stretch.
fn pointed(circles: &[(f64, f64, f64)], (height, share): (f64, f64), count: usize) -> Mesh {
    let mut mesh = turned(circles, count);
    mesh.faces.pop();
    let (tip, last) = (mesh.corners.len(), (circles.len() - 1) * count);
    mesh.corners.push(Corner { at: [0.0, 0.0, height], share });
    mesh.faces.extend((0..count).map(|index| vec![last + index, last + (index + 1) % count, tip]));
    mesh
}

fn tube([inner, outer]: [f64; 2], height: f64) -> Mesh {
    let (low, high) = (-0.5 * height, 0.5 * height);
    let rims = [(outer, low), (outer, high), (inner, high), (inner, low)];
    let corners = rims.iter().flat_map(|&(radius, z)| circle(radius, z, 0.0, ROUND)).collect();
    let mut faces = Vec::new();
    for index in 0..rims.len() {
        band(&mut faces, [index * ROUND, (index + 1) % rims.len() * ROUND], ROUND);
    }
    Mesh { corners, faces, lines: Vec::new(), is_closed: true }
}

pub(super) fn cuboid(sides: Vector) -> Mesh {
    let corners = (0..8).map(|index: usize| {
        corner(
            [0, 1, 2].map(|axis| if index >> axis & 1 == 1 { 0.5 * sides[axis] } else { -0.5 * sides[axis] }),
        )
    });
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    Mesh {
        corners: corners.collect(),
        faces: faces.map(|face| face.to_vec()).into(),
        lines: Vec::new(),
        is_closed: true,
    }
}

/// Returns an ellipsoid with these semi-axes about the origin.
fn ellipsoid(axes: Vector, count: usize, rings: usize) -> Mesh {
    let circles: Vec<_> = (1..rings)
        .map(|ring| {
            let (sin, cos) = (PI * ring as f64 / rings as f64).sin_cos();
            (sin, -cos, 0.0)
        })
        .collect();
    let mut mesh = pointed(&circles, (1.0, 0.0), count);
    // The flat end below is also replaced by a tip.
    mesh.faces.retain(|face| face.len() != count);
    let tip = mesh.corners.len();
    mesh.corners.push(corner([0.0, 0.0, -1.0]));
    mesh.faces.extend((0..count).map(|index| vec![(index + 1) % count, index, tip]));
    for Corner { at, .. } in &mut mesh.corners {
        *at = [0, 1, 2].map(|axis| axes[axis] * at[axis]);
    }
    mesh
}

/// Returns a sphere with smaller faces than those of solids.
pub(super) fn large_sphere(radius: f64) -> Mesh {
    ellipsoid([radius; 3], LARGE_ROUND, LARGE_RINGS)
}

/// Returns a small sphere.
pub(super) fn ball(radius: f64) -> Mesh {
    ellipsoid([radius; 3], SMALL_ROUND, SMALL_RINGS)
}

fn rod_along_x(length: f64, radius: f64) -> Mesh {
    let rod = cylinder(radius, [-0.5 * length, 0.5 * length], SMALL_ROUND);
    // Maps z to x, x to y, and y to z.
    rod.placed([0.0; 3], &[[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
}

/// Returns a short cylinder about z.
pub(super) fn pin(radius: f64, height: f64) -> Mesh {
    cylinder(radius, [-0.5 * height, 0.5 * height], SMALL_ROUND)
}

/// Returns a rod from one point to another.
pub(super) fn stick(radius: f64) -> Mesh {
    turned(&[(radius, 0.0, 0.0), (radius, 0.0, 1.0)], SMALL_ROUND)
}

/// Returns a coil spring from one point to another.
pub(super) fn spring(radius: f64) -> Mesh {
    let steps = WINDINGS * SMALL_ROUND;
    let winding = (0..=steps).map(|index| {
        let part = index as f64 / steps as f64;
        let (sin, cos) = (TAU * (index % SMALL_ROUND) as f64 / SMALL_ROUND as f64).sin_cos();
        Corner { at: [radius * cos, radius * sin, 0.0], share: STRAIGHT + (1.0 - 2.0 * STRAIGHT) * part }
    });
    let on_axis = |share: f64| Corner { at: [0.0; 3], share };
    let corners: Vec<Corner> = [on_axis(0.0), on_axis(STRAIGHT)]
        .into_iter()
        .chain(winding)
        .chain([on_axis(1.0 - STRAIGHT), on_axis(1.0)])
        .collect();
    let line = (0..corners.len()).collect();
    Mesh { corners, faces: Vec::new(), lines: vec![line], is_closed: false }
}

/// Returns a damper from one point to another: a cylinder at the first, a piston rod at the second.
pub(super) fn damper(radius: f64) -> Mesh {
    let cylinder = turned(&[(radius, 0.0, 0.25), (radius, 0.0, 0.65)], SMALL_ROUND);
    let thin = 0.25 * radius;
    let rods = [[0.0, 0.25], [0.65, 1.0]]
        .map(|[from, to]| turned(&[(thin, 0.0, from), (thin, 0.0, to)], SMALL_ROUND));
    rods.into_iter().fold(cylinder, Mesh::with)
}

/// Length of an arrowhead relative to the radius of its shaft.
const HEAD: f64 = 9.0;
/// Width of an arrowhead relative to the radius of its shaft.
const WIDTH: f64 = 3.2;
/// Length of an arrow below which its head would exceed its allowed fraction of the arrow, relative
/// to the radius of its shaft.
pub(super) const SHORTEST_ARROW: f64 = 1.6 * HEAD;

/// Returns the outline of a cone with its apex at the origin, as high as its stretch.
pub(super) fn cone_outline(radius: f64) -> Mesh {
    let mut corners: Vec<Corner> = circle(radius, 0.0, 1.0, ROUND).collect();
    corners.push(corner([0.0; 3]));
    let rim = (0..=ROUND).map(|index| index % ROUND).collect();
    let sides = (0..ROUND).step_by(ROUND / 4).map(|index| vec![ROUND, index]);
    Mesh { corners, faces: Vec::new(), lines: [rim].into_iter().chain(sides).collect(), is_closed: false }
}

/// Returns an arrow from one point to another.
pub(super) fn arrow(radius: f64) -> Mesh {
    let neck = -HEAD * radius;
    let circles = [(radius, 0.0, 0.0), (radius, neck, 1.0), (WIDTH * radius, neck, 1.0)];
    pointed(&circles, (0.0, 1.0), SMALL_ROUND)
}

/// Returns an arrow with two heads, one after the other, the symbol of a moment.
pub(super) fn double_arrow(radius: f64) -> Mesh {
    let [neck, middle] = [-HEAD * radius, -0.5 * HEAD * radius];
    let circles = [
        (radius, 0.0, 0.0),
        (radius, neck, 1.0),
        (WIDTH * radius, neck, 1.0),
        (radius, middle, 1.0),
        (WIDTH * radius, middle, 1.0),
    ];
    pointed(&circles, (0.0, 1.0), SMALL_ROUND)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::{arrow, ball, cuboid, damper, double_arrow, pin, solid, stick};
    use crate::geometry::{dot, subtract};
    use crate::space::mesh::{Mesh, normal};
    use crate::space::vector::{Vector, cross};
    use lagrange_runtime::scene::Solid;

    const SOLIDS: [Solid<f64>; 10] = [
        Solid::PointMass,
        Solid::SlenderRod(2.0),
        Solid::Sphere(1.5),
        Solid::Ellipsoid(1.0, 2.0, 3.0),
        Solid::Cuboid(1.0, 2.0, 3.0),
        Solid::Disk(1.0),
        Solid::Ring(1.0),
        Solid::Cylinder(0.5, 2.0),
        Solid::HollowCylinder(0.5, 1.0, 2.0),
        Solid::Cone(1.0, 2.0),
    ];

    fn points(mesh: &Mesh, face: &[usize]) -> Vec<Vector> {
        face.iter()
            .map(|&index| mesh.corners[index])
            .map(|corner| {
                let [x, y, z] = corner.at;
                [x, y, z + 20.0 * corner.share]
            })
            .collect()
    }

    /// Computes ∭ dV by the divergence theorem: a sixth of the sum of a·(b × c) over triangles.
    fn volume(mesh: &Mesh) -> f64 {
        let of_face = |face: &Vec<usize>| {
            let points = points(mesh, face);
            (1..points.len() - 1).map(|k| dot(points[0], cross(points[k], points[k + 1])) / 6.0).sum::<f64>()
        };
        mesh.faces.iter().map(of_face).sum()
    }

    #[test]
    fn every_surface_is_closed_and_its_faces_are_plane() {
        let others = [
            arrow(0.1),
            double_arrow(0.1),
            damper(0.1),
            stick(0.1),
            pin(0.1, 1.0),
            ball(1.0),
            cuboid([1.0; 3]),
        ];
        for mesh in SOLIDS.map(|kind| solid(kind, 0.1)).into_iter().chain(others) {
            let mut sides: BTreeMap<[usize; 2], i32> = BTreeMap::new();
            for face in &mesh.faces {
                for (k, &a) in face.iter().enumerate() {
                    let b = face[(k + 1) % face.len()];
                    *sides.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
                }
                let points = points(&mesh, face);
                let normal = normal(&points).expect("has an area");
                let heights = points.iter().map(|point| dot(normal, subtract(*point, points[0])).abs());
                assert!(heights.fold(0.0, f64::max) < 1e-12);
            }
            assert!(
                sides.values().all(|count| *count == 0),
                "each side is gone along once in each direction"
            );
            assert!(volume(&mesh) > 0.0, "faces are counterclockwise from outside");
        }
    }

    #[test]
    fn volumes_are_those_of_the_solids() {
        use std::f64::consts::PI;
        let exact = [
            (Solid::Sphere(1.5), 4.5 * PI),
            (Solid::Ellipsoid(1.0, 2.0, 3.0), 8.0 * PI),
            (Solid::Cuboid(1.0, 2.0, 3.0), 6.0),
            (Solid::Cylinder(0.5, 2.0), 0.5 * PI),
            (Solid::HollowCylinder(0.5, 1.0, 2.0), 1.5 * PI),
            (Solid::Cone(1.0, 2.0), 2.0 / 3.0 * PI),
        ];
        for (kind, exact) in exact {
            let volume = volume(&solid(kind, 0.0));
            assert!((0.95..=1.0 + 1e-12).contains(&(volume / exact)), "{kind:?}: {volume} of {exact}");
        }
    }
}
