//! Small systems of linear equations that may be singular.
//!
//! Regular ones by elimination. Of the solutions of a singular one the shortest, from the singular value decomposition that
//! rotations of columns give; directions whose singular value is rounding beside the largest are left out.
//! Sources: Hestenes, "Inversion of matrices by biorthogonalization and related results", *J. SIAM* 6 (1958) 51–90; Golub, Van
//! Loan, *Matrix Computations*, 4th ed., §5.5, §8.6.

use core::array;

use crate::integrate::linear::{Factors, Matrix};
use crate::scalar::Scalar;

/// Rotations go over all pairs of columns at most so often; ten times are rare.
const MOST_SWEEPS: u32 = 40;

/// The shortest x with A x = b, or NaN if there is none. Rows and columns are taken to be scaled, so that A has entries of about one.
pub(super) fn solve<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K]) -> [S; K] {
    let x = nearest(a, b);
    if residual(a, b, &x) <= size(a, b, &x) * negligible::<S>().sqrt() { x } else { [S::NAN; K] }
}

/// The shortest x for which A x is nearest to b. Rows and columns are taken to be scaled, so that A has entries of about one.
pub(super) fn nearest<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K]) -> [S; K] {
    let factors = Factors::<S, [S; K]>::new(Matrix(*a));
    match factors.filter(|factors| factors.smallest_pivot() > negligible()) {
        Some(factors) => factors.solve(b),
        None => shortest(a, b),
    }
}

/// What is rounding beside one: a little below the three quarters of all digits.
fn negligible<S: Scalar>() -> S {
    let root = S::epsilon().sqrt();
    root * root.sqrt()
}

/// The shortest of the vectors for which A x is nearest to b.
fn shortest<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K]) -> [S; K] {
    let (columns, rotation) = rotated(a);
    let largest = columns.iter().map(|column| dot(column, column)).fold(S::ZERO, S::max);
    let least = largest * negligible::<S>() * negligible::<S>();
    let mut x = [S::ZERO; K];
    for (column, direction) in columns.iter().zip(&rotation) {
        let square = dot(column, column);
        if square <= least {
            continue;
        }
        let share = dot(column, b) / square;
        for (x, &part) in x.iter_mut().zip(direction) {
            *x = *x + share * part;
        }
    }
    x
}

/// The columns of A V, which are at right angles to each other, and the columns of the rotation V.
fn rotated<S: Scalar, const K: usize>(a: &[[S; K]; K]) -> ([[S; K]; K], [[S; K]; K]) {
    let mut columns: [[S; K]; K] = array::from_fn(|k| array::from_fn(|row| a[row][k]));
    let one = |k, row| if k == row { S::ONE } else { S::ZERO };
    let mut rotation: [[S; K]; K] = array::from_fn(|k| array::from_fn(|row| one(k, row)));
    for _ in 0..MOST_SWEEPS {
        let mut is_done = true;
        for one in 0..K {
            for other in one + 1..K {
                if let Some(angle) = angle(&columns[one], &columns[other]) {
                    rotate(&mut columns, (one, other), angle);
                    rotate(&mut rotation, (one, other), angle);
                    is_done = false;
                }
            }
        }
        if is_done {
            break;
        }
    }
    (columns, rotation)
}

/// Cosine and sine of the angle that makes two columns orthogonal, unless they are.
fn angle<S: Scalar, const K: usize>(one: &[S; K], other: &[S; K]) -> Option<(S, S)> {
    let (alpha, beta, gamma) = (dot(one, one), dot(other, other), dot(one, other));
    let is_orthogonal = gamma.abs() <= S::epsilon() * (alpha * beta).sqrt();
    if is_orthogonal || gamma == S::ZERO {
        return None;
    }
    let zeta = (beta - alpha) / (gamma + gamma);
    let root = zeta.abs() + S::ONE.hypot(zeta);
    let tangent = if zeta < S::ZERO { -(S::ONE / root) } else { S::ONE / root };
    let cosine = S::ONE / S::ONE.hypot(tangent);
    Some((cosine, cosine * tangent))
}

fn rotate<S: Scalar, const K: usize>(
    columns: &mut [[S; K]; K],
    (one, other): (usize, usize),
    (cos, sin): (S, S),
) {
    let (x, y) = (columns[one], columns[other]);
    columns[one] = array::from_fn(|row| cos * x[row] - sin * y[row]);
    columns[other] = array::from_fn(|row| sin * x[row] + cos * y[row]);
}

fn residual<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], x: &[S; K]) -> S {
    let rows = a.iter().zip(b);
    rows.fold(S::ZERO, |sum, (row, b)| sum + (dot(row, x) - *b).abs())
}

/// How large the terms are whose difference is the residual.
fn size<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], x: &[S; K]) -> S {
    let terms = |row: &[S; K]| row.iter().zip(x).fold(S::ZERO, |sum, (a, x)| sum + (*a * *x).abs());
    a.iter().zip(b).fold(S::ZERO, |sum, (row, b)| sum + terms(row) + b.abs())
}

/// a·b
pub(super) fn dot<S: Scalar, const L: usize>(a: &[S; L], b: &[S; L]) -> S {
    a.iter().zip(b).fold(S::ZERO, |sum, (a, b)| a.multiply_add(*b, sum))
}
