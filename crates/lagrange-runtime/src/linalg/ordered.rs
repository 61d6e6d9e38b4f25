//! Linear equations whose unknowns are eliminated in their order, without exchanges where possible.

use crate::linalg::singular::regular;
use crate::linalg::vector::{UNROLLED, add_scaled, inner};
use crate::scalar::Scalar;

/// The smallest pivot, relative to one, by which an unknown is eliminated in its order.
const LEAST_PIVOT: f64 = 0.5;

/// Solves A x = b for a matrix that exceeds the unit matrix, such as 1 + Jᵀ J. Unknowns are
/// eliminated from the last to the first, so zeros between branches of a tree remain zeros. If a
/// pivot is too small for that, rows are exchanged. NaN if A is singular.
pub(crate) fn solve_in_order<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K]) -> [S; K] {
    eliminated(*a, *b).unwrap_or_else(|| regular(a, b, K))
}

fn eliminated<S: Scalar, const K: usize>(mut a: [[S; K]; K], mut x: [S; K]) -> Option<[S; K]> {
    for k in (0..K).rev() {
        // A copy is known to be apart from the lines, so that loops become vector instructions.
        let row = a[k];
        if !(row[k] >= S::from_f64(LEAST_PIVOT) && row[k].is_finite()) {
            return None;
        }
        let (reciprocal, end) = (S::ONE / row[k], if const { K <= UNROLLED } { K } else { k });
        for (i, line) in a[..k].iter_mut().enumerate().filter(|(_, line)| line[k] != S::ZERO) {
            let multiple = -(line[k] * reciprocal);
            add_scaled(&mut line[..end], multiple, &row[..end]);
            x[i] = multiple.multiply_add(x[k], x[i]);
        }
        a[k][k] = reciprocal;
    }
    for k in 0..K {
        x[k] = (x[k] - inner(&a[k][..k], &x[..k])) * a[k][k];
    }
    Some(x)
}

#[cfg(test)]
mod tests;
