//! Ensembles on the command line: final states against closed forms, and all possible errors.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const SPRING: &str = "
/// A mass on a spring.
pub struct Spring;
param m: kg = 2, k: N/m;
coord x: m, angle: rad;
input push: N = 0;
kinetic = 1/2 * m * dot(x)^2 + 1/2 * dot(angle)^2 * m * 1 [m^2];
potential = 1/2 * k * x^2;
force x = push;
output twice: m = 2 * x;
";

fn declaration(name: &str, text: &str) -> String {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, text).expect("written");
    path.to_str().expect("UTF-8").to_owned()
}

fn ensemble(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lagrange"));
    command.arg("ensemble").args(arguments).output().expect("the command starts")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

/// Returns the columns and rows that a command writes without errors.
fn table(arguments: &[&str]) -> (Vec<String>, Vec<Vec<f64>>) {
    let result = ensemble(arguments);
    assert_eq!((result.status.code(), text(&result.stderr)), (Some(0), ""), "{arguments:?}");
    let mut lines = text(&result.stdout).lines();
    let names = lines.next().expect("a head").split(',').map(str::to_owned).collect();
    let row = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    (names, lines.map(row).collect())
}

/// Balls that fall from h on a floor without restitution lie there. Blocks with the speed v slide
/// by v²/(2 μ g).
#[test]
fn balls_and_blocks_end_where_they_lie() {
    let file = declaration(
        "case.lag",
        "param mu = 0.5, g = 10; coord x = 0, h = 0; start dot(x) = 2;
        kinetic = 1/2 * (dot(x)^2 + dot(h)^2); potential = g * h;
        event floor = h, falling => impact(0); friction rub = dot(x), mu * floor;",
    );
    let common = [&*file, "--until", "3", "--vary", "mu=0.2..0.8", "--motions", "4", "--threads", "3"];
    for (method, error) in [(&[][..], 1e-8), (&["--method", "stepped", "--step", "1 ms"], 4e-3)] {
        let (names, rows) = table(&[&common[..], method].concat());
        let place = |name: &str| names.iter().position(|known| known == name).expect("a column");
        assert_eq!(rows.len(), 4);
        for row in rows {
            let way = 4.0 / (2.0 * row[place("mu")] * 10.0);
            assert!((row[place("x")] - way).abs() < error, "{row:?}");
            assert!(row[place("h")].abs() < 1e-9 && row[place("x_dot")].abs() < 1e-9, "{row:?}");
        }
    }
}

const DIFFUSING: &str = "
/// A particle in a liquid.
pub struct Diffusing;
param m: kg = 1;
coord x: m;
noise push: N, density: 2 [N^2*s];
kinetic = 1/2 * m * dot(x)^2;
force x = push - 1 [N*s/m] * dot(x);
";

#[test]
fn noise_has_a_seed_and_a_method() {
    let file = declaration("diffusing.lag", DIFFUSING);
    let common = [&*file, "--until", "4", "--start", "x=0", "--start", "x_dot=0", "--motions", "1000"];
    let by = |method: &str, seed: &str| {
        table(&[&common[..], &["--method", method, "--step", "0.0625", "--seed", seed]].concat()).1
    };
    let ends = by("stochastic", "3");
    let square = ends.iter().map(|row| row[2] * row[2]).sum::<f64>() / 1000.0;
    let exact = 1.0 - (-8.0_f64).exp();
    assert!((square - exact).abs() < 3.0 * exact * (2.0_f64 / 1000.0).sqrt(), "{square}");
    assert_eq!(ends, by("stochastic", "3"));
    assert_ne!(ends, by("stochastic", "4"));
    let near = by("maruyama", "3").iter().zip(&ends).map(|(a, b)| (a[1] - b[1]).abs()).fold(0.0, f64::max);
    assert!(near > 0.0 && near < 0.3, "{near}");
    let refused = ensemble(&common);
    assert!(text(&refused.stderr).contains("`maruyama` and `stochastic`"), "{}", text(&refused.stderr));
}

#[test]
fn ends_are_those_of_the_closed_form() {
    let file = declaration("ends.lag", SPRING);
    let varied = ["--vary", "x=20 cm..30 cm", "--vary", "k=1..3", "--vary", "push=-1..1"];
    let common = [&*file, "--until", "2", "--start", "angle=90deg", "--motions", "50"];
    let (names, rows) = table(&[&common, &varied[..]].concat());
    let head = ["t in s", "x in m", "angle in rad", "x_dot in m/s", "angle_dot in rad/s", "twice in m"];
    assert_eq!(names[..6], head);
    assert_eq!(names[6..], ["m in kg", "k in N/m", "push in N", "x at start in m"], "{names:?}");
    assert_eq!(rows.len(), 50);
    for row in &rows {
        let (omega, rest) = ((row[7] / row[6]).sqrt(), row[8] / row[7]);
        assert!((0.2..0.3).contains(&row[9]) && (1.0..3.0).contains(&row[7]), "{row:?}");
        assert!((row[1] - rest - (row[9] - rest) * (omega * 2.0).cos()).abs() < 1e-8, "{row:?}");
        assert!((row[5] - 2.0 * row[1]).abs() < 1e-15 && row[2] == std::f64::consts::FRAC_PI_2);
    }
    let spread = |column: usize| {
        let values = rows.iter().map(|row| row[column]);
        values.clone().fold(f64::MIN, f64::max) - values.fold(f64::MAX, f64::min)
    };
    assert!(spread(7) > 1.8, "values fill their range: {}", spread(7));
}

#[test]
fn quantities_vary_in_their_declared_ranges() {
    let file = declaration(
        "ranged.lag",
        "param k: N/m in 1..=3 = 2, m: kg > 0 = 1; coord x: cm in -20..=30 = 5; range dot(x) > -1;
        kinetic = 1/2 * m * dot(x)^2; potential = 1/2 * k * x^2;",
    );
    let common = [&*file, "--until", "0", "--motions", "400"];
    let (names, rows) = table(&[&common[..], &["--vary", "k", "--vary", "x"]].concat());
    let column = |name: &str| {
        let place = names.iter().position(|known| known.starts_with(name)).expect("a column");
        let values = rows.iter().map(move |row| row[place]);
        [values.clone().fold(f64::MAX, f64::min), values.fold(f64::MIN, f64::max)]
    };
    for (name, [low, high]) in [("k in", [1.0, 3.0]), ("x at start", [-0.2, 0.3])] {
        let [least, most] = column(name);
        assert!(low <= least && least < low + 0.02 * (high - low), "{name}: {least}");
        assert!(high - 0.02 * (high - low) < most && most < high, "{name}: {most}");
    }
    for (name, message) in [
        ("m", "error: --vary m: it has no declared range with two bounds: write `--vary m=0..1`"),
        ("x_dot", "error: --vary x_dot: it has no declared range with two bounds: write `--vary x_dot=0..1`"),
        ("y", "error: --vary: there is no `y`; known are `k`, `m`, `x`, `x_dot`"),
    ] {
        let refused = ensemble(&[&common[..], &["--vary", name]].concat());
        assert_eq!((refused.status.code(), text(&refused.stderr).trim()), (Some(2), message));
    }
}

#[test]
fn ends_depend_on_the_seed_alone() {
    let file = declaration("seed.lag", SPRING);
    let run = |more: &[&str]| {
        let common = [&*file, "--until", "1", "--vary", "x=0..1", "--set", "k=2", "--start", "angle=0"];
        ensemble(&[&common, more].concat()).stdout
    };
    assert_eq!(run(&["--threads", "1"]), run(&["--threads", "2", "--seed", "0"]));
    assert_ne!(run(&[]), run(&["--seed", "1"]));
    assert_eq!(text(&run(&[])).lines().count(), 101);
}

#[test]
fn motions_that_fail_are_rows_of_nan_and_named() {
    let file = declaration("fails.lag", "coord x; param a; kinetic = 1/2 * dot(x)^2; force x = 2 * x^3 * a;");
    // From x = 1 with ẋ = 1 and a = 1 it is 1/(1 − t), and regular for a near 0.
    let start = ["--start", "x=1", "--start", "x_dot=1", "--vary", "a=0..2", "--motions", "20"];
    let result = ensemble(&[&[&*file, "--until", "1.2"], &start[..]].concat());
    assert_eq!(result.status.code(), Some(3));
    let failed = text(&result.stdout).lines().filter(|line| line.contains("NaN")).count();
    assert!((1..20).contains(&failed), "{}", text(&result.stdout));
    let messages = text(&result.stderr);
    assert!(messages.lines().all(|line| line.matches(": motion ").count() == 1), "{messages}");
    assert_eq!(
        messages.lines().filter(|line| line.starts_with("error: motion ")).count(),
        failed,
        "{messages}"
    );
}

/// A member with a start out of its range, or with a delay that is none, fails by itself.
#[test]
fn members_with_values_that_make_no_sense_fail_alone() {
    let cases = [
        ("half.lag", "coord x in ..=1; kinetic = 1/2 * dot(x)^2;", "x=0..2", "the coordinate `x` is 1."),
        (
            "late.lag",
            "param lag = 1; state x = 1; dot(x) = -delay(x, lag);",
            "lag=-1..1",
            "the delay of `delayed_1` is -0.",
        ),
    ];
    for (name, text_of_file, range, message) in cases {
        let file = declaration(name, text_of_file);
        let result = ensemble(&[&file, "--until", "1", "--vary", range, "--motions", "40"]);
        assert_eq!(result.status.code(), Some(3), "{}", text(&result.stderr));
        let failed = text(&result.stdout).lines().filter(|line| line.contains("NaN")).count();
        assert!((8..32).contains(&failed), "{failed}");
        let messages = text(&result.stderr);
        assert_eq!(messages.lines().filter(|line| line.contains(message)).count(), failed, "{messages}");
    }
}

#[test]
fn a_start_follows_what_it_depends_on() {
    let file = declaration(
        "depends.lag",
        "param push = 1, m = 2; coord x = push; kinetic = 1/2 * m * dot(x)^2; start dot(x) = push / m;",
    );
    let (_, rows) = table(&[&file, "--until", "1", "--vary", "push=1..2", "--motions", "10"]);
    for row in rows {
        // The columns are t, x, x_dot, push and m.
        assert!((row[1] - 1.5 * row[3]).abs() < 1e-9 && (row[2] - row[3] / 2.0).abs() < 1e-12, "{row:?}");
    }
}

#[test]
fn a_file_is_written() {
    let file = declaration("file.lag", SPRING);
    let out = declaration("file.csv", "");
    let arguments =
        [&*file, "--until", "1", "--vary", "k=1..2", "--start", "x=1", "--start", "angle=0", "-o", &out];
    let result = ensemble(&arguments);
    assert_eq!((result.status.code(), text(&result.stdout), text(&result.stderr)), (Some(0), "", ""));
    assert_eq!(fs::read_to_string(&out).expect("written").lines().count(), 101);
}

#[test]
fn everything_that_makes_no_sense_is_refused() {
    let file = declaration("refused.lag", SPRING);
    let complete = ["--until", "1", "--set", "k=1", "--start", "x=0", "--start", "angle=0"];
    let mistakes: [(&[&str], &str); 16] = [
        (&["--vary", "m=1"], "error: --vary m=1: a range is missing: write `0..1`"),
        (&["--vary", "m=2..1"], "error: --vary m=2..1: the first number must be below the second"),
        (&["--vary", "m=1..1"], "error: --vary m=1..1: the first number must be below the second"),
        (&["--vary", "m=1..2 s"], "error: --vary m=2 s: this is a time (s), but `m` is declared in kg"),
        (
            &["--vary", "y=0..1"],
            "error: --vary: there is no `y`; known are `m`, `k`, `push`, `x`, `angle`, `x_dot`, `angle_dot`",
        ),
        (&["--vary", "m=1..2", "--vary", "m=2..3"], "error: `m` varies twice"),
        (&["--vary", "k=1..2"], "error: `k` varies: remove its `--set`"),
        (&["--vary", "x=1..2"], "error: `x` varies: remove its `--start`"),
        (&["--motions", "0"], "error: --motions 0: it must be from 1 to 10000000"),
        (&["--motions", "18446744073709551615"], "error: --motions 18446744073709551615: it must be"),
        (&["--threads", "0"], "error: --threads 0: at least one thread is needed"),
        (&["-o", "ends.svg"], "error: ends.svg: the extension must be one of csv"),
        (&["--motions", "many"], "error: --motions many: expected a whole number"),
        (&["--seed", "-1"], "error: --seed -1: expected a whole number"),
        (&["--method", "rk4"], "error: the method `rk4` needs a step: write `--step 0.01`"),
        (&["--every", "1"], "error: invalid option '--every'"),
    ];
    for (more, message) in mistakes {
        let result = ensemble(&[&[&*file], &complete[..], more].concat());
        let found = text(&result.stderr);
        assert!(result.status.code() == Some(2) && found.starts_with(message), "{more:?}: {found}");
    }
    let without_end = ensemble(&[&file, "--vary", "k=1..2", "--start", "x=0", "--start", "angle=0"]);
    assert!(text(&without_end.stderr).starts_with("error: the end is missing"));
    let without_start = ensemble(&[&file, "--until", "1", "--vary", "k=1..2", "--start", "angle=0"]);
    assert!(text(&without_start.stderr).starts_with("error: the start of `x` is missing"));
}
