//! Constrained systems beside the same systems in independent coordinates.

use lagrange::Simulate;
use lagrange::linear::{Linearise, Stability};
use lagrange::system::Direction;

lagrange::system! {
    /// A point on a rod, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    pub(crate) struct Rod<S>;

    param m = 2, l = 0.7, g = 9.81, c = 0.3;
    coord x, y;
    input push;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    dissipation = 1/2 * c * (dot(x)^2 + dot(y)^2);
    force x = push;
    constraint rod = (x^2 + y^2 - l^2) / 2;
    output tension = rod;
    emit { system_matrix }
}

lagrange::system! {
    /// Three rods between two nails at the same height.
    #[derive(Debug)]
    pub(crate) struct Garland;

    param l = 1, width = 2, g = 9.81;
    coord x[2], y[2];
    kinetic = sum(i in 0..2, 1/2 * (dot(x[i])^2 + dot(y[i])^2));
    potential = g * (y[0] + y[1]);
    constraint left = hypot(x[0], y[0]) - l;
    constraint middle = hypot(x[1] - x[0], y[1] - y[0]) - l;
    constraint right = hypot(width - x[1], y[1]) - l;
    emit { system_matrix }
}

lagrange::system! {
    /// A plate on three parallel rods of the same length.
    #[derive(Debug)]
    struct Plate;

    param l = 1, g = 9.81;
    coord x, y, a;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(a)^2);
    potential = g * y;
    constraint left = (x - cos(a) + 1)^2 + (y - sin(a) - l)^2 - l^2;
    constraint middle = x^2 + (y - l)^2 - l^2;
    constraint right = (x + cos(a) - 1)^2 + (y + sin(a) - l)^2 - l^2;
    emit { system_matrix }
}

lagrange::system! {
    /// A skate on ice: its blade allows no lateral slip.
    #[derive(Debug)]
    pub(crate) struct Skate;

    param m = 1, j = 0.1, a = 0.2;
    coord x, y, phi;
    kinetic = kinetic_energy(m, dot((x + a*cos(phi), y + a*sin(phi)))) + 1/2 * j * dot(phi)^2;
    constraint knife = -sin(phi) * dot(x) + cos(phi) * dot(y);
    emit { system_matrix }
}

#[test]
fn a_point_on_a_rod_is_a_pendulum() {
    let rod = Rod::<f64>::default();
    let found = rod.equilibrium([0.3, -0.5, 0.0, 0.0]).solve().expect("an equilibrium");
    assert!(found.state[0].abs() < 1e-15 && (found.state[1] + rod.l).abs() < 1e-15, "{found:?}");
    let model = rod.linearise(0.0, found.state).expect("smooth");
    assert_eq!(model.states(), ["x", "x_dot"]);
    let wanted = [[0.0, 1.0], [-rod.g / rod.l, -rod.c / rod.m]];
    for (i, row) in wanted.iter().enumerate() {
        for (found, wanted) in model.a().row(i).iter().zip(row) {
            assert!((found - wanted).abs() < 1e-14, "{model:?}");
        }
    }
    assert_eq!((model.b()[(0, 0)], model.b()[(1, 0)]), (0.0, 1.0 / rod.m));
    // The tension changes to second order only.
    assert!(model.c().largest() < 1e-15 && model.d().largest() < 1e-15, "{model:?}");
    assert_eq!(model.components(), ["x", "y", "x_dot", "y_dot"]);
    let modes = model.modes().expect("eigenvalues");
    assert_eq!(modes.stability(), Stability::AsymptoticallyStable);
    let square = modes.modes()[0].natural_frequency().powi(2);
    assert!((square - rod.g / rod.l).abs() < 1e-13, "{modes}");
}

#[test]
fn a_push_holds_a_rod_aside_and_its_tension_has_slopes() {
    // At the angle α, tan α = push / (m g).
    let rod = Rod { push: 8.0, ..Rod::<f64>::default() };
    let found = rod.equilibrium([0.1, -0.6, 0.0, 0.0]).solve().expect("an equilibrium");
    let (weight, push) = (rod.m * rod.g, rod.push);
    let total = weight.hypot(push);
    assert!((found.state[0] - rod.l * push / total).abs() < 1e-15, "{found:?}");
    let model = rod.linearise(0.0, found.state).expect("smooth");
    // λ = -(m g cos α + push sin α) / l: to first order the angle has no effect, the push does.
    let slope = model.c()[(0, 0)];
    assert!(slope.abs() < 1e-12 && model.d()[(0, 0)].abs() > 0.1, "{model:?}");
    let wanted = -(push / total) / rod.l;
    assert!((model.d()[(0, 0)].abs() - wanted.abs()).abs() < 1e-14, "{model:?}");
    let square = -model.a()[(1, 0)];
    assert!((square - total / (rod.m * rod.l)).abs() < 1e-13, "{model:?}");
}

