//! Rotations: by roll, pitch and yaw, of directions and of tensors of inertia.
//!
//! An entry of a rotation within [`SNAPPED`] of 0, 1 or −1 becomes this number if its whole row or
//! column does. The language itself does the same.

use crate::decimal::Decimal;

/// Tolerance within which an entry is rounded to 0, 1 or −1, and an angle to quarter turns.
pub(crate) const SNAPPED: f64 = 1e-9;
/// Larger angles are not written as fractions of π, since a match is more likely a coincidence.
const MAX_QUARTERS: f64 = 8.0;
/// Fraction of the largest entry of a tensor below which an entry is attributed to cancellation.
const NEGLIGIBLE: f64 = 1e-15;

/// A rotation matrix, by rows.
pub(crate) type Rotation = [[f64; 3]; 3];

/// Computes Rz(yaw) Ry(pitch) Rx(roll).
pub(crate) fn roll_pitch_yaw([roll, pitch, yaw]: [f64; 3]) -> Rotation {
    let ((sr, cr), (sp, cp), (sy, cy)) = (roll.sin_cos(), pitch.sin_cos(), yaw.sin_cos());
    snapped([
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ])
}

/// Computes the rotation of a quaternion x, y, z, w of any length; `None` if the length is zero.
pub(crate) fn from_quaternion(components: [f64; 4]) -> Option<Rotation> {
    if components == [0.0; 4] {
        return None;
    }
    let [x, y, z, w] = direction(components);
    Some(snapped([
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]))
}

fn snapped(rotation: Rotation) -> Rotation {
    let is_axis = |row: &[f64; 3]| row.iter().all(|entry| (entry - entry.round()).abs() < SNAPPED);
    let rounded = |row: [f64; 3]| if is_axis(&row) { row.map(f64::round) } else { row };
    transposed(transposed(rotation.map(rounded)).map(rounded))
}

pub(crate) fn transposed(rotation: Rotation) -> Rotation {
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| rotation[column][row]))
}

pub(crate) fn product(a: Rotation, b: Rotation) -> Rotation {
    let columns = transposed(b).map(|column| applied(a, column));
    transposed(columns)
}

pub(crate) fn applied(rotation: Rotation, vector: [f64; 3]) -> [f64; 3] {
    rotation.map(|row| (0..3).map(|column| row[column] * vector[column]).sum())
}

/// Computes the rotation by an angle about a unit vector.
pub(crate) fn about(axis: [f64; 3], angle: f64) -> Rotation {
    let to_axis = from_z_to(axis);
    product(product(to_axis, roll_pitch_yaw([0.0, 0.0, angle])), transposed(to_axis))
}

/// Returns the roll, pitch and yaw of a rotation; at gimbal lock, where pitch is a quarter turn,
/// roll is zero.
pub(crate) fn angles_of(rotation: Rotation) -> [f64; 3] {
    let [[xx, xy, _], [yx, yy, _], [zx, zy, zz]] = rotation;
    let cosine = xx.hypot(yx);
    if cosine < SNAPPED {
        return [0.0, (-zx).atan2(cosine), (-xy).atan2(yy)];
    }
    [zy.atan2(zz), (-zx).atan2(cosine), yx.atan2(xx)]
}

/// Computes the smallest rotation that maps the z-axis to a unit vector.
pub(crate) fn from_z_to([x, y, z]: [f64; 3]) -> Rotation {
    if z < SNAPPED - 1.0 {
        return [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]];
    }
    let k = 1.0 / (1.0 + z);
    snapped([[1.0 - k * x * x, -k * x * y, x], [-k * x * y, 1.0 - k * y * y, y], [-x, -y, z]])
}

/// Returns the unit vector along a nonzero vector.
pub(crate) fn direction<const N: usize>(vector: [f64; N]) -> [f64; N] {
    let largest = vector.iter().fold(0.0_f64, |largest, component| largest.max(component.abs()));
    let scaled = vector.map(|component| component / largest);
    let length = scaled.iter().map(|component| component * component).sum::<f64>().sqrt();
    scaled.map(|component| component / length)
}

/// Returns the index of the coordinate axis parallel to a unit vector, and true if the two are
/// opposite.
pub(crate) fn coordinate_axis(direction: [f64; 3]) -> Option<(usize, bool)> {
    let is_along = |axis: usize| (0..3).all(|other| other == axis || direction[other].abs() < SNAPPED);
    let axis = (0..3).find(|&axis| is_along(axis))?;
    Some((axis, direction[axis] < 0.0))
}

