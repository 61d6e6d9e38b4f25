//! Forces and moments that are drawn.

use super::plain::{Drawn, DrawnKind, LoadOrigin};
use super::space::point_on_link;
use super::translation::Translation;
use crate::syntax::ast::{AstId, Expression, SurfaceKind};

/// A load and the body on which it acts, if known.
pub(super) struct Load<'a> {
    pub(super) name: &'a str,
    pub(super) cause: LoadOrigin,
    pub(super) body: Option<String>,
}

impl Load<'_> {
    /// Creates the load of a `force` or `torque` statement.
    pub(super) fn applied(name: &str, body: Option<String>) -> Load<'_> {
        Load { name, cause: LoadOrigin::Applied, body }
    }
}

/// Returns the name of the body to which a point belongs, according to its written form. A frame in
/// space represents the body that it is fixed in.
pub(super) fn owner_of_point(translation: &mut Translation<'_>, point: AstId) -> Option<String> {
    if let Some(body) = translation.body_of(point) {
        return Some(translation.bodies[body].name.text.clone());
    }
    let link = link_of_point(translation, point)?;
    let space = translation.space.as_ref()?;
    space.loaded_link(link).map(|link| space.name_of(link).to_owned())
}

/// Returns the link of a point, which may also be known for a point that moves in it.
fn link_of_point(translation: &mut Translation<'_>, point: AstId) -> Option<usize> {
    let of_call = match translation.expressions.get(point) {
        Expression::Call(function, arguments) if function.text == "point" => arguments.first().copied(),
        _ => None,
    };
    let link = of_call.and_then(|body| translation.link_named(body));
    link.or_else(|| point_on_link(translation, point).map(|(link, _)| link))
}

/// Draws a force that acts at a place, unless it contains the multiplier of an omitted constraint.
pub(super) fn draw_force(
    translation: &mut Translation<'_>,
    load: Load<'_>,
    [at, force]: [AstId; 2],
    needs: &[&str],
) {
    let needs = needs.iter().map(|&name| name.to_owned()).collect();
    let kind = DrawnKind::Force { name: load.name.to_owned(), cause: load.cause, body: load.body };
    translation.loads.push(Drawn { kind, values: vec![at, force], needs });
}

/// Draws a force on the first body at its point, and the opposite one on the second.
pub(super) fn draw_forces(
    translation: &mut Translation<'_>,
    (name, cause): (&str, LoadOrigin),
    needs: &[&str],
    ends: [(Option<String>, AstId); 2],
    force: AstId,
) {
    let opposite = translation.terms().negative(force);
    for ((body, at), force) in ends.into_iter().zip([force, opposite]) {
        if body.is_some() {
            draw_force(translation, Load { name, cause, body }, [at, force], needs);
        }
    }
}

/// Draws a moment at a place.
pub(super) fn draw_moment(translation: &mut Translation<'_>, load: Load<'_>, [at, moment]: [AstId; 2]) {
    let kind = DrawnKind::Moment { name: load.name.to_owned(), cause: load.cause, body: load.body };
    translation.loads.push(Drawn { kind, values: vec![at, moment], needs: Vec::new() });
}

/// Draws a surface that a body or link may carry. Terrain has a height.
pub(super) fn draw_surface(
    translation: &mut Translation<'_>,
    name: &str,
    (kind, carrier): (SurfaceKind, Option<usize>),
    values: Vec<AstId>,
    height: Option<(Vec<String>, AstId)>,
) {
    let (name, body) = (name.to_owned(), carrier.map(|body| translation.name_of(body).to_owned()));
    let kind = DrawnKind::Surface { name, body, kind, is_inside: false, height };
    translation.drawing.push(Drawn { kind, values, needs: Vec::new() });
}

/// Draws a surface as seen from inside.
pub(super) fn draw_from_inside(translation: &mut Translation<'_>, surface: &str) {
    for drawn in &mut translation.drawing {
        if let DrawnKind::Surface { name, is_inside, .. } = &mut drawn.kind
            && name == surface
        {
            *is_inside = true;
        }
    }
}

/// Returns the name of a torque on an angle for pictures that cannot show it.
pub(super) fn torque_on(translation: &Translation<'_>, angle: AstId) -> String {
    match translation.expressions.get(angle) {
        Expression::Name(name) => format!("torque on `{name}`"),
        _ => "torque on an angle".to_owned(),
    }
}
