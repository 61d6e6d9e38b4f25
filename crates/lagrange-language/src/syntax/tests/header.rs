use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

use super::{errors, read, read_wrong, statements};
use crate::syntax::ast::{Declaration, ScalarType};
use crate::syntax::parse_tokens;
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::diagnostics::Report;

fn scalar(declaration: &Declaration) -> &str {
    match &declaration.scalar {
        ScalarType::F32 => "f32",
        ScalarType::F64 => "f64",
        ScalarType::Generic(name) => &name.text,
    }
}

#[test]
fn attributes_are_kept_or_consumed() {
    let declaration = read(
        "/// A cart.\n#[derive(Clone, ::core::fmt::Debug)] #[scalar(f32)] #[accuracy(standard)]
        #[cfg(all())] #[derive(PartialEq,)] pub(crate) struct Cart; coord x;",
    );
    assert_eq!(declaration.name.text, "Cart");
    assert_eq!(scalar(&declaration), "f32");
    assert_eq!(declaration.visibility.to_string(), "pub (crate)");
    let derives = declaration.derives.iter().map(|name| name.text.as_str());
    assert_eq!(derives.collect::<Vec<_>>(), ["Clone", "Debug", "PartialEq"]);
    let kept = declaration.attributes.to_string();
    let expected = "# [doc = \" A cart.\"] # [derive (Clone , :: core :: fmt :: Debug)] \
                    # [cfg (all ())] # [derive (PartialEq ,)]";
    assert_eq!(kept, expected);
    assert_eq!(statements(&declaration), ["coord x"]);
}

#[test]
fn number_types_are_chosen_in_the_head() {
    assert_eq!(scalar(&read("struct A;")), "f64");
    assert_eq!(scalar(&read("#[scalar(f64)] struct A;")), "f64");
    assert_eq!(scalar(&read("struct A<S>;")), "S");
}

#[test]
fn the_level_of_accuracy_is_chosen_in_the_head() {
    assert_eq!(read("struct A;").accuracy, Accuracy::Standard);
    assert_eq!(read("coord x;").accuracy, Accuracy::Standard);
    for level in Accuracy::ALL {
        assert_eq!(read(&format!("#[accuracy({})] struct A;", level.name())).accuracy, level);
    }
}

#[test]
fn a_bare_list_of_statements_is_a_system() {
    let declaration = read("coord x;");
    assert_eq!(declaration.name.text, "System");
    assert_eq!(declaration.visibility.to_string(), "pub");
    assert_eq!(scalar(&declaration), "f64");
    assert!(declaration.attributes.is_empty() && declaration.derives.is_empty());
}

#[test]
fn tokens_need_a_struct() {
    for text in ["", "coord x;", "pub enum A;", "#[a]", "struct", "struct fn;", "struct 1;"] {
        let mut report = Report::default();
        let tokens = text.parse().expect("tokens");
        assert!(parse_tokens(tokens, &mut report).is_none(), "{text}");
        assert_eq!(report.diagnostics().len(), 1, "{text}: {report}");
    }
}

