//! Small systems of linear equations that may be singular.
//!
//! Regular systems are solved by elimination. For singular systems, the shortest solution is
//! computed from orthogonal factors of the rows.

use crate::linalg::orthogonal::OrthogonalFactors;
use crate::linalg::vector::{UNROLLED, add_scaled, dot};
use crate::scalar::Scalar;

/// Returns the shortest x with A x = b, or NaN if there is none. A is assumed to be scaled to
/// entries of about one. Contradictions between equations are attributed to rounding if they are
/// small relative to the terms or `scale`. Only the first `count` rows and columns are nonzero.
pub(crate) fn solve<S: Scalar, const K: usize>(
    a: &[[S; K]; K],
    b: &[S; K],
    count: usize,
    scale: S,
) -> [S; K] {
    let x = nearest(a, b, count);
    let size = size(a, b, &x, count) + scale;
    if residual(a, b, &x, count) <= size * negligible::<S>().sqrt() { x } else { [S::NAN; K] }
}

/// Solves without checking A x = b: dependent rows are omitted and may contradict the others.
pub(crate) fn nearest<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], count: usize) -> [S; K] {
    eliminated(a, b, count, suspect())
        .unwrap_or_else(|| OrthogonalFactors::leading(*a, [count, count], negligible()).shortest(b))
}

/// True if rows of A are dependent, up to rounding.
pub(crate) fn is_singular<S: Scalar, const K: usize>(a: &[[S; K]; K]) -> bool {
    eliminated(a, &[S::ZERO; K], K, suspect()).is_none()
}

/// Solves the first `count` equations of A x = b with a regular A, even if it is nearly singular;
/// NaN if it is singular.
pub(crate) fn regular<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], count: usize) -> [S; K] {
    eliminated(a, b, count, S::ZERO).unwrap_or([S::NAN; K])
}

/// Solves the first `count` equations by elimination with partial pivoting, if all pivots are
/// larger than `least`.
fn eliminated<S: Scalar, const K: usize>(
    a: &[[S; K]; K],
    b: &[S; K],
    count: usize,
    least: S,
) -> Option<[S; K]> {
    let (mut a, mut x) = (*a, *b);
    for k in 0..count {
        let pivot =
            (k..count).fold(k, |best, row| if a[row][k].abs() > a[best][k].abs() { row } else { best });
        a.swap(k, pivot);
        x.swap(k, pivot);
        if !(a[k][k].abs() > least && a[k][k].is_finite()) {
            return None;
        }
        let (pivot_row, reciprocal) = (a[k], S::ONE / a[k][k]);
        let (from, to) = if const { K <= UNROLLED } { (0, K) } else { (k + 1, count) };
        for row in k + 1..count {
            let multiple = -(a[row][k] * reciprocal);
            add_scaled(&mut a[row][from..to], multiple, &pivot_row[from..to]);
            x[row] = multiple.multiply_add(x[k], x[row]);
        }
        a[k][k] = reciprocal;
    }
    for row in (0..count).rev() {
        x[row] = x[row] * a[row][row];
        let known = x[row];
        a[..row].iter().zip(&mut x[..row]).for_each(|(a, x)| *x = (-a[row]).multiply_add(known, *x));
    }
    Some(x)
}

/// Returns the suspect size of pivots. A pivot below it amplifies rounding so much that later
/// pivots may consist of rounding errors only.
fn suspect<S: Scalar>() -> S {
    S::epsilon().sqrt().sqrt()
}

/// Returns the rounding level relative to one: slightly below three quarters of all digits.
pub(crate) fn negligible<S: Scalar>() -> S {
    let root = S::epsilon().sqrt();
    root * root.sqrt()
}

fn residual<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], x: &[S; K], count: usize) -> S {
    let rows = a.iter().zip(b).take(count);
    rows.fold(S::ZERO, |sum, (row, b)| sum + (dot(row, x) - *b).abs())
}

/// Returns the size of the terms whose difference is the residual.
fn size<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], x: &[S; K], count: usize) -> S {
    let terms = |row: &[S; K]| row.iter().zip(x).fold(S::ZERO, |sum, (a, x)| sum + (*a * *x).abs());
    a.iter().zip(b).take(count).fold(S::ZERO, |sum, (row, b)| sum + terms(row) + b.abs())
}

#[cfg(test)]
mod tests;
