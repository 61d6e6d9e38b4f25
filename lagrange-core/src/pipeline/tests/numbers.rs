//! Numbers that are not real, and numbers outside the range of all scalars: reported at their
//! position.

use crate::pipeline::parse;

const POINT: &str = "coord x; kinetic = 1/2 * dot(x)^2; ";

/// Returns the report about a point with an additional statement.
fn report(statement: &str) -> String {
    parse(&format!("{POINT}{statement}")).map_or_else(|report| report.to_string(), |_| String::new())
}

/// Checks that a statement has a single error, at this part of it.
fn assert_reported(statement: &str, part: &str, message: &str) {
    let column = POINT.len() + statement.find(part).expect("a part of the statement") + 1;
    let report = report(statement);
    assert!(report.starts_with(&format!("error at 1:{column}: {message}")), "{statement}\n{report}");
    assert_eq!(report.matches("error at").count(), 1, "{statement}\n{report}");
}

#[test]
fn numbers_that_are_not_real_are_reported_in_place() {
    let message = "this is not a real number";
    for value in ["sqrt(-2)", "ln(-1)", "ln(0)", "asin(2)", "acos(-3/2)", "(-pi)^(1/2)", "pow(-pi, 1/3)"] {
        for statement in [
            "potential = x * (1 + @);",
            "let a = @; potential = a * x;",
            "param k = 2 * @; potential = k * x;",
            "const k = @; potential = k * x;",
            "output o = (x, @);",
            "force x = if x < @ { 1 } else { 2 };",
            "event hit = x - @, falling => stop;",
        ] {
            assert_reported(&statement.replace('@', value), value, message);
        }
    }
    assert!(report("output o = asin(2);").contains("help: `asin` is defined between -1 and 1"));
    assert!(report("output o = ln(0);").contains("help: `ln` is defined above 0"));
}

/// Compares with the functions of the standard library.
#[test]
fn functions_are_refused_exactly_where_they_have_no_value() {
    type Function = (&'static str, fn(f64) -> f64);
    let functions: [Function; 14] = [
        ("sin", f64::sin),
        ("cos", f64::cos),
        ("tan", f64::tan),
        ("asin", f64::asin),
        ("acos", f64::acos),
        ("atan", f64::atan),
        ("sinh", f64::sinh),
        ("cosh", f64::cosh),
        ("tanh", f64::tanh),
        ("exp", f64::exp),
        ("ln", f64::ln),
        ("sqrt", f64::sqrt),
        ("abs", f64::abs),
        ("1/", f64::recip),
    ];
    for twelfths in -36..=36 {
        for (name, function) in functions {
            let text = format!("output o = {name}({twelfths}/12);");
            let is_defined = function(f64::from(twelfths) / 12.0).is_finite();
            assert_eq!(report(&text).is_empty(), is_defined, "{text}");
        }
        for exponent in [-2.0, -0.5, 0.0, 0.5, 1.0 / 3.0, 3.0] {
            let text = format!("output o = ({twelfths}/12)^({}/6);", (6.0_f64 * exponent).round());
            let is_defined = (f64::from(twelfths) / 12.0).powf(exponent).is_finite();
            assert_eq!(report(&text).is_empty(), is_defined, "{text}");
        }
    }
}

#[test]
fn numbers_that_are_too_large_are_reported_where_they_stand() {
    for value in ["1e400", "10^400", "2^1000000000", "exp(1000)", "pi^1000000000", "sinh(1e9)"] {
        let message = "this number is too large for `f64`";
        assert_reported(&format!("potential = {value} * x;"), value, message);
        assert_reported(&format!("let a = {value}; potential = a * x;"), value, message);
        assert_reported(&format!("const a = 1 + {value}; output o = a + x;"), value, message);
        assert_reported(&format!("force x = sin({value} * x);"), value, message);
        assert_reported(&format!("event hit = x, rising => {{ x = {value}; }}"), value, message);
    }
    let message = "a number in this expression is too large for `f64`";
    assert_reported("potential = 1e200 * cos(x) * 1e200;", "1e200 * cos(x) * 1e200", message);
    assert_reported("potential = x + (1e200 * x)^2;", "(1e200 * x)^2", message);
    assert_reported("param m = 10^400;", "10^400", "the default of `m` is too large for `f64`");
}

#[test]
fn single_precision_holds_less() {
    let text = |value| format!("#[scalar(f32)] struct Single; {POINT} potential = {value} * x;");
    assert!(parse(&text("1e38")).is_ok());
    let report = parse(&text("1e39")).expect_err("too large").to_string();
    assert!(report.contains("this number is too large for `f32`"), "{report}");
}

#[test]
fn numbers_that_would_lose_digits_are_reported_where_they_stand() {
    for value in ["1e-400", "10^(-400)", "1e-310"] {
        let message = "this number is too small for `f64`, where it would lose digits";
        assert_reported(&format!("potential = {value} * x;"), value, message);
        assert_reported(&format!("force x = sqrt(x^2 + {value});"), value, message);
    }
    let message = "a number in this expression is too small for `f64`, where it would lose digits";
    assert_reported("potential = 1e-200 * cos(x) * 1e-200;", "1e-200 * cos(x) * 1e-200", message);
    let message = "the default of `m` is too small for `f64`, where it would lose digits";
    assert_reported("param m = 10^(-400);", "10^(-400)", message);
    assert_reported("param m = 2.2e-308;", "2.2e-308", message);
    assert_eq!(report("param m = 2.3e-308;"), "");
    let single = |value| format!("#[scalar(f32)] struct Single; {POINT} potential = {value} * x;");
    assert!(parse(&single("2e-38")).is_ok());
    for value in ["1e-38", "1e-50"] {
        let report = parse(&single(value)).expect_err("too small").to_string();
        assert!(
            report.contains("this number is too small for `f32`, where it would lose digits"),
            "{report}"
        );
    }
}

#[test]
fn only_numbers_that_are_left_have_to_fit() {
    for statement in [
        "potential = 1e400 / 1e399 * x;",
        "const a = 10^400; potential = a / 10^399 * x;",
        "let a = 2^1000000000; potential = a / 2^999999999 * x;",
        "let _a = 10^400;",
        "potential = x^1000000000;",
    ] {
        assert_eq!(report(statement), "", "{statement}");
    }
}
