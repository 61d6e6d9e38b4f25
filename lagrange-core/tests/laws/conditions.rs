//! Conditions of several comparisons follow their operators.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{NumericSystem, parse};

use crate::printing::{emitted, printed_and_read, read};

fn system(text: &str) -> NumericSystem {
    let derived = parse(text).expect("a correct declaration").derive(StrategyChoice::Cheapest);
    NumericSystem::new(&derived.expect("a regular system"))
}

/// A condition in the language and in Rust.
type Case = (&'static str, fn(f64, f64) -> bool);

const CASES: [Case; 11] = [
    ("x > 0 && y > 0", |x, y| x > 0.0 && y > 0.0),
    ("x > 0 || y > 0", |x, y| x > 0.0 || y > 0.0),
    ("!(x > 0)", |x, _| x <= 0.0),
    ("!!(x > 0) && !(y >= 1)", |x, y| x > 0.0 && y < 1.0),
    ("x > 0 && y > 0 || x < -1 && y < 1", |x, y| x > 0.0 && y > 0.0 || x < -1.0 && y < 1.0),
    ("(x > 0 || y > 0) && (x < 1 || y < -1)", |x, y| (x > 0.0 || y > 0.0) && (x < 1.0 || y < -1.0)),
    ("!(x > 0 && y > 0 || x < -1)", |x, y| !(x > 0.0 && y > 0.0 || x < -1.0)),
    ("(x + y) < 1 && -1 < (x - y) * 2", |x, y| x + y < 1.0 && -1.0 < (x - y) * 2.0),
    ("(((x >= 1)))", |x, _| x >= 1.0),
    ("k == 2 && (x > y || k != 2)", |x, y| x > y),
    ("(if x < 0 { -x } else { x }) < 1 || !(y <= x)", |x, y| x.abs() < 1.0 || y > x),
];

fn text(condition: &str) -> String {
    format!(
        "param k = 2; coord x, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        let chosen(c) = if {condition} {{ c + x }} else {{ c - y }};
        output found = chosen(10);
        output other = sum(i in 0..2, if {condition} {{ i }} else {{ 5 }});"
    )
}

#[test]
fn combined_conditions_choose_as_those_of_rust() {
    let values = [-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0];
    for (condition, expected) in CASES {
        let system = system(&text(condition));
        for (x, y) in values.iter().flat_map(|&x| values.map(|y| (x, y))) {
            let holds = expected(x, y);
            let output = |name| system.output(name, 0.0, &[x, y], &[0.0; 2]).expect("it is declared")[0];
            assert_eq!(output("found"), if holds { 10.0 + x } else { 10.0 - y }, "{condition} at {x} {y}");
            assert_eq!(output("other"), if holds { 1.0 } else { 10.0 }, "{condition} at {x} {y}");
        }
        let nothing = system.output("found", 0.0, &[f64::NAN; 2], &[0.0; 2]).expect("it is declared");
        assert!(nothing[0].is_nan(), "{condition}");
    }
}

#[test]
fn combined_conditions_survive_printing() {
    for (condition, _) in CASES {
        let declaration = read(&text(condition));
        let again = printed_and_read(&declaration);
        assert_eq!(emitted(again), emitted(declaration), "{condition}");
    }
}

#[test]
fn long_conditions_choose_as_those_of_rust() {
    let every = |n: usize, sign: &str| (0..n).map(|i| format!("x > {i}")).collect::<Vec<_>>().join(sign);
    let groups = (0..5).map(|i| format!("(x > {i} || y > {i})")).collect::<Vec<_>>().join(" && ");
    for (condition, expected) in
        [(every(90, " && "), [1.0, 0.0]), (every(90, " || "), [1.0, 1.0]), (groups, [1.0, 1.0])]
    {
        let system = system(&format!(
            "coord x, y; kinetic = 1/2 * dot(x)^2 + 1/2 * dot(y)^2;
            output found = if {condition} {{ 1 }} else {{ 0 }};"
        ));
        let output = |x: f64| system.output("found", 0.0, &[x, 0.0], &[0.0; 2]).expect("it is declared")[0];
        assert_eq!([output(89.5), output(88.5)], expected, "{condition}");
        assert_eq!(output(0.0), 0.0);
    }
}
