use super::check_obligations;
use crate::elaborate::add_statement;
use crate::elaborate::elaborator::Elaborator;
use crate::pipeline::parse;
use lagrange_expr::diagnostics::{Origin, Report};
use lagrange_language::bodies::{Obligation, plain};
use lagrange_language::syntax::ast::{AstId, Declaration, Name, StatementKind};
use lagrange_language::syntax::parse_text;

/// Returns the value and the name of a `let`.
fn named(declaration: &Declaration, wanted: &str) -> (AstId, Name) {
    let found = declaration.statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Let(name, value) if name.text == wanted => Some((*value, name.clone())),
        _ => None,
    });
    found.expect("a `let` of that name")
}

/// Returns the report on obligations about statements.
fn reported(statements: &str, obligations: impl Fn(&Declaration) -> Vec<Obligation>) -> String {
    let mut report = Report::default();
    let declaration = parse_text(statements, &mut report).expect("a readable declaration");
    let obligations = obligations(&declaration);
    let plain = plain(declaration, &mut report);
    let mut elaborator = Elaborator::new(&plain, &mut report);
    plain.declaration.statements.iter().for_each(|statement| add_statement(&mut elaborator, statement));
    check_obligations(&mut elaborator, &obligations);
    report.to_string()
}

/// Returns the report on `let rod = …;` as a mass.
fn of_mass(statements: &str) -> String {
    reported(statements, |declaration| {
        let (mass, body) = named(declaration, "rod");
        vec![Obligation::PositiveMass { body, mass }]
    })
}

/// Returns the report on `let rod = …;` as a stated moment of inertia, compared with `let shape =
/// …;` as that of the shape.
fn of_inertia(statements: &str) -> String {
    reported(statements, |declaration| {
        let (stated, body) = named(declaration, "rod");
        let (of_shape, shape) = named(declaration, "shape");
        vec![Obligation::SameInertia { body, stated, of_shape, shape: Origin::from(shape.span) }]
    })
}

#[test]
fn masses_that_are_not_positive_are_errors() {
    for (mass, written) in [("-2", "-2"), ("0", "0"), ("1/2 - 3/4", "-1/4"), ("1 - pi", "-2.14159265358979")]
    {
        let report = of_mass(&format!("let rod = {mass};"));
        assert!(report.starts_with(&format!("error at 1:11: the mass of `rod` is {written}")), "{report}");
        assert!(report.contains("hole disk(r)"), "{report}");
    }
    assert_eq!(of_mass("let rod = 3/4 - 1/2;"), "");
}

#[test]
fn masses_that_only_defaults_make_negative_are_warnings() {
    let report = of_mass("param m = 1, h = 2; let rod = m - h;");
    assert!(
        report.starts_with("warning at 1:31: with the defaults of the parameters the mass of `rod` is -1"),
        "{report}"
    );
    for known_later in
        ["param m = 1, h; let rod = m - h;", "param m; let rod = -m;", "input m; let rod = m - 1;"]
    {
        assert_eq!(of_mass(known_later), "");
    }
    assert_eq!(of_mass("param m = 1; let rod = m;"), "");
}

#[test]
fn stated_inertias_that_contradict_shapes_are_warned_of_with_both_values() {
    assert_eq!(of_inertia("let rod = 3; let shape = rectangle(2, 3, 3);"), "");
    let report = of_inertia("let rod = 4; let shape = rectangle(2, 3, 3);");
    assert!(
        report.starts_with(
            "warning at 1:11: the stated moment of inertia of `rod` is 4, but that of its shape is 3\n"
        ),
        "{report}"
    );
    assert!(report.contains("note at 1:18: the shape is given here"), "{report}");
    let report = of_inertia("param m = 3, l = 2; let rod = m * l^2 / 3; let shape = slender_rod(m, l);");
    assert!(report.contains("with the defaults of the parameters the stated"), "{report}");
    assert!(report.contains("is 4, but that of its shape is 1\n"), "{report}");
}

#[test]
fn formulas_in_the_same_symbols_are_compared_at_generic_values() {
    let report = of_inertia("param m, l; let rod = slender_rod_end(m, l); let shape = slender_rod(m, l);");
    assert!(report.contains("for m = 2, l = 3 the stated moment of inertia of `rod` is 6, but"), "{report}");
    assert!(report.contains("that of its shape is 1.5\n"), "{report}");
    assert_eq!(of_inertia("param m, l; let rod = m * l^2 / 12; let shape = slender_rod(m, l);"), "");
    assert_eq!(of_inertia("param m, l; let rod = (l * sqrt(m / 12))^2; let shape = slender_rod(m, l);"), "");
}

#[test]
fn rounding_and_what_is_not_known_are_no_contradictions() {
    assert_eq!(of_inertia("let rod = 0.3198734513; let shape = semicircular_disk(1, 1);"), "");
    let report = of_inertia("let rod = 0.31987345; let shape = semicircular_disk(1, 1);");
    assert!(report.contains("is 0.31987345, but that of its shape is 0.319873451"), "{report}");
    assert_eq!(of_inertia("param m, l, j; let rod = j; let shape = slender_rod(m, l);"), "");
    assert_eq!(of_inertia("param m = 1, l = 1, j; let rod = j; let shape = slender_rod(m, l);"), "");
}

#[test]
fn a_value_that_is_not_a_number_is_reported_once() {
    for report in [of_mass("let rod = ln(-1);"), of_inertia("let rod = ln(-1); let shape = disk(1, 1);")] {
        assert!(report.starts_with("error at 1:11: this is not a real number"), "{report}");
        assert_eq!(report.matches("error at").count(), 1, "{report}");
    }
}

/// Returns statements with a body and parameters m = 2 and l = 3.
fn with_body(members: &str) -> String {
    format!("param m = 2, l = 3; coord x, y, a; let _l = m*l; body rod {{ angle: a; {members} }}")
}

/// Returns the report on such a body.
fn of_body(members: &str) -> String {
    match parse(&with_body(members)) {
        Ok(system) => system.report.to_string(),
        Err(report) => report.to_string(),
    }
}

#[test]
fn moments_of_inertia_are_not_negative() {
    let report = of_body("mass: m; center: (x, y); inertia: -m / m;");
    assert!(report.starts_with("error at "), "{report}");
    assert!(report.contains(": the moment of inertia of `rod` is -1, but must not be negative"), "{report}");
    let hole_outside =
        "origin: (x, y); compound { rectangle(l, l), mass: m; hole disk(l/4), mass: m/10, at: (9*l, 0); }";
    let report = of_body(hole_outside);
    assert!(report.starts_with("warning at "), "{report}");
    assert!(
        report.contains("with the defaults of the parameters the moment of inertia of `rod` is -"),
        "{report}"
    );
    assert_eq!(of_body(&hole_outside.replace("9*l", "l/9")), "");
    assert_eq!(of_body("mass: m; center: (x, y); inertia: m * l^2;"), "");
}

#[test]
fn a_shape_that_does_not_exist_is_reported_once_where_it_stands() {
    for (shape, culprit) in [
        ("triangle(1, 2, 4)", "triangle"),
        ("semicircular_disk((1, 2))", "(1, 2)"),
        ("polygon((0,0), (1,1), (2,2))", "polygon"),
    ] {
        let members = format!("mass: m; origin: (x, y); shape: {shape};");
        let column = with_body(&members).find(culprit).map(|index| index + 1).expect("the culprit");
        let report = of_body(&members);
        assert_eq!(report.matches("error at").count(), 1, "{report}");
        assert!(report.contains(&format!("error at 1:{column}: ")), "{report}");
    }
}
