//! Derivatives of the inverse dynamics beside its differences.

use lagrange_core::pipeline::NumericSystem;

use crate::coriolis::{ARM, CART, FREE, assert_near, moved, slope, states};
use crate::random::Random;
use crate::regressor::numeric;

/// Returns the derivatives by differences: columns for displacements, states and velocities.
fn differences(system: &NumericSystem, (t, q, v, a): (f64, &[f64], &[f64], &[f64])) -> Vec<Vec<f64>> {
    let (n, states) = (v.len(), system.programs().variables.first_order_states);
    let unit =
        |count: usize, place: usize| (0..count).map(|k| f64::from(u8::from(k == place))).collect::<Vec<_>>();
    let torques = |q: &[f64], v: &[f64]| system.inverse_dynamics(t, q, v, a).expect("it is emitted");
    // Rates of positions are displacements along velocities.
    let displacements = (0..n).map(|k| {
        let mut along = system.position_rates(t, q, &unit(n, k));
        along[q.len() - states..].fill(0.0);
        along
    });
    let of_states = (0..states).map(|k| unit(q.len(), q.len() - states + k));
    let by_places = displacements.chain(of_states).map(|along| slope(|h| torques(&moved(q, &along, h), v)));
    let by_velocities = (0..n).map(|k| slope(|h| torques(q, &moved(v, &unit(n, k), h))));
    by_places.chain(by_velocities).collect()
}

fn assert_derivatives(text: &str) {
    let system = numeric(&format!("{text} emit {{ inverse_dynamics_jacobian }}"));
    let mut random = Random::new(3);
    for (t, q, v) in states(&system, 4) {
        let a = (0..v.len()).map(|_| random.between(-1.2, 1.2)).collect::<Vec<_>>();
        let found = system.inverse_dynamics_jacobian(t, &q, &v, &a).expect("it is requested");
        let columns = differences(&system, (t, &q, &v, &a));
        let rows = (0..v.len()).flat_map(|row| columns.iter().map(move |column| column[row]));
        assert_near(&found, &rows.collect::<Vec<_>>(), 1e-9);
    }
}

#[test]
fn entries_are_slopes_of_the_inverse_dynamics() {
    for text in [CART, ARM, FREE] {
        assert_derivatives(&format!("struct S; {text}"));
        assert_derivatives(&format!("#[accuracy(strict)] struct S; {text}"));
    }
    assert_derivatives(
        "struct S; param k = 3; coord x, y; state m = 2, p; kinetic = 1/2*m*(1 + x^2)*(dot(x)^2 + (2 + sin(t))*dot(y)^2);
         potential = k*x^2*y; force y = p*dot(x)^2; dot(m) = -0.1*m; dot(p) = x - p; dissipation = x^2*dot(y)^2;",
    );
}
