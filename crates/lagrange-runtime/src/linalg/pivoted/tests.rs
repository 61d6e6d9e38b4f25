//! Factors of matrices that need pivoting, and of singular matrices.

use super::{ComplexFactors, Factors, Matrix};

/// A matrix in which every row must be exchanged.
const REAL: [[f64; 3]; 3] = [[0.0, 2.0, 1.0], [1e-20, 1.0, -1.0], [3.0, 0.5, 2.0]];
const IMAGINARY: [[f64; 3]; 3] = [[0.0, 0.3, -0.2], [0.7, 0.0, 0.4], [-1.0, 0.2, 0.0]];

fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).fold(0.0, |largest, (a, b)| largest.max((a - b).abs()))
}

#[test]
fn a_solution_satisfies_its_equations() {
    let matrix = Matrix::<f64, [f64; 3]>(REAL);
    let right = [1.0, -2.0, 0.25];
    let solution = Factors::new(matrix.clone()).expect("regular").solve(&right);
    assert!(difference(matrix.apply(&solution), right) < 1e-15);
}

#[test]
fn a_complex_solution_satisfies_its_equations() {
    let (real, imaginary) = (Matrix::<f64, [f64; 3]>(REAL), Matrix(IMAGINARY));
    let right = ([1.0, -2.0, 0.25], [0.5, 3.0, -1.0]);
    let (x, y) =
        ComplexFactors::new(real.clone(), imaginary.clone()).expect("regular").solve((&right.0, &right.1));
    let subtract = |a: [f64; 3], b: [f64; 3]| core::array::from_fn(|i| a[i] - b[i]);
    let add = |a: [f64; 3], b: [f64; 3]| core::array::from_fn(|i| a[i] + b[i]);
    assert!(difference(subtract(real.apply(&x), imaginary.apply(&y)), right.0) < 1e-14);
    assert!(difference(add(real.apply(&y), imaginary.apply(&x)), right.1) < 1e-14);
}

#[test]
fn singular_matrices_and_those_that_are_not_finite_have_no_factors() {
    let zero = Matrix::<f64, [f64; 2]>::ZERO;
    for matrix in [
        [[1.0, 2.0], [2.0, 4.0]],
        [[0.0, 0.0], [0.0, 1.0]],
        [[f64::NAN, 1.0], [1.0, 1.0]],
        [[1.0, 1.0], [f64::NAN, 1.0]],
        [[1.0, f64::INFINITY], [1.0, 1.0]],
        [[1.0, 1.0], [1.0, f64::NAN]],
    ] {
        assert!(Factors::<f64, [f64; 2]>::new(Matrix(matrix)).is_none(), "{matrix:?}");
        assert!(ComplexFactors::<f64, [f64; 2]>::new(Matrix(matrix), zero.clone()).is_none(), "{matrix:?}");
    }
}

#[test]
fn a_product_of_matrices_applies_one_after_the_other() {
    let (first, second) = (Matrix::<f64, [f64; 3]>(REAL), Matrix(IMAGINARY));
    let x = [1.0, -2.0, 0.25];
    assert!(difference(second.times(&first).apply(&x), second.apply(&first.apply(&x))) < 1e-14);
    assert_eq!(Matrix::identity(&[0.0; 3]).times(&first).0, REAL);
}
