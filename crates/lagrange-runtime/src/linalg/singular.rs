//! Small systems of linear equations that may be singular.
//!
//! Regular ones by elimination. Of the solutions of a singular one the shortest, from orthogonal factors of its rows.

use crate::linalg::orthogonal;
use crate::linalg::pivoted::{Factors, Matrix};
use crate::linalg::vector::dot;
use crate::scalar::Scalar;

/// Returns the shortest x with A x = b, or NaN if there is none. Rows and columns are taken to be scaled, so that A has entries of
/// about one. Equations that contradict each other count as rounded where they do so by little beside their terms or `scale`.
pub(crate) fn solve<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], scale: S) -> [S; K] {
    let x = nearest(a, b);
    let size = size(a, b, &x) + scale;
    if residual(a, b, &x) <= size * negligible::<S>().sqrt() { x } else { [S::NAN; K] }
}

/// Solves without checking A x = b: rows that depend on others are omitted, and may contradict
/// these.
pub(crate) fn nearest<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K]) -> [S; K] {
    let negligible = negligible::<S>();
    let factors = Factors::<S, [S; K]>::new(Matrix(*a));
    match factors.filter(|factors| factors.smallest_pivot() > negligible) {
        Some(factors) => factors.solve(b),
        None => orthogonal::OrthogonalFactors::new(*a, negligible).shortest(b),
    }
}

/// Returns the rounding level relative to one: slightly below three quarters of all digits.
pub(crate) fn negligible<S: Scalar>() -> S {
    let root = S::epsilon().sqrt();
    root * root.sqrt()
}

fn residual<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], x: &[S; K]) -> S {
    let rows = a.iter().zip(b);
    rows.fold(S::ZERO, |sum, (row, b)| sum + (dot(row, x) - *b).abs())
}

/// Returns the size of the terms whose difference is the residual.
fn size<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], x: &[S; K]) -> S {
    let terms = |row: &[S; K]| row.iter().zip(x).fold(S::ZERO, |sum, (a, x)| sum + (*a * *x).abs());
    a.iter().zip(b).fold(S::ZERO, |sum, (row, b)| sum + terms(row) + b.abs())
}

#[cfg(test)]
mod tests;
