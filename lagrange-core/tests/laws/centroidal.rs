//! Totals of bodies beside formulas by hand and laws of momentum.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};

use crate::coriolis::{FREE, assert_near, moved, slope, states};
use crate::regressor::numeric;

const ASKED: &str = "emit { center_of_mass, centroidal_momentum, centroidal_momentum_matrix }";

/// Two bodies in free fall, joined by a hinge with a motor.
const PAIR: &str = "param g = 9.81; coord x, y, a, b; gravity = (0, -g);
    body upper { mass: 2; inertia: 0.3; centroid: (0.1, -0.2); origin: (x, y); angle: a; }
    body lower { mass: 1.5; inertia: 0.2; centroid: (0.4, 0.1); origin: upper.point(0.5, 0.2); angle: a + b; }
    force b = 3*t - dot(b);";

fn of(system: &NumericSystem, product: Product, (t, q, v): (f64, &[f64], &[f64])) -> Vec<f64> {
    system.product(product, t, q, v).expect("it is requested")
}

/// Asserts that in free fall, the mass falls with g and no moment acts about its centre.
fn assert_free_fall(text: &str, (mass, up): (f64, usize)) {
    let system = numeric(&format!("struct S; {text} {ASKED}"));
    for (t, q, v) in states(&system, 6) {
        let momentum = of(&system, Product::CentroidalMomentum, (t, &q, &v));
        let matrix = of(&system, Product::CentroidalMomentumMatrix, (t, &q, &v));
        let product =
            matrix.chunks_exact(v.len()).map(|row| row.iter().zip(&v).map(|(a, v)| a * v).sum::<f64>());
        assert_near(&product.collect::<Vec<_>>(), &momentum, 1e-14);
        let rates = system.position_rates(t, &q, &v);
        let place = slope(|h| of(&system, Product::CenterOfMass, (t, &moved(&q, &rates, h), &v)));
        let linear = place.iter().map(|rate| mass * rate).collect::<Vec<_>>();
        assert_near(&momentum[momentum.len() - place.len()..], &linear, 1e-10);
        let accelerations = system.acceleration(t, &q, &v);
        let change = slope(|h| {
            let (q, v) = (moved(&q, &rates, h), moved(&v, &accelerations, h));
            of(&system, Product::CentroidalMomentum, (t, &q, &v))
        });
        let mut expected = vec![0.0; change.len()];
        expected[up] = -mass * 9.81;
        assert_near(&change, &expected, 1e-9);
    }
}

#[test]
fn momentum_changes_as_forces_say() {
    assert_free_fall(PAIR, (3.5, 2));
    assert_free_fall(FREE, (3.5, 5));
}

#[test]
fn a_pair_of_bodies_in_the_plane_has_the_totals_found_by_hand() {
    let system = numeric(&format!(
        "struct S; coord x, y, a; gravity = (0, -9.81);
         body left {{ mass: 1; inertia: 0.5; center: (x, 0); }}
         body right {{ mass: 3; inertia: 2; center: (2, y); angle: a; }} {ASKED}"
    ));
    let at: (f64, &[f64], &[f64]) = (0.0, &[-2.0, 1.0, 0.3], &[0.5, -1.0, 2.0]);
    assert_near(&of(&system, Product::CenterOfMass, at), &[1.0, 0.75], 1e-15);
    // Lever arms (−3, −0.75) and (1, 0.25), momenta (0.5, 0) and (0, −3).
    assert_near(&of(&system, Product::CentroidalMomentum, at), &[4.0 + 0.375 - 3.0, 0.5, -3.0], 1e-15);
    let matrix = [0.75, 3.0, 2.0, 1.0, 0.0, 0.0, 0.0, 3.0, 0.0];
    assert_near(&of(&system, Product::CentroidalMomentumMatrix, at), &matrix, 1e-15);
}

#[test]
fn systems_without_bodies_have_no_totals() {
    let text = format!("struct S; coord x; kinetic = dot(x)^2; {ASKED}");
    let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let report = derived.expect_err("a mistake").to_string();
    assert!(report.contains("`center_of_mass` is not defined for a system without rigid bodies"), "{report}");
}
