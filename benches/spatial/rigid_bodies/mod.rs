//! Handwritten dynamics of chains of revolute joints: an expert's code for any such chain.
//!
//! A module, not a separate bench. The algorithms are those of Featherstone, *Rigid Body Dynamics
//! Algorithms* (2008):
//! - recursive Newton–Euler (table 5.1), in the axes of the links;
//! - the composite-rigid-body algorithm (table 6.2), in the axes of the world;
//! - the articulated-body algorithm (table 7.1), in the axes of the links.
//!
//! They are written for speed: arrays on the stack, the number of joints known to the compiler, and
//! symmetric matrices by their six entries. A transform is a rotation and a position. Every joint
//! rotates about the z-axis of its link, so that its motion subspace selects a component. The first
//! link has no velocity but its own rate and nothing to pass on, and is written separately.
//!
//! Numbers of the chain are run-time values, as in every library of dynamics. Unlike emitted code,
//! nothing here knows which of them are 0 or 1, or that a link has no mass. Branches, prismatic
//! joints and contact are not supported.

mod articulated;
mod composite;
mod newton_euler;
mod vectors;

use std::array::from_fn;

use crate::handwritten::{SinCos, fma};
use vectors::{Matrix, Symmetric, Vector, cross_sum, dot, product, scaled, transposed_product};

/// A joint and the link that it carries, in the axes of that link, as in descriptions of robots.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Joint {
    /// Position of the joint on the previous link.
    pub(crate) at: [f64; 3],
    /// Roll, pitch and yaw of the link's axes there.
    pub(crate) turned: [f64; 3],
    /// Index of the axis of rotation among these.
    pub(crate) axis: usize,
    pub(crate) mass: f64,
    pub(crate) centroid: [f64; 3],
    /// About the centroid: xx, yy, zz, xy, xz, yz.
    pub(crate) inertia: [f64; 6],
}

/// A chain of N links, each on a revolute joint on the previous one, under gravity along −z.
#[derive(Clone, Debug)]
pub(crate) struct Chain<const N: usize> {
    links: [Link; N],
    gravity: f64,
}

/// A link in axes in which it rotates about z.
#[derive(Clone, Copy, Debug, Default)]
struct Link {
    /// Rotation from the axes of the previous link to those of this one at angle 0, in rows.
    turned: Matrix,
    /// Position of the joint, in the axes of the previous link.
    at: Vector,
    mass: f64,
    /// Mass times centroid.
    first_moment: Vector,
    /// About the joint.
    inertia: Symmetric,
    /// ∫ x xᵀ dm about the joint.
    second_moment: Symmetric,
}

impl<const N: usize> Chain<N> {
    pub(crate) fn new(joints: &[Joint; N], gravity: f64) -> Self {
        const { assert!(N > 1, "the first link is written apart") }
        let mut links = [Link::default(); N];
        let mut before = 2;
        for (link, joint) in links.iter_mut().zip(joints) {
            *link = Link::new(joint, before);
            before = joint.axis;
        }
        Self { links, gravity }
    }
}

impl Link {
    fn new(joint: &Joint, axis_before: usize) -> Link {
        let [before, own] = [cycled(axis_before), cycled(joint.axis)];
        let [xx, yy, zz, xy, xz, yz] = joint.inertia;
        let about_centroid = Symmetric { xx, yy, zz, xy, xz, yz }.turned_back(&own);
        let centroid = transposed_product(&own, joint.centroid);
        let square = dot(centroid, centroid);
        let at_centroid = Symmetric::from_entries(|i, j| {
            joint.mass * (if i == j { square } else { 0.0 } - centroid[i] * centroid[j])
        });
        let inertia = about_centroid.plus(at_centroid);
        let half_trace = (inertia.xx + inertia.yy + inertia.zz) / 2.0;
        let rows = inertia.rows();
        Link {
            // (A₀ᵀ P A)ᵀ with A₀ and A from z to the axes of the joints.
            turned: multiplied(&transposed(&own), &multiplied(&transposed(&oriented(joint.turned)), &before)),
            at: transposed_product(&before, joint.at),
            mass: joint.mass,
            first_moment: scaled(joint.mass, centroid),
            inertia,
            second_moment: Symmetric::from_entries(|i, j| {
                if i == j { half_trace - rows[i][j] } else { -rows[i][j] }
            }),
        }
    }

    /// Returns the rotation from the axes of the previous link to those of this one, in rows.
    #[inline(always)]
    fn rotation(&self, (sin, cos): (f64, f64)) -> Matrix {
        let [x, y, z] = self.turned;
        [
            [fma(cos, x[0], sin * y[0]), fma(cos, x[1], sin * y[1]), fma(cos, x[2], sin * y[2])],
            [fma(cos, y[0], -sin * x[0]), fma(cos, y[1], -sin * x[1]), fma(cos, y[2], -sin * x[2])],
            z,
        ]
    }
}

/// Computes sines and cosines of all joints first. Calls in between would spill all registers in
/// use.
#[inline(always)]
fn sines<F: SinCos, const N: usize>(q: &[f64; N]) -> [(f64, f64); N] {
    let waves = F::of(*q);
    from_fn(|i| F::at(&waves, i))
}

/// Returns the rotation that permutes axes so that z becomes the given one.
fn cycled(axis: usize) -> Matrix {
    let mut matrix = Matrix::default();
    for (column, row) in [(0, axis + 1), (1, axis + 2), (2, axis)] {
        matrix[row % 3][column] = 1.0;
    }
    matrix
}

/// Returns Rz(yaw) Ry(pitch) Rx(roll).
fn oriented([roll, pitch, yaw]: [f64; 3]) -> Matrix {
    let [(sr, cr), (sp, cp), (sy, cy)] = [roll, pitch, yaw].map(f64::sin_cos);
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
}

fn transposed(m: &Matrix) -> Matrix {
    [[m[0][0], m[1][0], m[2][0]], [m[0][1], m[1][1], m[2][1]], [m[0][2], m[1][2], m[2][2]]]
}

fn multiplied(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transposed(b);
    transposed(&columns.map(|column| product(a, column)))
}

/// Returns a moment and a force in the axes of the previous link, about its joint.
#[inline(always)]
fn handed_on(e: &Matrix, at: Vector, [moment, force]: [Vector; 2]) -> [Vector; 2] {
    let force = transposed_product(e, force);
    [cross_sum(at, force, transposed_product(e, moment)), force]
}
