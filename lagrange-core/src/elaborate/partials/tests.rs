use crate::pipeline::parse;
use lagrange_expr::expr::evaluate;

/// Evaluates the only output with all symbols equal to 2.
fn value(statements: &str) -> f64 {
    let text = format!("coord x, y; param p, q; kinetic = dot(x)^2 + dot(y)^2; {statements}");
    let system = parse(&text).unwrap_or_else(|report| panic!("{text}\n{report}"));
    let output = system.model.outputs.first().expect("an output");
    evaluate(&system.model.graph, &output.components, |_| 2.0)[0]
}

#[test]
fn derivatives_hold_other_names() {
    let rows = [
        ("output c = partial(x^3 * y, x);", 24.0),
        ("output c = partial(p * x^2 + q, p);", 4.0),
        ("output c = partial(sin(t) * x, t);", 2.0 * 2.0_f64.cos()),
        ("velocity v = dot(x); output c = partial(1/2 * p * dot(x)^2, v);", 4.0),
        ("let v = (x^2, x * y); output c = partial(v, x);", 4.0),
        ("output c = partial(if x < 3 { x^2 } else { 0 }, x);", 4.0),
        // Quantities defined by means of a coordinate vary with it.
        ("let u = x^2; output c = partial(u * y, x);", 8.0),
    ];
    for (statements, wanted) in rows {
        assert!((value(statements) - wanted).abs() < 1e-12, "{statements}: {}", value(statements));
    }
}

/// Each abbreviation is a separate variable, even if it is a sum, a number or a copy of another
/// name.
#[test]
fn derivatives_by_abbreviations_are_those_of_what_is_written() {
    let rows = [
        ("let u = x + y; output c = partial(u^3, u);", 48.0),
        ("let u = 3; output c = partial(u^2 * y, u);", 12.0),
        ("let u = x; let w = x; output c = partial(u^2 * w, u);", 8.0),
        ("let u = x; let w = u^2; output c = partial(u * w, u);", 4.0),
        ("let u = x; output c = partial(partial(u^4, u), u);", 48.0),
        ("let u = x; let w = x; output c = partial(partial(u^2 * w^2, u), w);", 16.0),
        ("let u = x; output c = u + partial(u^2, u) + u;", 8.0),
        ("let f(a, b) = a^2 * b; let u = x; output c = partial(f(u, u), u) + partial(f(u, 5), u);", 32.0),
        ("let slope(a) = partial(a^3, a); let u = x; output c = slope(u);", 12.0),
    ];
    for (statements, wanted) in rows {
        assert!((value(statements) - wanted).abs() < 1e-12, "{statements}: {}", value(statements));
    }
}

/// ∂(z² x)/∂z = 2 z x with z itself remaining, for whose solution there is no symbol.
#[test]
fn derivatives_by_unknowns_are_those_of_what_is_written() {
    let text =
        "coord x; kinetic = dot(x)^2; solve z: 0 = z^3 + z - x; output c = partial(z^2 * x, z) - 2 * z * x;";
    let system = parse(text).expect("sound");
    let output = system.model.outputs.first().expect("an output");
    assert!(system.model.graph.is_zero(output.components[0]));
}

/// d/dt ∂(x³)/∂x is 6 x ẋ. Only expressions of parameters are constant.
#[test]
fn derivatives_change_with_what_they_are_derivatives_of() {
    assert_eq!(value("output c = dot(partial(x^3, x));"), 24.0);
    let text = "coord x; param p; kinetic = dot(x)^2; output c = dot(partial(p^3, p));";
    let report = parse(text).expect_err("it is at rest").to_string();
    assert!(report.contains("does not change continuously"), "{report}");
}

/// A number that is too large is reported at its position within a derivative.
#[test]
fn mistakes_in_derivatives_are_reported_within() {
    let text = "coord x; input f; kinetic = dot(x)^2; output c = dot(x * partial(f * x^2, x));";
    let report = parse(text).expect_err("the rate of an input").to_string();
    assert_eq!(report.lines().next(), Some("error at 1:66: the rate of input `f` is unknown"), "{report}");
    let text = "coord x; kinetic = dot(x)^2; output c = partial(sin(x) + 1e400 * x, x);";
    let report = parse(text).expect_err("the number is too large").to_string();
    assert!(report.starts_with("error at 1:58: "), "{report}");
}

/// The help for a derivative with respect to an expression can be followed, including in calls of
/// functions.
#[test]
fn expressions_need_a_name_for_derivatives_by_them() {
    let slope = "let slope(s) = partial(s^3, s);";
    for statements in
        [format!("{slope} output c = slope(2 * x);"), "output c = partial(dot(x)^2, dot(x));".into()]
    {
        let report =
            parse(&format!("coord x; kinetic = dot(x)^2; {statements}")).expect_err("no name").to_string();
        assert!(report.contains("`let u = 2 * x;` or `velocity u = dot(x);`"), "{report}");
        assert_eq!(report.matches("error at").count(), 1, "{report}");
    }
    assert_eq!(value(&format!("{slope} let u = 2 * x; output c = slope(u);")), 48.0);
    assert_eq!(value("velocity u = dot(x); output c = partial(dot(x)^2, u);"), 4.0);
}

#[test]
fn derivatives_nest_to_a_limit() {
    let nested = |count: usize| {
        let mut text = "coord x; kinetic = dot(x)^2; let f0(a) = exp(a);".to_owned();
        (0..count).for_each(|i| text += &format!("let f{}(a) = partial(f{i}(a), a);", i + 1));
        parse(&format!("{text} let u = x; output c = f{count}(u);")).err().map(|report| report.to_string())
    };
    assert_eq!(nested(20), None);
    assert!(nested(100).is_some_and(|report| report.contains("too many derivatives are nested here")));
}
