//! A four-bar linkage of three bodies with coordinates of their own and four pins, against a
//! 30-digit trajectory computed from three angles and two constraints.

use std::f64::consts::FRAC_PI_3;

use lagrange::Simulate;

use crate::assert_within;
use crate::references::{Numbers, state};

lagrange::system! {
    /// Uniform bars of 10 kg/m on two fixed pins.
    #[derive(Clone, Debug)]
    struct Linkage;

    param a = 0.1, b = 0.3, c = 0.3, d = 0.4, m1 = 1.0, m2 = 3.0, m3 = 3.0, g = 9.81;
    coord x1, y1, p1, x2, y2, p2, x3, y3, p3;
    gravity = (0, -g);
    body crank { shape: slender_rod(a); mass: m1; center: (x1, y1); angle: p1; }
    body coupler { shape: slender_rod(b); mass: m2; center: (x2, y2); angle: p2; }
    body rocker { shape: slender_rod(c); mass: m3; center: (x3, y3); angle: p3; }
    pin crank.point(-a/2, 0) to (0, 0);
    pin coupler.point(-b/2, 0) to crank.point(a/2, 0);
    pin coupler.point(b/2, 0) to rocker.point(c/2, 0);
    pin rocker.point(-c/2, 0) to (d, 0);
}

/// Returns centres and angles for the angles of the bars, and their rates for rates of the angles.
fn places(linkage: &Linkage, [p1, p2, p3]: [f64; 3], [w1, w2, w3]: [f64; 3]) -> [f64; 18] {
    let &Linkage { a, b, c, d, .. } = linkage;
    let along = |length: f64, angle: f64| [length * angle.cos(), length * angle.sin()];
    let across =
        |length: f64, angle: f64, rate: f64| [-rate * length * angle.sin(), rate * length * angle.cos()];
    let sum = |[x, y]: [f64; 2], [u, v]: [f64; 2]| [x + u, y + v];
    let [x1, y1] = along(a / 2.0, p1);
    let [x2, y2] = sum(along(a, p1), along(b / 2.0, p2));
    let [x3, y3] = sum([d, 0.0], along(c / 2.0, p3));
    let [u1, v1] = across(a / 2.0, p1, w1);
    let [u2, v2] = sum(across(a, p1, w1), across(b / 2.0, p2, w2));
    let [u3, v3] = across(c / 2.0, p3, w3);
    [x1, y1, p1, x2, y2, p2, x3, y3, p3, u1, v1, w1, u2, v2, w2, u3, v3, w3]
}

/// Almost six turns of the crank, with pins closed to rounding.
#[test]
fn bodies_on_pins_move_as_the_linkage_of_the_reference() {
    let linkage = Linkage::default();
    let start = places(&linkage, [0.0, FRAC_PI_3, 2.0 * FRAC_PI_3], [30.0, -10.0, -10.0]);
    let run = linkage.simulate(start).until(1.0).tolerance(1e-13).energy().run().expect("it runs");
    let [p1, p2, p3, w1, w2, w3] = state("four_bar", Numbers::Decimal, 1.0);
    let expected = places(&linkage, [p1, p2, p3], [w1, w2, w3]);
    for (found, expected) in run.last().into_iter().zip(expected) {
        assert_within(1e-11, found, expected);
    }
    let last = LinkageState::from(run.last());
    for residual in linkage.constraints(1.0, &last.coordinates(), &last.velocities()) {
        assert_within(1e-15, residual, 0.0);
    }
    let energy = run.column("energy").expect("it is observed");
    assert_within(1e-12, energy[energy.len() - 1], energy[0]);
}
