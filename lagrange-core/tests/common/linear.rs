//! Systems of linear equations in many digits.

use crate::digits::{Arithmetic, Real};

/// Returns the solution of M x = b, M in rows; `None` if a pivot vanishes.
pub(crate) fn solve(arithmetic: &Arithmetic, matrix: &[Real], right: &[Real]) -> Option<Vec<Real>> {
    let n = right.len();
    let mut rows = matrix
        .chunks(n)
        .zip(right)
        .map(|(row, b)| [row, std::slice::from_ref(b)].concat())
        .collect::<Vec<_>>();
    for k in 0..n {
        let pivot = (k..n).reduce(|best, i| if larger(&rows[i][k], &rows[best][k]) { i } else { best })?;
        rows.swap(k, pivot);
        let (done, below) = rows.split_at_mut(k + 1);
        let pivot_row = &done[k];
        if pivot_row[k].is_zero() || pivot_row[k].is_nan() || pivot_row[k].is_inf() {
            return None;
        }
        for row in below.iter_mut().filter(|row| !row[k].is_zero()) {
            let factor = arithmetic.divide(&row[k], &pivot_row[k]);
            for (entry, above) in row[k..].iter_mut().zip(&pivot_row[k..]) {
                *entry = arithmetic.subtract(entry, &arithmetic.multiply(&factor, above));
            }
        }
    }
    let mut solution = vec![arithmetic.integer(0); n];
    for k in (0..n).rev() {
        let known = arithmetic.dot(&rows[k][k + 1..n], &solution[k + 1..]);
        solution[k] = arithmetic.divide(&arithmetic.subtract(&rows[k][n], &known), &rows[k][k]);
    }
    Some(solution)
}

fn larger(a: &Real, b: &Real) -> bool {
    // `abs_cmp` of version 0.3.7 compares with signs.
    a.abs().cmp(&b.abs()).is_some_and(|order| order > 0)
}
