//! Reduced types with ignored coordinates, compared with Routhians from textbooks.

use super::{NumericSystem, derived, parse};
use crate::model::Product;
use lagrange_expr::expr::Dependencies;

/// Compares the Lagrangian of the first reduced type with a Routhian as a function of parameters,
/// positions and velocities.
fn assert_routhian(text: &str, expected: impl Fn(&[f64], &[f64], &[f64]) -> f64) {
    let derived = derived(&format!("{text} emit {{ lagrangian }}"));
    let part = &derived.reduced[0];
    let model = &part.reduced.model;
    assert!(!model.graph.dependencies(model.lagrangian).intersects(Dependencies::STATE));
    let mut system = NumericSystem::of_part(part);
    for shift in [0.0, 0.4, 1.1] {
        let numbers = |first: f64, count: usize| (0..count).map(move |i| first + shift + 0.37 * i as f64);
        for (index, value) in numbers(0.8, model.parameters.len()).enumerate() {
            system.set_field(index, value);
        }
        let q = numbers(0.5, model.coordinates.len()).collect::<Vec<_>>();
        let v = numbers(-0.9, model.speeds.len()).collect::<Vec<_>>();
        let found = system.product(Product::Lagrangian, 0.0, &q, &v).expect("asked for")[0];
        let expected = expected(system.fields(), &q, &v);
        assert!((found - expected).abs() <= 1e-13 * (1.0 + expected.abs()), "{found} is not {expected}");
    }
}

/// R = ½ m l² θ̇² − p²/(2 m l² sin² θ) + m g l cos θ (Landau and Lifshitz, *Mechanics*,
/// §14, problem 1)
#[test]
fn a_spherical_pendulum_has_a_centrifugal_potential() {
    let text = "param m, l, g; coord theta, phi;
        let bob = l*(sin(theta)*cos(phi), sin(theta)*sin(phi), -cos(theta));
        kinetic = kinetic_energy(m, dot(bob)); potential = gravitational_energy(m, g, bob.z);
        reduce Turning { ignore phi; }";
    assert_routhian(text, |fields, q, v| {
        let [m, l, g, p] = fields[..] else { unreachable!() };
        let inertia = m * l * l;
        0.5 * inertia * v[0] * v[0] - p * p / (2.0 * inertia * q[0].sin().powi(2)) + m * g * l * q[0].cos()
    });
}

/// R = ½ m ṙ² + k/r − p²/(2 m r²) (Goldstein, Poole and Safko, *Classical Mechanics*, 3rd ed.,
/// §8.3, with the opposite sign)
#[test]
fn a_planet_has_an_effective_potential() {
    let text = "param m, k; coord phi, r;
        kinetic = kinetic_energy(m, dot((r*cos(phi), r*sin(phi)))); potential = -k/r;
        reduce Radial { ignore phi; }";
    assert_routhian(text, |fields, q, v| {
        let [m, k, p] = fields[..] else { unreachable!() };
        0.5 * m * v[0] * v[0] + k / q[0] - p * p / (2.0 * m * q[0] * q[0])
    });
}

/// R = ½ A θ̇² − (p_φ − p_ψ cos θ)²/(2 A sin² θ) − p_ψ²/(2 C) − w cos θ (Goldstein, Poole and
/// Safko, §5.7)
#[test]
fn a_heavy_top_ignores_two_angles() {
    let text = "param a, c, w; coord phi, theta, psi;
        kinetic = 1/2*a*(dot(theta)^2 + sin(theta)^2*dot(phi)^2) + 1/2*c*(dot(psi) + dot(phi)*cos(theta))^2;
        potential = w*cos(theta);
        reduce Nutating { ignore psi, phi; }";
    assert_routhian(text, |fields, q, v| {
        let [a, c, w, p, s] = fields[..] else { unreachable!() };
        let (sine, cosine) = q[0].sin_cos();
        let rest = p - s * cosine;
        0.5 * a * v[0] * v[0] - rest * rest / (2.0 * a * sine * sine) - s * s / (2.0 * c) - w * cosine
    });
}

