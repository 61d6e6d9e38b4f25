//! Labels of contacts: those of the declaration, and combinations.
//!
//! `contacts: compliant { … }` gives each contact the labels that concern it and that it does not
//! have. Only then is it known which contacts are compliant.

use crate::bodies::expressions::mention;
use crate::bodies::messages::contacts as words;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{
    AstId, Compliance, Contact, ContactDefaults, SceneStatement, Statement, StatementKind,
};
use lagrange_expr::diagnostics::Report;

/// A value that must not be there, with the message and the help.
type Rule = (Option<AstId>, String, &'static str);

/// Returns the labels of all contacts in a declaration; repeated ones are reported.
pub(in crate::bodies) fn default_compliance(statements: &[Statement], report: &mut Report) -> Compliance {
    let declared = statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Scene(SceneStatement::Contacts(defaults)) => Some((statement.origin, defaults)),
        _ => None,
    });
    let declared = declared.collect::<Vec<_>>();
    if let [(first, _), (second, _), ..] = declared[..] {
        let error = report.error(second, words::SECOND_CONTACTS);
        error.related(first, words::FIRST_CONTACTS).help(words::SECOND_CONTACTS_HELP);
    }
    declared.first().map(|(_, defaults)| defaults.compliance).unwrap_or_default()
}

/// Translates the labels of all contacts, so that errors are found even if no contact has them.
pub(in crate::bodies) fn mention_defaults(translation: &mut Translation<'_>, defaults: &ContactDefaults) {
    for value in defaults.compliance.values().into_iter().filter_map(|(_, value)| value) {
        mention(translation, value);
    }
}

/// Checks combinations of labels. A contact with a stiffness loses energy by dissipation, and its
/// frictions have one coefficient and a creep speed each. False after an error.
pub(super) fn check_labels(translation: &mut Translation<'_>, contact: &Contact) -> bool {
    let rules = match contact.compliance.way() {
        None => of_rigid(contact),
        Some(_) => [of_law(contact), of_compliant(contact)].concat(),
    };
    let broken = rules.into_iter().find_map(|(value, message, help)| Some((value?, message, help)));
    let Some((value, message, help)) = broken else { return true };
    let origin = translation.expressions.origin(value);
    translation.report.error(origin, message).help(help);
    false
}

fn of_rigid(contact: &Contact) -> Vec<Rule> {
    let name = &contact.name.text;
    let Compliance { dissipation, stiction, stiction_rate, .. } = contact.compliance;
    let labels = [("dissipation", dissipation), ("stiction", stiction), ("stiction_rate", stiction_rate)];
    let rule = |(label, value)| (value, words::without_stiffness(name, label), words::ADD_STIFFNESS_HELP);
    labels.map(rule).to_vec()
}

fn of_law(contact: &Contact) -> Vec<Rule> {
    let name = &contact.name.text;
    let Compliance { stiffness, penetration, load, .. } = contact.compliance;
    vec![
        (penetration.or(load).and(stiffness), words::second_law(name), words::SECOND_LAW_HELP),
        (
            penetration.filter(|_| load.is_none()),
            words::half_a_law(name, "penetration", "load"),
            words::HALF_A_LAW_HELP,
        ),
        (
            load.filter(|_| penetration.is_none()),
            words::half_a_law(name, "load", "penetration"),
            words::HALF_A_LAW_HELP,
        ),
    ]
}

fn of_compliant(contact: &Contact) -> Vec<Rule> {
    let name = &contact.name.text;
    let Contact { friction, kinetic, restitution, rolling, spinning, .. } = *contact;
    let Compliance { stiction, stiction_rate, .. } = contact.compliance;
    let turning = rolling.or(spinning);
    vec![
        (restitution, words::compliant_restitution(name), words::COMPLIANT_RESTITUTION_HELP),
        (kinetic, words::compliant_coefficients(name), words::COMPLIANT_COEFFICIENTS_HELP),
        (friction.filter(|_| stiction.is_none()), words::without_stiction(name), words::ADD_STICTION_HELP),
        (
            stiction.filter(|_| friction.is_none()),
            words::without_friction(name),
            words::WITHOUT_FRICTION_HELP,
        ),
        (
            turning.filter(|_| stiction_rate.is_none()),
            words::without_stiction_rate(name),
            words::ADD_STICTION_RATE_HELP,
        ),
        (
            stiction_rate.filter(|_| turning.is_none()),
            words::without_turning(name),
            words::WITHOUT_TURNING_HELP,
        ),
    ]
}
