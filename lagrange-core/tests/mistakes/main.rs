//! Mistakes that people make when they declare a system. Each must lead to a single error, which
//! points at the right tokens, names the mistake and suggests a remedy.
//!
//! The files of mistakes are beside this one, including open cases with their reasons. With
//! `LAGRANGE_ANSWERS=words`, the test prints the answers to all mistakes whose names contain the
//! words: `LAGRANGE_ANSWERS= cargo test -p lagrange-core --test mistakes -- --nocapture`.

mod advice;
mod corpus;
mod limits;
mod processor_time;
mod slips;

use corpus::{Mistake, mistakes};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::{Diagnostic, Report, Severity};
use lagrange_core::pipeline::{expand, parse};
use proc_macro2::TokenStream;
use quote::quote;

/// The smallest number of mistakes that makes a useful test.
const FEWEST_MISTAKES: usize = 240;
/// One in this many mistakes may lack a good answer.
const SHARE_OF_OPEN_ONES: usize = 20;

/// Returns the whole report of a declaration.
fn report(text: &str) -> Report {
    let krate = quote!(::lagrange);
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let emitted = derived.and_then(|derived| derived.emit(&krate));
    emitted.err().unwrap_or_default()
}

/// Returns the number of `compile_error!` calls that a declaration leads to.
fn compile_errors(text: &str) -> usize {
    let Ok(tokens) = text.parse::<TokenStream>() else { return 1 };
    let head = quote!(
        struct System;
    );
    let is_whole = text.contains("struct ");
    let tokens = if is_whole { tokens } else { head.into_iter().chain(tokens).collect() };
    expand(tokens, &quote!(::lagrange)).to_string().matches("compile_error !").count()
}

/// Returns the faults in the answer to a mistake.
fn faults(mistake: &Mistake) -> Vec<String> {
    let report = report(&mistake.text);
    let mut faults = Vec::new();
    let errors = report.diagnostics().iter().filter(|one| one.severity == Severity::Error);
    let [error] = errors.collect::<Vec<_>>()[..] else {
        return vec![format!("this is not one error:\n{report}")];
    };
    let compiled = compile_errors(&mistake.text);
    if compiled != 1 {
        faults.push(format!("{compiled} errors of the compiler"));
    }
    let found = place(error);
    if found != mistake.place {
        faults.push(format!("it stands at {found:?}, not at {:?}", mistake.place));
    }
    let missing = |needed: &[String], text: &str| {
        needed.iter().filter(|words| !text.contains(words.as_str())).cloned().collect::<Vec<_>>()
    };
    let message = missing(&mistake.says, &error.message);
    let help = missing(&mistake.helps, error.help.as_deref().unwrap_or_default());
    faults.extend(message.iter().map(|words| format!("the message lacks `{words}`")));
    faults.extend(help.iter().map(|words| format!("the help lacks `{words}`")));
    if mistake.says.is_empty() || mistake.helps.is_empty() {
        faults.push("it is not said what the answer should be".to_owned());
    }
    if !faults.is_empty() {
        faults.push(format!("{report}"));
    }
    faults
}

fn place(error: &Diagnostic) -> [(usize, usize); 2] {
    let (start, end) = (error.origin.start.start(), error.origin.end.end());
    [(start.line, start.column), (end.line, end.column)]
}

#[test]
fn mistakes_are_answered() {
    let mistakes = mistakes();
    let (open, answered): (Vec<_>, Vec<_>) = mistakes.iter().partition(|mistake| mistake.open.is_some());
    let describe = |mistake: &Mistake, faults: &[String]| {
        format!("{}: {}\n{}  {}\n", mistake.file, mistake.name, mistake.text, faults.join("\n  "))
    };
    let wrong = answered.iter().filter_map(|mistake| {
        let faults = faults(mistake);
        (!faults.is_empty()).then(|| describe(mistake, &faults))
    });
    let wrong = wrong.collect::<Vec<_>>();
    println!("{} of {} mistakes are answered", answered.len() - wrong.len(), mistakes.len());
    assert!(wrong.is_empty(), "{}\n{} are not answered", wrong.join("\n"), wrong.len());
    let good = open.iter().filter(|mistake| faults(mistake).is_empty()).collect::<Vec<_>>();
    assert!(good.is_empty(), "these are answered: {good:#?}");
    assert!(open.len() * SHARE_OF_OPEN_ONES <= mistakes.len(), "{} have no answer", open.len());
    assert!(mistakes.len() >= FEWEST_MISTAKES, "there are {}", mistakes.len());
}

#[test]
fn mistakes_differ() {
    let mut names = mistakes().into_iter().map(|mistake| mistake.name).collect::<Vec<_>>();
    let count = names.len();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), count);
}

#[test]
fn answers_are_printed_on_demand() {
    let Ok(words) = std::env::var("LAGRANGE_ANSWERS") else { return };
    for mistake in mistakes().iter().filter(|mistake| mistake.name.contains(&words)) {
        println!("{}\n{}{}", mistake.name, mistake.text, report(&mistake.text));
    }
}
