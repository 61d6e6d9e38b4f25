//! Laws for every text: nothing panics, and the same text always gives the same tokens.

use std::path::Path;
use std::process::Command;
use std::sync::LazyLock;
use std::{env, fs};

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{expand, parse};
use proc_macro2::TokenStream;
use proptest::prelude::{Strategy, any, prop, prop_assert_eq, prop_oneof, proptest};
use proptest::sample::Index;
use quote::quote;

use crate::machines::machines;
use crate::printing::SCENE;

/// Folder of the crate.
const ROOT: &str = env!("CARGO_MANIFEST_DIR");
/// Environment variable with the name of the file that a child process writes.
const CHILD: &str = "LAGRANGE_LAWS_CHILD";
/// Length beyond which declarations are not mutated, because deriving them takes too long.
const LONGEST_MUTATED: usize = 1_500;
/// Words with a meaning in many places.
const WORDS: [&str; 40] = [
    " 0 ",
    " - ",
    " 1/2 ",
    " t ",
    "^",
    "^2 ",
    "/0",
    "(",
    ")",
    " dot ",
    " dot(x) ",
    " ddot(x) ",
    ";",
    "=",
    ";lagrangian = ",
    ";force x = ",
    "if x < 0 { 1 } else { x }",
    ";let x = ",
    ";emit { bias, momentum_rates, latex };",
    ";constraint c = x;",
    ";stabilise = 1;",
    ";event hit = x, falling => impact(1/2);",
    ";event turn = dot(x), crossing => { dot(x) = -dot(x); x = 0; };",
    ";friction brake = dot(x), kinetic: 1, static: 2;",
    ";friction slow = dot(x) + 1, hit, smooth: 1;",
    " hit ",
    ";reduce A { freeze x = 0; }",
    ";reduce B { small x, theta = m; }",
    "small q1;",
    "1e999",
    ";gravity = (0, -1);",
    ";body b { mass: 1; inertia: 2; center: (x, 0); angle: x; }",
    ";body c { origin: (x, x^2); angle: t; compound { disk(1), mass: 2; hole disk(x), mass: 1, at: (x, 0); } }",
    ";line l { on: b; angle: x; }",
    ";spring { from: b; to: (0, 1); stiffness: 1; rest: 0; }",
    ";pin b to c.point(0, 1);",
    ";slide s = b on l;",
    ";roll c on l, radius: x;",
    " b.point(x, s.normal) ",
    "; emit { motion, drawing, statements };",
];

/// Declarations without errors.
static DECLARATIONS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let directories = ["oracle", "constrained"].map(|name| Path::new(ROOT).join("../tests").join(name));
    let entries = directories.iter().map(|path| fs::read_dir(path).expect("a directory of declarations"));
    let mut paths =
        entries.flatten().map(|entry| entry.expect("a readable entry").path()).collect::<Vec<_>>();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "lag"));
    paths.sort();
    paths.iter().map(|path| fs::read_to_string(path).expect("readable text")).collect()
});

/// Returns the result of the whole pipeline for a text: emitted tokens, or errors.
fn emitted(text: &str) -> String {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    match derived.and_then(|derived| derived.emit(&quote!(::lagrange))) {
        Ok(tokens) => tokens.to_string(),
        Err(report) => report.to_string(),
    }
}

/// Returns the output of the macro for a text, if the text consists of tokens.
fn expanded(text: &str) -> Option<String> {
    let tokens = format!("pub struct Machine; {text}").parse::<TokenStream>().ok()?;
    Some(expand(tokens, &quote!(::lagrange)).to_string())
}

/// One change to a list of pieces.
#[derive(Clone, Debug)]
enum Mutation {
    Delete(Index),
    Duplicate(Index),
    Swap(Index, Index),
    Replace(Index, Index),
    Insert(Index, &'static str),
}

impl Mutation {
    fn apply(&self, pieces: &mut Vec<String>) {
        let count = pieces.len();
        match self {
            Mutation::Delete(_) if count == 1 => {}
            Mutation::Delete(i) => drop(pieces.remove(i.index(count))),
            Mutation::Duplicate(i) => pieces.insert(i.index(count), pieces[i.index(count)].clone()),
            Mutation::Swap(i, j) => pieces.swap(i.index(count), j.index(count)),
            Mutation::Replace(i, j) => pieces[i.index(count)] = pieces[j.index(count)].clone(),
            Mutation::Insert(i, word) => pieces.insert(i.index(count), (*word).to_owned()),
        }
    }
}

fn mutations() -> impl Strategy<Value = Mutation> {
    let index = any::<Index>;
    prop_oneof![
        index().prop_map(Mutation::Delete),
        index().prop_map(Mutation::Duplicate),
        (index(), index()).prop_map(|(i, j)| Mutation::Swap(i, j)),
        (index(), index()).prop_map(|(i, j)| Mutation::Replace(i, j)),
        (index(), prop::sample::select(WORDS.to_vec())).prop_map(|(i, word)| Mutation::Insert(i, word)),
    ]
}

/// Returns a correct declaration with a few changed words or statements.
fn mutated() -> impl Strategy<Value = String> {
    let texts = DECLARATIONS.iter().map(String::as_str).chain([SCENE]);
    let short = texts.filter(|text| text.len() <= LONGEST_MUTATED).map(str::to_owned);
    let text = prop::sample::select(short.collect::<Vec<_>>());
    let mutations = prop::collection::vec(mutations(), 1..4);
    (text, any::<bool>(), mutations).prop_map(|(text, by_statement, mutations)| {
        let mut pieces = if by_statement { statements(&text) } else { words(&text) };
        mutations.iter().for_each(|mutation| mutation.apply(&mut pieces));
        pieces.concat()
    })
}

/// Splits a text into names, numbers, spaces and single characters.
fn words(text: &str) -> Vec<String> {
    let class = |c: char| (c.is_alphanumeric() || "_.".contains(c), c.is_whitespace());
    let characters = text.chars().collect::<Vec<_>>();
    let together = |a: &char, b: &char| class(*a) == class(*b) && class(*a) != (false, false);
    characters.chunk_by(together).map(String::from_iter).collect()
}

fn statements(text: &str) -> Vec<String> {
    text.split_inclusive(';').map(str::to_owned).collect()
}

proptest! {
    #![proptest_config(crate::one_in(1))]

    #[test]
    fn any_bytes_are_harmless(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let text = String::from_utf8_lossy(&bytes);
        emitted(&text);
        expanded(&text);
    }

    #[test]
    fn mistakes_are_harmless(text in mutated()) {
        emitted(&text);
        expanded(&text);
    }
}

proptest! {
    #![proptest_config(crate::one_in(10))]

    #[test]
    fn the_same_text_gives_the_same_tokens(machine in machines()) {
        prop_assert_eq!(emitted(&machine.text), emitted(&machine.text));
    }
}

/// Runs itself in another process, where addresses and random seeds differ.
#[test]
fn another_process_emits_the_same_tokens() {
    let everything = DECLARATIONS.iter().map(|text| emitted(text)).collect::<String>();
    if let Some(path) = env::var_os(CHILD) {
        fs::write(path, everything).expect("a file can be written");
        return;
    }
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("emitted_by_another_process");
    let mut child = Command::new(env::current_exe().expect("the path of this test"));
    child.args(["--exact", "declarations::another_process_emits_the_same_tokens"]).env(CHILD, &path);
    assert!(child.output().expect("a process").status.success());
    assert!(fs::read_to_string(path).expect("what the other process wrote") == everything);
}
