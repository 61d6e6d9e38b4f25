//! The inverse dynamics equals the regressor times its parameters, plus a remainder independent of
//! them.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{NumericSystem, parse};

use crate::random::Random;

pub(crate) fn numeric(text: &str) -> NumericSystem {
    let system = parse(text).unwrap_or_else(|report| panic!("{report}"));
    let derived = system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}"));
    NumericSystem::new(&derived)
}

fn names(text: &str) -> Vec<String> {
    numeric(text).programs().variables.regressor.clone()
}

/// Returns the remainder τ − Y π.
fn rest(system: &NumericSystem, (q, v, a): (&[f64], &[f64], &[f64])) -> Vec<f64> {
    let regressor = system.regressor(0.3, q, v, a).expect("it is requested");
    let parameters = system.regressor_parameters();
    let torques = system.inverse_dynamics(0.3, q, v, a).expect("it is requested");
    let rows = regressor.chunks_exact(parameters.len());
    assert_eq!(rows.len(), torques.len());
    let product = |row: &[f64]| row.iter().zip(&parameters).map(|(y, p)| y * p).sum::<f64>();
    torques.iter().zip(rows).map(|(torque, row)| torque - product(row)).collect()
}

/// Compares the remainder before and after all of `changed` are multiplied by a number.
fn assert_linear(text: &str, changed: &[&str], tolerance: f64) {
    let mut random = Random::new(7);
    let mut number = || random.between(-1.2, 1.2);
    let mut system = numeric(text);
    let layout = system.programs().layout;
    for _ in 0..5 {
        let mut q = (0..layout.positions).map(|_| number()).collect::<Vec<_>>();
        for &first in &system.programs().variables.quaternions {
            let length = q[first..first + 4].iter().map(|x| x * x).sum::<f64>().sqrt();
            q[first..first + 4].iter_mut().for_each(|x| *x /= length);
        }
        let [v, a] = [0, 1].map(|_| (0..layout.velocities).map(|_| number()).collect::<Vec<_>>());
        let before = rest(&system, (&q, &v, &a));
        for name in changed {
            let fields = &system.programs().variables.fields;
            let index = fields.iter().position(|field| field == name).expect("a parameter");
            let value = system.fields()[index];
            system.set_field(index, value * (1.0 + 0.3 * number().abs()));
        }
        let after = rest(&system, (&q, &v, &a));
        let largest = system.inverse_dynamics(0.3, &q, &v, &a).expect("it is requested");
        let largest = largest.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
        for (before, after) in before.iter().zip(&after) {
            assert!((before - after).abs() < tolerance * largest, "{before} {after} of {text}");
        }
    }
}

/// A rod on a cart in the plane, with every parameter that may be linear, and lengths that are not.
const PLANE: &str = "struct S;
    param mc = 3, m = 2, j = 0.4, x0 = 0.6, y0 = 0.1, l = 1, c = 0.2, d = 0.3, k = 5, g = 9.81, load = 0.5;
    coord x, phi; input u;
    gravity = (0, -g);
    kinetic = 1/2 * mc * dot(x)^2;
    body rod { mass: m; inertia: j; centroid: (x0, y0); origin: (x, 0); angle: phi; }
    kinetic = kinetic_energy(load, dot((x + l*cos(phi), l*sin(phi))));
    potential = load * g * l * sin(phi) + spring_energy(k, x);
    dissipation = 1/2 * c * dot(x)^2;
    force x = u - d * tanh(dot(x) / 0.1);
    emit { regressor }
";

#[test]
fn declared_parameters_follow_those_of_bodies() {
    let expected = ["rod.mass", "rod.mx", "rod.my", "rod.zz", "mc", "load", "c", "d", "k"];
    assert_eq!(names(PLANE), expected);
    assert_linear(PLANE, &["m", "j", "x0", "y0", "mc", "load", "c", "d", "k"], 1e-14);
}

#[test]
fn lengths_gravity_and_inputs_are_no_columns() {
    let found = names(PLANE);
    for name in ["l", "g", "u", "m", "j", "x0"] {
        assert!(!found.iter().any(|known| known == name), "{name}");
    }
}

