use super::systems::systems;
use super::{errors, parse_text, read};
use crate::syntax::ast::Declaration;
use crate::syntax::keywords::{self, STATEMENTS};
use crate::syntax::{messages, print};
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::Report;

/// Returns the first statement in the form of a keyword.
fn example(word: &str) -> &'static str {
    let keyword = keywords::statement(word).expect("a keyword");
    keyword.form.split('`').nth(1).expect("a form in backquotes")
}

#[test]
fn every_keyword_begins_the_statement_that_its_form_shows() {
    for word in STATEMENTS {
        let printed = print::statements(&read(example(word)));
        let begins = |end: &str| printed.starts_with(&format!("{word}{end}"));
        assert!(begins(" ") || begins(": "), "{word}: {printed}");
    }
}

#[test]
fn documentation_is_advised_where_it_is_kept() {
    for word in STATEMENTS {
        let mut report = Report::default();
        parse_text(&format!("/// Text.\n{}", example(word)), &mut report);
        let is_advised = messages::ATTRIBUTE_ON_STATEMENT_HELP.contains(&format!("`{word}`"));
        assert_eq!(is_advised, !report.has_errors(), "{word}: {report}");
    }
}

#[test]
fn documentation_of_names_that_cannot_be_read_is_no_second_mistake() {
    assert_eq!(errors("/// Text.\nparam 1;").len(), 1);
    assert_eq!(errors("/// Text.\ncoord;").len(), 1);
}

/// Returns expressions that no statement contains, neither directly nor as parts.
fn strays(declaration: &Declaration) -> Vec<String> {
    let expressions = &declaration.expressions;
    let mut known = HashSet::default();
    let mut pending = declaration.statements.iter().flat_map(|s| s.kind.expressions()).collect::<Vec<_>>();
    while let Some(id) = pending.pop() {
        known.insert(id);
        pending.extend(expressions.get(id).operands());
    }
    let strays = expressions.iter().filter(|(id, _)| !known.contains(id));
    strays.map(|(id, _)| print::expression(expressions, id)).collect()
}

#[test]
fn every_expression_is_one_of_a_statement() {
    let examples = STATEMENTS.map(|word| (word.to_owned(), example(word).to_owned()));
    let optional = [
        "let (p, q) = (a, b);",
        "force (u, w) at (p, q);",
        "event wall = x, rising => impact(e);",
        "event kick = x - a, crossing => { dot(x) = -k * dot(x); y = a; }",
        "friction shoe = dot(x), kinetic: mu, static: nu;",
        "friction slow = dot(x), mu, smooth: a;",
        "body rod { mass: m; center: (x, y); centroid: (l/2, 0); angle: a; shape: disk(r); }",
        "body wheel { origin: (x, y); compound { disk(r), mass: m; hole disk(s), mass: n, at: (a, b), angle: e; } }",
        "roll wheel on floor, radius: r;",
    ];
    let optional = optional.map(|text| (text.to_owned(), text.to_owned()));
    for (name, text) in systems().into_iter().chain(examples).chain(optional) {
        assert_eq!(strays(&read(&text)), [""; 0], "{name}");
    }
}
