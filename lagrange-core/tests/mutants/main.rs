//! No text makes the compiler panic, hang, use excessive memory or emit invalid Rust. The texts are
//! all declarations of the repository, changed at random in a few places.
//!
//! Case n is the same in every run. `LAGRANGE_MUTANTS` selects cases by a count or a range:
//!
//! ```sh
//! LAGRANGE_MUTANTS=1000000 cargo test --release -p lagrange-core --test mutants
//! LAGRANGE_MUTANTS=4711..4712 cargo test --release -p lagrange-core --test mutants
//! ```
//!
//! `LAGRANGE_MUTANTS_COMPILED=200` builds that many of the accepted ones with `cargo check`,
//! warnings denied.
//!
//! `LAGRANGE_TABLES=100000` tests that many files of tables (`table_files`).
//!
//! These tests have their own binary, since it replaces the allocator.

mod compiled;
mod corpus;
mod guard;
mod mutation;
#[path = "../common/numbered.rs"]
mod numbered;
#[path = "../common/project.rs"]
mod project;
#[path = "../common/random.rs"]
#[allow(dead_code, reason = "other tests draw otherwise")]
mod random;
mod table_files;
mod table_judge;

use std::panic;
use std::sync::Arc;

use lagrange_core::pipeline::{expand, parse};
use proc_macro2::TokenStream;
use quote::quote;

use corpus::Declaration;
use guard::{Answer, Case, Verdict};
use numbered::numbered;
use random::Random;

/// Number of cases by default.
const USUAL: usize = if cfg!(debug_assertions) { 5_000 } else { 20_000 };
/// One in this many cases is also derived and emitted. Unoptimised, that takes ten times as long as
/// reading and checking.
const WHOLE: usize = if cfg!(debug_assertions) { 16 } else { 1 };
/// Length of the longest declaration. Only optimised builds take long ones, whose derivation takes
/// other builds seconds.
const LONGEST: usize = if cfg!(debug_assertions) { 700 } else { 6_000 };

#[test]
fn every_mutant_is_emitted_or_refused() {
    let cases = numbered("LAGRANGE_MUTANTS", USUAL);
    let corpus = corpus::declarations(LONGEST);
    assert!(corpus.len() > 100, "{} declarations found", corpus.len());
    let (mut clean, mut accepted) = (Vec::new(), 0);
    let count = cases.len();
    panic::set_hook(Box::new(|_| {}));
    let shared = Arc::new(corpus);
    let corpus = Arc::clone(&shared);
    let verdicts = guard::run(cases, move |case| examined(mutant(&corpus, case), case % WHOLE == 0));
    drop(panic::take_hook());
    let mut failures = Vec::new();
    let (mut slowest, mut largest) = (Verdict::default(), Verdict::default());
    for verdict in verdicts {
        if verdict.seconds > slowest.seconds {
            slowest = verdict.clone();
        }
        if verdict.bytes > largest.bytes {
            largest = verdict.clone();
        }
        accepted += usize::from(matches!(verdict.answer, Some(Answer::Accepted | Answer::Clean)));
        match &verdict.failure {
            Some(failure) => failures.push(format!("case {}: {failure}\n{}", verdict.case, verdict.text)),
            None if verdict.answer == Some(Answer::Clean) && verdict.case % WHOLE == 0 => {
                clean.push(verdict.case);
            }
            None => {}
        }
    }
    println!("{count} mutants, {accepted} of them accepted, {} emitted without a warning", clean.len());
    println!("slowest: {:.3} s, case {}", slowest.seconds, slowest.case);
    println!("largest: {:.1} MB, case {}", largest.bytes as f64 / 1e6, largest.case);
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), failures.join("\n\n"));
    assert!(count < 1_000 || accepted > count / 50, "{accepted} of {count} are accepted");
    compiled::without_warnings(&clean, |case| mutant(&shared, case));
}

/// Returns a declaration with a few changes, which depend on the number alone. The first mutants
/// are the declarations themselves.
fn mutant(corpus: &[Declaration], case: usize) -> String {
    if let Some(declaration) = corpus.get(case) {
        return mutation::text(&declaration.pieces);
    }
    let random = &mut Random::of_case(case as u64);
    let mut pieces = random.choice(corpus).pieces.clone();
    // Most mutants have a single change, so that many are accepted.
    for _ in 0..*random.choice(&[1, 1, 1, 2, 3]) {
        mutation::change(&mut pieces, corpus, random);
    }
    mutation::text(&pieces)
}

/// Returns a case that does everything with a text, or only reads and checks it.
fn examined(text: String, is_whole: bool) -> Case {
    Case { judge: if is_whole { expanded } else { checked }, text }
}

/// Checks that the emitted code is Rust.
fn expanded(text: &str) -> Result<Answer, String> {
    let Ok(tokens) = text.parse::<TokenStream>() else { return checked(text) };
    let emitted = expand(tokens, &quote!(::lagrange)).to_string();
    syn::parse_file(&emitted).map_err(|error| format!("the output is no Rust: {error}"))?;
    let has = |word: &str| emitted.contains(word);
    Ok(match () {
        () if has("compile_error") => Answer::Refused,
        () if has("deprecated") || has("const _ : fn ()") => Answer::Accepted,
        () => Answer::Clean,
    })
}

fn checked(text: &str) -> Result<Answer, String> {
    match parse(text) {
        Err(report) if report.has_errors() => Ok(Answer::Refused),
        Err(_) => Err("refused without an error".to_owned()),
        Ok(system) if system.report.diagnostics().is_empty() => Ok(Answer::Clean),
        Ok(_) => Ok(Answer::Accepted),
    }
}
