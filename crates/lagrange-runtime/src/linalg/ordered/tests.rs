//! Solutions with and without exchanges of rows.

use super::{eliminated, solve_in_order};

fn residual<const K: usize>(a: &[[f64; K]; K], b: &[f64; K], x: &[f64; K]) -> f64 {
    let errors = a.iter().zip(b).map(|(row, b)| row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>() - b);
    errors.fold(0.0, |largest: f64, error| largest.max(error.abs()))
}

/// Returns 1 + Jᵀ J of two branches on one base, and a skew part.
fn branches(skew: f64) -> [[f64; 4]; 4] {
    let rows = [[1.0, 2.0, 0.0, 0.0], [-3.0, 0.0, 0.5, 0.0], [0.25, 0.0, 0.0, 4.0]];
    let mut matrix: [[f64; 4]; 4] =
        std::array::from_fn(|i| std::array::from_fn(|j| rows.iter().map(|row| row[i] * row[j]).sum()));
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] += 1.0;
    }
    (matrix[0][2], matrix[2][0]) = (matrix[0][2] + skew, matrix[2][0] - skew);
    matrix
}

#[test]
fn matrices_beyond_the_unit_matrix_need_no_exchanges() {
    let b = [1.0, -2.0, 3.0, 0.5];
    for skew in [0.0, 0.7] {
        let matrix = branches(skew);
        let x = eliminated(matrix, b).expect("pivots of at least one");
        assert!(residual(&matrix, &b, &x) < 1e-14, "{x:?}");
        assert_eq!(x, solve_in_order(&matrix, &b));
    }
}

#[test]
fn small_and_negative_pivots_are_exchanged() {
    let b = [1.0, -2.0];
    for matrix in [[[1.0, 2.0], [3.0, 0.0]], [[2.0, 1.0], [1.0, -3.0]], [[1.0, 2.0], [0.5, 1e-9]]] {
        assert_eq!(eliminated(matrix, b), None);
        let x = solve_in_order(&matrix, &b);
        assert!(residual(&matrix, &b, &x) < 1e-14, "{x:?}");
    }
    assert!(solve_in_order(&[[1.0, 2.0], [2.0, 4.0]], &b).iter().any(|x| !x.is_finite()));
    assert!(solve_in_order(&[[f64::NAN, 0.0], [0.0, 1.0]], &b).iter().any(|x| !x.is_finite()));
    assert_eq!(solve_in_order(&[[4.0_f32]], &[2.0]), [0.5]);
}
