//! Coefficients of friction and restitution, the compliance and the radius of a contact.

use crate::bodies::constants::number;
use crate::bodies::expressions::mention;
use crate::bodies::mass_geometry::property;
use crate::bodies::messages::contacts as words;
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
    let given = [statement.friction.or(statement.kinetic), statement.friction.or(statement.fixed)];
    let [Some(kinetic), Some(fixed)] = given else { return Some(None) };
    let name = &statement.name.text;
    let [kinetic, fixed] =
        [kinetic, fixed].map(|written| Coefficient { written, value: mention(translation, written) });
    let sizes = [kinetic, fixed].map(|coefficient| size_of(translation, coefficient.value));
    let is_negative = |size: &Option<f64>| size.is_some_and(|size| size < 0.0);
    let (written, message, help) = match sizes {
        [kinetic_size, _] if is_negative(&kinetic_size) => {
            (kinetic.written, words::negative_coefficient(name), words::NEGATIVE_COEFFICIENT_HELP)
        }
        [_, fixed_size] if is_negative(&fixed_size) => {
            (fixed.written, words::negative_coefficient(name), words::NEGATIVE_COEFFICIENT_HELP)
        }
        [Some(low), Some(high)] if high < low => {
            (fixed.written, words::static_below_kinetic(name), words::STATIC_BELOW_KINETIC_HELP)
        }
        _ => return Some(Some([kinetic, fixed])),
    };
    translation.report.error(translation.expressions.origin(written), message).help(help);
    None
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
    if size_of(translation, value).is_none_or(|size| size >= 0.0) {
        return Some(Some(value));
    }
    let origin = translation.expressions.origin(written);
    let message = words::negative_radius(&statement.name.text);
    translation.report.error(origin, message).help(words::NEGATIVE_RADIUS_HELP);
    None
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
            let value = mention(translation, written);
            if size_of(translation, value).is_some_and(|size| size < 0.0) {
                let message = words::negative_turning(kind, name);
                let error = translation.report.error(translation.expressions.origin(written), message);
                error.help(words::NEGATIVE_TURNING_HELP);
                is_sound = false;
            }
            Some(Coefficient { written, value })
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
        let is_wrong = |size: f64| size < 0.0 || size == 0.0 && label != "dissipation";
        if size_of(translation, value).is_some_and(is_wrong) {
            translation.report.error(translation.expressions.origin(written), message).help(help);
            are_possible = false;
        }
    }
    are_possible
}