#[test]
fn an_upright_rod_is_unstable_and_a_level_one_has_another_free_coordinate() {
    let rod = Rod::<f64>::default();
    let found = rod.equilibrium([0.05, 0.69, 0.0, 0.0]).solve().expect("an equilibrium");
    assert!((found.state[1] - rod.l).abs() < 1e-15, "{found:?}");
    let modes = rod.linearise(0.0, found.state).expect("smooth").modes().expect("eigenvalues");
    assert_eq!(modes.stability(), Stability::Unstable);
    let level = rod.linearise(0.0, [rod.l, 0.0, 0.0, 0.0]).expect("smooth");
    assert_eq!(level.states(), ["y", "y_dot"]);
}

#[test]
fn single_precision_gives_its_own_digits() {
    let rod = Rod::<f32> { push: 8.0, ..Rod::default() };
    let found = rod.equilibrium([0.1_f32, -0.6, 0.0, 0.0]).solve().expect("an equilibrium");
    let total = (rod.m * rod.g).hypot(rod.push);
    assert!((found.state[0] - rod.l * rod.push / total).abs() < 2.0 * f32::EPSILON, "{found:?}");
    let model = rod.linearise(0.0, found.state).expect("smooth");
    assert!((model.a()[(1, 0)] + f64::from(total / (rod.m * rod.l))).abs() < 1e-4, "{model:?}");
}

#[test]
fn constraints_that_follow_from_others_have_no_derivatives() {
    // Three parallel rods carry a plate; any two would suffice.
    let error = Plate::default().linearise(0.0, [0.0; 6]).expect_err("the forces are not determined");
    assert!(error.to_string().contains("constraints that depend on each other"), "{error}");
}

#[test]
fn a_garland_hangs_in_a_trapezium() {
    let found = Garland::default().equilibrium([0.4, 1.5, -0.7, -0.9, 0.0, 0.0, 0.0, 0.0]).solve();
    let found = found.expect("an equilibrium");
    let wanted = [0.5, 1.5, -0.75_f64.sqrt(), -0.75_f64.sqrt()];
    for (found, wanted) in found.state.into_iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-14, "{found} {wanted}");
    }
    let model = Garland::default().linearise(0.0, found.state).expect("smooth");
    assert_eq!(model.states().len(), 2);
    let frequency = model.modes().expect("eigenvalues").modes()[0].imaginary;
    assert!((frequency - swing(found.state)).abs() < 1e-6 * frequency, "{frequency}");
}

/// Returns the angular frequency of a small swing of the garland, from its zeros.
fn swing(rest: [f64; 8]) -> f64 {
    let mut start = rest;
    start[4..].copy_from_slice(&[1e-4, 1e-4, 0.0, 0.0]);
    let garland = Garland::default();
    let velocity = garland
        .consistent_velocity(0.0, &[start[0], start[1], start[2], start[3]], &[1e-4, 1e-4, 0.0, 0.0])
        .expect("velocities");
    start[4..].copy_from_slice(&velocity);
    let motion = garland.simulate(start).until(4.0).tolerance(1e-13);
    let motion = motion.event("middle", Direction::Crossing, |_, _, y| y[0] - 0.5).run().expect("a motion");
    let times = motion.events().iter().map(|event| event.time).filter(|time| *time > 0.1).collect::<Vec<_>>();
    std::f64::consts::PI * (times.len() - 1) as f64 / (times[times.len() - 1] - times[0])
}

#[test]
fn a_skate_keeps_its_places_and_loses_a_velocity() {
    let skate = Skate::default();
    let ahead = [0.3, 0.2, 0.0, 1.5, 0.0, 0.0];
    let found = skate.equilibrium(ahead).solve().expect("a steady motion");
    assert_eq!((found.state, found.freedom), (ahead, 3));
    let model = skate.linearise(0.0, ahead).expect("smooth");
    assert_eq!(model.states(), ["x", "y", "phi", "x_dot", "phi_dot"]);
    // With the centre of mass ahead of the blade, turns decay at the rate m a v / (j + m a²).
    let rate = skate.m * skate.a * 1.5 / (skate.j + skate.m * skate.a * skate.a);
    let row = model.a().row(4);
    assert!((row[4] + rate).abs() < 1e-14 && row[..4].iter().all(|entry| entry.abs() < 1e-14), "{row:?}");
    // The lateral velocity rotates with the blade.
    let across = model.components().iter().position(|name| name == "y_dot").expect("a velocity");
    assert_eq!(model.basis().row(across), [0.0, 0.0, 1.5, 0.0, 0.0]);
    let back = skate.linearise(0.0, [0.3, 0.2, 0.0, -1.5, 0.0, 0.0]).expect("smooth");
    assert_eq!(back.modes().expect("eigenvalues").stability(), Stability::Unstable);
    // Four zeros, two of which belong to the position along the path, which grows with the speed.
    assert_eq!(model.modes().expect("eigenvalues").stability(), Stability::Undecided);
}