#[test]
fn fragments_of_other_macros_are_read_as_units() {
    let fragment = |text: &str| {
        let tokens = text.parse::<TokenStream>().expect("tokens");
        TokenStream::from(TokenTree::from(Group::new(Delimiter::None, tokens)))
    };
    let (visibility, sum) = (fragment("pub"), fragment("a + b"));
    let mut report = Report::default();
    let tokens = quote!(#visibility struct A; let c = #sum * 2;);
    let declaration = parse_tokens(tokens, &mut report).expect("a struct");
    assert!(!report.has_errors(), "{report}");
    assert_eq!(declaration.visibility.to_string(), "pub");
    assert_eq!(statements(&declaration), ["let c (* (+ a b) 2)"]);
}

#[test]
fn wrong_heads_leave_a_skeleton() {
    let cases = [
        ("struct A { x: f64 }", "fields come from `param` and `input` statements, not from the struct"),
        ("struct A(f64);", "fields come from `param` and `input` statements, not from the struct"),
        ("struct A<'a>;", "only one plain type parameter, the number type, is possible here"),
        ("struct A<S, T>;", "only one plain type parameter, the number type, is possible here"),
        ("struct A<S: Float>;", "only one plain type parameter, the number type, is possible here"),
        ("struct A<const N: usize>;", "only one plain type parameter, the number type, is possible here"),
        ("struct A<>;", "only one plain type parameter, the number type, is possible here"),
        (
            "struct A<S: Fn(f64) -> [f64; 2] + 'static>;",
            "only one plain type parameter, the number type, is possible here",
        ),
        ("struct A<S;", "only one plain type parameter, the number type, is possible here"),
        ("struct A<'a, S>;", "only one plain type parameter, the number type, is possible here"),
        ("struct A<S,, T>;", "only one plain type parameter, the number type, is possible here"),
        ("struct A<_>;", "`_` is a Rust keyword and cannot name a type"),
        ("struct A<gen>;", "`gen` is a Rust keyword and cannot name a type"),
        ("struct A<r#S>;", "`r#S` is a raw identifier, which cannot be used as a name here"),
        (
            "struct A<S> where S: Fn(f64) -> [f64; 2], for<'a> &'a S: Copy;",
            "a `where` clause is not allowed here",
        ),
        ("struct A where 1;", "a `where` clause is not allowed here"),
        ("struct A where A: Copy;", "a `where` clause is not allowed here"),
        ("struct A", "missing `;` after this"),
        ("#[scalar(f32)] struct A<S>;", "the type parameter already specifies the number type"),
        ("#[scalar(f16)] struct A;", "`scalar` takes a number type"),
        ("#[scalar] struct A;", "`scalar` takes a number type"),
        ("#[scalar(f32, f64)] struct A;", "`scalar` takes a number type"),
        ("#[scalar(f32)] #[scalar(f32)] struct A;", "`scalar` is given twice"),
        ("#[accuracy(best)] struct A;", "unknown level of accuracy `best`"),
        ("#[accuracy] struct A;", "`accuracy` takes one level"),
        ("#[accuracy()] struct A;", "`accuracy` takes one level"),
        ("#[accuracy(fast, strict)] struct A;", "`accuracy` takes one level"),
        ("#[accuracy(standard)] #[accuracy(fast)] struct A;", "`accuracy` is given twice"),
        ("#![a] struct A;", "attributes that begin with `#!` are not allowed here"),
        ("# struct A;", "expected `[` after `#`"),
        ("#[a = ] struct A;", "invalid attribute: unexpected end of input, expected a literal or a macro"),
    ];
    for (head, message) in cases {
        let text = format!("{head}\ncoord x;");
        let found = errors(&text);
        assert_eq!(found.len(), 1, "{head}: {found:#?}");
        assert!(found[0].ends_with(message), "{head}: {found:#?}");
        let declaration = read_wrong(&text).0.expect("the struct has a name");
        assert_eq!(declaration.name.text, "A");
        assert_eq!(statements(&declaration), ["coord x"], "{head}");
    }
}

#[test]
fn all_mistakes_of_a_head_are_found_at_once() {
    let text = "#[derive *] #[doc = ] #[accuracy(best)] pub(in) struct A<S: Copy> where S: Copy { x: S }";
    let places = errors(text).into_iter().filter_map(|error| Some(error.split_once(": ")?.0.to_owned()));
    let columns = [10, 21, 34, 44, 57, 67, 81];
    let expected = columns.map(|column| format!("error at 1:{column}"));
    assert_eq!(places.collect::<Vec<_>>(), expected, "{:#?}", errors(text));
}

/// A `macro_rules!` macro passes fragments as groups without brackets.
#[test]
fn attributes_hold_fragments_of_other_macros() {
    let fragment = |text: &str| {
        let tokens = text.parse::<TokenStream>().expect("tokens");
        TokenTree::from(Group::new(Delimiter::None, tokens))
    };
    let (literal, value) = (fragment("\"text\""), fragment("concat!(\"a\", \"b\")"));
    let (derive, doc) = (fragment("derive(Clone)"), fragment("doc = \"text\""));
    let tokens = quote!(#[#derive] #[doc = #literal] struct A; #[#doc] #[doc = #value] coord x;);
    let mut report = Report::default();
    let declaration = parse_tokens(tokens, &mut report).expect("a struct");
    assert!(!report.has_errors(), "{report}");
    assert_eq!(declaration.derives[0].text, "Clone");
    assert!(declaration.attributes.to_string().starts_with("# [derive (Clone)] # [doc = "));
    assert!(declaration.statements[0].docs.to_string().starts_with("# [doc = \"text\"] # [doc = "));
}

/// Emitted unchanged, they would make all emitted items unreadable.
#[test]
fn invalid_attributes_are_refused() {
    let cases = [
        ("[derive *]", 10),
        ("[derive Clone]", 10),
        ("[derive(Clone *)]", 16),
        ("[derive(Clone<S>)]", 15),
        ("[doc \"text\"]", 7),
        ("[doc = ]", 9),
        ("[doc = 1 2]", 11),
        ("[do = 1]", 3),
        ("[_ = 1]", 3),
        ("[= 1]", 3),
        ("[]", 3),
        ("[a::]", 6),
        ("[a:b]", 4),
        ("[a::b c]", 8),
        ("[a(b) c]", 8),
        ("[a = b]", 7),
        ("[a = b!]", 7),
        ("[a = --1]", 7),
        ("[unsafe = --1]", 12),
    ];
    for (attribute, column) in cases {
        let report = read_wrong(&format!("#{attribute} struct Rod;")).1;
        let message = format!("error at 1:{column}: invalid attribute: ");
        assert!(report.starts_with(&message), "{attribute}\n{report}");
    }
    for attribute in [
        "[doc = \"text\"]",
        "[doc = include_str!(\"a\")]",
        "[doc = core::concat!(\"a\")]",
        "[a]",
        "[a::b]",
        "[::a]",
        "[a::b(c d)]",
        "[a[1]]",
        "[a{b}]",
        "[unsafe(no_mangle)]",
        "[a = 1]",
        "[derive(Clone, ::core::fmt::Debug,)]",
    ] {
        read(&format!("#{attribute} struct Rod;"));
    }
}

#[test]
fn invalid_visibilities_are_refused() {
    for restriction in ["(crate crate)", "(in)", "(rod)", "()", "(in crate::)"] {
        let report = read_wrong(&format!("pub{restriction} struct Rod;")).1;
        assert!(report.starts_with("error at 1:4: unknown visibility"), "{restriction}\n{report}");
    }
    for restriction in ["", "(crate)", "(self)", "(super)", "(in super::rod)"] {
        read(&format!("pub{restriction} struct Rod;"));
    }
}

#[test]
fn a_number_type_is_no_type_parameter() {
    for (number, scalar) in [("f32", "F32"), ("f64", "F64")] {
        let (declaration, report) = read_wrong(&format!("pub struct Rod<{number}>;"));
        let message = format!("error at 1:16: `{number}` is a number type and cannot be a parameter");
        let help = format!("help: write `#[scalar({number})]` above the struct and remove `<{number}>`");
        assert!(report.starts_with(&message) && report.contains(&help), "{report}");
        assert_eq!(format!("{:?}", declaration.expect("a head").scalar), scalar);
    }
}
