//! Gravity, which acts on every body.

use super::drawing::{Load, draw_force};
use super::expressions::plain_expression;
use super::messages;
use super::object::Body;
use super::plain::{LoadOrigin, Obligation};
use super::translation::Translation;
use crate::syntax::ast::{AstId, StatementKind};

/// Translates gravity, which acts on every body, independent of its place in the declaration.
pub(super) fn translate_gravity(translation: &mut Translation<'_>, value: AstId) {
    let value = plain_expression(translation, value);
    if let Some((_, first)) = translation.gravity {
        let error = translation.report.error(translation.origin, messages::GRAVITY_TWICE);
        error.related(first, messages::FIRST_DECLARED).help(messages::GRAVITY_TWICE_HELP);
        return;
    }
    translation.obligations.push(Obligation::PlaneVector { what: "gravity".to_owned(), value });
    translation.obligations.push(Obligation::Uniform { gravity: value });
    translation.mentioned.push(value);
    let gravity = translation.terms().pair(value);
    translation.gravity = Some((gravity, translation.origin));
    for body in 0..translation.bodies.len() {
        weigh(translation, body);
    }
}

/// Reports gravity without bodies: hand-written energies have no weight.
pub(super) fn report_idle_gravity(translation: &mut Translation<'_>) {
    let Some((_, origin)) = translation.gravity.filter(|_| translation.motions.is_empty()) else { return };
    if !translation.report.has_errors() {
        translation.report.error(origin, messages::IDLE_GRAVITY).help(messages::IDLE_GRAVITY_HELP);
    }
}

/// Adds the potential −m g·c of a body and its weight, if there is gravity.
pub(super) fn weigh(translation: &mut Translation<'_>, index: usize) {
    let Some((gravity, _)) = translation.gravity else { return };
    let Body { name, mass, center, .. } = translation.bodies[index].clone();
    let mut terms = translation.terms();
    if terms.is_zero(mass) {
        // A frame.
        return;
    }
    let center_pair = terms.pair(center);
    let weighed = [0, 1].map(|axis| {
        let weight = terms.times(mass, gravity[axis]);
        terms.times(weight, center_pair[axis])
    });
    let sum = terms.plus(weighed[0], weighed[1]);
    let potential = terms.negative(sum);
    let force = terms.scale(mass, gravity);
    let force = terms.tuple(force);
    if !terms.is_zero(potential) {
        translation.push(StatementKind::Potential(potential));
        translation.bodies[index].energies.potential = Some(potential);
    }
    let load = Load { name: "gravity", cause: LoadOrigin::Gravity, body: Some(name.text) };
    draw_force(translation, load, [center, force], &[]);
}
