//! Compiled programs of all declarations of the repository, with their Taylor series, have the bits
//! of the interpreter. That holds for random numbers, and among zeros, infinities, the smallest and
//! the largest numbers and NaN.

#[path = "../../../lagrange-core/tests/mutants/corpus.rs"]
mod corpus;
mod equality;

use std::fs;
use std::path::Path;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{Programs, parse_with};
use lagrange_core::tables::FileText;

/// Smallest number of declarations that are derived.
const FEWEST: usize = 930;
/// One program in so many may be too large to be compiled. Examples are the linear model of a
/// bicycle and the contact terms of a wall.
const PROGRAMS_PER_TOO_LARGE: usize = 1000;
/// Length of the longest declaration, in characters.
const LONGEST: usize = 20_000;

/// Reads a file of a declaration, whose path is relative to its package.
fn file(path: &str) -> Result<FileText, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let texts = ["", "examples", "tests"].map(|package| fs::read_to_string(root.join(package).join(path)));
    let text = texts.into_iter().find_map(Result::ok).ok_or("there is no such file")?;
    Ok(FileText { path: path.to_owned(), text })
}

#[test]
fn all_programs_of_all_declarations_have_the_bits_of_the_interpreter() {
    let mut checked = equality::Checked::default();
    let mut systems = 0;
    for declaration in corpus::declarations(LONGEST) {
        let text = declaration.pieces.join(" ");
        let derived = parse_with(&text, &file)
            .and_then(|system| system.with(Product::Taylor).derive(StrategyChoice::Cheapest));
        // Some declarations are examples of mistakes.
        let Ok(derived) = derived else { continue };
        systems += 1;
        checked.check(&Programs::new(&derived)).unwrap_or_else(|message| panic!("{text}: {message}"));
    }
    println!("{systems} systems; {checked:?}");
    assert!(systems >= FEWEST, "{systems}");
    assert!(checked.too_large * PROGRAMS_PER_TOO_LARGE <= checked.programs, "{}", checked.too_large);
    assert_eq!(checked.kinds.len(), 21, "{:?}", checked.kinds);
}