/// Formats an angle in readable form: quarter turns as fractions of π.
pub(crate) fn angle(angle: &Decimal) -> String {
    let quarters = angle.value() / std::f64::consts::FRAC_PI_2;
    let whole = quarters.round();
    let is_whole = (quarters - whole).abs() * std::f64::consts::FRAC_PI_2 < SNAPPED;
    if !is_whole || whole.abs() > MAX_QUARTERS {
        return angle.to_string();
    }
    let (sign, count) = (if whole < 0.0 { "-" } else { "" }, whole.abs());
    let half_turns = count / 2.0;
    match (count, half_turns.fract() == 0.0) {
        (0.0, _) => "0".to_owned(),
        (1.0, _) => format!("{sign}pi/2"),
        (2.0, _) => format!("{sign}pi"),
        (_, true) => format!("{sign}{half_turns}*pi"),
        (..) => format!("{sign}{count}*pi/2"),
    }
}

/// Computes R J Rᵀ for a tensor xx, yy, zz, xy, xz, yz. If R consists of quarter turns, entries
/// keep their digits as written.
pub(crate) fn turned_tensor(rotation: Rotation, tensor: &[Decimal; 6]) -> [Decimal; 6] {
    const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
    const INDEX: [[usize; 3]; 3] = [[0, 3, 4], [3, 1, 5], [4, 5, 2]];
    let axes = rotation.map(coordinate_axis);
    if let [Some(first), Some(second), Some(third)] = axes {
        let axes = [first, second, third];
        return ENTRIES.map(|(row, column)| {
            let ((i, against), (j, against_too)) = (axes[row], axes[column]);
            let entry = &tensor[INDEX[i][j]];
            if against == against_too { entry.clone() } else { entry.negated() }
        });
    }
    let values = tensor.each_ref().map(Decimal::value);
    let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    ENTRIES.map(|(row, column)| {
        let terms = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
        let sum =
            terms.map(|(i, j)| rotation[row][i] * values[INDEX[i][j]] * rotation[column][j]).sum::<f64>();
        Decimal::of(if sum.abs() < NEGLIGIBLE * largest { 0.0 } else { sum })
    })
}

#[cfg(test)]
mod tests {
    use super::{angle, angles_of, direction, from_z_to, roll_pitch_yaw, transposed, turned_tensor};
    use crate::decimal::Decimal;

    fn assert_close(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) {
        let differences = a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs());
        assert!(differences.fold(0.0, f64::max) < 1e-14, "{a:?} {b:?}");
    }

    #[test]
    fn angles_of_a_rotation_make_it_again() {
        for angles in [[0.3, -0.4, 2.0], [-3.0, 1.2, -1.0], [1.0, std::f64::consts::FRAC_PI_2, 0.5]] {
            let rotation = roll_pitch_yaw(angles);
            assert_close(roll_pitch_yaw(angles_of(rotation)), rotation);
        }
    }

    #[test]
    fn turns_from_z_lead_to_the_direction_and_are_rotations() {
        for vector in
            [[0.0, 0.0, 1.0], [0.0, 0.0, -2.0], [3.0, 0.0, 0.0], [1.0, -2.0, 0.5], [-1.0, 1.0, -1e-3]]
        {
            let (direction, rotation) = (direction(vector), from_z_to(direction(vector)));
            for (row, component) in rotation.iter().zip(direction) {
                assert!((row[2] - component).abs() < 1e-15);
            }
            let product =
                [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| rotation[i][k] * rotation[j][k]).sum()));
            assert_close(product, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        }
    }

    #[test]
    fn quarter_turns_have_names() {
        let cases = [
            ("1.57079632679", "pi/2"),
            ("-1.5707963267948966", "-pi/2"),
            ("3.14159265359", "pi"),
            ("4.71238898038469", "3*pi/2"),
            ("-6.283185307179586", "-2*pi"),
            ("1.5708", "1.5708"),
            ("1e-10", "0"),
            ("0.3", "0.3"),
        ];
        for (text, written) in cases {
            assert_eq!(angle(&Decimal::parse(text).expect("a number")), written);
        }
    }

    #[test]
    fn quarter_turns_of_tensors_move_numbers_and_change_none() {
        let tensor =
            ["1.10", "2.2", "3.3", "0.1", "0.2", "0.3"].map(|text| Decimal::parse(text).expect("a number"));
        // x becomes y, and y becomes −x.
        let turned = turned_tensor(roll_pitch_yaw([0.0, 0.0, std::f64::consts::FRAC_PI_2 + 5e-12]), &tensor);
        assert_eq!(turned.each_ref().map(ToString::to_string), ["2.2", "1.1", "3.3", "-0.1", "-0.3", "0.2"]);
        let rotation = roll_pitch_yaw([0.3, 0.4, 0.5]);
        let back = turned_tensor(transposed(rotation), &turned_tensor(rotation, &tensor));
        for (entry, before) in back.iter().zip(&tensor) {
            assert!((entry.value() - before.value()).abs() < 1e-14);
        }
    }
}
