//! Responses by one factorisation of the mass matrix.

use super::systems::{TestTerms, nothing};
use crate::contact::{ForcedTerms, Terms};

#[test]
fn responses_solve_the_equations_of_definite_and_indefinite_masses() {
    let rows = [[0.0, 1.0, 0.0], [1.0, -2.0, 0.5]];
    let masses = [
        [[4.0, 1.0, 0.5], [1.0, 3.0, -1.0], [0.5, -1.0, 2.0]],
        [[0.0, 1.0, 0.5], [1.0, -3.0, -1.0], [0.5, -1.0, 2.0]],
    ];
    for mass in masses {
        let terms: TestTerms<3, 2> = ForcedTerms::new(Terms { rows, ..nothing() }, mass).accelerated();
        for (row, response) in rows.iter().zip(terms.responses) {
            for (entry, line) in row.iter().zip(mass) {
                let product = line.iter().zip(response).map(|(m, w)| m * w).sum::<f64>();
                assert!((product - entry).abs() < 1e-15, "{product} for {entry}");
            }
        }
    }
    let terms: TestTerms<2, 1> = Terms { rows: [[1.0, 0.0]], ..nothing() };
    let singular = ForcedTerms::new(terms, [[1.0; 2]; 2]).accelerated();
    assert!(!singular.responses[0][0].is_finite());
}

#[test]
fn no_step_is_too_long_for_a_damper() {
    let terms: TestTerms<1, 1> = Terms { free: [-24.0], rows: [[1.0]], ..nothing() };
    let damped = |h: f64| ForcedTerms::damped(terms, [[2.0]], &[[6.0]], h).accelerated();
    assert_eq!((damped(1.0).free, damped(1.0).responses), ([-3.0], [[0.125]]));
    assert_eq!(damped(0.0), ForcedTerms::new(terms, [[2.0]]).accelerated());
}

/// Products of rows and responses do not depend on the coordinates, and velocities return.
#[test]
fn coordinates_in_which_the_inertia_is_one_keep_all_products() {
    // Two branches on a base of two degrees of freedom, and more rows than are solved together.
    let mass = [[5.0, 1.0, 0.5, 0.25], [1.0, 4.0, -0.5, 0.75], [0.5, -0.5, 2.0, 0.0], [0.25, 0.75, 0.0, 3.0]];
    let rows: [[f64; 4]; 7] =
        std::array::from_fn(|k| std::array::from_fn(|i| ((3 * k + i * i) % 5) as f64 - 2.0));
    let mut terms: TestTerms<4, 7> = Terms { rows, free: [1.0, -2.0, 3.0, 0.5], ..nothing() };
    terms.rows[6] = [0.0, 0.0, 1.0, 0.0];
    let plain = ForcedTerms::new(terms, mass).accelerated();
    let mut forced = ForcedTerms::new(terms, mass);
    let (normal, metric) = forced.normalise();
    metric.respond(normal, &[true, true, false, true, true, true, true]);
    assert!(metric.is_normal() && normal.rows == plain.rows && normal.responses[2] == [0.0; 4]);
    let product = |a: &[f64; 4], b: &[f64; 4]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    for k in (0..7).filter(|k| *k != 2) {
        for j in (0..7).filter(|j| *j != 2) {
            let one = product(&plain.rows[k], &plain.responses[j]);
            let other = product(&normal.responses[k], &normal.responses[j]);
            assert!((one - other).abs() < 1e-14, "{one} {other}");
        }
        let velocities = metric.velocities(normal.responses[k]);
        let pairs = velocities.iter().zip(plain.responses[k]);
        assert!(pairs.into_iter().all(|(one, other)| (one - other).abs() < 1e-14));
    }
    assert_eq!(normal.responses[6][3], 0.0, "the other branch");
    assert_eq!(normal.free, plain.free);
}

/// Without a positive definite inertia, coordinates are the velocities.
#[test]
fn coordinates_of_indefinite_and_missing_inertias_are_velocities() {
    let terms: TestTerms<2, 1> = Terms { rows: [[1.0, 0.0]], free: [2.0, 3.0], ..nothing() };
    let mut forced = ForcedTerms::new(terms, [[-1.0, 0.0], [0.0, 2.0]]);
    let (indefinite, metric) = forced.normalise();
    assert_eq!((indefinite.free, indefinite.responses), ([-2.0, 1.5], [[-1.0, 0.0]]));
    assert_eq!(metric.velocities([4.0, 5.0]), [4.0, 5.0]);
    let mut complete = ForcedTerms::complete(terms);
    let (complete, metric) = complete.normalise();
    assert_eq!(metric.velocities([4.0, 5.0]), [4.0, 5.0]);
    assert!(complete.free == [2.0, 3.0] && !metric.is_normal());
}
