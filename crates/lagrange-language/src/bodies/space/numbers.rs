//! Numeric orientations and directions, computed during translation.
//!
//! Quarter turns must stay exact, since an entry of 6e-17 instead of zero makes a rotation matrix
//! dense. Robot descriptions round π/2 to the number of digits that their tool prints. Rows and
//! columns whose entries are all within [`SNAPPED`] of 0, 1 and −1 are replaced by these numbers.

use super::vectors::{Matrix, Triple};
use crate::bodies::constants::number;
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{AstId, Expression};
use lagrange_expr::number::Number;

/// Distance from 0, 1 or −1 within which an entry of a rotation is that number.
const SNAPPED: f64 = 1e-9;

/// Returns the value of an expression that consists of numbers, π and constants.
pub(super) fn value_of_numbers(translation: &Translation<'_>, root: AstId) -> Option<f64> {
    number(&translation.expressions, translation.names.constants(), root)
}

/// True for an expression that is not a vector in space according to its form.
pub(in crate::bodies) fn is_no_vector(translation: &Translation<'_>, id: AstId) -> bool {
    match translation.expressions.get(id) {
        Expression::Tuple(components) => components.len() != 3,
        Expression::Name(name) => translation.names.is_scalar(name),
        _ => value_of_numbers(translation, id).is_some(),
    }
}

/// Returns the components of a numeric vector.
pub(in crate::bodies) fn triple_of_numbers(
    translation: &Translation<'_>,
    vector: Triple,
) -> Option<[f64; 3]> {
    let [x, y, z] = vector.map(|component| value_of_numbers(translation, component));
    Some([x?, y?, z?])
}

/// Returns the entries of a numeric matrix.
pub(super) fn matrix_of_numbers(translation: &Translation<'_>, matrix: Matrix) -> Option<[[f64; 3]; 3]> {
    let [x, y, z] = matrix.map(|row| triple_of_numbers(translation, row));
    Some([x?, y?, z?])
}

/// Returns Rz(yaw) Ry(pitch) Rx(roll), the convention of URDF and of textbooks on aircraft.
pub(super) fn roll_pitch_yaw([roll, pitch, yaw]: [f64; 3]) -> [[f64; 3]; 3] {
    let ((sr, cr), (sp, cp), (sy, cy)) = (roll.sin_cos(), pitch.sin_cos(), yaw.sin_cos());
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
}

/// Returns a rotation, in rows, that maps the z-axis to a direction.
pub(in crate::bodies) fn frame_along(direction: [f64; 3]) -> [[f64; 3]; 3] {
    let z = normalised(direction);
    // Use the coordinate axis that is farthest from the direction.
    let farthest = (0..3).min_by(|&a, &b| z[a].abs().total_cmp(&z[b].abs())).unwrap_or(0);
    let helper = [0, 1, 2].map(|axis| f64::from(u8::from(axis == farthest)));
    let x = normalised(cross(helper, z));
    let y = cross(z, x);
    [0, 1, 2].map(|row| [x[row], y[row], z[row]])
}

fn normalised(vector: [f64; 3]) -> [f64; 3] {
    let length = vector.iter().map(|component| component * component).sum::<f64>().sqrt();
    vector.map(|component| component / length)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        a[next] * b[last] - a[last] * b[next]
    })
}

/// Writes a numeric rotation as syntax, exactly for quarter turns.
pub(in crate::bodies) fn written(terms: &mut TermWriter<'_>, rotation: [[f64; 3]; 3]) -> Matrix {
    let is_whole = |entry: &f64| (entry - entry.round()).abs() < SNAPPED;
    // A row with one entry near 1 whose others do not vanish is a small turn: cosines alone must
    // not be rounded.
    let is_axis = |row: &[f64; 3]| row.iter().all(is_whole);
    let rows = rotation.map(|row| if is_axis(&row) { row.map(f64::round) } else { row });
    let columns = [0, 1, 2].map(|column| rows.map(|row| row[column]));
    let columns = columns.map(|column| if is_axis(&column) { column.map(f64::round) } else { column });
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| written_number(terms, columns[column][row])))
}

/// Writes the shortest decimal that is read as this number.
pub(super) fn written_number(terms: &mut TermWriter<'_>, entry: f64) -> AstId {
    let magnitude = Number::parse_decimal(&format!("{}", entry.abs())).unwrap_or(Number::ZERO);
    let magnitude = terms.number(magnitude);
    if entry < 0.0 { terms.negative(magnitude) } else { magnitude }
}

/// Returns the coordinate axis of a direction, and its sign, if it is along one.
pub(super) fn coordinate_axis(direction: [f64; 3]) -> Option<(usize, bool)> {
    let direction = normalised(direction);
    let is_along = |axis: usize| (0..3).all(|other| other == axis || direction[other].abs() < SNAPPED);
    let axis = (0..3).find(|&axis| is_along(axis))?;
    Some((axis, direction[axis] < 0.0))
}

#[cfg(test)]
mod tests {
    use super::{coordinate_axis, frame_along, roll_pitch_yaw};

    #[test]
    fn orientations_turn_about_x_then_y_then_z() {
        let quarter = std::f64::consts::FRAC_PI_2;
        // The roll maps z to −y, and the yaw maps this to x.
        let rotation = roll_pitch_yaw([quarter, 0.0, quarter]);
        let column = [rotation[0][2], rotation[1][2], rotation[2][2]];
        for (entry, wanted) in column.into_iter().zip([1.0, 0.0, 0.0]) {
            assert!((entry - wanted).abs() < 1e-15, "{column:?}");
        }
    }

    #[test]
    fn frames_along_a_direction_are_right_handed() {
        for direction in [[0.0, 0.0, 2.0], [1.0, 0.0, 0.0], [1.0, -2.0, 3.0], [-1.0, -1.0, 1e-12]] {
            let rows = frame_along(direction);
            let column = |axis: usize| [rows[0][axis], rows[1][axis], rows[2][axis]];
            let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let length = dot(direction, direction).sqrt();
            assert!((dot(column(2), direction) / length - 1.0).abs() < 1e-15);
            let volume = dot(super::cross(column(0), column(1)), column(2));
            assert!((volume - 1.0).abs() < 1e-15, "{direction:?}");
        }
    }

    #[test]
    fn directions_along_axes_are_recognised() {
        assert_eq!(coordinate_axis([0.0, -3.0, 0.0]), Some((1, true)));
        assert_eq!(coordinate_axis([0.0, 1.0, 1.0]), None);
        assert_eq!(coordinate_axis([3e-5, 0.0, 1.0]), None);
    }
}
