//! Every example runs to its end, which means that it agrees with its reference. One does not: it measures for minutes.

use std::env;
use std::fs::read_dir;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread::{self, available_parallelism};

/// What measures and checks nothing.
const MEASUREMENT: &str = "trade";

fn examples() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    let files =
        read_dir(folder).expect("the examples are in place").map(|entry| entry.expect("readable").path());
    let stem = |file: PathBuf| file.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let mut names = files
        .filter(|file| file.is_file())
        .filter_map(stem)
        .filter(|name| name != MEASUREMENT)
        .collect::<Vec<_>>();
    names.sort();
    names
}

/// Cargo for the examples with all that they can use.
fn cargo(command: &str, what: &[&str]) -> Command {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args([command, "--quiet", "--package", "lagrange", "--features", "plot,draw,symbolic"]).args(what);
    cargo
}

fn run(name: &str) {
    let output = cargo("run", &["--example", name]).output().expect("cargo starts");
    let messages = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{name}: {messages}");
    assert!(!output.stdout.is_empty(), "{name} prints nothing");
}

/// All are built first, since builds wait for each other.
#[test]
fn agree_with_their_references() {
    let examples = examples();
    assert!(!examples.is_empty());
    let output = cargo("build", &["--examples"]).output().expect("cargo starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let at_once = available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for names in examples.chunks(examples.len().div_ceil(at_once)) {
            scope.spawn(move || names.iter().for_each(|name| run(name)));
        }
    });
}
