//! Motions known in closed form, and quantities that every motion conserves.
//!
//! Sources: Landau, Lifshitz, *Mechanics*, §§ 9, 14, 35 and 36; Goldstein, Poole, Safko, *Classical
//! Mechanics*, §§ 5.6 and 5.7.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};

use crate::cases::{cases, read};
use crate::motion::{assert_constant, assert_near};

/// Relative error allowed for an acceleration.
const TOLERANCE: f64 = 1e-13;

fn system(text: &str) -> NumericSystem {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{text}\n{report}")))
}

const STATES: [([f64; 3], [f64; 3]); 4] = [
    ([0.3, -0.7, 1.1], [1.2, 0.4, -0.9]),
    ([-1.0, 0.5, 0.25], [0.0, -2.0, 3.0]),
    ([2.5, 1.25, -0.5], [-0.6, 0.0, 0.1]),
    ([0.0, 0.625, 0.0], [0.75, 0.5, -0.25]),
];

/// Angles a about x and b about the rotated y satisfy `b̈ = −sin b cos b ȧ² − g/l cos a sin b` and
/// `ä = 2 tan b ȧ ḃ − g/l sin a / cos b`.
#[test]
fn a_spherical_pendulum_swings_as_its_two_equations_say() {
    let system = system(
        "gravity = (0, 0, -9.81);
        frame fork; frame rod; body bob { mass: 1.5; shape: point_mass(); }
        revolute a = ground to fork { axis: (1, 0, 0); }
        revolute b = fork to rod { axis: (0, 1, 0); }
        weld rod to bob { at: (0, 0, -0.8); }
        output spin = angular_momentum(bob);",
    );
    for (q, v) in STATES {
        let ([a, b], [va, vb]) = ([q[0], q[1]], [v[0], v[1]]);
        let ratio = 9.81 / 0.8;
        let first = 2.0 * b.tan() * va * vb - ratio * a.sin() / b.cos();
        let second = -b.sin() * b.cos() * va * va - ratio * a.cos() * b.sin();
        assert_near(
            &system.acceleration(0.0, &q[..2], &v[..2]),
            &[first, second],
            TOLERANCE,
            "accelerations",
        );
        let vertical = |q: &[f64], v: &[f64]| vec![system.output("spin", 0.0, q, v).expect("declared")[2]];
        assert_constant(&system, [&q[..2], &v[..2]], vertical, "angular momentum about the vertical");
        let energy = |q: &[f64], v: &[f64]| system.product(Product::Energy, 0.0, q, v).expect("emitted");
        assert_constant(&system, [&q[..2], &v[..2]], energy, "energy");
    }
}

/// A symmetrical top with the spin ω₃ about its axis precesses steadily at the angle θ where
/// `A cos θ ψ̇² − C ω₃ ψ̇ + m g l = 0`.
#[test]
fn a_gyroscope_precesses_steadily_at_both_of_its_rates() {
    let (mass, length, across, along) = (1.25, 0.4, 0.05, 0.02);
    let system = system(&format!(
        "gravity = (0, 0, -9.81);
        frame yoke; frame ring; body wheel {{ mass: {mass}; inertia: ({across}, {across}, {along}); centroid: (0, 0, {length}); }}
        revolute psi = ground to yoke; revolute theta = yoke to ring {{ axis: (1, 0, 0); }} revolute phi = ring to wheel;"
    ));
    // About the point of support.
    let about_tip = across + mass * length * length;
    for (theta, spin) in [(0.4_f64, 150.0), (1.2, 75.0), (2.0, 40.0), (2.75, -90.0)] {
        let (a, b, c) = (about_tip * theta.cos(), -along * spin, mass * 9.81 * length);
        let root = (b * b - 4.0 * a * c).sqrt();
        let larger = -0.5 * (b + b.signum() * root);
        for rate in [larger / a, c / larger] {
            let (q, v) = ([0.3, theta, -0.2], [rate, 0.0, spin - rate * theta.cos()]);
            let found = system.acceleration(0.0, &q, &v);
            let size = rate.abs() * spin.abs().max(rate.abs());
            assert!(found.iter().all(|a| a.abs() <= TOLERANCE * size), "{theta}, {spin}, {rate}: {found:?}");
        }
    }
}

