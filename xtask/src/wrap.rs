//! `cargo xtask wrap`: wraps the comments of Rust files and the paragraphs of pages according to
//! the house rules.

use std::path::Path;

use crate::prose::{long_sentences, wrapped};
use crate::size::git;

/// Folders with generated files, or files compared byte by byte.
const KEPT: [&str; 2] = ["lagrange-core/tests/golden/", "tests/ui/"];

/// Wraps the files tracked by git and prints those that changed.
pub(crate) fn wrap(root: &Path) -> Result<(), String> {
    for (file, text) in texts(root)? {
        let wrapped = wrapped(&text, file.ends_with(".rs"));
        if wrapped != text {
            std::fs::write(root.join(&file), wrapped).map_err(|error| format!("{file}: {error}"))?;
            println!("{file}");
        }
    }
    Ok(())
}

/// Prints the positions of long sentences.
pub(crate) fn sentences(root: &Path) -> Result<(), String> {
    for (file, text) in texts(root)? {
        for (line, beginning) in long_sentences(&text, file.ends_with(".rs")) {
            println!("{file}:{line}: {beginning} …");
        }
    }
    Ok(())
}

/// Returns the texts of the files tracked by git, by their paths.
fn texts(root: &Path) -> Result<Vec<(String, String)>, String> {
    let listed = git(root, &["ls-files", "*.rs", "*.md"])?;
    let files = listed.lines().filter(|file| !KEPT.iter().any(|folder| file.starts_with(folder)));
    let read = |file: &str| std::fs::read_to_string(root.join(file)).map(|text| (file.to_owned(), text));
    files.map(|file| read(file).map_err(|error| format!("{file}: {error}"))).collect()
}
