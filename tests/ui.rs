//! The compiler's messages about mistakes: each file of `ui/`, in the folder of the rule that it
//! breaks.

use std::fs;
use std::path::Path;

#[test]
fn mistakes_are_explained_where_they_are() {
    trybuild::TestCases::new().compile_fail("ui/*/*.rs");
}

/// Messages about missing features; `cargo test -p lagrange-tests --test ui`, without any feature.
#[cfg(not(any(feature = "plot", feature = "parquet", feature = "draw")))]
#[test]
fn missing_features_are_named() {
    trybuild::TestCases::new().compile_fail("ui_without_features/*.rs");
}

/// Each declaration in the folder `one_mistake` contains one mistake, for which the compiler
/// reports no second error.
#[test]
fn one_mistake_is_one_error() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("ui/one_mistake");
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let sources = files.filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    let mut declarations = 0;
    for path in sources {
        let read = |path: &Path| fs::read_to_string(path).expect("a file");
        let (source, answer) = (read(&path), read(&path.with_extension("stderr")));
        let mistakes = source.matches("lagrange::system!").count();
        let errors = answer.lines().filter(|line| line.starts_with("error")).count();
        assert_eq!(errors, mistakes, "{}:\n{answer}", path.display());
        assert_eq!(answer.matches("help: ").count(), mistakes, "{}:\n{answer}", path.display());
        declarations += mistakes;
    }
    assert!(declarations > 15, "{declarations}");
}

/// Errors include related locations in their text, with file, line and column.
#[test]
fn no_error_is_a_note() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("ui");
    let folders = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let files = folders.flat_map(|folder| fs::read_dir(folder).expect("a folder"));
    let answers = files.map(|entry| entry.expect("an entry").path());
    let answers = answers.filter(|path| path.extension().is_some_and(|extension| extension == "stderr"));
    let mut notes = 0;
    for path in answers {
        let answer = fs::read_to_string(&path).expect("a file");
        assert!(!answer.contains("error: note"), "{}:\n{answer}", path.display());
        notes += answer.matches("note at $DIR/ui/").count();
    }
    assert!(notes > 30, "{notes}");
}
