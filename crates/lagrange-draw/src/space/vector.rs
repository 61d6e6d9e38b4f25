//! Rotations in space.

use crate::geometry::{dot, subtract, times, unit};

/// A position or a direction.
pub(crate) type Vector = [f64; 3];
/// A rotation by rows: its columns are the rotated axes.
pub(crate) type Rotation = [Vector; 3];

pub(super) const NONE: Vector = [0.0; 3];
pub(super) const UPRIGHT: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Computes R a.
pub(super) fn apply(rotation: &Rotation, a: Vector) -> Vector {
    rotation.map(|row| dot(row, a))
}

/// Computes Rᵀ a.
pub(super) fn apply_back(rotation: &Rotation, a: Vector) -> Vector {
    apply(&transposed(rotation), a)
}

fn transposed(rotation: &Rotation) -> Rotation {
    [0, 1, 2].map(|column| [0, 1, 2].map(|row| rotation[row][column]))
}

/// Returns axes with the third along a unit vector. The other two jump as the vector crosses the
/// xy-plane. Source: Duff et al., *Building an Orthonormal Basis, Revisited*, Journal of Computer
/// Graphics Techniques 6 (2017), listing 3.
pub(super) fn axes_along([x, y, z]: Vector) -> Rotation {
    let sign = 1.0_f64.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    let (first, second) = ([1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]);
    transposed(&[first, second, [x, y, z]])
}

/// Returns axes with the third along a unit vector, and the first as near as possible to another
/// direction. `None` if both directions are the same.
pub(super) fn axes_near(first: Vector, along: Vector) -> Option<Rotation> {
    let first = unit(subtract(first, times(dot(first, along), along)))?;
    Some(transposed(&[first, cross(along, first), along]))
}

#[cfg(test)]
mod tests {
    use super::{apply, axes_along, cross, transposed};
    use crate::geometry::{dot, length, subtract};

    #[test]
    fn axes_along_a_direction_are_a_rotation_that_takes_z_there() {
        for direction in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.6, 0.0, 0.8], [-0.48, 0.64, -0.6]] {
            let axes = axes_along(direction);
            let [x, y, z] = transposed(&axes);
            assert!(length(subtract(apply(&axes, [0.0, 0.0, 1.0]), direction)) < 1e-15);
            assert!((dot(x, x) - 1.0).abs() < 1e-15 && dot(x, y).abs() < 1e-15);
            assert!(length(subtract(cross(x, y), z)) < 1e-15, "right-handed");
        }
    }
}
