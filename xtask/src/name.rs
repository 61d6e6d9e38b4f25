//! `cargo xtask name NAME`: the name of the package `lagrange` on the registry.
//!
//! The name is a constant: that of the package in the manifest of the workspace. Cargo has no
//! variables, so dependencies repeat it in manifests, pages, messages and scripts. The library is
//! called `lagrange` under any name.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::package::output;

/// Renames the package throughout the repository, and updates the lock files.
pub(crate) fn name(root: &Path, new: &str) -> Result<(), String> {
    if !new.starts_with(|first: char| first.is_ascii_alphabetic()) || !new.chars().all(is_of_name) {
        return Err(format!("not a name of a package: {new}"));
    }
    let files = files(root)?;
    for (path, text) in changed(root, &files, new)? {
        fs::write(root.join(&path), text).map_err(|error| format!("{path}: {error}"))?;
        println!("{path}");
    }
    let locks = files
        .iter()
        .filter_map(|path| root.join(path).parent().filter(|_| is_lock(path)).map(Path::to_owned));
    for folder in locks {
        output(Command::new("cargo").args(["update", "--workspace", "--quiet"]).current_dir(folder))?;
    }
    Ok(())
}

fn is_lock(path: &str) -> bool {
    path == "Cargo.lock" || path.ends_with("/Cargo.lock")
}

/// Returns the name of the package.
pub(crate) fn current(root: &Path) -> Result<String, String> {
    let manifest = fs::read_to_string(root.join("Cargo.toml")).map_err(|error| error.to_string())?;
    let name = manifest.split_once("[package]\nname = \"").and_then(|(_, rest)| rest.split_once('"'));
    name.map(|(name, _)| name.to_owned()).ok_or_else(|| "Cargo.toml names no package".to_owned())
}

/// Lists all files of the repository, except the history and this file, whose tests contain the
/// name.
fn files(root: &Path) -> Result<Vec<String>, String> {
    let listed = output(Command::new("git").arg("ls-files").current_dir(root))?;
    let lasting = |path: &&str| !["CHANGELOG.md", "xtask/src/name.rs"].contains(path);
    Ok(listed.lines().filter(lasting).map(str::to_owned).collect())
}

/// Returns the texts that change with the name.
fn changed(root: &Path, files: &[String], new: &str) -> Result<Vec<(String, String)>, String> {
    let old = current(root)?;
    // Files that are no text, and links to folders, name no package.
    let texts = files.iter().filter_map(|path| Some((path, fs::read_to_string(root.join(path)).ok()?)));
    let renamed = texts.map(|(path, text)| (path.clone(), renamed(&text, &old, new), text));
    Ok(renamed.filter(|(_, now, text)| now != text).map(|(path, now, _)| (path, now)).collect())
}

/// Returns a text in which dependencies on a package have its new name.
fn renamed(text: &str, old: &str, new: &str) -> String {
    // A key without `path` is that of `[workspace.dependencies]`, which is the library's name.
    const MENTIONS: [(&str, &str); 8] = [
        ("[package]\nname = \"", "\""),
        ("package = \"", "\""),
        ("", " = { path"),
        ("", " = {{ path"),
        ("", " = { …"),
        ("", " = {{ …"),
        ("cargo add ", " "),
        ("cargo run --features ", "/"),
    ];
    MENTIONS.iter().fold(text.to_owned(), |text, (before, after)| {
        let (found, replacement) = (format!("{before}{old}{after}"), format!("{before}{new}{after}"));
        let mut pieces = text.split(&found);
        let mut renamed = pieces.next().unwrap_or_default().to_owned();
        for piece in pieces {
            let is_end_of_name = before.is_empty() && renamed.ends_with(is_of_name);
            renamed += if is_end_of_name { &found } else { &replacement };
            renamed += piece;
        }
        renamed
    })
}

fn is_of_name(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || "-_".contains(letter)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::{Path, PathBuf};
    use std::process::Command;

    use super::{changed, files, name, renamed};
    use crate::package::output;

    #[test]
    fn cargo_resolves_all_dependencies_under_another_name() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("a folder of the workspace");
        let copy = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../target/renamed");
        drop(fs::remove_dir_all(&copy));
        let mut files = files(root).expect("git lists files");
        files.retain(|path| [".toml", ".rs", ".lock"].iter().any(|end| path.ends_with(end)));
        let write = |path: &str, text: &str| {
            let path = copy.join(path);
            fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            fs::write(path, text).expect("a file");
        };
        files.iter().for_each(|path| write(path, &fs::read_to_string(root.join(path)).expect("a text")));
        let changed = changed(root, &files, "another-name").expect("a name");
        changed.iter().for_each(|(path, text)| write(path, text));
        let tree = [
            "tree",
            "--offline",
            "--workspace",
            "--invert",
            "another-name",
            "--depth",
            "1",
            "--prefix",
            "none",
        ];
        let dependents =
            output(Command::new(env!("CARGO")).args(tree).current_dir(&copy)).expect("a workspace");
        for name in ["another-name", "lagrange-tests", "lagrange-book-tests", "renamed", "no_std"] {
            assert!(dependents.lines().any(|line| line.starts_with(&format!("{name} v"))), "{dependents}");
        }
        // Workspaces of their own, whose dependencies may not have been downloaded.
        for folder in ["crates/lagrange-jit", "examples/device", "examples/mpi"] {
            let (_, manifest) =
                changed.iter().find(|(path, _)| *path == format!("{folder}/Cargo.toml")).expect(folder);
            assert!(manifest.contains("lagrange = { package = \"another-name\", path"), "{manifest}");
        }
    }

    #[test]
    fn only_the_package_is_renamed() {
        let kept =
            "use lagrange::Simulate;\nlagrange = { workspace = true }\nlagrange-core = { path = \"..\" }";
        assert_eq!(renamed(kept, "lagrange", "b"), kept);
        let manifest = "lagrange = { path = \"../lagrange\" }\nm = { package = \"lagrange\" }\ncargo add lagrange --path";
        let expected = "b = { path = \"../lagrange\" }\nm = { package = \"b\" }\ncargo add b --path";
        assert_eq!(renamed(manifest, "lagrange", "b"), expected);
        let longer = "draw = { path = \"..\" }\nlagrange-draw = { path = \"../draw\" }";
        assert_eq!(renamed(longer, "draw", "b"), longer.replacen("draw", "b", 1));
    }

    #[test]
    fn names_that_are_none_are_refused() {
        for none in ["", "9x", "-x", "a b", "Schrödinger"] {
            let error = name(Path::new("nowhere"), none).expect_err(none);
            assert_eq!(error, format!("not a name of a package: {none}"));
        }
    }
}
