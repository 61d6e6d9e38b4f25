//! Coefficients of friction and restitution, the compliance and the radius of a contact.
//!
//! Numbers out of range are reported. Runs check values that depend on parameters.

use crate::bodies::constants::number;
use crate::bodies::expressions::mention;
use crate::bodies::mass_geometry::property;
use crate::bodies::messages::contacts as words;
use crate::bodies::plain::Obligation;
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId};

/// A coefficient as written, and in the plain language.
#[derive(Clone, Copy)]
pub(super) struct Coefficient {
    pub(super) written: AstId,
    pub(super) value: AstId,
}

/// Returns the kinetic and the static coefficient; none without friction. `None` after an error.
pub(super) fn coefficients(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
) -> Option<Option<[Coefficient; 2]>> {
    let name = &statement.name.text;
    let mut coefficient = |label: &'static str, written: AstId| {
        let coefficient = Coefficient { written, value: mention(translation, written) };
        let words = (words::negative_coefficient(name), words::NEGATIVE_COEFFICIENT_HELP);
        is_in_range(translation, statement, (label, coefficient), true, words).then_some(coefficient)
    };
    if let Some(friction) = statement.friction {
        return coefficient("friction", friction).map(|both| Some([both; 2]));
    }
    let (Some(kinetic), Some(fixed)) = (statement.kinetic, statement.fixed) else { return Some(None) };
    let (kinetic, fixed) = (coefficient("kinetic", kinetic)?, coefficient("static", fixed)?);
    let sizes = [kinetic, fixed].map(|coefficient| size_of(translation, coefficient.value));
    if let [Some(low), Some(high)] = sizes
        && high < low
    {
        let origin = translation.expressions.origin(fixed.written);
        let error = translation.report.error(origin, words::static_below_kinetic(name));
        error.help(words::STATIC_BELOW_KINETIC_HELP);
        return None;
    }
    oblige(translation, statement, words::label("static"), fixed.value, (kinetic.value, true));
    Some(Some([kinetic, fixed]))
}

/// Returns the coefficient of restitution, 0 by default.
pub(super) fn restitution(translation: &mut Translation<'_>, statement: &ast::Contact) -> Option<AstId> {
    let Some(written) = statement.restitution else { return Some(translation.terms().number(0)) };
    let value = mention(translation, written);
    if size_of(translation, value).is_none_or(|size| (0.0..=1.0).contains(&size)) {
        return Some(value);
    }
    let origin = translation.expressions.origin(written);
    let message = words::restitution_out_of_range(&statement.name.text);
    translation.report.error(origin, message).help(words::RESTITUTION_HELP);
    None
}

/// Returns the radius, if it is given; `None` after an error.
pub(super) fn radius(translation: &mut Translation<'_>, statement: &ast::Contact) -> Option<Option<AstId>> {
    let Some(written) = statement.radius else { return Some(None) };
    let value = property(translation, written, &words::radius_of(&statement.name.text));
    let words = (words::negative_radius(&statement.name.text), words::NEGATIVE_RADIUS_HELP);
    let radius = Coefficient { written, value };
    is_in_range(translation, statement, ("radius", radius), true, words).then_some(Some(value))
}

/// Reports a number below zero, or zero unless it `may_be_zero`. Runs check other values. False
/// after an error.
pub(super) fn is_in_range(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    (label, Coefficient { written, value }): (&str, Coefficient),
    may_be_zero: bool,
    (message, help): (String, &str),
) -> bool {
    let is_wrong = |size: f64| size < 0.0 || size == 0.0 && !may_be_zero;
    if size_of(translation, value).is_some_and(is_wrong) {
        translation.report.error(translation.expressions.origin(written), message).help(help);
        return false;
    }
    let zero = translation.terms().number(0);
    oblige(translation, statement, words::label(label), value, (zero, may_be_zero));
    true
}

/// Obliges a quantity of a contact to have this lower bound, which may be included.
pub(super) fn oblige(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    quantity: String,
    value: AstId,
    lower: (AstId, bool),
) {
    let contact = statement.name.clone();
    translation.obligations.push(Obligation::InRange { contact, quantity, value, lower });
}

fn size_of(translation: &Translation<'_>, value: AstId) -> Option<f64> {
    number(&translation.expressions, translation.names.constants(), value)
}

