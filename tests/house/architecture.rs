//! The tables of layers as `ARCHITECTURE.md` shows them, between two comments.

use std::path::Path;
use std::{env, fs};

use crate::book::book;
use crate::tables::{LIBRARIES, Library};

const START: &str = "<!-- Layers: tests/house/tables.rs -->\n";
const END: &str = "<!-- End of layers -->\n";

/// Compares the document with the tables, or writes them to it if `UPDATE_ARCHITECTURE` is set.
pub(crate) fn check(root: &Path) {
    let path = root.join("ARCHITECTURE.md");
    let text = fs::read_to_string(&path).expect("the document");
    let updated = with_tables(&text).expect("two comments in ARCHITECTURE.md around the tables of layers");
    if env::var_os("UPDATE_ARCHITECTURE").is_some() {
        fs::write(&path, updated).expect("the document can be written");
    } else {
        assert!(text == updated, "ARCHITECTURE.md does not show the layers; they are\n\n{}", tables());
    }
}

/// Beginnings of paths of the project.
const FOLDERS: [&str; 7] = ["crates/", "docs/", "examples/", "lagrange-", "src/", "tests/", "tools/"];

/// Finds files and folders in backticks in the documents of the project that do not exist.
pub(crate) fn missing_paths(root: &Path) -> Vec<String> {
    let others = ["ARCHITECTURE.md", "README.md", "tests/README.md"].map(str::to_owned);
    let mut missing = Vec::new();
    for document in others.into_iter().chain(book(root)) {
        let text = fs::read_to_string(root.join(&document)).expect("a document");
        let quoted = paths(&text).filter(|path| !root.join(path).exists());
        missing.extend(quoted.map(|path| format!("{document} names `{path}`, which does not exist")));
    }
    missing
}

/// Returns the paths of the project that a text quotes in backticks.
fn paths(text: &str) -> impl Iterator<Item = &str> {
    let is_of_path = |sign: char| sign.is_ascii_alphanumeric() || "_./-".contains(sign);
    let quoted = text.split('`').skip(1).step_by(2);
    quoted.filter(move |word| {
        let begins = FOLDERS.iter().any(|folder| word.starts_with(folder));
        begins && word.contains('/') && word.chars().all(is_of_path)
    })
}

/// Returns the document with the tables between the comments.
fn with_tables(text: &str) -> Option<String> {
    let (before, rest) = text.split_once(START)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{START}\n{}{END}{after}", tables()))
}

/// Returns one table for each crate with modules, in Markdown.
fn tables() -> String {
    LIBRARIES.iter().filter(|library| !library.layers.is_empty()).map(table).collect()
}

fn table(library: &Library) -> String {
    let rows = library.layers.iter().map(|layer| {
        let modules = layer.modules.iter().map(|module| format!("`{module}`")).collect::<Vec<_>>();
        format!("| {} | {} |\n", modules.join(", "), layer.purpose)
    });
    let name = library.name;
    format!("| layer of `{name}` | responsibility |\n|---|---|\n{}\n", rows.collect::<String>())
}

#[cfg(test)]
mod tests {
    use crate::architecture::{END, START, paths, with_tables};

    #[test]
    fn tables_go_between_the_comments() {
        let text = format!("before\n{START}stale\n{END}after\n");
        let updated = with_tables(&text).expect("comments");
        assert!(
            updated.starts_with("before\n") && updated.ends_with("after\n") && !updated.contains("stale")
        );
        assert_eq!(with_tables(&updated).as_ref(), Some(&updated));
        assert_eq!(with_tables("no comments"), None);
    }

    #[test]
    fn paths_are_quoted_words_with_a_folder() {
        let text = "See `src/lib.rs`, `tests/house`, `a / b`, `src/*.rs` and `lagrange-core`.";
        assert_eq!(paths(text).collect::<Vec<_>>(), ["src/lib.rs", "tests/house"]);
    }
}
