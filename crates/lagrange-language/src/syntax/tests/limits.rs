use std::thread;

use proptest::prelude::{ProptestConfig, any, prop_assert, proptest};
use proptest::strategy::Strategy;

use proc_macro2::TokenStream;

use crate::syntax::ast::Expression;
use crate::syntax::cursor::Cursor;
use crate::syntax::keywords::{STATEMENTS, soft_statement};
use crate::syntax::parse_text;
use crate::syntax::parser::Parser;
use lagrange_expr::diagnostics::Report;

const LONG: usize = 100_000;

/// Reads a text on a stack of 2 MiB, and returns the numbers of nodes and of errors.
fn read(text: String) -> (usize, usize) {
    let work = move || {
        let mut report = Report::default();
        let declaration = parse_text(&text, &mut report);
        let nodes = declaration.map_or(0, |declaration| declaration.expressions.iter().count());
        (nodes, report.diagnostics().len())
    };
    let thread = thread::Builder::new().stack_size(2 << 20).spawn(work).expect("a thread");
    thread.join().expect("no panic")
}

fn chain(first: &str, link: &str, last: &str) -> (usize, usize) {
    read(format!("kinetic = {first}{}{last};", link.repeat(LONG)))
}

#[test]
fn long_chains_are_read() {
    assert_eq!(chain("x", " + x", ""), (2 * LONG + 1, 0));
    assert_eq!(chain("x", " * x - x", ""), (4 * LONG + 1, 0));
    assert_eq!(chain("x", "^x", ""), (2 * LONG + 1, 0));
    assert_eq!(chain("x", "^-x", ""), (3 * LONG + 1, 0));
    assert_eq!(chain("", "-", "x"), (LONG + 1, 0));
    assert_eq!(chain("x", ".sin()", ""), (LONG + 1, 0));
    assert_eq!(chain("x", ".y", ""), (LONG + 1, 0));
    assert_eq!(chain("", "if x < y { x } else ", "{ z }"), (4 * LONG + 1, 0));
    assert_eq!(chain("max(x", ", x", ")"), (LONG + 2, 0));
}

#[test]
fn long_texts_are_read() {
    assert_eq!(read("let a = 1;".repeat(LONG)), (LONG, 0));
    assert_eq!(read(format!("param a{};", ", a = 1".repeat(LONG))), (LONG, 0));
    assert_eq!(read("@".repeat(LONG)), (0, 1));
    assert_eq!(read("@;".repeat(LONG)), (0, LONG));
    assert_eq!(read("let let ".repeat(LONG)).0, 0);
    assert_eq!(read("let a = ".repeat(LONG)), (LONG, LONG));
    assert_eq!(read("param a = , ".repeat(LONG)).0, LONG);
}

#[test]
fn brackets_are_read_to_a_depth_of_64() {
    let nested = |depth| read(format!("kinetic = {}x{};", "(".repeat(depth), ")".repeat(depth)));
    assert_eq!(nested(64), (1, 0));
    assert_eq!(nested(65), (1, 1));
    assert_eq!(nested(LONG), (1, 1));
}

#[test]
fn deep_nesting_of_any_kind_is_harmless() {
    let deep = |open: &str, inner: &str, close: &str| {
        let text = format!("kinetic = {}{inner}{};", open.repeat(LONG), close.repeat(LONG));
        read(text).1
    };
    assert_eq!(deep("sin(", "x", ")"), 1);
    assert_eq!(deep("(x, ", "x", ")"), 1);
    assert_eq!(deep("x.max(", "x", ")"), 1);
    assert_eq!(deep("if x < x {", "x", "} else { x }"), 1);
    assert_eq!(deep("if x < x { x } else {", "x", "}"), 1);
    // The missing comparison of a condition is reported at every readable depth.
    assert!(deep("if (", "x < x", ")") <= 64);
    assert_eq!(deep("if ", "x", " < x { x } else { x }"), 1);
    assert_eq!(deep("[", "x", "]"), 1);
    assert_eq!(deep("(", "x", ""), 1);
    assert_eq!(deep("", "x", ")"), 1);
    let deep_attribute = format!("#[a{}{}] struct A;", "(".repeat(LONG), ")".repeat(LONG));
    assert_eq!(read(deep_attribute), (0, 1));
    let deep_docs = format!("#[doc{}{}] coord x;", "(".repeat(LONG), ")".repeat(LONG));
    assert_eq!(read(deep_docs), (0, 1));
    let deep_visibility = format!("pub{}{} struct A;", "(".repeat(LONG), ")".repeat(LONG));
    assert_eq!(read(deep_visibility), (0, 1));
}