/// Returns μ N, located at the coefficient.
pub(super) fn limit(translation: &mut Translation<'_>, coefficient: Coefficient, normal: AstId) -> AstId {
    let origin = translation.expressions.origin(coefficient.written);
    TermWriter::new(&mut translation.expressions, origin).times(coefficient.value, normal)
}

/// Coefficients of the friction against turning, as far as they are given.
#[derive(Clone, Copy, Default)]
pub(super) struct TurningCoefficients {
    pub(super) rolling: Option<Coefficient>,
    pub(super) spinning: Option<Coefficient>,
}

/// Returns the coefficients of rolling and spinning friction; `None` after an error.
pub(super) fn turning_coefficients(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
) -> Option<TurningCoefficients> {
    let name = &statement.name.text;
    if let Some(spinning) = statement.spinning
        && translation.space.is_none()
    {
        let error = translation
            .report
            .error(translation.expressions.origin(spinning), words::spins_in_the_plane(name));
        error.help(words::SPINS_IN_THE_PLANE_HELP);
        return None;
    }
    let mut is_sound = true;
    let [rolling, spinning] =
        [(statement.rolling, "rolling"), (statement.spinning, "spinning")].map(|(written, kind)| {
            let written = written?;
            let coefficient = Coefficient { written, value: mention(translation, written) };
            let words = (words::negative_turning(kind, name), words::NEGATIVE_TURNING_HELP);
            is_sound &= is_in_range(translation, statement, (kind, coefficient), true, words);
            Some(coefficient)
        });
    is_sound.then_some(TurningCoefficients { rolling, spinning })
}

/// Stiffness, dissipation and stiction speeds of a compliant contact.
pub(super) struct ComplianceCoefficients {
    pub(super) stiffness: AstId,
    pub(super) dissipation: Option<AstId>,
    pub(super) stiction: Option<AstId>,
    pub(super) stiction_rate: Option<AstId>,
}

/// Returns the compliance, if there is a stiffness; `None` after an error.
pub(super) fn compliance(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
) -> Option<Option<ComplianceCoefficients>> {
    if statement.compliance.way().is_none() {
        return Some(None);
    }
    let name = &statement.name.text;
    let what = words::stiffness_of(name);
    let ast::Compliance { stiffness, penetration, load, .. } = statement.compliance;
    let [stiffness, penetration, load] =
        [stiffness, penetration, load].map(|id| id.map(|id| property(translation, id, &what)));
    let ast::Compliance { dissipation, stiction, stiction_rate, .. } = statement.compliance;
    let [dissipation, stiction, stiction_rate] =
        [dissipation, stiction, stiction_rate].map(|id| id.map(|id| mention(translation, id)));
    let values = [stiffness, penetration, load, dissipation, stiction, stiction_rate];
    if !are_possible(translation, statement, values) {
        return None;
    }
    let by_load = penetration.zip(load);
    let stiffness = stiffness
        .or_else(|| by_load.map(|(penetration, load)| translation.terms().divide(load, penetration)));
    Some(Some(ComplianceCoefficients { stiffness: stiffness?, dissipation, stiction, stiction_rate }))
}

/// Reports values of the labels of a compliant contact that are negative, or zero where they must
/// not be.
fn are_possible(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    values: [Option<AstId>; 6],
) -> bool {
    let name = &statement.name.text;
    let words = [
        (words::stiffness_not_positive(name), words::STIFFNESS_HELP),
        (words::not_positive("penetration", name), words::PENETRATION_HELP),
        (words::not_positive("load", name), words::LOAD_HELP),
        (words::negative_dissipation(name), words::DISSIPATION_HELP),
        (words::stiction_not_positive(name), words::STICTION_HELP),
        (words::stiction_rate_not_positive(name), words::STICTION_RATE_HELP),
    ];
    let mut are_possible = true;
    for (((label, written), value), (message, help)) in
        statement.compliance.values().into_iter().zip(values).zip(words)
    {
        let (Some(written), Some(value)) = (written, value) else { continue };
        let coefficient = Coefficient { written, value };
        let may_be_zero = label == "dissipation";
        are_possible &=
            is_in_range(translation, statement, (label, coefficient), may_be_zero, (message, help));
    }
    are_possible
}
