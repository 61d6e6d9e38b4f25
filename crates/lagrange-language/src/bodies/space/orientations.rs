//! Orientations that are declared by three angles.

use super::inertia::fixed_triple;
use super::numbers::{roll_pitch_yaw, triple_of_numbers, written};
use super::vectors::{Matrix, matrix_product, unit};
use crate::bodies::translation::Translation;
use crate::syntax::ast::AstId;

/// Returns Rz(yaw) Ry(pitch) Rx(roll) for three constant angles; exact for numeric quarter turns.
pub(super) fn orientation(translation: &mut Translation<'_>, angles: AstId, what: &str) -> Matrix {
    let angles = fixed_triple(translation, angles, what);
    if let Some(angles) = triple_of_numbers(translation, angles) {
        return written(&mut translation.terms(), roll_pitch_yaw(angles));
    }
    let mut terms = translation.terms();
    let mut rotation = [0, 1, 2].map(|axis| unit(&mut terms, axis));
    for (axis, angle) in [(2, angles[2]), (1, angles[1]), (0, angles[0])] {
        let [cosine, sine] = terms.direction(angle);
        let mut turn = [0, 1, 2].map(|axis| unit(&mut terms, axis));
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        (turn[next][next], turn[last][last], turn[last][next]) = (cosine, cosine, sine);
        turn[next][last] = terms.negative(sine);
        rotation = matrix_product(&mut terms, rotation, turn);
    }
    rotation
}
