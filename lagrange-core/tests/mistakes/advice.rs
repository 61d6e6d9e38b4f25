//! Advice for functions and constants of other languages parses, and keeps their meaning.

use lagrange_core::expr::evaluate;
use lagrange_core::pipeline::parse;
use lagrange_core::symbol::Role;
use lagrange_core::syntax::foreign::{FUNCTIONS, NAMES, function, name};

/// Arguments at which functions are compared, within the domain of all of them.
const PLACE: [f64; 3] = [1.3, 0.7, 2.1];

/// Returns the value of an expression in x, y and z there.
fn worth(expression: &str) -> Vec<f64> {
    let text =
        format!("coord x, y, z; kinetic = dot(x)^2 + dot(y)^2 + dot(z)^2; output worth = {expression};");
    let system = parse(&text).unwrap_or_else(|report| panic!("{text}\n{report}"));
    let value = |role: Role| match role {
        Role::Coordinate(index) => PLACE[index as usize],
        _ => f64::NAN,
    };
    evaluate(&system.model.graph, &system.model.outputs[0].components, value)
}

#[test]
fn all_advice_can_be_read() {
    let numbers = ["x", "y", "z"].map(str::to_owned);
    let vectors = ["(x, y)", "(y, z)", "(z, x)"].map(str::to_owned);
    for (names, count, template) in FUNCTIONS {
        let is_of_vectors = ["norm(#1)", "inner(", "cross("].iter().any(|call| template.contains(call));
        let arguments = if is_of_vectors { &vectors } else { &numbers };
        for name in *names {
            let written = function(name, &arguments[..*count]).expect(name);
            // A condition has no template for its operands, and the delay must be constant.
            worth(&written.replace("if a >", "if x >").replace("delay(x, y)", "delay(x, 0.7)"));
        }
    }
    for (words, meant) in NAMES {
        assert!(words.iter().all(|word| name(word) == Some(meant)));
        assert!(worth(&meant.replace('t', "x"))[0].is_finite() || *meant == "t", "{meant}");
    }
}

#[test]
fn functions_have_the_same_values_as_elsewhere() {
    type Elsewhere = fn(f64, f64, f64) -> f64;
    let [x, y, z] = PLACE;
    let cases: [(&str, usize, Elsewhere); 22] = [
        ("log", 1, |x, _, _| x.ln()),
        ("log", 2, |x, y, _| x.log(y)),
        ("log10", 1, |x, _, _| x.log10()),
        ("log2", 1, |x, _, _| x.log2()),
        ("asinh", 1, |x, _, _| x.asinh()),
        ("acosh", 1, |x, _, _| x.acosh()),
        ("arctan2", 2, |x, y, _| x.atan2(y)),
        ("sec", 1, |x, _, _| x.cos().recip()),
        ("csc", 1, |x, _, _| x.sin().recip()),
        ("cot", 1, |x, _, _| x.tan().recip()),
        ("sgn", 1, |x, _, _| x.signum()),
        ("square", 1, |x, _, _| x * x),
        ("cbrt", 1, |x, _, _| x.cbrt()),
        ("root", 2, |x, y, _| x.powf(1.0 / y)),
        ("exp2", 1, |x, _, _| x.exp2()),
        ("to_radians", 1, |x, _, _| x.to_radians()),
        ("to_degrees", 1, |x, _, _| x.to_degrees()),
        ("min", 3, |x, y, z| x.min(y).min(z)),
        ("clamp", 3, |x, y, z| x.clamp(y, z)),
        ("Heaviside", 1, |x, _, _| if x > 0.0 { 1.0 } else { 0.0 }),
        ("mul_add", 3, |x, y, z| x.mul_add(y, z)),
        ("length", 2, |x, y, _| x.hypot(y)),
    ];
    for (name, count, elsewhere) in cases {
        let arguments = ["x", "y", "z"].map(str::to_owned);
        let written = function(name, &arguments[..count]).expect(name);
        let (found, expected) = (worth(&written)[0], elsewhere(x, y, z));
        assert!(
            (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
            "{name}: {found}, {expected}"
        );
    }
}
