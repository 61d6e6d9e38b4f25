//! Proposals of methods on the command line, verified by running them.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const SWING: &str = "tests/data/swing.lag";
/// A state that follows a pendulum at a million times its rate.
const STIFF: &str = "struct Stiff; coord x = 1; state y = 0; kinetic = 1/2 * dot(x)^2; potential = 1/2 * x^2;
    dot(y) = -1e6 * (y - x);";
/// A bouncing ball that an event stops.
const STOP: &str = "struct Ball; coord y = 1; kinetic = 1/2 * dot(y)^2; potential = 9.81 * y + sin(y);
    event floor = y, falling => { dot(y) = -0.7 * dot(y); } event end = t + y - 1.3, rising => stop;";

fn run(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lagrange"));
    command.args(arguments).output().expect("the command starts")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

fn declaration(name: &str, text: &str) -> String {
    let path = temporary(name);
    fs::write(&path, text).expect("written");
    path.to_str().expect("UTF-8").to_owned()
}

fn temporary(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Returns the last row of a motion.
fn end(file: &str, until: &str, options: &[&str]) -> Vec<f64> {
    let result = run(&[&["simulate", file, "--until", until], options].concat());
    assert_eq!(result.status.code(), Some(0), "{options:?}: {}", text(&result.stderr));
    let last = text(&result.stdout).lines().last().expect("a row");
    last.split(',').map(|cell| cell.parse().expect("a number")).collect()
}

/// Runs the proposal for an error against a run with the finer options `reference`.
fn try_proposal(file: &str, until: &str, error: f64, reference: &[&str]) -> String {
    let wanted = error.to_string();
    let result = run(&["trade", file, "--until", until, "--error", &wanted, "--longest", "0.01"]);
    assert_eq!(result.status.code(), Some(0), "{}", text(&result.stderr));
    let lines = text(&result.stdout).lines().collect::<Vec<_>>();
    let [proposal, _, in_rust] = lines[..] else { panic!("{lines:?}") };
    let setting = proposal.rsplit(' ').next().and_then(|text| text.parse::<f64>().ok()).expect("a number");
    assert!(
        in_rust.starts_with("in Rust: .method(") && in_rust.contains(&format!("{setting:?}")),
        "{in_rust}"
    );
    let proposal = proposal.to_owned();
    let found = end(file, until, &proposal.split(' ').collect::<Vec<_>>());
    for (found, exact) in found.iter().zip(end(file, until, reference)) {
        assert!((found - exact).abs() <= error, "{proposal}: {found} instead of {exact}");
    }
    proposal
}

#[test]
fn proposals_keep_their_promise() {
    for error in [1e-2, 1e-5, 1e-8] {
        try_proposal(SWING, "1", error, &["--tolerance", "1e-14"]);
    }
    let stop = declaration("stop.lag", STOP);
    for error in [1e-2, 1e-8] {
        try_proposal(&stop, "3", error, &["--tolerance", "1e-14"]);
    }
}

#[test]
fn series_are_measured_where_they_exist() {
    let folder = temporary("series_of_trade");
    let path = folder.to_str().expect("UTF-8");
    let wave =
        declaration("wave.lag", "struct Wave; coord x = 1; kinetic = 1/2 * dot(x)^2; force x = -sin(x);");
    let result = run(&["trade", &wave, "--until", "2", "--longest", "0.01", "-o", path]);
    assert_eq!(result.status.code(), Some(0), "{}", text(&result.stderr));
    let files = fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("a file").path());
    let csv = files.filter(|path| path.extension().is_some_and(|extension| extension == "csv"));
    let rows = csv.map(|path| fs::read_to_string(path).expect("text")).collect::<String>();
    assert!(rows.contains("taylor") && rows.contains("Taylor series"), "{rows}");
    let by = |method| end(&wave, "2", &["--method", method, "--tolerance", "1e-12"]);
    let [series, pair] = [by("taylor"), by("verner")];
    assert!((series[1] - pair[1]).abs() < 1e-11, "{series:?} {pair:?}");
}

#[test]
fn a_stiff_system_gets_the_method_for_it() {
    let stiff = declaration("stiff.lag", STIFF);
    let proposal = try_proposal(&stiff, "0.1", 1e-5, &["--method", "radau", "--tolerance", "1e-11"]);
    assert!(proposal.starts_with("--method radau "), "{proposal}");
}

#[test]
fn the_table_has_a_line_for_each_error_and_all_runs_are_saved() {
    let folder = temporary("trade");
    let path = folder.to_str().expect("UTF-8");
    let result = run(&["trade", SWING, "--until", "1", "--longest", "0.01", "-o", path]);
    assert_eq!((result.status.code(), text(&result.stderr)), (Some(0), ""));
    let lines = text(&result.stdout).lines().collect::<Vec<_>>();
    assert!(lines.len() == 9 && lines[1..8].iter().all(|line| line.starts_with("1e-")), "{lines:?}");
    for extension in ["csv", "md", "svg"] {
        assert!(folder.join(format!("swing.{extension}")).is_file(), "{extension}");
    }
}

#[test]
fn unmeasurable_motions_are_refused() {
    let ending = declaration("ends.lag", "coord x = 0; kinetic = 1/2 * dot(x)^2; force x = sqrt(1/2 - t);");
    let stack = declaration(
        "stack.lag",
        "gravity = (0, 0, -9.81); body a { mass: 1; shape: cuboid(1, 1, 1); } free a;
         body b { mass: 1; shape: cuboid(1, 1, 1); } free b; start b_z = 2; contact touch = b on a;",
    );
    let cases: [(&str, &[&str], i32, &str); 10] = [
        (SWING, &[], 2, "the end is missing"),
        (SWING, &["--until", "0"], 2, "the motion has no duration"),
        (SWING, &["--until", "1", "--error", "0"], 2, "--error 0: expected a positive number"),
        (SWING, &["--until", "1", "--error", "1 kg"], 2, "--error 1 kg: "),
        (SWING, &["--until", "1", "--longest", "-1"], 2, "--longest -1: expected a positive number"),
        (SWING, &["--until", "1", "--start", "phi=1"], 2, "no `phi`"),
        (SWING, &["--until", "1", "--every", "0.1"], 2, "--every"),
        (SWING, &["--until", "1", "--error", "1e-30", "--longest", "0.01"], 3, "longer `--longest`"),
        (&stack, &["--until", "1"], 3, "needs the method `Stepped`"),
        (&ending, &["--until", "1"], 3, "no method with a tolerance reaches the end"),
    ];
    for (file, arguments, code, message) in cases {
        let result = run(&[&["trade", file], arguments].concat());
        let errors = text(&result.stderr);
        assert_eq!(result.status.code(), Some(code), "{arguments:?}: {errors}");
        assert!(errors.contains(message) && result.stdout.is_empty(), "{arguments:?}: {errors}");
    }
}
