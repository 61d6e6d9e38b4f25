use super::super::keywords;
use super::super::messages::forms::form;
use super::{
    LABELS, NAMES, Owner, PARTS, Rate, SOLIDS, STATEMENTS, STRANGERS, function, label, letter, name, part,
    rate, solid,
};
use lagrange_expr::solids::by_name;

/// Asserts that no word is in two rows, where its answer would be arbitrary.
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

#[test]
fn every_statement_has_a_form() {
    for keyword in keywords::STATEMENTS {
        let is_shown = |end: &str| form(keyword).contains(&format!("`{keyword}{end}"));
        assert!(is_shown(" ") || is_shown(": "), "{keyword}: {}", form(keyword));
    }
}
