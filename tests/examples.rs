//! Every example runs to its end, which means that it agrees with its reference. One is left out:
//! it measures for minutes.

use std::env;
use std::fs::read_dir;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{self, available_parallelism};

/// An example that measures and checks nothing.
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

/// The packages and features of `cargo verify`, for which examples are already built.
const AS_VERIFIED: [&str; 4] = [
    "--workspace",
    "--exclude=lagrange-adapters-tests",
    "--exclude=lagrange-benches",
    "--features=lagrange-tests/draw,lagrange-tests/ensemble,lagrange-tests/fit,lagrange-tests/linear,lagrange-tests/parquet,lagrange-tests/plot,lagrange-tests/symbolic,lagrange-tests/trade,xtask/performance",
];

/// Returns the folder in which cargo puts examples, beside that of this test.
fn folder_of_examples() -> PathBuf {
    let this = env::current_exe().expect("this test is a file");
    this.parent().and_then(Path::parent).expect("a folder of tests in a folder of a profile").join("examples")
}

fn run(folder: &Path, name: &str) {
    let output = Command::new(folder.join(name)).output().unwrap_or_else(|error| panic!("{name}: {error}"));
    let messages = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{name}: {messages}");
    assert!(!output.stdout.is_empty(), "{name} prints nothing");
}

#[test]
fn agree_with_their_references() {
    let examples = examples();
    assert!(!examples.is_empty());
    let cargo =
        Command::new(env!("CARGO")).args(["build", "--quiet", "--examples"]).args(AS_VERIFIED).output();
    let output = cargo.expect("cargo starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let (folder, at_once) = (folder_of_examples(), available_parallelism().map_or(1, usize::from));
    // Some take seconds, most do not, so each thread takes the next one.
    let next = AtomicUsize::new(0);
    let run_next = || examples.get(next.fetch_add(1, Ordering::Relaxed)).map(|name| run(&folder, name));
    thread::scope(|scope| {
        for _ in 0..at_once {
            scope.spawn(|| while run_next().is_some() {});
        }
    });
}

#[test]
fn examples_are_built_as_all_tests_are() {
    let aliases = include_str!("../.cargo/config.toml");
    assert!(AS_VERIFIED.iter().all(|argument| aliases.contains(&format!("\"{argument}\""))), "{aliases}");
}
