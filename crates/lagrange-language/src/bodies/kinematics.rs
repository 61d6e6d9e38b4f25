//! Functions of bodies and lines: points, vectors, rates, momenta, distances.
//!
//! Source: Meriam, Kraige, *Engineering Mechanics: Dynamics*, §5/4 to 5/6 and 6/8.

use super::corners::corner;
use super::messages;
use super::object::{Body, Line};
use super::terms::Pair;
use super::translation::Translation;
use crate::syntax::ast::AstId;

pub(super) fn of_body(
    translation: &mut Translation<'_>,
    body: usize,
    function: &str,
    places: &[AstId],
) -> AstId {
    match (function, places) {
        ("point", &[x, y]) => {
            let point = point_of_body(translation, body, [x, y]);
            translation.terms().tuple(point)
        }
        ("corner", &[index]) => {
            let Body { name, shape, .. } = translation.bodies[body].clone();
            match corner(translation, &name.text, shape.as_ref(), index) {
                Some([x, y, _]) => {
                    let point = point_of_body(translation, body, [x, y]);
                    translation.terms().tuple(point)
                }
                None => translation.terms().invalid(),
            }
        }
        ("vector", &[x, y]) => {
            let angle = translation.bodies[body].angle;
            let vector = translation.terms().turned([x, y], angle);
            translation.terms().tuple(vector)
        }
        ("tangential_acceleration" | "radial_acceleration", &[to, ref from @ ..]) => {
            part_of_acceleration(translation, body, function, to, from.first().copied())
        }
        ("angular_momentum", about) => angular_momentum(translation, body, about.first().copied()),
        _ => rate_of_body(translation, body, function),
    }
}

/// Returns the position of a point given by body-fixed coordinates.
pub(super) fn point_of_body(translation: &mut Translation<'_>, body: usize, own: Pair) -> Pair {
    let Body { origin, angle, .. } = translation.bodies[body].clone();
    let mut terms = translation.terms();
    let arm = terms.turned(own, angle);
    terms.plus_pair(origin, arm)
}

fn rate_of_body(translation: &mut Translation<'_>, body: usize, function: &str) -> AstId {
    let Body { name, mass, center, angle, .. } = translation.bodies[body].clone();
    if function == "instant_center" && translation.terms().is_zero(angle) {
        let error = translation.report.error(translation.origin, messages::never_turns(&name.text));
        error.help(messages::NEVER_TURNS_HELP);
        return translation.terms().invalid();
    }
    let mut terms = translation.terms();
    match function {
        "angular_velocity" => terms.rate(angle),
        "angular_acceleration" => {
            let rate = terms.rate(angle);
            terms.rate(rate)
        }
        "linear_momentum" => {
            let velocity = terms.call("dot", &[center]);
            terms.times(mass, velocity)
        }
        // r + e_z × v/ω
        _ => {
            let velocity = terms.call("dot", &[center]);
            let (center, velocity) = (terms.pair(center), terms.pair(velocity));
            let rate = terms.rate(angle);
            let arm = terms.quarter_turn(velocity).map(|component| terms.divide(component, rate));
            let place = terms.plus_pair(center, arm);
            terms.tuple(place)
        }
    }
}

/// Returns ω̇ e_z × ρ or −ω² ρ for the arm ρ between two points of a body.
fn part_of_acceleration(
    translation: &mut Translation<'_>,
    body: usize,
    function: &str,
    to: AstId,
    from: Option<AstId>,
) -> AstId {
    let Body { center, angle, .. } = translation.bodies[body].clone();
    let mut terms = translation.terms();
    let (to, from) = (terms.pair(to), terms.pair(from.unwrap_or(center)));
    let arm = terms.minus_pair(to, from);
    let rate = terms.rate(angle);
    let part = match function {
        "tangential_acceleration" => {
            let (rate, across) = (terms.rate(rate), terms.quarter_turn(arm));
            terms.scale(rate, across)
        }
        _ => {
            let square = if terms.is_zero(rate) { rate } else { terms.square(rate) };
            let inwards = terms.negative(square);
            terms.scale(inwards, arm)
        }
    };
    terms.tuple(part)
}

/// Returns m (r_S − r_P) × v_S + J ω.
fn angular_momentum(translation: &mut Translation<'_>, body: usize, about: Option<AstId>) -> AstId {
    let Body { mass, inertia, center, angle, .. } = translation.bodies[body].clone();
    let mut terms = translation.terms();
    let about = match about {
        Some(about) => terms.pair(about),
        None => terms.zero_pair(),
    };
    let velocity = terms.call("dot", &[center]);
    let (center, velocity) = (terms.pair(center), terms.pair(velocity));
    let arm = terms.minus_pair(center, about);
    let moment = terms.cross(arm, velocity);
    let (moment, rate) = (terms.times(mass, moment), terms.rate(angle));
    let spin = terms.times(inertia, rate);
    terms.plus(moment, spin)
}

pub(super) fn of_line(translation: &mut Translation<'_>, line: usize, function: &str, point: AstId) -> AstId {
    let Line { through, angle, .. } = translation.lines[line].clone();
    let mut terms = translation.terms();
    let [tangent, normal] = terms.axes(angle);
    let direction = if function == "along" { tangent } else { normal };
    let point = terms.pair(point);
    terms.projection(direction, point, through)
}
