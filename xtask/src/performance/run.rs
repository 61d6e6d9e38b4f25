//! Programs to run, and the rows of the tables that they print.

use std::env;
use std::path::Path;
use std::process::Command;

/// The target processor, with its compiler flags.
pub(super) struct Target {
    pub(super) name: &'static str,
    pub(super) flags: &'static str,
}

pub(super) const DEFAULT: Target = Target { name: "default", flags: "" };
pub(super) const NATIVE: Target = Target { name: "native", flags: "-C target-cpu=native" };

/// Returns the output of `cargo` in a folder, compiled for a target in its own folder.
pub(super) fn cargo(
    root: &Path,
    folder: &Path,
    target: &Target,
    arguments: &[&str],
) -> Result<String, String> {
    eprintln!("{}: cargo {}", target.name, arguments.join(" "));
    let program = env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let own = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), Into::into);
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).env("RUSTFLAGS", target.flags);
    command.env("CARGO_TARGET_DIR", own.join("performance").join(target.name));
    output(&mut command)
}

/// Returns the output of a command.
pub(super) fn output(command: &mut Command) -> Result<String, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let result = command.stderr(std::process::Stdio::inherit()).output();
    let output = result.map_err(|error| format!("{name}: {error}"))?;
    if !output.status.success() {
        return Err(format!("{name} failed: {}", output.status));
    }
    String::from_utf8(output.stdout).map_err(|error| format!("{name}: {error}"))
}

/// Returns the cells of the rows of a Markdown table that end with numbers.
pub(super) fn rows(text: &str) -> impl Iterator<Item = Vec<&str>> {
    let lines = text.lines().filter_map(|line| line.strip_prefix('|')?.strip_suffix('|'));
    let rows = lines.map(|line| line.split('|').map(str::trim).collect::<Vec<_>>());
    rows.filter(|cells| cells.last().is_some_and(|last| last.parse::<f64>().is_ok()))
}
