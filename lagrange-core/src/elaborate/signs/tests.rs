use super::check_signs;
use crate::elaborate::add_statement;
use crate::elaborate::elaborator::Elaborator;
use lagrange_expr::diagnostics::Report;
use lagrange_language::bodies::plain;
use lagrange_language::syntax::parse_text;

/// Returns the report on the signs of energies.
fn reported(statements: &str) -> String {
    let mut report = Report::default();
    let declaration = parse_text(statements, &mut report).expect("a readable declaration");
    let plain = plain(declaration, &mut report);
    let mut elaborator = Elaborator::new(&plain, &mut report);
    plain.declaration.statements.iter().for_each(|statement| add_statement(&mut elaborator, statement));
    check_signs(&mut elaborator);
    report.to_string()
}

#[test]
fn energies_that_only_defaults_make_negative_are_warnings() {
    let of = |kinetic: &str| reported(&format!("param m = 2, n; coord x, y; kinetic = {kinetic};"));
    for kinetic in ["-1/2 * m * dot(x)^2", "-m * (dot(y)^2 + dot(x)^2)", "dot(x)^2 - (m - 1/2) * dot(x)^2"] {
        let report = of(kinetic);
        assert!(report.starts_with("warning at 1:3"), "{kinetic}: {report}");
        assert!(report.contains("with the defaults, this kinetic energy decreases as"), "{report}");
    }
    // The sign is positive, without a default, or unknown before the motion.
    for kinetic in ["m * dot(x)^2", "-n * dot(x)^2", "-m * x * dot(x)^2", "-m * dot(x)^2 + dot(x) * dot(y)"] {
        assert_eq!(of(kinetic), "", "{kinetic}");
    }
    // Among several terms, those with the same velocity decide.
    for kinetic in ["-dot(x)^2", "-dot(x)^2 + m * dot(y)^2", "-dot(x)^2 + 1/2 * (dot(x)^2 + m * dot(y)^2)"] {
        assert!(of(kinetic).starts_with("error"), "{kinetic}: {}", of(kinetic));
    }
    let small = reported("param m = 1/2; coord x; kinetic = 1/2 * m * dot(x)^2; kinetic = -1/2 * dot(x)^2;");
    assert!(small.starts_with("warning"), "{small}");
}

#[test]
fn dissipation_that_drives_is_a_warning() {
    let of = |dissipation: &str| reported(&format!("param c = 2; coord x; dissipation = {dissipation};"));
    for dissipation in ["-1/2 * c * dot(x)^2", "-1/2 * dot(x)^2"] {
        let report = of(dissipation);
        assert!(report.contains("speeds `x` up") && report.contains("with a positive c"), "{report}");
    }
    // Van der Pol's oscillator is only driven near the middle.
    for dissipation in ["1/2 * c * dot(x)^2", "1/2 * c * (x^2 - 1) * dot(x)^2"] {
        assert_eq!(of(dissipation), "", "{dissipation}");
    }
}
