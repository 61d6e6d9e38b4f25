//! Accepted mutants as modules of a crate that the compiler checks.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

/// Checks as many of the cases as are asked for, evenly spread, with all warnings denied.
pub(crate) fn without_warnings(cases: &[usize], text: impl Fn(usize) -> String) {
    let Ok(wanted) = env::var("LAGRANGE_MUTANTS_COMPILED") else { return };
    let wanted: usize = wanted.parse().expect("LAGRANGE_MUTANTS_COMPILED is a number");
    let chosen = cases.iter().step_by((cases.len() / wanted.max(1)).max(1)).take(wanted);
    // What nobody uses is not what is tested here.
    let mut code = "#![deny(warnings)]\n#![allow(dead_code)]\n".to_owned();
    for &case in chosen {
        let declaration = text(case);
        writeln!(code, "pub mod mutant_{case} {{\n    lagrange::system! {{ {declaration} }}\n}}")
            .expect("a string");
    }
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mutants");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let manifest = format!(
        "[package]\nname = \"mutants\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
         lagrange = {{ path = {root:?} }}\n"
    );
    fs::create_dir_all(directory.join("src")).expect("a directory");
    fs::write(directory.join("Cargo.toml"), manifest).expect("a file");
    fs::write(directory.join("src/lib.rs"), code).expect("a file");
    fs::copy(root.join("Cargo.lock"), directory.join("Cargo.lock")).expect("a file");
    let mut cargo = Command::new(env!("CARGO"));
    let status = cargo.args(["check", "--offline"]).current_dir(&directory).status();
    assert!(status.expect("cargo runs").success(), "see {}", directory.display());
}