/// Types and expressions of Rust also nest without brackets.
#[test]
fn heads_of_any_length_are_read() {
    let head =
        |before: &str, link: &str, behind: &str| read(format!("{before}{}{behind}", link.repeat(LONG)));
    assert_eq!(head("struct A<S: ", "B<", ">; coord x;"), (0, 1));
    assert_eq!(head("struct A<S = ", "&", "T>; coord x;"), (0, 1));
    assert_eq!(head("struct A<S = [u8; ", "-", "1]>; coord x;"), (0, 1));
    assert_eq!(head("struct A where ", "&", "T: Copy; coord x;"), (0, 1));
    assert_eq!(head("#[a = ", "-", "1] struct A; coord x;"), (0, 1));
    assert_eq!(head("#[unsafe = ", "-", "1] struct A; coord x;"), (0, 1));
    assert_eq!(head("#[a = b!(", "-", "1)] struct A; coord x;"), (0, 0));
    assert_eq!(head("#[derive(", "A, ", ")] struct A; coord x;"), (0, 0));
    assert_eq!(head("#[a", "::a", "] struct A; coord x;"), (0, 0));
    assert_eq!(head("", "#[a] ", "struct A; coord x;"), (0, 0));
}

/// Turns that consume nothing: each token is reported and skipped.
#[test]
fn a_loop_ends_whatever_its_turns_do() {
    let mut report = Report::default();
    let tokens = "a ; (b c) let d = 1 # x".parse::<TokenStream>().expect("tokens");
    let count = tokens.clone().into_iter().count();
    let cursor = &mut Cursor::new(tokens);
    Parser::new(&mut report).each(cursor, |_, _| {});
    assert!(cursor.at_end());
    assert_eq!(report.diagnostics().len(), count);
}

/// A statement in place of anything else is either read or reported.
#[test]
fn a_statement_has_a_place_only_among_statements() {
    let places = [
        "event hit = x, rising => { @ }",
        "event hit = x, rising => { dot(x) = 1; @ }",
        "event hit = x, rising => { dot(x) = @ }",
        "reduce Rod { @ }",
        "reduce Rod { small @ }",
        "emit { @ }",
        "body rod { @ }",
        "body rod { mass: @ }",
        "body rod { compound { @ } }",
        "body rod { compound { disk(1), @ } }",
        "line floor { @ }",
        "spring { @ }",
        "let y = sin(@);",
        "let y = (1, @);",
        "let (y, @) = x;",
        "let y = if x < @ { @ } else { @ };",
        "friction rub = x, @",
        "param m = @",
        "coord @",
        "roll wheel on @",
    ];
    for keyword in STATEMENTS {
        for rest in ["", "v", "v = x", "v = x;", "= x; v = 1;", "v { a: b; }", "{ a: b; }", "v to w;", ": 1;"]
        {
            for place in places {
                let text = place.replace('@', &format!("{keyword} {rest}"));
                let (_, mistakes) = read(text.clone());
                // Products are checked by later phases.
                let is_word = is_soft(keyword) || place.starts_with("emit");
                assert!(mistakes > 0 || is_word, "{text}");
                assert!(mistakes < 20, "{text}");
            }
        }
    }
}

/// True if a word can be a user-defined name in most places.
fn is_soft(keyword: &str) -> bool {
    soft_statement(keyword).is_some()
}

/// Generates texts that resemble declarations.
fn shuffled_words() -> impl Strategy<Value = String> {
    let words = [
        "param", "coord", "let", "kinetic", "force", "at", "torque", "on", "emit", "no", "const", "body",
        "event", "friction", "=>", "falling", "stop", "impact", "smooth:", "if", "else", "struct", "pub",
        "#", "[", "]", "(", ")", "{", "}", "<", "=", ">", "+", "-", "*", "/", "^", ".", ",", ";", ":", "!",
        "&", "|", "x", "sin", "t", "_", "r#x", "1", "2.", "0.5", "1e5", "1f32", "'a", "\"s\"", "//", "///",
        "\n", " ", "θ", "²",
    ];
    proptest::collection::vec(proptest::sample::select(words.to_vec()), 0..60)
        .prop_map(|words| words.concat())
}

/// True if every child is older than its parent, and every unreadable part has an error.
fn is_sound(text: &str) -> bool {
    let mut report = Report::default();
    let Some(declaration) = parse_text(text, &mut report) else {
        return report.has_errors();
    };
    report.to_string();
    let expressions = &declaration.expressions;
    expressions.iter().all(|(id, expression)| match expression {
        Expression::Invalid => report.has_errors(),
        other => other.operands().into_iter().all(|operand| operand < id),
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn arbitrary_texts_are_harmless(text in any::<String>()) {
        prop_assert!(is_sound(&text));
    }

    #[test]
    fn shuffled_words_are_harmless(text in shuffled_words()) {
        prop_assert!(is_sound(&text));
    }

    #[test]
    fn statements_with_arbitrary_values_are_harmless(text in "\\PC{0,40}") {
        let statements = format!("let a = {text}; coord x;");
        prop_assert!(is_sound(&statements));
    }
}
