//! What is printed of a declaration says the same: it is printed again alike, and the same code is emitted for it.

use std::fs;
use std::path::Path;

use lagrange_core::bodies::plain;
use lagrange_core::diagnostics::Report;
use lagrange_core::mechanics::{RoadChoice, elaborate};
use lagrange_core::pipeline::System;
use lagrange_core::syntax::ast::{Declaration, Statement};
use lagrange_core::syntax::{parse_text, print};
use proptest::prelude::{prop_assert_eq, proptest};
use quote::quote;

use crate::machines::machines;
use crate::trees::trees;

fn read(text: &str) -> Declaration {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report);
    assert!(!report.has_errors(), "{text}\n{report}");
    declaration.expect("tokens")
}

/// The code for a declaration, or what is wrong with it.
fn emitted(declaration: Declaration) -> String {
    let mut report = Report::default();
    let plain = plain(declaration, &mut report);
    let Some(model) = elaborate(&plain, &mut report) else { return messages(&report) };
    let declaration = plain.without(&model.implied);
    let derived = System { declaration, model, report }.derive(RoadChoice::Cheapest);
    match derived.and_then(|derived| derived.emit(&quote!(::lagrange))) {
        Ok(tokens) => tokens.to_string(),
        Err(report) => messages(&report),
    }
}

/// What is reported, without where it stands.
fn messages(report: &Report) -> String {
    report.diagnostics().iter().map(|diagnostic| format!("{}\n", diagnostic.message)).collect()
}

/// The declaration with its statements printed and read; head and documentation are not printed.
fn printed_and_read(declaration: &Declaration) -> Declaration {
    let again = read(&print::statements(declaration));
    assert_eq!(again.statements.len(), declaration.statements.len());
    let documented = again.statements.into_iter().zip(&declaration.statements);
    let documented = documented.map(|(new, old)| Statement { docs: old.docs.clone(), ..new });
    let (statements, expressions) = (documented.collect(), again.expressions);
    Declaration { statements, expressions, ..declaration.clone() }
}

#[test]
fn golden_declarations_are_printed_as_what_they_say() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let directories = fs::read_dir(root).expect("a directory").map(|entry| entry.expect("an entry").path());
    let mut count = 0;
    for directory in directories {
        let text = fs::read_to_string(directory.join("declaration.lag")).expect("a declaration");
        let declaration = read(&text);
        let again = printed_and_read(&declaration);
        assert_eq!(print::statements(&again), print::statements(&declaration), "{}", directory.display());
        assert_eq!(emitted(again), emitted(declaration), "{}", directory.display());
        count += 1;
    }
    assert!(count >= 11);
}

proptest! {
    #![proptest_config(crate::one_in(32))]

    #[test]
    fn random_machines_are_printed_as_what_they_say(machine in machines()) {
        let declaration = read(&machine.text);
        let again = printed_and_read(&declaration);
        prop_assert_eq!(print::statements(&again), print::statements(&declaration));
        prop_assert_eq!(emitted(again), emitted(declaration));
    }

    #[test]
    fn random_trees_are_printed_as_what_they_say(tree in trees()) {
        let declaration = read(&tree.text);
        prop_assert_eq!(emitted(printed_and_read(&declaration)), emitted(declaration));
    }
}
