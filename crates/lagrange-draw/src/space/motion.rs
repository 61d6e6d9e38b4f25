//! Tracks of numbers for files: quaternions instead of matrices, and a single value for constants.

use super::mesh::Placement;
use super::recording::MovingMesh;
use super::vector::{Rotation, Vector};

/// A rotation as x, y, z and w = cos(φ/2).
pub(super) type Quaternion = [f64; 4];

/// The motion of a mesh: each quantity has one value per moment, or a single one if it is constant.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Motion {
    pub(super) origins: Vec<Vector>,
    /// Rotations. Neighbours are on the same hemisphere, so that interpolation follows the short
    /// arc.
    pub(super) rotations: Vec<Quaternion>,
    pub(super) stretches: Vec<f64>,
    pub(super) scales: Vec<f64>,
}

impl Motion {
    pub(super) fn of(thing: &MovingMesh) -> Motion {
        let track = &thing.track;
        Motion {
            origins: once(track.iter().map(|placement| placement.origin).collect()),
            rotations: once(rotations(track)),
            stretches: once(track.iter().map(|placement| placement.stretch).collect()),
            scales: once(track.iter().map(|placement| placement.scale).collect()),
        }
    }
}

/// Returns a list, or only its first element if all are equal.
pub(super) fn once<T: PartialEq>(mut values: Vec<T>) -> Vec<T> {
    if values.windows(2).all(|pair| pair[0] == pair[1]) {
        values.truncate(1);
    }
    values
}

fn rotations(track: &[Placement]) -> Vec<Quaternion> {
    let mut before = [0.0, 0.0, 0.0, 1.0];
    let mut next = |placement: &Placement| {
        let quaternion = quaternion(&placement.rotation);
        let is_far = quaternion.iter().zip(before).map(|(a, b)| a * b).sum::<f64>() < 0.0;
        before = if is_far { quaternion.map(|part| -part) } else { quaternion };
        before
    };
    track.iter().map(&mut next).collect()
}

/// Returns the quaternion of a rotation. Source: Shepperd, *Quaternion from Rotation Matrix*,
/// Journal of Guidance and Control 1 (1978).
pub(super) fn quaternion(r: &Rotation) -> Quaternion {
    let trace = r[0][0] + r[1][1] + r[2][2];
    let squares = [r[0][0], r[1][1], r[2][2], trace].map(|part| 1.0 - trace + 2.0 * part);
    let sums = |a: usize, b: usize| r[a][b] + r[b][a];
    let differences = |a: usize, b: usize| r[b][a] - r[a][b];
    let largest = (0..4).max_by(|&a, &b| squares[a].total_cmp(&squares[b])).unwrap_or(3);
    let four = match largest {
        0 => [squares[0], sums(0, 1), sums(0, 2), differences(1, 2)],
        1 => [sums(0, 1), squares[1], sums(1, 2), differences(2, 0)],
        2 => [sums(0, 2), sums(1, 2), squares[2], differences(0, 1)],
        _ => [differences(1, 2), differences(2, 0), differences(0, 1), squares[3]],
    };
    let length = four.iter().map(|part| part * part).sum::<f64>().sqrt();
    four.map(|part| part / length)
}

#[cfg(test)]
mod tests {
    use super::{Quaternion, quaternion};
    use crate::geometry::{length, subtract};
    use crate::space::vector::{Rotation, axes_along};

    /// Computes R = 1 + 2 w [v]× + 2 [v]×².
    fn matrix([x, y, z, w]: Quaternion) -> Rotation {
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    }

    #[test]
    fn a_quaternion_turns_as_its_matrix_does() {
        let half_turns = [[1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]]
            .map(|[x, y, z]| [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]);
        let others =
            [[0.6, 0.0, 0.8], [-0.48, 0.64, -0.6], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]].map(axes_along);
        for rotation in half_turns.into_iter().chain(others) {
            let back = matrix(quaternion(&rotation));
            for (row, wanted) in back.iter().zip(rotation) {
                assert!(length(subtract(*row, wanted)) < 1e-14, "{back:?} of {rotation:?}");
            }
        }
    }
}
