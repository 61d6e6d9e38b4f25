//! Additions of users to bodies in space, and parts that they omit.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};

use crate::motion::{assert_constant, assert_near};

/// Rounding between two ways of computing the same accelerations.
const TOLERANCE: f64 = 1e-13;

const ARM: &str = "gravity = (0, 0, -9.81);
    body crank { mass: 2; inertia: (0.2, 0.3, 0.4, 0.02, 0, -0.03); centroid: (0.1, 0, 0.2); }
    body rod { mass: 1.5; inertia: (0.1, 0.2, 0.25); centroid: (0.3, 0, 0); }
    revolute q = ground to crank { at: (0, 0, 1); axis: (1, 2, 0); }\n";
const UNIVERSAL: &str = "universal (a, b) = crank to rod { at: (0, 0.7, 0); turned: (0.3, 0, pi/2); }\n";

fn derived(text: &str) -> Derived {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    derived.unwrap_or_else(|report| panic!("{text}\n{report}"))
}

#[test]
fn energies_of_the_user_are_kept_together_with_those_of_bodies() {
    let rotor = "kinetic = 0.15*(1 + sin(a)^2)*dot(b)^2 + 0.2*dot(q)*dot(b);";
    let spring = "potential = spring_energy(3, a - q/2) + 2*rod.point(0.5, 0, 0).x^2;";
    let ring = "kinetic = kinetic_energy(0.4, velocity(rod.point(0, 0.6, 0.1)));";
    for added in [rotor, spring, ring, &format!("{rotor}\n{spring}\n{ring}")] {
        let system = NumericSystem::new(&derived(&format!("{ARM}{UNIVERSAL}{added}")));
        let energy = |q: &[f64], v: &[f64]| system.product(Product::Energy, 0.0, q, v).expect("emitted");
        for (q, v) in [([0.3, -0.7, 1.1], [1.2, 0.4, -0.9]), ([0.0, 0.5, 0.0], [0.75, -1.5, 2.0])] {
            assert_constant(&system, [&q, &v], energy, added);
            let a = system.acceleration(0.0, &q, &v);
            let rest = system.inverse_dynamics(0.0, &q, &v, &a).expect("emitted");
            assert_near(&rest, &[0.0; 3], 1e-11, added);
        }
    }
}

#[test]
fn a_mass_that_the_user_adds_is_a_body_without_inertia() {
    let by_energy = "kinetic = kinetic_energy(0.4, velocity(rod.point(0, 0.6, 0.1)));
        potential = 9.81*0.4*rod.point(0, 0.6, 0.1).z;";
    let by_body = "body weight { mass: 0.4; shape: point_mass(); } weld rod to weight { at: (0, 0.6, 0.1); }";
    let systems =
        [by_energy, by_body].map(|added| NumericSystem::new(&derived(&format!("{ARM}{UNIVERSAL}{added}"))));
    for (q, v) in [([0.3, -0.7, 1.1], [1.2, 0.4, -0.9]), ([0.0, 0.0, 0.0], [0.0, -1.5, 2.0])] {
        let [by_energy, by_body] = systems.each_ref().map(|system| system.acceleration(0.0, &q, &v));
        assert_near(&by_energy, &by_body, TOLERANCE, "accelerations");
    }
}

#[test]
fn a_frozen_joint_is_a_weld() {
    let frozen = derived(&format!("{ARM}{UNIVERSAL}reduce Stiff {{ freeze a = 0, b = 0; }}"));
    let frozen = NumericSystem::of_part(&frozen.reduced[0]);
    let welded = "weld crank to rod { at: (0, 0.7, 0); turned: (0.3, 0, pi/2); }";
    let welded = NumericSystem::new(&derived(&format!("{ARM}{welded}")));
    for (q, v) in [(0.3, 1.2), (-2.0, 0.0), (0.0, 3.0)] {
        let [frozen, welded] = [&frozen, &welded].map(|system| system.acceleration(0.0, &[q], &[v]));
        assert_near(&frozen, &welded, TOLERANCE, "accelerations");
    }
}

/// A joint with several coordinates is a chain of joints on frames.
#[test]
fn joints_are_chains_of_simpler_ones() {
    let pairs = [
        (
            UNIVERSAL,
            "frame fork; revolute a = crank to fork { at: (0, 0.7, 0); turned: (0.3, 0, pi/2); axis: (1, 0, 0); }
            revolute b = fork to rod { axis: (0, 1, 0); }",
        ),
        (
            "cylindrical (a, b) = crank to rod { at: (0, 0.7, 0); axis: (1, -1, 2); }",
            "frame sleeve; revolute a = crank to sleeve { at: (0, 0.7, 0); axis: (1, -1, 2); }
            prismatic b = sleeve to rod { axis: (1, -1, 2); }",
        ),
        (
            "screw a = crank to rod { turned: (0, 1, 0); pitch: 0.3; } coord b; kinetic = 1/2*dot(b)^2;",
            "cylindrical (a, s) = crank to rod { turned: (0, 1, 0); } constraint lead = s - 0.3*a/(2*pi);
            coord b; kinetic = 1/2*dot(b)^2;",
        ),
    ];
    for (short, long) in pairs {
        let [short, long] = [short, long].map(|joint| NumericSystem::new(&derived(&format!("{ARM}{joint}"))));
        let (q, v) = ([0.3, -0.7, 1.1], [1.2, 0.4, -0.9]);
        let expected = short.acceleration(0.0, &q, &v);
        let found = match long.degrees_of_freedom() {
            3 => long.acceleration(0.0, &q, &v),
            _ => {
                // The nut advances with the screw.
                let lead = 0.3 / std::f64::consts::TAU;
                let (q, v) = ([q[0], q[1], lead * q[1], q[2]], [v[0], v[1], lead * v[1], v[2]]);
                let found = long.acceleration(0.0, &q, &v);
                vec![found[0], found[1], found[3]]
            }
        };
        assert_near(&found, &expected, TOLERANCE, "accelerations");
    }
}
