//! Equilibria and steady motions in closed form.

use std::f64::consts::PI;

use lagrange::linear::{EquilibriumCause, Linearise};
use lagrange::scalar::Scalar;

lagrange::system! {
    /// Two rods in a plane, by absolute angles from the downward vertical.
    #[derive(Clone, Debug)]
    pub(crate) struct DoublePendulum<S>;

    param m = 1.5, l = 0.8, g = 9.81, pull = 0;
    coord a, b;
    let (x1, y1) = (l * sin(a), -l * cos(a));
    let (x2, y2) = (x1 + l * sin(b), y1 - l * cos(b));
    kinetic = kinetic_energy(m, dot((x1, y1))) + kinetic_energy(m, dot((x2, y2)));
    potential = m * g * (y1 + y2) - pull * x2;
    emit { system_matrix }
}

lagrange::system! {
    /// A bead on a hoop that rotates about its vertical diameter.
    #[derive(Debug)]
    struct Bead;

    param r = 0.5, g = 9.81;
    coord theta, phi;
    kinetic = kinetic_energy(1, dot((r*sin(theta)*cos(phi), r*sin(theta)*sin(phi), -r*cos(theta))));
    potential = -g * r * cos(theta);
    emit { system_matrix }
}

lagrange::system! {
    /// A rotor with two propellers in a vertical plane.
    #[derive(Debug)]
    pub(crate) struct Rotor;

    param m = 1.2, j = 0.02, arm = 0.3, g = 9.81, wind = 0;
    coord x, y, theta;
    input left = 1, right = 1;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/2 * j * dot(theta)^2;
    potential = m * g * y;
    force x = -(left + right) * sin(theta) + wind;
    force y = (left + right) * cos(theta);
    force theta = arm * (right - left);
    output height = y;
    emit { system_matrix }
}

lagrange::system! {
    /// A coil that lifts a weight on a spring.
    #[derive(Debug)]
    pub(crate) struct Magnet;

    param m = 0.1, k = 50, r = 2, strength = 0.3, g = 9.81;
    coord x;
    input voltage;
    state current;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2 - m * g * x;
    force x = -strength * current;
    dot(current) = voltage - r * current - strength * dot(x);
    emit { system_matrix }
}

lagrange::system! {
    /// A body on a ball joint, with its centre of mass off the joint.
    #[derive(Debug)]
    pub(crate) struct Hanging;

    gravity = (0, 0, -9.81);
    body bob { mass: 2; centroid: (0.1, -0.2, 0.2); inertia: (0.03, 0.04, 0.05); }
    ball hook = ground to bob { at: (0, 0, 0); }
    output below = bob.center;
    emit { system_matrix }
}

#[test]
fn hanging_rods_are_pulled_aside_by_the_ratio_of_forces() {
    let rods = DoublePendulum { pull: 3.0, ..DoublePendulum::<f64>::default() };
    let found = rods.equilibrium([0.1, 0.1, 0.0, 0.0]).solve().expect("an equilibrium");
    let weight = rods.m * rods.g;
    let wanted = [(3.0 / (2.0 * weight)).atan(), (3.0 / weight).atan()];
    for (found, wanted) in found.state.into_iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
    }
    assert_eq!((found.freedom, &found.state[2..]), (0, &[0.0, 0.0][..]));
}

#[test]
fn every_corner_of_the_torus_has_an_equilibrium_nearby() {
    for (a, b) in [(0.0, 0.0), (PI, 0.0), (0.0, PI), (PI, PI)] {
        for aside in [0.0, 0.05, -0.3] {
            let near = [a + aside, b - aside, 0.0, 0.0];
            let found = DoublePendulum::<f64>::default().equilibrium(near).solve().expect("an equilibrium");
            assert!((found.state[0] - a).abs() < 1e-15 && (found.state[1] - b).abs() < 1e-15, "{found:?}");
        }
    }
}

#[test]
fn single_precision_gives_its_own_digits() {
    let rods = DoublePendulum { pull: 3.0, ..DoublePendulum::<f32>::default() };
    let found = rods.equilibrium([0.1_f32, 0.1, 0.0, 0.0]).solve().expect("an equilibrium");
    let wanted = (3.0_f32 / (1.5 * 9.81)).atan();
    assert!((found.state[1] - wanted).abs() < 4.0 * f32::EPSILON, "{found:?}");
}

#[test]
fn a_bead_turns_steadily_where_weight_and_rotation_balance() {
    let bead = Bead::default();
    let near = BeadState { theta: 0.8, phi: 2.0, theta_dot: 0.0, phi_dot: 6.0 };
    let found = bead.equilibrium(near).solve().expect("a steady motion");
    let wanted = (bead.g / (bead.r * 36.0)).acos();
    assert!((found.state[0] - wanted).abs() < 1e-15, "{found:?}");
    // Any angle about the axis is an equilibrium, so it keeps its value.
    assert_eq!((found.state[1], found.state[3], found.freedom), (2.0, 6.0, 1));
}

#[test]
fn inputs_are_trimmed_for_a_hover_in_the_wind() {
    let rotor = Rotor { wind: 2.0, ..Rotor::default() };
    let search = rotor.equilibrium([0.3, 1.0, 0.1, 0.0, 0.0, 0.0]).trim(&["left", "right"]);
    let found = search.hold(&["x"]).solve().expect("a hover");
    let weight = rotor.m * rotor.g;
    assert!((found.state[2] - (2.0 / weight).atan()).abs() < 1e-15, "{found:?}");
    for thrust in &found.inputs {
        assert!((thrust - weight.hypot(2.0) / 2.0).abs() < 1e-14, "{found:?}");
    }
    // It hovers at every height, including the nearest one.
    assert_eq!((found.state[0], found.state[1], found.freedom), (0.3, 1.0, 1));
    let trimmed = found.system(&rotor);
    let [.., x, y, theta] = trimmed.rhs(0.0, &found.state);
    assert!(x.abs() + y.abs() + theta.abs() < 1e-13, "{x} {y} {theta}");
}

