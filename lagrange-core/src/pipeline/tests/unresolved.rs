//! Undefined names: each is reported once.

use crate::pipeline::parse;

fn report(text: &str) -> String {
    parse(text).expect_err("a mistake").to_string()
}

#[test]
fn a_name_that_is_not_declared_is_reported_once_with_the_number_of_other_places() {
    let text = "coord x; kinetic = 1/2 * m * dot(x)^2; potential = m * x + k * m; force x = m; force y = 1; output o = y;";
    let report = report(text);
    let expected = "\
error at 1:26: unknown name `m`, here and in 3 other places
  help: declare it before this line with `param`, `coord`, `input` or `let`
error at 1:60: unknown name `k`
  help: declare it before this line with `param`, `coord`, `input` or `let`
error at 1:86: unknown name `y`, here and in one other place
";
    let without_last_help = report.lines().take(5).map(|line| format!("{line}\n")).collect::<String>();
    assert_eq!(without_last_help, expected, "{report}");
    assert_eq!(report.matches("error at").count(), 3, "{report}");
}

#[test]
fn a_name_that_is_declared_further_down_is_reported_once() {
    let report = report("kinetic = 1/2 * dot(x)^2; potential = x + x^2; force x = x; coord x;");
    assert!(
        report.starts_with("error at 1:21: `x` is used before it is declared, here and in 4 other places")
    );
    assert_eq!(report.matches("error at").count(), 1, "{report}");
}

/// The number of errors does not grow with the number of uses.
#[test]
fn without_its_coordinates_a_chain_has_a_mistake_for_each() {
    let chain = |n: usize| {
        let coordinates = (1..=n).map(|i| format!("a{i}")).collect::<Vec<_>>().join(", ");
        let bodies = (1..=n).map(|i| {
            let before = i - 1;
            format!(
                "let (x{i}, y{i}) = (x{before} + sin(a{i}), y{before} - cos(a{i})); potential = y{i} + sin(a{i});
                kinetic = dot(x{i})^2 + dot(y{i})^2 + dot(a{i})^2; force a{i} = dot(a{i});"
            )
        });
        (format!("coord {coordinates};"), format!("let (x0, y0) = (0, 0); {}", bodies.collect::<String>()))
    };
    for n in [1, 5, 20] {
        let (coordinates, bodies) = chain(n);
        assert!(parse(&format!("{coordinates}{bodies}")).is_ok());
        let report = report(&format!("coord q; {bodies}"));
        assert_eq!(report.matches("error at").count(), n, "{report}");
        assert_eq!(report.matches("here and in 5 other places").count(), n, "{report}");
    }
}
