//! `emit { power }`: the powers add up to the rate of the energy, found by differences.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};

fn derived(text: &str) -> Derived {
    let text = format!("{text} emit {{ power }}");
    let system = parse(&text).unwrap_or_else(|report| panic!("{report}"));
    system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}"))
}

/// Returns the powers by name, with the balance at the end.
fn powers(derived: &Derived, t: f64, q: &[f64], v: &[f64]) -> Vec<(String, f64)> {
    let numeric = NumericSystem::new(derived);
    let names = derived.model.outputs.iter().filter(|output| output.name.starts_with("power_"));
    names.map(|output| (output.name.clone(), numeric.output(&output.name, t, q, v).unwrap()[0])).collect()
}

/// Returns the rate of the energy along the motion, by a central difference of fourth order.
fn energy_rate(derived: &Derived, t: f64, q: &[f64], v: &[f64]) -> f64 {
    let numeric = NumericSystem::new(derived);
    let y = [q, v].concat();
    let rate = numeric.rhs(t, &y);
    let energy = |step: f64| {
        let moved = y.iter().zip(&rate).map(|(y, rate)| y + step * rate).collect::<Vec<_>>();
        numeric.product(Product::Energy, t + step, &moved[..q.len()], &moved[q.len()..]).unwrap()[0]
    };
    let h = 1e-3 / rate.iter().fold(1.0, |largest: f64, rate| largest.max(rate.abs()));
    (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h))) / (12.0 * h)
}

/// Returns pseudorandom entries in (−1, 1).
fn state(seed: usize, length: usize) -> Vec<f64> {
    (0..length).map(|i| ((seed * 37 + i * 61 + 11) as f64 * 0.7548776662466927).fract() * 2.0 - 1.0).collect()
}

/// Checks a system at rest and at pseudorandom states, which satisfy no constraints.
fn check(text: &str, expected: &[&str]) {
    let derived = derived(text);
    let (positions, velocities) = (derived.model.coordinates.len(), derived.model.speeds.len());
    for seed in 0..8 {
        let (t, mut q, mut v) = (0.3 * seed as f64, state(seed, positions), state(seed + 50, velocities));
        for orientation in &derived.model.orientations {
            let quaternion = &mut q[orientation.position..][..4];
            let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
            quaternion.iter_mut().for_each(|x| *x /= length);
        }
        if seed == 0 {
            v.fill(0.0);
        }
        let powers = powers(&derived, t, &q, &v);
        let names = powers.iter().map(|(name, _)| name.strip_prefix("power_").unwrap()).collect::<Vec<_>>();
        assert_eq!(names, [expected, &["balance"]].concat());
        let scale = powers.iter().fold(1.0, |largest: f64, (_, power)| largest.max(power.abs()));
        let ((_, balance), powers) = powers.split_last().unwrap();
        assert!(balance.abs() < 1e-12 * scale, "{text} at {seed}: {balance:e} of {scale}");
        let sum = powers.iter().map(|(_, power)| power).sum::<f64>();
        let rate = energy_rate(&derived, t, &q, &v);
        assert!((rate - sum).abs() < 1e-8 * scale, "{text} at {seed}: {rate} and {sum}");
    }
}

#[test]
fn loads_have_the_names_of_what_they_act_on() {
    check(
        "coord x, theta; let p = (x + sin(theta), -cos(theta));
         kinetic = 1/2 * dot(x)^2 + kinetic_energy(2, dot(p)); potential = 3 * p.y;
         dissipation = dot(theta)^2 + 1/4 * dot(x)^4;
         force x = cos(t); force x = -dot(x)^3; force (1, x) at p; torque 3 * x on theta;
         force (2, t) at p + (t, 1); torque 1 on 2 * theta - x; force x along dot(x) + 3;",
        &["x", "x_2", "p", "theta", "force", "torque", "force_2", "dissipation"],
    );
}

