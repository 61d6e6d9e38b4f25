//! Andrews' squeezing mechanism as seven bodies, three pins and a spring, against accelerations and
//! multipliers derived independently with many digits (`tests/constrained/andrews_squeezer.json`,
//! like all data there).
//!
//! Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §VII.7, which gives the
//! mass matrix explicitly.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::pairs::assert_all_within;

lagrange::system! {
    /// Bodies are numbered as in the source.
    struct Squeezer;

    param m1 = 0.04325, m2 = 0.00365, m3 = 0.02373, m4 = 0.00706, m5 = 0.07050, m6 = 0.00706, m7 = 0.05498;
    param i1 = 2.194e-6, i2 = 4.410e-7, i3 = 5.255e-6, i4 = 5.667e-7, i5 = 1.169e-5, i6 = 5.667e-7, i7 = 1.912e-5;
    param xa = -0.06934, ya = -0.00227, xb = -0.03635, yb = 0.03273, xc = 0.014, yc = 0.072, c0 = 4530.0, l0 = 0.07785;
    param d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007, ra = 0.00092, ss = 0.035, sa = 0.01874, sb = 0.01043;
    param sc = 0.018, sd = 0.02, ta = 0.02308, tb = 0.00916, u = 0.04, ua = 0.01228, ub = 0.00449, zf = 0.02, zt = 0.04;
    param fa = 0.01421;
    input drive = 0.033;
    coord beta, theta, gamma, phi, delta, omega, eps;

    body k1 { mass: m1; inertia: i1; origin: (0, 0); centroid: (ra, 0); angle: beta; }
    body k2 { mass: m2; inertia: i2; origin: k1.point(rr, 0); centroid: (-da, 0); angle: k1.angle + theta; }
    body k3 { mass: m3; inertia: i3; origin: (xb, yb); centroid: (sa, sb); angle: gamma; }
    body k5 { mass: m5; inertia: i5; origin: (xa, ya); centroid: (ta, tb); angle: delta; }
    body k4 { mass: m4; inertia: i4; origin: k5.point(zt, 0); centroid: (0, ea - e); angle: k5.angle + phi; }
    body k7 { mass: m7; inertia: i7; origin: (xa, ya); centroid: (ua, ub); angle: eps; }
    body k6 { mass: m6; inertia: i6; origin: k7.point(0, -u); centroid: (zf - fa, 0); angle: k7.angle + omega; }
    pin k2.point(-d, 0) to k3.point(0, -ss);
    pin k2.point(-d, 0) to k4.point(0, -e);
    pin k2.point(-d, 0) to k6.point(zf, 0);
    spring { from: (xc, yc); to: k3.point(sd, -sc); stiffness: c0; rest: l0; }
    torque drive on k1;
}

fn numbers<const N: usize>(state: &Value, key: &str) -> [f64; N] {
    let number =
        |value: &Value| value.as_str().and_then(|text| text.parse().ok()).expect("a number in quotes");
    let values = state[key].as_array().expect("a list").iter().map(number).collect::<Vec<f64>>();
    values.try_into().expect("as many as there should be")
}

#[test]
fn bodies_and_pins_make_the_squeezer() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("constrained/andrews_squeezer.json");
    let reference = fs::read_to_string(file).expect("the reference is in place");
    let reference: Value = serde_json::from_str(&reference).expect("valid JSON");
    let states = reference["states"].as_array().expect("states");
    assert!(!states.is_empty());
    for state in states {
        let (q, v) = (numbers(state, "q"), numbers(state, "v"));
        let squeezer = Squeezer::default();
        let accelerations: [f64; 7] = numbers(state, "acceleration");
        let multipliers: [f64; 6] = numbers(state, "multipliers");
        let at = format!("{q:?}, {v:?}");
        assert_all_within(1e-11, &squeezer.acceleration(0.0, &q, &v), &accelerations, &at);
        assert_all_within(1e-11, &squeezer.multipliers(0.0, &q, &v), &multipliers, &at);
    }
}
