//! Slips of the pen: correct declarations with one token omitted or doubled. The answers must be
//! helpful.
//!
//! By default the test takes a sample.
//! `LAGRANGE_EXTREMES=1 cargo test -p lagrange-core --test mistakes slips` takes all.

use std::fs;
use std::path::Path;

use lagrange_core::diagnostics::{Report, Severity};
use lagrange_core::pipeline::parse;
use proc_macro2::{TokenStream, TokenTree};

/// One in this many slips is tested. The number divides no common line length.
const TRIED: usize = 13;
/// The smallest share of wrong slips, in percent, that lead to a single error.
const FEWEST_SINGLE: usize = 95;

/// Returns the declarations with golden code.
fn declarations() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let folders = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let mut files = folders.map(|folder| folder.join("declaration.lag")).collect::<Vec<_>>();
    files.sort();
    files.iter().map(|path| fs::read_to_string(path).expect("a declaration")).collect()
}

/// Returns the locations of all tokens in a text except brackets.
fn tokens(text: &str) -> Vec<std::ops::Range<usize>> {
    let stream = text.parse::<TokenStream>().expect("tokens");
    let mut pending = stream.into_iter().collect::<Vec<_>>();
    let mut places = Vec::new();
    while let Some(token) = pending.pop() {
        match token {
            TokenTree::Group(group) => pending.extend(group.stream()),
            other => places.push(other.span().byte_range()),
        }
    }
    // Documentation comments appear as the tokens of their attributes.
    places.retain(|place| !text[place.clone()].starts_with("//"));
    places.sort_by_key(|place| place.start);
    places.dedup();
    places
}

/// Returns the text with a token left out, and with the token twice.
fn slips(text: &str, place: &std::ops::Range<usize>) -> [String; 2] {
    let (before, token, after) = (&text[..place.start], &text[place.clone()], &text[place.end..]);
    [format!("{before} {after}"), format!("{before}{token} {token}{after}")]
}

/// Checks the report of every slip, and returns the number of errors.
fn check(text: &str, report: &Report) -> usize {
    let errors =
        report.diagnostics().iter().filter(|one| one.severity == Severity::Error).collect::<Vec<_>>();
    for error in &errors {
        assert!(error.help.as_ref().is_some_and(|help| !help.is_empty()), "{text}\n{error}");
        let is_same =
            |other: &&&lagrange_core::diagnostics::Diagnostic| other.to_string() == error.to_string();
        assert_eq!(errors.iter().filter(is_same).count(), 1, "{text}\n{report}");
    }
    errors.len()
}

#[test]
fn slips_are_answered_with_help_and_mostly_once() {
    let is_thorough = std::env::var("LAGRANGE_EXTREMES").is_ok();
    let (mut tried, mut wrong, mut single) = (0, 0, 0);
    for text in declarations() {
        for place in tokens(&text) {
            for slip in slips(&text, &place) {
                tried += 1;
                if !is_thorough && tried % TRIED != 0 {
                    continue;
                }
                let Err(report) = parse(&slip) else { continue };
                let errors = check(&slip, &report);
                (wrong, single) = (wrong + 1, single + usize::from(errors == 1));
                if errors != 1 && std::env::var("LAGRANGE_ANSWERS").is_ok() {
                    println!("{slip}\n{report}");
                }
            }
        }
    }
    println!("{single} of {wrong} slips that are mistakes are answered by one error");
    assert!(wrong > 100 && single * 100 >= FEWEST_SINGLE * wrong, "{single} of {wrong}");
}
