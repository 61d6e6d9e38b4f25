use super::without_functions;
use crate::syntax::{parse_text, print};
use lagrange_expr::diagnostics::Report;

/// Returns the printed text without functions.
fn inlined(text: &str) -> String {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report).expect("consists of tokens");
    let declaration = without_functions(declaration, &mut report);
    assert!(!report.has_errors(), "{report}");
    print::statements(&declaration)
}

fn assert_same(with_functions: &str, without: &str) {
    assert_eq!(inlined(with_functions), inlined(without), "{with_functions}");
}

#[test]
fn calls_stand_for_values() {
    assert_same(
        "let f(x, y) = x + 2*y; coord q; kinetic = f(q, dot(q))^2;",
        "coord q; kinetic = (q + 2*dot(q))^2;",
    );
    assert_same(
        "coord q; let s(x) = x^2; let e(m, v) = 1/2 * m * s(v); kinetic = e(3, dot(q)) + e(1, q.s());",
        "coord q; kinetic = 1/2*3*dot(q)^2 + 1/2*1*(q^2)^2;",
    );
    assert_same(
        "let place(l, a) = l * (sin(a), -cos(a)); body b { mass: 1; center: place(2, q); } coord q;",
        "body b { mass: 1; center: 2 * (sin(q), -cos(q)); } coord q;",
    );
    assert_same("let first(v) = v.x; output o = first((1, 2));", "output o = (1, 2).x;");
}

#[test]
fn parameters_hide_names_of_the_declaration() {
    assert_same(
        "param x = 1; let f(x) = x; coord q; potential = f(q) + x;",
        "param x = 1; coord q; potential = q + x;",
    );
    assert_same(
        "param a = 2; coord q; let f(x) = a*x; let g(a) = f(a) + a; potential = g(q);",
        "param a = 2; coord q; potential = a*q + q;",
    );
    assert_same("coord a, b; let f(a, b) = a - b; potential = f(b, a);", "coord a, b; potential = b - a;");
}

#[test]
fn values_without_parameters_are_shared() {
    assert_same("coord q; let c(_x) = q^2; potential = c(1) + c(2);", "coord q; potential = q^2 + q^2;");
}

/// Checks that n functions, each calling the previous one, exceed the limit.
fn assert_too_long(first: &str, n: usize, call: impl Fn(&str) -> String) {
    let mut text = format!("coord q; let f0(x) = {first};");
    for k in 1..n {
        text += &format!("let f{k}(x) = {};", call(&format!("f{}", k - 1)));
    }
    text += &format!("potential = f{}(q);", n - 1);
    let mut report = Report::default();
    let declaration = parse_text(&text, &mut report).expect("consists of tokens");
    drop(without_functions(declaration, &mut report));
    let errors: Vec<String> = report.diagnostics().iter().map(ToString::to_string).collect();
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert!(errors[0].contains("more than 200000 terms"), "{errors:?}");
}

#[test]
fn calls_that_double_each_time_come_to_an_end() {
    assert_too_long("x*x", 64, |f| format!("{f}(x) + {f}(x + 1)"));
    assert_too_long("x*x", 9, |f| format!("{f}({f}(x))"));
}