#[test]
fn first_order_states_and_inputs_are_unknowns() {
    let magnet = Magnet { voltage: 3.0, ..Magnet::default() };
    let found = magnet.equilibrium([0.0, 0.0, 0.0]).solve().expect("an equilibrium");
    let lifted = (magnet.m * magnet.g - magnet.strength * 1.5) / magnet.k;
    assert!((found.state[0] - lifted).abs() < 1e-16 && (found.state[1] - 1.5).abs() < 1e-15, "{found:?}");
    let found = magnet.equilibrium([0.0, 0.0, 0.0]).hold(&["x"]).trim(&["voltage"]).solve().expect("a trim");
    let voltage = magnet.r * magnet.m * magnet.g / magnet.strength;
    assert!((found.inputs[0] - voltage).abs() < 1e-14 * voltage, "{found:?}");
}

#[test]
fn an_orientation_turns_until_the_mass_centre_is_below() {
    let hanging = Hanging;
    let near = [0.1, 0.9, 0.2, -0.1, 0.0, 0.0, 0.0];
    let found = hanging.equilibrium(near).solve().expect("an equilibrium");
    let (q, w) = lagrange::system::split::<Hanging>(&found.state);
    let [x, y, z] = hanging.below(0.0, &q, &w);
    assert!(x.abs() < 1e-15 && y.abs() < 1e-15 && (z + 0.3).abs() < 1e-15, "{x} {y} {z}");
    assert!((q.iter().map(|entry| entry * entry).sum::<f64>() - 1.0).abs() < 1e-15);
    // It may turn about the vertical.
    assert_eq!(found.freedom, 1);
}

#[test]
fn searches_end_at_equilibria_or_report_their_last_point() {
    let rods = DoublePendulum { pull: 3.0, ..DoublePendulum::<f64>::default() };
    let mut found = 0;
    for i in 0..20 {
        for j in 0..20 {
            let near = [0.1 + 0.31 * f64::from(i), -3.0 + 0.31 * f64::from(j), 0.0, 0.0];
            match rods.equilibrium(near).solve() {
                Ok(rest) => {
                    let [.., a, b] = rods.rhs(0.0, &rest.state);
                    // The rounding of the angles, times the largest slope of an acceleration.
                    let angle = rest.state[0].abs().max(rest.state[1].abs()).max(1.0);
                    let rounding = 25.0 * angle * f64::EPSILON;
                    assert!(a.abs() < rounding && b.abs() < rounding, "{near:?}: {a} {b} at {angle}");
                    found += 1;
                }
                Err(error) => assert!(error.to_string().contains("remains"), "{near:?}: {error}"),
            }
        }
    }
    println!("{found} of 400");
    assert!(found > 380, "{found}");
}

lagrange::system! {
    /// A pendulum that only swings above its pivot.
    #[derive(Debug)]
    struct Inverted<S>;

    param g = 9.81;
    coord theta in 2..=4;
    kinetic = 1/2 * dot(theta)^2;
    potential = -g * cos(theta);
    emit { system_matrix }
}

fn an_inverted_pendulum_keeps_its_range<S: Scalar + Into<f64>>(tolerance: f64) {
    let pendulum = Inverted::<S>::default();
    let number = S::from_f64;
    let upright = pendulum.equilibrium([number(3.0), S::ZERO]).solve().expect("near the top");
    assert!((upright.state[0].into() - PI).abs() < tolerance);
    // The start is out of range.
    let error = pendulum.equilibrium([number(1.0), S::ZERO]).solve().expect_err("below its pivot");
    assert!(matches!(error.cause, EquilibriumCause::OutOfRange(_)), "{error}");
    assert_eq!(error.iterations, 0);
    let message = error.to_string();
    assert!(message.contains("the coordinate `theta` is 1.0, but it must be from 2.0 to 4.0"), "{message}");
    let start = pendulum.equilibrium([S::NAN, S::ZERO]).solve().expect_err("NaN");
    assert!(matches!(start.cause, EquilibriumCause::OutOfRange(_)), "{start}");
}

lagrange::system! {
    /// A mass on a spring, within stops.
    #[derive(Debug)]
    struct Stopped;

    param rest = 1.5;
    coord x in 1..=2;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * (x - rest)^2;
    emit { system_matrix }
}

#[test]
fn equilibria_out_of_their_ranges_are_errors() {
    an_inverted_pendulum_keeps_its_range::<f64>(1e-12);
    an_inverted_pendulum_keeps_its_range::<f32>(1e-5);
    // Bounds belong to the range.
    for rest in [1.0, 1.5, 2.0] {
        let found = Stopped { rest }.equilibrium([1.5, 0.0]).solve().expect("between the stops");
        assert!((found.state[0] - rest).abs() < 1e-15, "{found:?}");
    }
    let error = Stopped { rest: 0.5 }.equilibrium([1.5, 0.0]).solve().expect_err("beyond a stop");
    assert!(matches!(error.cause, EquilibriumCause::OutOfRange(_)), "{error}");
    assert!((error.state[0] - 0.5).abs() < 1e-15);
}
