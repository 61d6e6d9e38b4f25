//! Linear models on the command line, against matrices by hand, and all possible errors.

use std::f64::consts::PI;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

const CART: &str = "tests/data/cart.lag";

fn linearise(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lagrange"));
    command.arg("linearise").args(arguments).output().expect("the command starts")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

/// Returns the object that a command writes without errors.
fn model(arguments: &[&str]) -> Value {
    let result = linearise(&[arguments, &["--json"]].concat());
    assert_eq!((result.status.code(), text(&result.stderr)), (Some(0), ""), "{arguments:?}");
    serde_json::from_slice(&result.stdout).expect("JSON")
}

/// Compares a matrix of an object with one by hand.
fn assert_matrix(model: &Value, name: &str, expected: &[&[f64]]) {
    let rows: Vec<Vec<f64>> = serde_json::from_value(model[name].clone()).expect("a matrix");
    assert_eq!(rows.len(), expected.len(), "{name}");
    for (row, expected) in rows.iter().zip(expected) {
        assert_eq!(row.len(), expected.len(), "{name}");
        let is_near = |(found, wanted): (&f64, &f64)| (found - wanted).abs() < 1e-12;
        assert!(row.iter().zip(*expected).all(is_near), "{name}: {row:?} instead of {expected:?}");
    }
}

fn declaration(name: &str, text: &str) -> String {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, text).expect("written");
    path.to_str().expect("UTF-8").to_owned()
}

/// At θ = π: `(M + m) ẍ − m l θ̈ = u` and `l θ̈ − ẍ = g δ`, so that `ẍ = (u + m g δ)/M` and
/// `θ̈ = (ẍ + g δ)/l`.
#[test]
fn the_pole_on_a_cart_is_that_by_hand() {
    let at = [CART, "--equilibrium", "--at", "x=50 cm", "--hold", "x", "--set", "m=300 g", "--set", "u=0"];
    let found = model(&at);
    let (m, l, g) = (0.3, 0.5, 9.81);
    assert!((found["state"]["theta"].as_f64().expect("an angle") - PI).abs() < 1e-12);
    assert_eq!(
        (found["state"]["x"].as_f64(), found["equilibrium"]["freedom"].as_u64()),
        (Some(0.5), Some(0))
    );
    assert_matrix(
        &found,
        "a",
        &[
            &[0.0, 0.0, 1.0, 0.0],
            &[0.0, 0.0, 0.0, 1.0],
            &[0.0, m * g, 0.0, 0.0],
            &[0.0, (1.0 + m) * g / l, 0.0, 0.0],
        ],
    );
    assert_matrix(&found, "b", &[&[0.0], &[0.0], &[1.0], &[1.0 / l]]);
    assert_matrix(&found, "c", &[&[1.0, -l, 0.0, 0.0]]);
    assert_matrix(&found, "d", &[&[0.0]]);
    assert_eq!(found["states"], serde_json::json!(["x", "theta", "x_dot", "theta_dot"]));
    assert_eq!(
        [&found["input_names"], &found["output_names"]],
        [&serde_json::json!(["u"]), &serde_json::json!(["tip"])]
    );
    let rates = found["modes"].as_array().expect("modes").iter().map(|mode| mode["real"].as_f64());
    let fastest = rates.map(|rate| rate.expect("a rate")).fold(f64::NEG_INFINITY, f64::max);
    assert!((fastest - ((1.0 + m) * g / l).sqrt()).abs() < 1e-12);
    assert_eq!(found["stability"], "unstable");
}

/// At θ = 0: θ̈ = −g/l θ − c/(m l²) θ̇.
#[test]
fn modes_have_frequencies_and_damping_ratios() {
    let path = declaration(
        "damped.lag",
        "param m = 2, l = 0.5, g = 9.81, c = 0.4; coord a = 0.1; kinetic = 1/2 * m * (l * dot(a))^2;
         potential = -m * g * l * cos(a); dissipation = 1/2 * c * dot(a)^2;",
    );
    let found = model(&[&path, "--at", "a=0"]);
    let (square, damping) = (9.81_f64 / 0.5, 0.4 / (2.0 * 0.25));
    assert_matrix(&found, "a", &[&[0.0, 1.0], &[-square, -damping]]);
    let mode = &found["modes"][0];
    let natural = square.sqrt();
    let ratio = damping / (2.0 * natural);
    let close = |name: &str, wanted: f64| (mode[name].as_f64().expect("a number") - wanted).abs() < 1e-12;
    assert!(close("natural_frequency", natural) && close("damping_ratio", ratio), "{mode}");
    assert!(close("frequency", natural * (1.0 - ratio * ratio).sqrt() / (2.0 * PI)), "{mode}");
    assert_eq!((&found["stability"], &found["equilibrium"]), (&"asymptotically stable".into(), &Value::Null));
    let written = linearise(&[&path, "--at", "a=0"]);
    let written = text(&written.stdout).to_owned();
    let parts = ["state at time 0.0:\n  a = 0.0\n", "A ", "modes:\n", "\nasymptotically stable\n"];
    assert!(parts.iter().all(|part| written.contains(part)) && !written.contains("\nB"), "{written}");
}