/// An arm in space with a numeric body, a ball joint, a sliding joint and a free body.
const SPACE: &str = "struct S;
    param m = 2, x0 = 0.3, y0 = 0.1, z0 = -0.2, jxx = 0.5, jyy = 0.6, jzz = 0.4, jxy = 0.02, jyz = 0.03, c = 0.2, k = 3;
    gravity = (0, 0, -9.81);
    body base { mass: 4; inertia: (1, 2, 1.5, 0.1, 0.2, 0.3); centroid: (0.1, 0.2, 0.3); }
    revolute turn = ground to base { damping: c; }
    body boom { mass: m; inertia: (jxx, jyy, jzz, jxy, 0, jyz); centroid: (x0, y0, z0); }
    ball hip = base to boom { at: (0.2, 0, 0.5); }
    body slider { mass: 1 + m; inertia: (0.1, 0.2, 0.15); centroid: (0, 0.1, 0); }
    prismatic s = boom to slider { at: (0, 0, 1); axis: (1, 1, 0); }
    body stone { mass: m; inertia: (1, 2, 2.5); centroid: (x0, 0, 0.1); }
    free stone;
    potential = spring_energy(k, s);
    emit { regressor }
";

#[test]
fn bodies_in_space_have_ten_parameters() {
    let found = names(SPACE);
    let of = |body: &str| found.iter().filter(|name| name.starts_with(&format!("{body}."))).count();
    // About a vertical axis, only the moment of inertia about it matters.
    assert_eq!(["base", "boom", "slider", "stone"].map(of), [1, 10, 10, 10]);
    assert_eq!(found[found.len() - 2..], ["c", "k"]);
    let changed = ["m", "x0", "y0", "z0", "jxx", "jyy", "jzz", "jxy", "jyz", "c", "k"];
    assert_linear(SPACE, &changed, 1e-13);
    assert_linear(&format!("#[accuracy(strict)] {SPACE}"), &changed, 1e-13);
}

#[test]
fn systems_of_energies_have_columns_for_what_is_linear() {
    let pendulum = "struct S; param m = 2, l = 0.7, g = 9.81, c = 0.1; coord phi;
        kinetic = 1/2 * m * l^2 * dot(phi)^2; potential = -m * g * l * cos(phi);
        dissipation = 1/2 * c * dot(phi)^2; emit { regressor }";
    assert_eq!(names(pendulum), ["m", "c"]);
    assert_linear(pendulum, &["m", "c"], 1e-15);
    let lagrangian = "struct S; param m[3] = 2, b = 2; coord x[3];
        lagrangian = sum(i in 0..3, 1/2 * m[i] * dot(x[i])^2 - b * x[i]^4); emit { regressor }";
    assert_eq!(names(lagrangian), ["m[0]", "m[1]", "m[2]", "b"]);
    assert_linear(lagrangian, &["m[0]", "m[2]", "b"], 1e-15);
}

/// A product of parameters is linear in its first factor.
#[test]
fn products_are_linear_in_their_first_parameter() {
    let spring = "struct S; param a = 2, b = 3; coord x; kinetic = 1/2 * dot(x)^2;
        potential = 1/2 * a * b * x^2; emit { regressor }";
    assert_eq!(names(spring), ["a"]);
    assert_linear(spring, &["a"], 1e-15);
}

#[test]
fn a_system_without_linear_parameters_has_no_regressor() {
    let text = "struct S; param l = 1; coord phi; kinetic = 1/2 * l^2 * dot(phi)^2; potential = -l * cos(phi); emit { regressor }";
    let derived = parse(text).expect("valid").derive(StrategyChoice::Cheapest).expect("derived");
    let report = derived.clone().emit(&quote::quote!(::lagrange)).expect_err("nothing is linear").to_string();
    assert!(report.contains("the inverse dynamics is not linear in any parameter"), "{report}");
    assert!(NumericSystem::new(&derived).regressor(0.0, &[0.1], &[0.2], &[0.3]).is_none());
}

#[test]
fn frozen_coordinates_keep_the_regressor() {
    let text = "struct S; param m = 2, g = 9.81; coord x, phi;
        gravity = (0, -g);
        body rod { mass: m; inertia: 0.3; centroid: (0.5, 0); origin: (x, 0); angle: phi; }
        reduce Fixed { freeze x = 0.2; } reduce Small { small phi; }
        emit { regressor }";
    let derived =
        parse(text).expect("valid").derive(StrategyChoice::Cheapest).unwrap_or_else(|r| panic!("{r}"));
    let [fixed, small] = [0, 1].map(|part| NumericSystem::of_part(&derived.reduced[part]));
    assert_eq!(fixed.programs().variables.regressor, ["rod.mx", "rod.my", "rod.zz"]);
    assert!(rest(&fixed, (&[0.3], &[0.7], &[-0.2])).iter().all(|rest| rest.abs() < 1e-15));
    assert!(small.regressor(0.0, &[0.1, 0.2], &[0.2, 0.1], &[0.3, 0.4]).is_none());
}
