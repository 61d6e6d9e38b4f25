//! Derivatives of events beside formulas by hand and differences of their functions.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::parse;

use crate::coriolis::{assert_near, moved, slope, states};
use crate::regressor::numeric;

/// A bead on a ring that grows, with events of all kinds of functions.
const RING: &str = "struct Ring; param m = 2, g = 9.81; coord x, y; state s = 1;
    kinetic = kinetic_energy(m, dot((x, y))); potential = m*g*y; dissipation = 0.1*dot(x)^2; force y = s;
    constraint ring = x^2 + y^2 - 4 - sin(t); dot(s) = -s;
    event place = x*cos(t) - s^2, falling => record;
    event speed = norm((dot(x), dot(y))) - 3, rising => { s = 2; }
    event pull = ring - 5, rising => stop;
    event drop = ddot(y) + t*g/2, falling => record;
    emit { event_jacobian }";

#[test]
fn entries_are_slopes_of_event_functions() {
    let system = numeric(RING);
    let programs = system.programs();
    for (t, q, v) in states(&system, 6) {
        let at = |y: &[f64], t: f64| system.evaluate(&programs.event_functions, t, &y[..3], &y[3..]);
        let y = [&q[..], &v].concat();
        let mut columns = Vec::new();
        for k in 0..y.len() {
            let along = (0..y.len()).map(|j| f64::from(u8::from(j == k))).collect::<Vec<_>>();
            columns.push(slope(|h| at(&moved(&y, &along, h), t)));
        }
        columns.push(slope(|h| at(&y, t + h)));
        let expected = (0..4).flat_map(|row| columns.iter().map(move |column| column[row]));
        let found = system.product(Product::EventJacobian, t, &q, &v).expect("it is requested");
        assert_near(&found, &expected.collect::<Vec<_>>(), 1e-8);
    }
}

#[test]
fn contacts_have_the_derivatives_of_their_gaps() {
    let ball = numeric(
        "struct Ball; coord x, y = 1; kinetic = 1/2*(dot(x)^2 + dot(y)^2); potential = 9.81*y;
         event top = dot(y), falling => record; event floor = y - sin(x)*t, falling => impact(0.5);
         emit { event_jacobian }",
    );
    let found =
        ball.product(Product::EventJacobian, 2.0, &[0.5, 3.0], &[1.0, -4.0]).expect("it is requested");
    let expected = [0.0, 0.0, 0.0, 1.0, 0.0, -2.0 * 0.5_f64.cos(), 1.0, 0.0, 0.0, -0.5_f64.sin()];
    assert_near(&found, &expected, 1e-15);
}

#[test]
fn systems_without_it_are_refused() {
    for (text, says) in [
        ("coord x; kinetic = dot(x)^2;", "without events"),
        (
            "coord x, y; kinetic = dot(x)^2 + dot(y)^2; event fall = ddot(y) + 1, falling => record;
             event floor = y, falling => impact(0.5);",
            "accelerations jump",
        ),
    ] {
        let system = parse(&format!("struct S; {text} emit {{ event_jacobian }}"));
        let derived = system.and_then(|system| system.derive(StrategyChoice::Cheapest));
        let report = derived.expect_err("a mistake").to_string();
        assert!(report.contains(says), "{report}");
    }
}