#[test]
fn time_and_states_in_the_energies_have_a_power() {
    check(
        "coord x, r; state i; dot(i) = x - i; let p = (r * cos(t + x), r * sin(t + x));
         kinetic = kinetic_energy(1 + r^2, dot(p)) + 1/2 * dot(x)^2;
         potential = x^2 * cos(t) + 1/2 * i^2 * r; dissipation = 1/2 * (dot(r) - sin(t))^2;",
        &["dissipation", "time", "states"],
    );
    // A Lagrangian that is not quadratic in velocities.
    check("coord x; lagrangian = -sqrt(9 - dot(x)^2) - t * x^2; force x = 1;", &["x", "time"]);
}

#[test]
fn constraints_have_a_power_where_they_move() {
    check(
        "coord x, y, z; kinetic = 1/2 * (dot(x)^2 + 2 * dot(y)^2 + dot(z)^2 * (1 + x^2)); potential = y + z;
         constraint rod = (x - sin(t))^2 + y^2 - 1; constraint belt = dot(z) - 2 + t * dot(y);
         constraint slide = x + 2 * z;",
        &["rod", "belt", "constraints"],
    );
}

#[test]
fn bodies_in_space_obey_the_balance() {
    check(
        "gravity = (0, 0, -9.81);
         body top { mass: 2; inertia: (1, 2, 2.5); centroid: (0, 0, 1); } ball tip = ground to top;
         body arm { mass: 1; inertia: (1, 1, 2); centroid: (0, 1, 0); }
         revolute q = top to arm { axis: (1, 0, 0); damping: 0.3; }
         force q = cos(t); force (1, 2, 3) at arm.point(1, 2, 3); torque (t, 0, 1) on top;",
        &["q", "force", "force_2", "dissipation"],
    );
}

#[test]
fn reduced_types_have_powers_of_their_own() {
    let derived = derived(
        "coord x, y; kinetic = 1/2 * dot(x)^2 + 1/2 * (dot(x) + dot(y))^2; potential = y^2;
         force (sin(t), 2) at (x, y^2); reduce Still { freeze x = 1; }",
    );
    let numeric = NumericSystem::of_part(&derived.reduced[0]);
    let of = |name: &str| numeric.output(name, 0.0, &[0.5], &[3.0]).unwrap()[0];
    assert_eq!([of("power_force"), of("power_balance")], [6.0, 0.0]);
}

#[test]
fn powers_are_those_by_hand() {
    // A driven damped pendulum of mass 2 and length 3.
    let pendulum = derived(
        "coord phi; input u = 5; kinetic = 1/2 * 18 * dot(phi)^2; potential = -6 * 9.81 * cos(phi);
         dissipation = 1/2 * 0.7 * dot(phi)^2; force phi = u * cos(t);",
    );
    let expected = [("phi", 5.0 * 0.4_f64.cos() * 1.5), ("dissipation", -0.7 * 2.25)];
    for ((name, power), (short, value)) in powers(&pendulum, 0.4, &[0.9], &[1.5]).iter().zip(expected) {
        assert_eq!(*name, format!("power_{short}"));
        assert!((power - value).abs() < 1e-15, "{name}: {power}");
    }
    // A bead on a rod that turns at the rate 2: h = (ṙ² − 4 r²)/2 is conserved, T + V is not.
    let turning = "coord r; kinetic = kinetic_energy(1, dot((r * cos(2 * t), r * sin(2 * t))));";
    let names = powers(&derived(turning), 0.4, &[0.9], &[1.5]);
    assert_eq!(names.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["power_balance"]);
    // The same bead in Cartesian coordinates. The rod does the work λ·(0, 1)ᵀ 2 r with the Coriolis
    // force 2·2 ṙ, so the power is 8 r ṙ. Both are evaluated at t = 0, where the rod is the x axis.
    let held = derived(
        "coord x, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2); constraint rod = y * cos(2*t) - x * sin(2*t);",
    );
    let found = powers(&held, 0.0, &[0.9, 0.0], &[1.5, 1.8]);
    assert_eq!(found[0].0, "power_rod");
    assert!((found[0].1 - 8.0 * 0.9 * 1.5).abs() < 1e-14, "{found:?}");
}
