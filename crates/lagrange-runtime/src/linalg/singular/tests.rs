//! Small systems that may be singular.

use crate::linalg::singular::solve;

#[test]
fn regular_systems_are_solved() {
    let x: [f64; 3] = solve(&[[2.0, 1.0, 0.0], [1.0, 3.0, -1.0], [0.0, 1.0, 1.0]], &[4.0, 4.0, 5.0], 3, 0.0);
    for (x, wanted) in x.iter().zip([1.0, 2.0, 3.0]) {
        assert!((x - wanted).abs() < 1e-14, "{x}");
    }
}

#[test]
fn the_shortest_of_many_solutions_is_taken() {
    let x: [f64; 3] = solve(&[[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 2.0]], &[3.0, 3.0, 4.0], 3, 0.0);
    for (x, wanted) in x.iter().zip([1.5, 1.5, 2.0]) {
        assert!((x - wanted).abs() < 1e-14, "{x}");
    }
    // Four legs of a table with an unsymmetrical load: the shortest of all forces in equilibrium is
    // an affine function of the place.
    let place = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]];
    let g = |i: usize, j: usize| 1.0 + place[i][0] * place[j][0] + place[i][1] * place[j][1];
    let matrix = core::array::from_fn(|i| core::array::from_fn(|j| g(i, j)));
    let right = core::array::from_fn(|i| 2.0 + 0.4 * place[i][0] - 0.8 * place[i][1]);
    let x: [f64; 4] = solve(&matrix, &right, 4, 0.0);
    for (i, x) in x.iter().enumerate() {
        let wanted = 0.5 + 0.1 * place[i][0] - 0.2 * place[i][1];
        assert!((x - wanted).abs() < 1e-14, "{x} for {wanted}");
    }
}

/// The third equation is the sum of the others, but a small pivot precedes its own.
#[test]
fn a_small_pivot_does_not_hide_dependence() {
    for small in [1e-3, 1e-6, 1e-9, 1e-12] {
        let (first, second) = ([1.0, 1.0, 0.1], [1.0, 1.0 + small, 0.3]);
        let third = core::array::from_fn(|k| first[k] + second[k]);
        let x: [f64; 3] = solve(&[first, second, third], &[1.0, 2.0, 3.0], 3, 0.0);
        assert!((x[0] + x[1] + 0.1 * x[2] - 1.0).abs() < 1e-12, "{small} {x:?}");
        // The shortest solution has no component in the direction left free by all equations.
        let free = [-(1.0 + small) * 0.1 + 0.3, -0.2, small];
        let part = x.iter().zip(&free).map(|(x, free)| x * free).sum::<f64>();
        assert!(part.abs() < 1e-9, "{small} {part}");
    }
}

#[test]
fn unsolvable_systems_give_nan() {
    let impossible: [f64; 2] = solve(&[[1.0, 1.0], [1.0, 1.0]], &[1.0, 2.0], 2, 0.0);
    assert!(impossible.iter().all(|x| x.is_nan()));
    let broken: [f64; 2] = solve(&[[1.0, f64::NAN], [1.0, 1.0]], &[1.0, 2.0], 2, 0.0);
    assert!(broken.iter().all(|x| x.is_nan()));
    let zero: [f64; 2] = solve(&[[0.0; 2]; 2], &[0.0; 2], 2, 0.0);
    assert_eq!(zero, [0.0; 2]);
}

/// Rows and columns of zeros after the first `count` change nothing, for regular and for singular
/// equations.
#[test]
fn only_the_first_equations_count() {
    for last in [2.0, 1.0] {
        let (small, large) = ([[1.0, 1.0], [1.0, last]], [[1.0, 1.0, 0.0], [1.0, last, 0.0], [0.0; 3]]);
        let [x, y] = solve(&small, &[3.0, 3.0], 2, 0.0);
        assert_eq!(solve(&large, &[3.0, 3.0, 0.0], 2, 0.0), [x, y, 0.0]);
    }
    assert_eq!(solve(&[[0.0; 2]; 2], &[0.0; 2], 0, 0.0), [0.0; 2]);
}
