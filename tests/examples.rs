//! Every example runs to its end, which means that it agrees with its reference. One does not: it measures for minutes.

use std::env;
use std::fs::read_dir;
use std::path::{Path, PathBuf};
use std::process::Command;

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

#[test]
fn agree_with_their_references() {
    let examples = examples();
    assert!(!examples.is_empty());
    for name in examples {
        let cargo = Command::new(env!("CARGO"))
            .args([
                "run",
                "--quiet",
                "--package",
                "lagrange",
                "--features",
                "plot,draw,symbolic",
                "--example",
                &name,
            ])
            .output();
        let output = cargo.expect("cargo starts");
        let messages = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{name}: {messages}");
        assert!(!output.stdout.is_empty(), "{name} prints nothing");
    }
}
