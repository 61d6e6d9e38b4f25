//! The inverse of the mass matrix beside the mass matrix.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::parse;

use crate::coriolis::{ARM, CART, FREE, states};
use crate::regressor::numeric;

/// Roundings of a product with the inverse, for each unit of the condition number.
const ROUNDINGS: f64 = 4.0;

fn norm(rows: &[f64], n: usize) -> f64 {
    rows.chunks_exact(n).map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max)
}

fn assert_inverse(text: &str) {
    let system = numeric(&format!("{text} emit {{ inverse_mass_matrix }}"));
    let n = system.programs().layout.velocities;
    for (t, q, v) in states(&system, 6) {
        let [mass, inverse] = [Product::MassMatrix, Product::InverseMassMatrix]
            .map(|product| system.product(product, t, &q, &v).expect("it is emitted"));
        let allowed = ROUNDINGS * f64::EPSILON * norm(&mass, n) * norm(&inverse, n);
        for place in 0..n * n {
            let (i, j) = (place / n, place % n);
            let entry = (0..n).map(|k| mass[n * i + k] * inverse[n * k + j]).sum::<f64>();
            let error = (entry - f64::from(u8::from(i == j))).abs();
            assert!(error <= allowed, "{error:e} above {allowed:e} in {i} {j} of {text}");
            assert_eq!(inverse[place].to_bits(), inverse[n * j + i].to_bits());
        }
    }
}

#[test]
fn the_product_with_the_mass_matrix_is_the_identity() {
    for text in [CART, ARM, FREE] {
        assert_inverse(&format!("struct S; {text}"));
        assert_inverse(&format!("#[accuracy(strict)] struct S; {text}"));
    }
    assert_inverse("struct S; coord x, y; kinetic = 1/2*(2 + cos(y))*dot(x)^2 + 2*dot(y)^2;");
    // The mass matrix depends on the velocity.
    assert_inverse("struct S; coord x; lagrangian = -sqrt(2 - dot(x)^2);");
}

/// More links than a full matrix is tried for.
#[test]
fn long_chains_are_inverted_link_by_link() {
    assert_inverse(
        "struct S; const n = 24; coord theta[n]; let p[0] = (0, 0);
         for i in 0..n { let p[i+1] = p[i] + (sin(theta[i]), -cos(theta[i])); kinetic = kinetic_energy(1, dot(p[i+1])); }",
    );
}

#[test]
fn constraints_are_no_part_of_it() {
    let pendulum =
        "struct S; param m = 2; coord x, y = -1; kinetic = 1/2*m*(dot(x)^2 + dot(y)^2) + dot(x)*dot(y);
         constraint rod = x^2 + y^2 - 1;";
    assert_inverse(pendulum);
    let massless = "struct S; coord x, y; kinetic = 1/2*dot(x)^2; constraint c = x - y;
         emit { inverse_mass_matrix }";
    let derived = parse(massless).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let report = derived.expect_err("a mistake").to_string();
    assert!(report.contains("only constraints give some motion"), "{report}");
}

#[test]
fn matrices_without_a_sign_are_inverted_too() {
    assert_inverse("struct S; coord x, y; lagrangian = dot(x)*dot(y) - x*y;");
}
