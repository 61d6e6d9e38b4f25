//! Rules for loops over tokens and for paths in emitted code, checked in the sources.

use std::fs;
use std::path::{Path, PathBuf};

/// A source file without tests and comments.
struct Source {
    path: String,
    code: String,
}

/// A loop over tokens that takes none asks for memory without end. So all such loops are in
/// `Cursor` and in `Parser::turns`, which prevent that; others empty a stack.
#[test]
fn loops_over_tokens_are_in_one_place() {
    let mut wrong = Vec::new();
    for Source { path, code } in sources().into_iter().filter(|source| source.path.starts_with("syntax/")) {
        let is_place = ["syntax/cursor.rs", "syntax/recovery.rs"].contains(&path.as_str());
        for line in code.lines().map(str::trim).filter(|_| !is_place) {
            let is_loop = ["while ", "loop {", "loop "].iter().any(|word| line.starts_with(word))
                || [" while ", " loop {"].iter().any(|word| line.contains(word));
            if is_loop && !line.contains(".pop") {
                wrong.push(format!("{path} has `{line}`"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn emitted_code_names_only_core_and_the_crate() {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let emitted = files(&golden).into_iter().filter(|path| path.ends_with("code.rs")).collect::<Vec<_>>();
    assert!(!emitted.is_empty());
    for path in emitted {
        let text = fs::read_to_string(&path).expect("a file");
        let code = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<String>();
        let mut before = ' ';
        for (at, c) in code.char_indices() {
            let starts_path =
                code[at..].starts_with("::") && !before.is_alphanumeric() && !"_>:".contains(before);
            let known = ["::core::", "::lagrange::"].iter().any(|root| code[at..].starts_with(root));
            assert!(!starts_path || known, "{}: {:.40}", path.display(), &code[at..]);
            before = c;
        }
        assert!(!code.contains("std::") && !code.contains("alloc::"), "{}", path.display());
    }
}

/// Returns the files of the crate that are not tests.
fn sources() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let is_test = |path: &str| path.split(['/', '.']).any(|part| part == "tests");
    let sources = files(&root).into_iter().filter(|path| path.extension().is_some_and(|e| e == "rs"));
    let sources = sources.map(|path| {
        let text = fs::read_to_string(&path).expect("a source file");
        let path = path.strip_prefix(&root).expect("below the root").to_string_lossy().replace('\\', "/");
        let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
        let code = code.lines().filter(|line| !line.trim_start().starts_with("//"));
        Source { path, code: code.collect::<Vec<_>>().join("\n") }
    });
    sources.filter(|source| !is_test(&source.path)).collect()
}

fn files(directory: &Path) -> Vec<PathBuf> {
    let mut pending = vec![directory.to_owned()];
    let mut found = Vec::new();
    while let Some(path) = pending.pop() {
        if path.is_dir() {
            let entries = fs::read_dir(path).expect("a directory");
            pending.extend(entries.map(|entry| entry.expect("an entry").path()));
        } else {
            found.push(path);
        }
    }
    found.sort();
    found
}
