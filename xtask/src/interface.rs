//! The public interface: lists of it, and its changes since a revision.
//!
//! Both tools work on a clone in `target/interface`, so uncommitted changes are neither seen nor
//! touched.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::step::Step;

/// Crates whose items users name. `lagrange` re-exports most of them and has few items of its own.
const CRATES: [&str; 5] =
    ["lagrange-runtime", "lagrange-double", "lagrange-draw", "lagrange-dynamic", "lagrange-plot"];

/// Lists all public items of the last commit, a file for each crate. With a revision, reports
/// changes since then: those that break users, then all additions and removals.
pub(crate) fn interface(root: &Path, revision: Option<&str>) -> Result<(), String> {
    let folder = root.join("target").join("interface");
    let tree = cloned(root, &folder)?;
    let Some(revision) = revision else { return listed(&tree, &folder) };
    let old = output(root, &["rev-parse", "--verify", &format!("{revision}^{{commit}}")])?;
    let mut failures = Vec::new();
    for step in steps(old.trim()) {
        let step = step.with("CARGO_TARGET_DIR", folder.join("build").to_string_lossy());
        if !step.run(&tree) {
            failures.push(step.title);
        }
    }
    if failures.is_empty() { Ok(()) } else { Err(format!("failed: {}", failures.join(", "))) }
}

fn steps(old: &str) -> Vec<Step> {
    let packages = CRATES.map(|name| format!("--package {name}")).join(" ");
    let breaking = format!("semver-checks {packages} --all-features --baseline-rev {old}");
    let mut steps = vec![Step::new("changes that break users", &breaking)];
    steps.extend(CRATES.map(|name| {
        Step::new(&format!("interface of {name}"), &format!("{} diff {old}..HEAD", public_api(name)))
    }));
    steps
}

/// Returns the arguments of a list of the items of a crate, without derived and blanket ones.
fn public_api(name: &str) -> String {
    format!("public-api --package {name} --all-features -sss")
}

/// Writes lists of the items of all crates.
fn listed(tree: &Path, folder: &Path) -> Result<(), String> {
    for name in CRATES {
        let mut cargo = Command::new("cargo");
        cargo.args(public_api(name).split_whitespace()).env("CARGO_TARGET_DIR", folder.join("build"));
        let path = folder.join(format!("{name}.txt"));
        let items = read(cargo.current_dir(tree))?;
        fs::write(&path, &items).map_err(|error| format!("{}: {error}", path.display()))?;
        println!("{}: {} public items", path.display(), items.lines().count());
    }
    Ok(())
}

/// Clones the last commit, and returns the folder of the clone.
fn cloned(root: &Path, folder: &Path) -> Result<PathBuf, String> {
    let tree = folder.join("tree");
    let head = output(root, &["rev-parse", "HEAD"])?;
    if !tree.exists() {
        fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        output(root, &["clone", "--quiet", "--no-checkout", ".", &tree.to_string_lossy()])?;
    }
    output(&tree, &["fetch", "--quiet", "origin"])?;
    output(&tree, &["checkout", "--quiet", "--force", "--detach", head.trim()])?;
    Ok(tree)
}

/// Returns the output of a command of git.
fn output(folder: &Path, arguments: &[&str]) -> Result<String, String> {
    read(Command::new("git").args(arguments).current_dir(folder))
}

/// Returns what a command prints; an error if it fails.
fn read(command: &mut Command) -> Result<String, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let result = command.stderr(std::process::Stdio::inherit()).output();
    let found = result.map_err(|error| format!("{name} cannot be started: {error}"))?;
    match found.status.success() {
        true => Ok(String::from_utf8_lossy(&found.stdout).into_owned()),
        false => Err(format!("{name} {:?} failed", command.get_args().collect::<Vec<_>>())),
    }
}
