//! Every elementary function has a name in emitted code and an entry in the description of the
//! language.

use std::collections::BTreeSet;

use lagrange_core::elementary::{ROWS, Row};

const CALLABLE: &str = include_str!("../../src/private.rs");
const LISTED: &str = include_str!("../../crates/lagrange-math/src/functions.rs");
const LANGUAGE: &str = include_str!("../../src/language.md");

fn of_rows(name: fn(&Row) -> &'static str) -> BTreeSet<&'static str> {
    ROWS.iter().map(name).collect()
}

#[test]
fn emitted_code_can_call_every_function() {
    let rows = LISTED.lines().filter(|line| line.contains(") C("));
    let written = CALLABLE.lines();
    let callable = rows.chain(written).filter_map(|line| line.trim_start().split(['(', '<']).next());
    let callable = callable.collect::<BTreeSet<_>>();
    let missing = of_rows(|row| row.rust).into_iter().filter(|name| !callable.contains(name));
    assert_eq!(missing.collect::<Vec<_>>(), [""; 0]);
}

#[test]
fn the_description_of_the_language_lists_every_function() {
    let (_, list) = LANGUAGE.split_once("- Functions:").expect("a list of functions");
    let (_, list) = list.split_once('`').expect("its beginning");
    let (list, _) = list.split_once('`').expect("its end");
    assert_eq!(list.split_whitespace().collect::<BTreeSet<_>>(), of_rows(|row| row.name));
}
