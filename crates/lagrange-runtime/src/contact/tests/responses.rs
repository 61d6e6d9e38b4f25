//! Responses by one factorisation of the mass matrix.

use super::systems::{TestTerms, nothing};
use crate::contact::Terms;

#[test]
fn responses_solve_the_equations_of_definite_and_indefinite_masses() {
    let rows = [[0.0, 1.0, 0.0], [1.0, -2.0, 0.5]];
    let masses = [
        [[4.0, 1.0, 0.5], [1.0, 3.0, -1.0], [0.5, -1.0, 2.0]],
        [[0.0, 1.0, 0.5], [1.0, -3.0, -1.0], [0.5, -1.0, 2.0]],
    ];
    for mass in masses {
        let terms: TestTerms<3, 2> = Terms { rows, ..nothing() }.accelerated(&mass);
        for (row, response) in rows.iter().zip(terms.responses) {
            for (entry, line) in row.iter().zip(mass) {
                let product = line.iter().zip(response).map(|(m, w)| m * w).sum::<f64>();
                assert!((product - entry).abs() < 1e-15, "{product} for {entry}");
            }
        }
    }
    let singular: TestTerms<2, 1> = Terms { rows: [[1.0, 0.0]], ..nothing() }.accelerated(&[[1.0; 2]; 2]);
    assert!(!singular.responses[0][0].is_finite());
}

#[test]
fn no_step_is_too_long_for_a_damper() {
    let terms: TestTerms<1, 1> = Terms { free: [-24.0], rows: [[1.0]], ..nothing() };
    let damped = terms.damped(&[[2.0]], &[[6.0]], 1.0);
    assert_eq!((damped.free, damped.responses), ([-3.0], [[0.125]]));
    assert_eq!(terms.damped(&[[2.0]], &[[6.0]], 0.0), terms.accelerated(&[[2.0]]));
}
