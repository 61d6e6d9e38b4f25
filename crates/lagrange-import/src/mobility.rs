//! Directions in which points of links can move, which determine the possible contacts with the
//! ground.
//!
//! A ball at the end of a crane that only rotates about the vertical keeps its height. Velocities
//! are evaluated in two postures without any symmetry: if they are zero in both, they are always
//! zero.

use crate::decimal::Decimal;
use crate::robot::{Joint, Kind, Robot};
use crate::rotation::{Rotation, about, applied, direction, from_z_to, product, roll_pitch_yaw};

/// Velocities for unit rates below this are rounding errors.
const NEGLIGIBLE: f64 = 1e-9;
const POSTURES: usize = 2;

type Vector = [f64; 3];

/// A frame in the world.
#[derive(Clone, Copy)]
struct Pose {
    rotation: Rotation,
    origin: Vector,
}

/// The postures of a robot.
pub(crate) struct Mobility<'r> {
    robot: &'r Robot,
    is_free: bool,
    /// The joint that places each link.
    placed_by: Vec<Option<usize>>,
    /// For each posture, the frame of each link.
    postures: [Vec<Pose>; POSTURES],
}

impl Mobility<'_> {
    pub(crate) fn new(robot: &Robot, is_free: bool) -> Mobility<'_> {
        let mut placed_by = vec![None; robot.links.len()];
        robot.joints.iter().enumerate().for_each(|(index, joint)| placed_by[joint.child] = Some(index));
        let postures = std::array::from_fn(|posture| poses(robot, posture));
        Mobility { robot, is_free, placed_by, postures }
    }

    /// True if the lowest point of a ball in a link can move up and down; true if it can move along
    /// the ground.
    pub(crate) fn moves(&self, link: usize, center: &[Decimal; 3], radius: f64) -> [bool; 2] {
        let center = center.each_ref().map(Decimal::value);
        let mut moves = [self.is_free; 2];
        for poses in &self.postures {
            let Pose { rotation, origin } = poses[link];
            let [x, y, z] = sum(origin, applied(rotation, center));
            let mut carrier = self.placed_by[link];
            while let Some(joint) = carrier.map(|index| &self.robot.joints[index]) {
                let along = velocities(joint, poses[joint.parent], [x, y, z - radius]);
                for [x, y, z] in along {
                    moves[0] |= z.abs() > NEGLIGIBLE;
                    moves[1] |= x.abs().max(y.abs()) > NEGLIGIBLE;
                }
                carrier = self.placed_by[joint.parent];
            }
        }
        moves
    }
}

fn poses(robot: &Robot, posture: usize) -> Vec<Pose> {
    let world = Pose { rotation: from_z_to([0.0, 0.0, 1.0]), origin: [0.0; 3] };
    let mut poses = vec![world; robot.links.len()];
    // Joints follow those that carry them.
    for (index, joint) in robot.joints.iter().enumerate() {
        let positions = [0, 1, 2].map(|axis| (1.7 * (3 * index + axis) as f64 + posture as f64 + 0.3).sin());
        poses[joint.child] = placed(joint, poses[joint.parent], positions);
    }
    poses
}

/// Returns the frame of a joint in the world before it moves.
fn frame(joint: &Joint, parent: Pose) -> Pose {
    let rotation = product(parent.rotation, roll_pitch_yaw(joint.turned.each_ref().map(Decimal::value)));
    let origin = sum(parent.origin, applied(parent.rotation, joint.at.each_ref().map(Decimal::value)));
    Pose { rotation, origin }
}

fn axis(joint: &Joint) -> Vector {
    direction(joint.axis.each_ref().map(Decimal::value))
}

fn placed(joint: &Joint, parent: Pose, positions: Vector) -> Pose {
    let Pose { rotation, origin } = frame(joint, parent);
    let (moved, turned) = match joint.kind {
        Kind::Revolute => ([0.0; 3], about(axis(joint), positions[0])),
        Kind::Prismatic => (axis(joint).map(|component| component * positions[0]), about(axis(joint), 0.0)),
        Kind::Planar => {
            let [x, y, angle] = positions;
            (applied(from_z_to(axis(joint)), [x, y, 0.0]), about(axis(joint), angle))
        }
        Kind::Floating => (positions, roll_pitch_yaw(positions)),
        Kind::Fixed | Kind::Held => return Pose { rotation, origin },
    };
    Pose { rotation: product(rotation, turned), origin: sum(origin, applied(rotation, moved)) }
}

/// Returns velocities of a point for unit rates of a joint. Rotation of a planar joint adds no
/// directions to its translations.
fn velocities(joint: &Joint, parent: Pose, point: Vector) -> Vec<Vector> {
    let Pose { rotation, origin } = frame(joint, parent);
    match joint.kind {
        Kind::Revolute => {
            let ([ax, ay, az], [x, y, z]) = (applied(rotation, axis(joint)), difference(point, origin));
            vec![[ay * z - az * y, az * x - ax * z, ax * y - ay * x]]
        }
        Kind::Prismatic => vec![applied(rotation, axis(joint))],
        Kind::Planar => {
            let rotation = product(rotation, from_z_to(axis(joint)));
            vec![applied(rotation, [1.0, 0.0, 0.0]), applied(rotation, [0.0, 1.0, 0.0])]
        }
        Kind::Floating => vec![[1.0; 3]],
        Kind::Fixed | Kind::Held => Vec::new(),
    }
}

fn sum(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i])
}

fn difference(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}
