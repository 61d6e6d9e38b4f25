//! Fields of each published package that the registry shows, and files that licences require.

use std::fs;
use std::path::Path;

use crate::workspace::folders;

/// Beginnings of lines in a manifest. Fields that are the same for all packages are in the
/// workspace.
const LINES: [&str; 8] = [
    "description = \"",
    "version.workspace = true",
    "edition.workspace = true",
    "rust-version.workspace = true",
    "license",
    "repository.workspace = true",
    "keywords.workspace = true",
    "categories",
];
/// Line of a library by which its documentation shows the features that items need.
const SHOWN: &str = "#![cfg_attr(docsrs, feature(doc_cfg))]";
const FILES: [&str; 3] = ["LICENSE-APACHE", "LICENSE-MIT", "README.md"];

/// Finds missing fields and files of published packages.
pub(crate) fn lapses(root: &Path) -> Vec<String> {
    let mut lapses = Vec::new();
    for folder in folders(root) {
        let manifest = fs::read_to_string(root.join(&folder).join("Cargo.toml")).unwrap_or_default();
        if manifest.contains("\npublish = false\n") {
            continue;
        }
        let name = format!("{folder}Cargo.toml");
        lapses.extend(missing_lines(&manifest).iter().map(|line| format!("{name} has no `{line}`")));
        let library = fs::read_to_string(root.join(&folder).join("src/lib.rs")).unwrap_or_default();
        if hides_features(&manifest, &library) {
            lapses.push(format!("{folder}src/lib.rs has no `{SHOWN}`"));
        }
        let is_missing = |file: &&&str| !root.join(&folder).join(file).is_file();
        lapses.extend(FILES.iter().filter(is_missing).map(|file| format!("{name} has no {file} beside it")));
    }
    lapses
}

/// Returns the lines that a manifest lacks. Documentation shows all features where there are any.
fn missing_lines(manifest: &str) -> Vec<&'static str> {
    let section =
        |title: &str| manifest.split_once(title).map(|(_, rest)| rest.split("\n[").next().unwrap_or(rest));
    let package = section("\n[package]\n").or_else(|| section("[package]\n")).unwrap_or_default();
    let is_missing = |line: &&str| !package.lines().any(|known| known.starts_with(line));
    let shows_all =
        section("\n[package.metadata.docs.rs]").is_some_and(|rest| rest.contains("all-features = true"));
    let hides = section("\n[features]").is_some() && !shows_all;
    LINES.iter().copied().filter(is_missing).chain(hides.then_some("[package.metadata.docs.rs]")).collect()
}

/// True for a library with features on the documentation host, whose pages do not name them.
fn hides_features(manifest: &str, library: &str) -> bool {
    let has_features = manifest.contains("\n[package.metadata.docs.rs]") && !library.is_empty();
    has_features && !library.lines().any(|line| line == SHOWN)
}

#[cfg(test)]
mod tests {
    use super::{LINES, SHOWN, hides_features, missing_lines};

    #[test]
    fn libraries_with_features_name_them() {
        let manifest = "[package]\n\n[package.metadata.docs.rs]\nall-features = true\n";
        assert!(hides_features(manifest, "#![no_std]\n") && !hides_features("[package]\n", "#![no_std]\n"));
        assert!(!hides_features(manifest, &format!("//! A library.\n{SHOWN}\n")));
    }

    #[test]
    fn each_line_is_asked_for() {
        let whole = format!("[package]\n{}\n\n[features]\n", LINES.join("\n"));
        assert_eq!(missing_lines(&whole), ["[package.metadata.docs.rs]"]);
        let shown = format!("{whole}\n[package.metadata.docs.rs]\nall-features = true\n");
        assert!(missing_lines(&shown).is_empty());
        for line in LINES {
            assert_eq!(missing_lines(&shown.replacen(&format!("\n{line}\n"), "\n", 1)), [line]);
        }
    }
}