/// The torque that holds an arm at an angle, m g l sin a, and the linear model there.
#[test]
fn inputs_are_trimmed() {
    let path = declaration(
        "arm.lag",
        "param m = 1, l = 1, g = 9.81; coord a = 0.3; input u; kinetic = 1/2 * m * (l * dot(a))^2;
         potential = -m * g * l * cos(a); force a = u;",
    );
    let found = model(&[&path, "--equilibrium", "--hold", "a", "--trim", "u"]);
    let torque = found["inputs"]["u"].as_f64().expect("a torque");
    assert!((torque - 9.81 * 0.3_f64.sin()).abs() < 1e-12);
    assert_matrix(&found, "a", &[&[0.0, 1.0], &[-9.81 * 0.3_f64.cos(), 0.0]]);
    assert_eq!(found["stability"], "undecided");
}

#[test]
fn options_that_make_no_sense_are_named() {
    let cases: [(&[&str], &str); 9] = [
        (&["--set", "q=1"], "no `q`; known are `M`, `m`, `l`, `g`, `u`"),
        (&["--set", "m=2 s"], "--set m=2 s: "),
        (&["--at", "phi=1"], "--at: the state has no `phi`; known are `x`, `theta`, `x_dot`, `theta_dot`"),
        (&["--at", "x"], "write `--at x=1`"),
        (&["--at", "theta=nan"], "--at theta=nan: "),
        (&["--time", "1 kg", "--at", "x=0"], "--time 1 kg: "),
        (&["--at", "x=0", "--hold", "x"], "add `--equilibrium`"),
        (&["--at", "x=0", "--equilibrium", "--hold", "y"], "--hold: there is no `y`; known are `x`"),
        (&["--at", "x=0", "--equilibrium", "--trim", "x"], "--trim: there is no `x`; known are `u`"),
    ];
    for (arguments, message) in cases {
        let result = linearise(&[&[CART], arguments].concat());
        assert_eq!((result.status.code(), text(&result.stdout)), (Some(2), ""), "{arguments:?}");
        assert!(text(&result.stderr).contains(message), "{arguments:?}: {}", text(&result.stderr));
    }
    let unset = declaration("unset.lag", "param k; coord x; kinetic = dot(x)^2; potential = k * x^2;");
    let refused = |arguments: &[&str]| text(&linearise(arguments).stderr).to_owned();
    assert!(refused(&[&unset]).contains("`k` has no value: write `--set k=1`"));
    assert!(refused(&[&unset, "--set", "k=1"]).contains("the start of `x` is missing: write `--at x=0`"));
}

#[test]
fn points_out_of_a_range_are_refused() {
    let valve =
        declaration("valve.lag", "coord x: mm in 0..=10; range dot(x) < 2; kinetic = (1 [kg]) * dot(x)^2;");
    let refused = |arguments: &[&str]| {
        let result = linearise(&[&[&*valve], arguments].concat());
        assert_eq!((result.status.code(), text(&result.stdout)), (Some(2), ""), "{arguments:?}");
        text(&result.stderr).to_owned()
    };
    let message = "--at: the coordinate `x` is 0.012 m, but it must be from 0.0 to 0.01 m";
    assert!(refused(&["--at", "x=12 mm"]).contains(message), "{}", refused(&["--at", "x=12 mm"]));
    let message = "--at: the velocity `x_dot` is 2.0 m/s, but it must be less than 2.0 m/s";
    let fast = refused(&["--at", "x=1 mm", "--at", "x_dot=2"]);
    assert!(fast.contains(message), "{fast}");
    assert_eq!(model(&[&valve, "--at", "x=10 mm"])["state"]["x"].as_f64(), Some(0.01));
}

#[test]
fn missing_equilibria_and_models_are_explained() {
    let cases = [
        (
            "falls.lag",
            "coord x = 0; kinetic = dot(x)^2; potential = -x;",
            &["--equilibrium"][..],
            3,
            "remains",
        ),
        ("corner.lag", "coord x = 0; kinetic = dot(x)^2; potential = abs(x);", &[], 3, "x"),
        (
            "off.lag",
            "coord x = 1, y = 1; kinetic = dot(x)^2 + dot(y)^2; constraint circle = x^2 + y^2 - 1;",
            &[],
            3,
            "constraint",
        ),
        (
            "clock.lag",
            "discrete n = 0; coord x = 0; kinetic = dot(x)^2; every 0.1 => { n = n + 1; }",
            &[],
            1,
            "clock.lag: ",
        ),
        ("mistake.lag", "coord x = 0; kinetic = dot(y)^2;", &[], 1, "mistake.lag:1:"),
    ];
    for (name, system, arguments, code, message) in cases {
        let path = declaration(name, system);
        let result = linearise(&[&[path.as_str()], arguments].concat());
        assert_eq!(
            (result.status.code(), text(&result.stdout)),
            (Some(code), ""),
            "{name}: {}",
            text(&result.stderr)
        );
        assert!(text(&result.stderr).contains(message), "{name}: {}", text(&result.stderr));
    }
}
