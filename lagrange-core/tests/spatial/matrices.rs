//! Matrices of the dynamics of arms against Pinocchio, written by `tools/dynamics_matrices.py`.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};

use crate::cases::{Case, cases};

/// Error relative to the largest entry.
const TOLERANCE: f64 = 2e-15;

fn numeric(case: &Case, products: &[Product]) -> NumericSystem {
    let products = products.iter().map(|product| product.name()).collect::<Vec<_>>().join(", ");
    let text = format!("struct Robot; {} emit {{ {products} }}", case.text);
    let derived = parse(&text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{}: {report}", case.name)))
}

#[track_caller]
fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert!(!expected.is_empty() && found.len() == expected.len());
    let largest = expected.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
    let error = found.iter().zip(expected).fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs()));
    assert!(error < tolerance * largest, "{error:e} of {largest}");
}

#[test]
fn matrices_are_those_of_pinocchio() {
    for case in cases("matrices.txt") {
        let matrices =
            [Product::CoriolisMatrix, Product::InverseMassMatrix, Product::InverseDynamicsJacobian];
        let system = numeric(&case, &matrices);
        for state in &case.states {
            let [q, v] = ["q", "v"].map(|word| state.numbers(word));
            let tolerances = [
                (Product::CoriolisMatrix, TOLERANCE),
                (Product::InverseMassMatrix, TOLERANCE * state.number("condition").expect("a number")),
            ];
            for (product, tolerance) in tolerances {
                let found = system.product(product, 0.0, q, v).expect("it is requested");
                assert_near(&found, state.numbers(product.name()), tolerance);
            }
            let found = system.inverse_dynamics_jacobian(0.0, q, v, state.numbers("wanted"));
            assert_near(
                &found.expect("it is requested"),
                state.numbers("inverse_dynamics_jacobian"),
                TOLERANCE,
            );
        }
    }
}

#[test]
fn centroidal_momenta_are_those_of_pinocchio() {
    let products = [Product::CenterOfMass, Product::CentroidalMomentum, Product::CentroidalMomentumMatrix];
    for case in cases("centroidal.txt") {
        let system = numeric(&case, &products);
        for state in &case.states {
            let [q, v] = ["q", "v"].map(|word| state.numbers(word));
            for product in products {
                let found = system.product(product, 0.0, q, v).expect("it is requested");
                assert_near(&found, state.numbers(product.name()), TOLERANCE);
            }
        }
    }
}
