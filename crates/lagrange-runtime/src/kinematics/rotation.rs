//! Rotations as vectors.

use crate::scalar::Scalar;

/// Returns the rotation vector, in world axes, that rotates `from` into `to`. Its length is the
/// angle in rad, at most π.
///
/// The quaternion of the rotation is computed from its largest component. Source: Shepperd,
/// "Quaternion from rotation matrix", *J. Guidance and Control* 1 (1978) 223–224.
pub(super) fn rotation_between<S: Scalar>(from: &[[S; 3]; 3], to: &[[S; 3]; 3]) -> [S; 3] {
    let entry = |i: usize, j: usize| (0..3).fold(S::ZERO, |sum, k| sum + to[i][k] * from[j][k]);
    let r = core::array::from_fn::<_, 3, _>(|i| core::array::from_fn::<_, 3, _>(|j| entry(i, j)));
    let [scalar, vector @ ..] = quaternion(&r);
    let length = vector.iter().fold(S::ZERO, |sum, x| x.multiply_add(*x, sum)).sqrt();
    let two = S::from_f64(2.0);
    let factor = match length > S::ZERO {
        true if scalar < S::ZERO => two * (-length).atan2(-scalar) / length,
        true => two * length.atan2(scalar) / length,
        false => two,
    };
    vector.map(|x| factor * x)
}

/// Returns the quaternion of a rotation matrix, scalar part first, up to its length and sign.
fn quaternion<S: Scalar>(r: &[[S; 3]; 3]) -> [S; 4] {
    let trace = r[0][0] + r[1][1] + r[2][2];
    let largest = (0..3).fold(0, |best, i| if r[i][i] > r[best][best] { i } else { best });
    if trace >= r[largest][largest] {
        let difference = |i: usize, j: usize| r[i][j] - r[j][i];
        return [S::ONE + trace, difference(2, 1), difference(0, 2), difference(1, 0)];
    }
    let (i, j, k) = (largest, (largest + 1) % 3, (largest + 2) % 3);
    let mut q = [S::ZERO; 4];
    q[0] = r[k][j] - r[j][k];
    q[1 + i] = S::ONE + r[i][i] - r[j][j] - r[k][k];
    q[1 + j] = r[j][i] + r[i][j];
    q[1 + k] = r[k][i] + r[i][k];
    q
}

/// True if, up to rounding, the rows are orthogonal unit vectors of a right-handed system.
pub(super) fn is_rotation<S: Scalar>(r: &[[S; 3]; 3]) -> bool {
    let inner = |i: usize, j: usize| (0..3).fold(S::ZERO, |sum, k| sum + r[i][k] * r[j][k]);
    let minor = |a: usize, b: usize| r[1][a] * r[2][b] - r[1][b] * r[2][a];
    let volume = r[0][0] * minor(1, 2) + r[0][1] * minor(2, 0) + r[0][2] * minor(0, 1);
    let rounding = S::epsilon().sqrt();
    let is_unit = |i: usize, j: usize| {
        let wanted = if i == j { S::ONE } else { S::ZERO };
        (inner(i, j) - wanted).abs() <= rounding
    };
    volume > S::ZERO && (0..3).all(|i| (i..3).all(|j| is_unit(i, j)))
}

#[cfg(test)]
mod tests {
    use super::{is_rotation, rotation_between};
    use crate::scalar::Number;
    use crate::spread::spread;

    /// Computes the rotation matrix by Rodrigues' formula.
    fn matrix(vector: [f64; 3]) -> [[f64; 3]; 3] {
        let angle = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [x, y, z] = if angle > 0.0 { vector.map(|c| c / angle) } else { [1.0, 0.0, 0.0] };
        let (s, c) = Number::sin_cos(angle);
        let d = 1.0 - c;
        [
            [c + d * x * x, d * x * y - s * z, d * x * z + s * y],
            [d * y * x + s * z, c + d * y * y, d * y * z - s * x],
            [d * z * x - s * y, d * z * y + s * x, c + d * z * z],
        ]
    }

    const UNTURNED: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    #[test]
    fn vectors_of_rotations_are_found_from_none_to_half_a_turn() {
        for point in 0..400 {
            let axis: [f64; 3] = core::array::from_fn(|place| spread(point, place));
            let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            let angles = [0.0, 1e-12, 1e-3, 1.0, 2.0, 3.0, core::f64::consts::PI - 1e-9];
            let vector = axis.map(|x| x / length * angles[point % angles.len()]);
            let base = matrix(core::array::from_fn(|place| 3.0 * spread::<f64>(point, 3 + place)));
            let by = matrix(vector);
            let to = core::array::from_fn(|i| {
                core::array::from_fn(|j| (0..3).map(|k| by[i][k] * base[k][j]).sum::<f64>())
            });
            let found = rotation_between(&base, &to);
            let error = (0..3).map(|i| (found[i] - vector[i]).abs()).fold(0.0, f64::max);
            assert!(error < 1e-13, "{vector:?} {found:?} {error}");
        }
    }

    #[test]
    fn half_a_turn_about_each_axis_has_the_length_pi() {
        for axis in 0..3 {
            let mut half = UNTURNED.map(|row| row.map(|x| -x));
            half[axis][axis] = 1.0;
            let found = rotation_between(&UNTURNED, &half);
            assert!((found[axis].abs() - core::f64::consts::PI).abs() < 1e-15, "{found:?}");
        }
    }

    #[test]
    fn mirrors_and_stretched_axes_are_no_rotations() {
        assert!(is_rotation(&UNTURNED) && is_rotation(&matrix([0.3, -2.0, 0.9])));
        assert!(!is_rotation(&UNTURNED.map(|row| row.map(|x| -x))));
        assert!(!is_rotation(&[[1.0, 0.0, 0.0], [0.0, 1.01, 0.0], [0.0, 0.0, 1.0]]));
        assert!(!is_rotation(&[[f64::NAN; 3]; 3]));
    }
}
