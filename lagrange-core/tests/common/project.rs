//! Crates that tests generate, outside the workspace.

use std::fs;
use std::path::Path;
use std::process::Command;

/// Writes a library that depends on `lagrange`, and returns `cargo` in its folder.
pub(crate) fn project(name: &str, code: &str) -> Command {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
         lagrange = {{ path = {root:?} }}\n"
    );
    fs::create_dir_all(directory.join("src")).expect("a directory");
    fs::write(directory.join("Cargo.toml"), manifest).expect("a file");
    fs::write(directory.join("src/lib.rs"), code).expect("a file");
    fs::copy(root.join("Cargo.lock"), directory.join("Cargo.lock")).expect("a file");
    println!("compiled in {}", directory.display());
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(directory);
    cargo
}
