//! Forces at points of bodies and torques on bodies in space.
//!
//! They do work along velocities that are known in the axes of the body: F·v_P and M·ω. Nothing has
//! to be differentiated.

use super::drawing::loaded_body;
use super::expressions::{point_on_link, rate_of_link_point};
use super::inertia::components_of;
use super::messages as words;
use crate::bodies::drawing::{Load, draw_force, draw_moment, owner_of_point};
use crate::bodies::expressions::{mention, plain_expression, translated_place};
use crate::bodies::plain::Obligation;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{AstId, Expression, Statement, StatementKind};

/// Translates `force F at P;` for a point P of a body; any other point stays as it is.
pub(in crate::bodies) fn translate_spatial_force(
    translation: &mut Translation<'_>,
    force: AstId,
    point: AstId,
    statement: Statement,
) {
    let place = translated_place(translation, point);
    let Some((link, own)) = point_on_link(translation, point) else {
        let (written, force, point) = (point, plain_expression(translation, force), place);
        let body = owner_of_point(translation, written);
        draw_force(translation, Load::applied("force", body), [point, force], &[]);
        translation.statements.push(Statement { kind: StatementKind::ForceAt { force, point }, ..statement });
        return;
    };
    let body = owner_of_point(translation, point);
    let drawn = [place, plain_expression(translation, force)];
    draw_force(translation, Load::applied("force", body), drawn, &[]);
    let (pose, velocity) = rate_of_link_point(translation, "velocity", link, own);
    let components = own_load(translation, force, link, words::FORCE);
    let components = components.unwrap_or_else(|world| pose.in_own_axes(&mut translation.terms(), world));
    push_load(translation, components, velocity, statement);
}

/// Translates `torque M on body;` for a vector, in world axes or as `body.vector(…)`.
pub(in crate::bodies) fn translate_spatial_torque(
    translation: &mut Translation<'_>,
    moment: AstId,
    link: usize,
    statement: Statement,
) {
    let origin = [translation.terms().number(0); 3];
    let (pose, _) = rate_of_link_point(translation, "velocity", link, origin);
    let components = own_load(translation, moment, link, words::TORQUE);
    let components = components.unwrap_or_else(|world| pose.in_own_axes(&mut translation.terms(), world));
    let drawn = plain_expression(translation, moment);
    if let Some((body, center)) = loaded_body(translation, link) {
        draw_moment(translation, Load::applied("torque", Some(body)), [center, drawn]);
    }
    push_load(translation, components, pose.spin, statement);
}

/// Returns the body components of a load if it was written as a vector of the body, else the world
/// components.
fn own_load(
    translation: &mut Translation<'_>,
    load: AstId,
    link: usize,
    what: &str,
) -> Result<[AstId; 3], [AstId; 3]> {
    let own = match translation.expressions.get(load).clone() {
        Expression::Call(function, arguments) if function.text == "vector" => match arguments[..] {
            [body, x, y, z] if translation.link_named(body) == Some(link) => Some([x, y, z]),
            _ => None,
        },
        _ => None,
    };
    let value = mention(translation, load);
    translation.obligations.push(Obligation::SpaceVector { what: what.to_owned(), value });
    match own {
        Some(own) => Ok(own.map(|component| plain_expression(translation, component))),
        None => Err(components_of(translation, value)),
    }
}

fn push_load(
    translation: &mut Translation<'_>,
    force: [AstId; 3],
    velocity: [AstId; 3],
    statement: Statement,
) {
    let mut terms = translation.terms();
    let (force, velocity) = (terms.vector(&force), terms.vector(&velocity));
    translation
        .statements
        .push(Statement { kind: StatementKind::ForceAlong { force, velocity }, ..statement });
}