/// J₁ ω̇₁ = (J₂ − J₃) ω₂ ω₃ and so on, with joints and with angles. The angular momentum in the
/// world and the energy are conserved.
#[test]
fn a_free_top_turns_as_euler_says() {
    let inertia = [0.3, 0.5, 0.7];
    let by_joints = "frame yoke; frame ring; body top { mass: 2; inertia: (0.3, 0.5, 0.7); }
        revolute psi = ground to yoke; revolute theta = yoke to ring { axis: (1, 0, 0); } revolute phi = ring to top;";
    let by_angles = "coord psi, theta, phi;
        body top { mass: 2; inertia: (0.3, 0.5, 0.7); origin: (0, 0, 0); angles: (psi, theta, phi); sequence: zxz; }";
    for placed in [by_joints, by_angles] {
        let system = system(&format!(
            "{placed} output spin = angular_velocity(top) in top; output change = angular_acceleration(top) in top;
            output momentum = angular_momentum(top);"
        ));
        for (q, v) in STATES {
            let output = |name: &str, q: &[f64], v: &[f64]| system.output(name, 0.0, q, v).expect("declared");
            let (w, change) = (output("spin", &q, &v), output("change", &q, &v));
            let euler = [0, 1, 2].map(|k| {
                let (next, last) = ((k + 1) % 3, (k + 2) % 3);
                (inertia[next] - inertia[last]) / inertia[k] * w[next] * w[last]
            });
            assert_near(&change, &euler, TOLERANCE, placed);
            assert_constant(&system, [&q, &v], |q, v| output("momentum", q, v), "angular momentum");
            let energy = |q: &[f64], v: &[f64]| system.product(Product::Energy, 0.0, q, v).expect("emitted");
            assert_constant(&system, [&q, &v], energy, "energy");
        }
    }
}

/// Two bodies on a freely moving frame without gravity: all forces are internal.
#[test]
fn internal_forces_conserve_momentum_and_angular_momentum() {
    let system = system(
        "frame f1; frame f2; frame f3; frame f4; frame f5;
        body hull { mass: 3; centroid: (0.1, -0.2, 0.05); inertia: (0.5, 0.6, 0.4, 0.02, -0.05, 0.1); }
        body arm { mass: 1.5; centroid: (0.3, 0, 0.1); inertia: (0.1, 0.2, 0.15, 0.01, 0.02, -0.03); }
        prismatic x = ground to f1 { axis: (1, 0, 0); } prismatic y = f1 to f2 { axis: (0, 1, 0); } prismatic z = f2 to f3;
        revolute a = f3 to f4; revolute b = f4 to f5 { axis: (0, 1, 0); } revolute c = f5 to hull { axis: (1, 0, 0); }
        cylindrical (d, e) = hull to arm { at: (0.4, 0.1, -0.3); turned: (0.3, -0.4, 0.5); axis: (1, 2, -2); }
        spring { from: hull.point(0.1, 0.9, 0); to: arm.point(0.5, 0, 0.5); stiffness: 12; rest: 0.3; }
        damper { from: hull.point(-0.2, 0, 0.4); to: arm.point(0, 1, 0); damping: 3; }
        output p = linear_momentum(hull) + linear_momentum(arm);
        output l = angular_momentum(hull) + angular_momentum(arm);",
    );
    let states = [
        ([0.1, -0.3, 0.8, 0.5, -0.4, 1.2, 0.7, 0.2], [1.0, 0.5, -0.7, 0.9, -1.1, 0.3, 2.0, -0.4]),
        ([0.0, 0.0, 0.0, -2.0, 0.6, 0.1, -1.0, 0.5], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.0, 1.0]),
    ];
    for (q, v) in states {
        for name in ["p", "l"] {
            assert_constant(
                &system,
                [&q, &v],
                |q, v| system.output(name, 0.0, q, v).expect("declared"),
                name,
            );
        }
    }
}

#[test]
fn robots_keep_their_energy() {
    for name in ["ur5", "universal_2", "ball_2"] {
        let system = system(&read(&format!("models/{name}.lag")));
        for state in &cases(&format!("models/{name}.txt"))[0].states {
            let energy = |q: &[f64], v: &[f64]| system.product(Product::Energy, 0.0, q, v).expect("emitted");
            assert_constant(&system, ["q", "v"].map(|word| state.numbers(word)), energy, name);
        }
    }
}