/// A charge in the field B along z has `L = ½ m (ẋ² + ẏ²) + b x ẏ − V` and
/// `R = ½ m ẋ² − (p − b x)²/(2 m) − V` (Landau and Lifshitz, *Quantum Mechanics*, §112, where it
/// oscillates about p/b).
#[test]
fn a_charge_in_a_field_oscillates() {
    let text = "param m, b, k; coord x, y;
        lagrangian = 1/2*m*(dot(x)^2 + dot(y)^2) + b*x*dot(y) - 1/2*k*x^2;
        reduce Across { ignore y; }";
    assert_routhian(text, |fields, q, v| {
        let [m, b, k, p] = fields[..] else { unreachable!() };
        0.5 * m * v[0] * v[0] - (p - b * q[0]).powi(2) / (2.0 * m) - 0.5 * k * q[0] * q[0]
    });
}

/// R = ½ (m l² − (m l cos θ)²/M) θ̇² + p m l cos θ θ̇/M − p²/(2 M) + m g l cos θ, M = m_c + m
#[test]
fn coupled_velocities_leave_gyroscopic_terms() {
    let text = "param mc, m, l, g; coord x, theta;
        let bob = (x + l*sin(theta), -l*cos(theta));
        kinetic = kinetic_energy(mc, dot(x)) + kinetic_energy(m, dot(bob)); potential = m*g*bob.y;
        reduce Swinging { ignore x; }";
    assert_routhian(text, |fields, q, v| {
        let [mc, m, l, g, p] = fields[..] else { unreachable!() };
        let (all, lever) = (mc + m, m * l * q[0].cos());
        let square = 0.5 * (m * l * l - lever * lever / all) * v[0] * v[0];
        square + p * lever * v[0] / all - p * p / (2.0 * all) + g * lever
    });
}

#[test]
fn coordinates_become_states_and_momenta_parameters() {
    let mut derived = derived(
        "param m: kg = 2, decay: s = 1, k: N/m = 1, d: m = 1;
         coord x: m, y: m = 3, z: m; start dot(y) = 0.5;
         state s: m; dot(s) = dot(y) - s/decay;
         kinetic = kinetic_energy(m, dot((x, y, z))); potential = k*x^2;
         output w = dot(y) + dot(x); output a = ddot(y);
         reduce R { ignore y; freeze z = d; }",
    );
    let part = derived.reduced.remove(0);
    let model = &part.reduced.model;
    let names = model.coordinates.iter().map(|of| (of.name.as_str(), of.is_state)).collect::<Vec<_>>();
    assert_eq!(names, [("x", false), ("s", true), ("y", true)]);
    assert_eq!(model.parameters.last().map(|of| of.name.as_str()), Some("y_momentum"));
    assert_eq!(model.units.get("y_momentum").map(|unit| unit.unit.as_str()), Some("N*s"));
    let system = NumericSystem::of_part(&part);
    assert_eq!(system.fields(), [2.0, 1.0, 1.0, 1.0, 1.0], "the momentum at the start");
    let (q, v) = ([0.5, 0.25, 7.0], [0.125]);
    assert_eq!(system.position_rates(0.0, &q, &v), [0.125, 0.25, 0.5]);
    assert_eq!(system.output("w", 0.0, &q, &v), Some(vec![0.625]));
    assert_eq!(system.output("a", 0.0, &q, &v), Some(vec![0.0]));
}

/// A pendulum on an arm that rotates about the vertical axis, declared with bodies, whose
/// accelerations are derived from a Gibbs function.
#[test]
fn bodies_in_space_turn_about_the_vertical() {
    let derived = derived(
        "gravity = (0, 0, -9.81);
         body arm { mass: 0.7; centroid: (0.3, 0, 0.02); inertia: (0.02, 0.04, 0.05, 0, 0, 0.001); }
         revolute phi = ground to arm { at: (0, 0, 1); axis: (0, 0, 1); }
         body rod { mass: 0.2; centroid: (0, 0.01, -0.25); inertia: (0.01, 0.011, 0.003, 0, 0.001, 0); }
         revolute theta = arm to rod { at: (0.5, 0, 0); axis: (1, 0, 0); damping: 0.1; }
         emit { frames }
         reduce Swinging { ignore phi; }",
    );
    let (whole, mut part) = (NumericSystem::new(&derived), NumericSystem::of_part(&derived.reduced[0]));
    for (theta, [turn, swing]) in [(0.3, [1.5, -0.4]), (2.0, [-3.0, 2.5]), (-1.2, [0.2, 0.7])] {
        let (q, v) = ([0.9, theta], [turn, swing]);
        let momenta = whole.product(Product::Momenta, 0.0, &q, &v).expect("derived by default");
        assert!(part.set("phi_momentum", momenta[0]));
        let [expected, found] =
            [whole.acceleration(0.0, &q, &v)[1], part.acceleration(0.0, &[theta, 0.9], &[swing])[0]];
        assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{found} is not {expected}");
        let rates = part.position_rates(0.0, &[theta, 0.9], &[swing]);
        assert!((rates[1] - turn).abs() < 1e-13, "{rates:?}");
    }
}

