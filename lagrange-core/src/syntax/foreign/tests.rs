use super::super::keywords;
use super::super::messages::forms::form;
use super::functions::FUNCTIONS;
use super::{
    LABELS, NAMES, Owner, PARTS, Rate, SOLIDS, STATEMENTS, STRANGERS, function, label, letter, name, part,
    rate, solid,
};
use crate::calculus::evaluate;
use crate::pipeline::parse;
use crate::solids::by_name;
use crate::symbol::Role;

/// A word of two rows would be answered by chance.
fn assert_all_differ<'a>(words: impl Iterator<Item = &'a str>) {
    let mut words = words.collect::<Vec<_>>();
    let count = words.len();
    words.sort();
    words.dedup();
    assert_eq!(words.len(), count);
}

#[test]
fn statements_stand_for_statements() {
    let words = STATEMENTS.iter().flat_map(|(words, _)| words.iter());
    assert_all_differ(words.chain(STRANGERS.iter().flat_map(|(words, ..)| words.iter())).copied());
    for (words, keyword) in STATEMENTS {
        assert!(keywords::STATEMENTS.contains(keyword), "{keyword}");
        assert!(words.iter().all(|word| !keywords::STATEMENTS.contains(word)), "{words:?}");
    }
}

#[test]
fn solids_stand_for_solids() {
    assert_all_differ(SOLIDS.iter().flat_map(|(_, words)| words.iter().copied()));
    for (row, words) in SOLIDS {
        assert!(by_name(row).is_some(), "{row}");
        assert!(words.iter().all(|word| by_name(word).is_none()), "{words:?}");
        assert_eq!(solid(words[0]), Some(*row));
    }
}

#[test]
fn names_and_parts_are_unambiguous() {
    assert_all_differ(NAMES.iter().flat_map(|(words, _)| words.iter().copied()));
    for owner in [Owner::Body, Owner::BodyInSpace, Owner::Frame, Owner::Connector, Owner::Joint] {
        let rows = PARTS.iter().filter(|(kind, ..)| *kind == owner);
        assert_all_differ(rows.flat_map(|(_, words, _)| words.iter().copied()));
    }
    assert_all_differ(LABELS.iter().map(|(label, _)| *label));
    assert_eq!(name("PI"), Some("pi"));
    assert_eq!(part((Owner::Body, "rod"), "x"), Some("rod.center.x".to_owned()));
}

#[test]
fn greek_letters_have_names() {
    assert_eq!(letter("θ1").as_deref(), Some("theta1"));
    assert_eq!(letter("theta1").as_deref(), Some("θ1"));
    assert_eq!(letter("x"), None);
}

#[test]
fn a_label_is_one_of_those_that_are_possible() {
    let spring = ["from", "to", "stiffness", "rest"];
    let damper = ["from", "to", "damping"];
    assert_eq!(label("c", spring), Some("stiffness"));
    assert_eq!(label("c", damper), Some("damping"));
    assert_eq!(label("k", damper), None);
    assert_eq!(label("stiffness", spring), None);
}

#[test]
fn arguments_hold_together() {
    let written = |name: &str, arguments: &[&str]| {
        function(name, &arguments.iter().map(|&text| text.to_owned()).collect::<Vec<_>>())
    };
    let cases: [(&str, &[&str], Option<&str>); 9] = [
        ("sec", &["a + b"], Some("1/cos(a + b)")),
        ("to_radians", &["a + b"], Some("(a + b) * pi/180")),
        ("to_radians", &["30"], Some("30 * pi/180")),
        ("square", &["sin(x)"], Some("sin(x)^2")),
        ("square", &["(a)*(b)"], Some("((a)*(b))^2")),
        ("log", &["a", "b"], Some("ln(a)/ln(b)")),
        ("norm", &["x - 1", "y"], Some("norm((x - 1, y))")),
        ("log", &[], None),
        ("sin", &["a", "b"], None),
    ];
    for (name, arguments, expected) in cases {
        assert_eq!(written(name, arguments).as_deref(), expected, "{name}");
    }
}

#[test]
fn rates_are_recognised_by_what_changes() {
    let written = |name: &str| rate(name, |of| ["x", "theta", "d"].contains(&of)).map(Rate::written);
    for name in
        ["dx", "xdot", "x_dot", "dot_x", "xd", "xp", "x_t", "vx", "v_x", "x_prime", "ẋ", "x\u{307}", "d_x"]
    {
        assert_eq!(written(name).as_deref(), Some("dot(x)"), "{name}");
    }
    for name in ["thetaddot", "theta_ddot", "ddtheta", "d2theta", "atheta", "theta_dd"] {
        assert_eq!(written(name).as_deref(), Some("ddot(theta)"), "{name}");
    }
    for name in ["dm", "mdot", "dot", "d", "theta", "omega"] {
        assert_eq!(written(name), None, "{name}");
    }
    assert_eq!(written("dd").as_deref(), Some("dot(d)"));
}

/// Where functions are compared: within the domain of all of them.
const PLACE: [f64; 3] = [1.3, 0.7, 2.1];

/// What an expression in x, y and z is worth there.
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
fn whatever_is_advised_can_be_read() {
    let numbers = ["x", "y", "z"].map(str::to_owned);
    let vectors = ["(x, y)", "(y, z)", "(z, x)"].map(str::to_owned);
    for (names, count, template) in FUNCTIONS {
        let is_of_vectors = ["norm(#1)", "inner(", "cross("].iter().any(|call| template.contains(call));
        let arguments = if is_of_vectors { &vectors } else { &numbers };
        for name in *names {
            let written = function(name, &arguments[..*count]).expect(name);
            // In the place of a condition stands what nobody can know.
            worth(&written.replace("if a >", "if x >"));
        }
    }
    for (words, meant) in NAMES {
        assert!(words.iter().all(|word| name(word) == Some(meant)));
        assert!(worth(&meant.replace('t', "x"))[0].is_finite() || *meant == "t", "{meant}");
    }
    for keyword in keywords::STATEMENTS {
        assert!(form(keyword).contains(&format!("`{keyword} ")), "{keyword}: {}", form(keyword));
    }
}

#[test]
fn functions_are_worth_what_they_are_elsewhere() {
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