/// The first force points outwards from the axis, independently of rotation; the second depends on
/// the direction.
#[test]
fn forces_on_others_may_turn_with_what_is_ignored() {
    let text = "coord theta, phi; let (x, y) = (sin(theta)*cos(phi), sin(theta)*sin(phi));
        kinetic = kinetic_energy(1, dot((x, y, -cos(theta))));
        force dot(phi)*(x, y) at (x, y);";
    for (direction, depends) in [("", false), ("force theta = cos(phi)*dot(phi);", true)] {
        let derived = derived(&format!("{text} {direction} reduce Turning {{ ignore phi; }}"));
        let part = &derived.reduced[0];
        let roots = &part.equations.accelerations;
        let found =
            roots.iter().any(|&a| part.reduced.model.graph.dependencies(a).intersects(Dependencies::STATE));
        assert_eq!(found, depends, "{direction}");
        let (whole, mut part) = (NumericSystem::new(&derived), NumericSystem::of_part(part));
        let (q, v) = ([0.7, 0.9], [0.3, 1.6]);
        part.set("phi_momentum", 0.7_f64.sin().powi(2) * 1.6);
        let expected = whole.acceleration(0.0, &q, &v)[0];
        let found = part.acceleration(0.0, &q, &v[..1])[0];
        assert!((found - expected).abs() < 1e-14, "{found} is not {expected}");
    }
}

const TURN: &str = "param k = 3, f = 2; coord theta, phi;
    kinetic = 1/2*dot(theta)^2 + 1/2*(1 + theta^2)*dot(phi)^2; ";

/// Conditions, signs and tables have no gradient if they depend on an angle.
#[test]
fn outputs_keep_what_only_decides() {
    let derived = derived(&format!(
        "{TURN} table steps(s) = [(0, 1), (1, 2), (2, 5)], interpolation: linear, outside: clamp;
         output side = if phi > 1 {{ 1 }} else {{ 2 }}; output s = sign(phi - 1);
         output nested = if (if phi > 1 {{ theta }} else {{ 0 }}) > 0.5 {{ 1 }} else {{ 2 }};
         output read = steps(phi); output alike = sign(theta + sin(phi)^2 + cos(phi)^2);
         output jump = sign(abs(phi - 1)/(phi - 1)); potential = k*theta^2*f;
         reduce Turning {{ ignore phi; }}"
    ));
    let model = &derived.reduced[0].reduced.model;
    let system = NumericSystem::of_part(&derived.reduced[0]);
    for (phi, expected) in [(0.5, [2.0, -1.0, 2.0, 1.5, 1.0, -1.0]), (2.0, [1.0, 1.0, 1.0, 5.0, 1.0, 1.0])] {
        for (name, expected) in ["side", "s", "nested", "read", "alike", "jump"].into_iter().zip(expected) {
            let found = system.output(name, 0.0, &[0.7, phi], &[0.1]);
            assert_eq!(found, Some(vec![expected]), "{name} at {phi}");
        }
    }
    let alike = model.outputs.iter().find(|output| output.name == "alike").expect("declared");
    assert!(!model.graph.dependencies(alike.components[0]).intersects(Dependencies::STATE));
}

#[test]
fn forces_on_others_may_begin_where_an_angle_is_passed() {
    for force in ["if phi > 1 { f } else { 0 }", "f*(1 + sign(phi - 1))/2"] {
        let text = format!("{TURN} potential = k*theta; force theta = {force}; reduce R {{ ignore phi; }}");
        let derived = derived(&text);
        let mut part = NumericSystem::of_part(&derived.reduced[0]);
        part.set("phi_momentum", 0.0);
        let found = [0.5, 2.0].map(|phi| part.acceleration(0.0, &[0.7, phi], &[0.1])[0]);
        assert_eq!(found, [-3.0, -1.0], "{force}");
    }
}

fn report(text: &str) -> String {
    parse(text).map_or_else(|report| report.to_string(), |_| String::new())
}

#[test]
fn energies_with_conditions_on_an_angle_are_not_cyclic() {
    let condition = "potential = if phi > 1 { k*theta^2/2 } else { 0 };";
    for potential in [condition, "potential = k*theta^2*sign(phi - 1);"] {
        let text = format!("{TURN} potential = f*theta; reduce R {{ ignore phi; }}\n{potential}");
        let found = report(&text);
        assert!(found.contains("`phi` cannot be ignored: the Lagrangian depends on it"), "{found}");
        assert!(found.contains("note at 3:1: this term depends on it"), "{found}");
    }
    let found = report(
        "coord x, y; reduce R { ignore y; }
         lagrangian = 1/2*dot(x)^2 + if dot(y) > 0 { dot(y)^2 } else { 1/2*dot(y)^2 };",
    );
    assert!(found.contains("`y` cannot be ignored: its momentum is not linear"), "{found}");
}

#[test]
fn names_of_momenta_are_new_wherever_others_stand() {
    let (point, reduction) = ("coord x, y; kinetic = 1/2*(dot(x)^2 + dot(y)^2);", "reduce R { ignore x; }");
    let taken = "param x_momentum = 1; potential = x_momentum*y;";
    for text in [format!("{point} {taken} {reduction}"), format!("{point} {reduction} {taken}")] {
        let found = report(&text);
        assert!(found.contains("a parameter `x_momentum`, but this name is taken"), "{found}");
        assert_eq!(found.matches("error at").count(), 1, "{found}");
    }
}

#[test]
fn rates_of_ignored_coordinates_have_a_name() {
    let reserved = |statements: &str, reduction: &str| {
        let point = "coord x, y; kinetic = 1/2*(dot(x)^2 + dot(y)^2); output position_rates = x;";
        let found = report(&format!("{point} {statements} reduce R {{ {reduction}; }}"));
        (
            found.matches("an output cannot be called `position_rates`").count(),
            found.contains("beside `reduce`"),
        )
    };
    assert_eq!(reserved("", "ignore y"), (1, true));
    assert_eq!(reserved("", "freeze y = 0"), (0, false));
    assert_eq!(reserved("state s; dot(s) = x;", "ignore y"), (1, false));
}

/// For ẋẏ alone, R = ½ ż² − V − p_x p_y; with 2ẋẇ + ẏ² + u ẇ ẏ added, M is also indefinite
#[test]
fn indefinite_energies_are_reduced_if_momenta_are_independent() {
    assert_routhian(
        "coord x, y, z; lagrangian = dot(x)*dot(y) + 1/2*dot(z)^2 - 1/2*z^2; reduce R { ignore x, y; }",
        |p, q, v| 0.5 * (v[0] * v[0] - q[0] * q[0]) - p[0] * p[1],
    );
    // ẋ = p_w/2, ẏ = p_y/2 − u ẇ/2 and 2ẋ + u ẏ = p_w
    assert_routhian(
        "param u; coord x, y, w, z; reduce R { ignore x, y, w; }
         lagrangian = 2*dot(x)*dot(w) + dot(y)^2 + u*dot(w)*dot(y) + 1/2*dot(z)^2;",
        |p, _, v| {
            let [u, x, y, w] = p[..] else { unreachable!() };
            let rate = x / 2.0;
            let turn = (y - u * rate) / 2.0;
            let shift = (w - u * turn) / 2.0;
            0.5 * v[0] * v[0] - 0.5 * (x * shift + y * turn + w * rate)
        },
    );
    // A pivot that is zero by an identity is rejected.
    let zero = "(sin(z)^2 + cos(z)^2 - 1)";
    assert_routhian(
        &format!(
            "coord x, y, z; reduce R {{ ignore x, y; }}
         lagrangian = {zero}*dot(x)^2 + dot(x)*dot(y) + 1/2*(1 + z^2)*dot(y)^2 + 1/2*dot(z)^2;"
        ),
        |p, q, v| {
            let shift = p[1] - (1.0 + q[0] * q[0]) * p[0];
            0.5 * v[0] * v[0] - 0.5 * (p[0] * shift + p[1] * p[0])
        },
    );
    let found = report(
        "coord x, y, z; reduce R { ignore x, y; } lagrangian = 1/2*(dot(x) + dot(y))^2 + 1/2*dot(z)^2;",
    );
    assert!(found.contains("cannot be ignored"), "{found}");
}

/// Both terms overflow: ∞ ≤ 10⁻⁹ ∞ is meaningless.
#[test]
fn infinite_terms_do_not_vanish() {
    let found = report(&format!("{TURN} potential = (1 + theta)^2000*phi^2; reduce R {{ ignore phi; }}"));
    assert!(found.contains("`phi` cannot be ignored: the Lagrangian depends on it"), "{found}");
}
