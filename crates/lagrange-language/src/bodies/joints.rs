//! Pins, slides and rolling as constraints.
//!
//! The gradient of a constraint is the direction in which its force acts on the first-named body.
//! The force is λ times the direction.

use super::drawing::{draw_forces, owner_of_point};
use super::expressions::{mention, scene_point};
use super::lines::{carrier, track};
use super::messages;
use super::object::{Body, Joint, Line, Object};
use super::plain::{Drawn, DrawnKind, JointForm, LoadOrigin};
use super::space::{draw_pin, point_on_link};
use super::terms::Pair;
use super::translation::Translation;
use crate::syntax::ast::{self, AstId, JointKind, Name, StatementKind};

pub(super) fn translate_joint(translation: &mut Translation<'_>, statement: &ast::Joint) {
    let joint = match &statement.kind {
        JointKind::Pin { first, second } => hold_pin(translation, statement, *first, *second),
        JointKind::Slide { point, line } => hold_slide(translation, statement, *point, line),
        JointKind::Roll { body, line, radius } => hold_roll(translation, statement, body, line, *radius),
    };
    if let Some(name) = &statement.name {
        let joint = joint.unwrap_or_else(|| {
            let invalid = translation.terms().invalid();
            Joint { force: invalid, parts: vec![("normal", invalid), ("friction", invalid)] }
        });
        translation.names.declare(&name.text, Object::Joint(joint));
    }
}

/// Returns the name of a joint, or a generated one.
fn joint_name(translation: &mut Translation<'_>, statement: &ast::Joint, kind: &str) -> String {
    match &statement.name {
        Some(name) => name.text.clone(),
        None => translation.names.of_nameless(kind),
    }
}

fn hold_pin(
    translation: &mut Translation<'_>,
    statement: &ast::Joint,
    first: AstId,
    second: AstId,
) -> Option<Joint> {
    let bodies = [first, second].map(|point| translation.body_of(point));
    let owners = [first, second].map(|point| owner_of_point(translation, point));
    let name = joint_name(translation, statement, "pin");
    let links = [first, second].map(|point| link_of_point(translation, point));
    let points = [first, second].map(|point| scene_point(translation, point, messages::PINNED_POINT));
    translation.mentioned.extend(points);
    let same = [bodies, links].into_iter().any(|[first, second]| first.is_some() && first == second);
    if same {
        let name = name_of_owner(translation, bodies[0], links[0]);
        let error = translation
            .report
            .error(translation.expressions.origin(second), messages::pinned_to_itself(&name));
        error.help(messages::PINNED_TO_ITSELF_HELP);
        return None;
    }
    let dimension = translation.dimension();
    let mut terms = translation.terms();
    let gap = terms.difference(dimension, points);
    let gaps = ["x", "y", "z"].into_iter().zip(gap);
    let names = gaps.map(|(axis, gap)| add_constraint(translation, &format!("{name}_{axis}"), gap));
    let names = names.collect::<Vec<_>>();
    let mut terms = translation.terms();
    let force = names.iter().map(|name| terms.name(&name.text)).collect::<Vec<_>>();
    let force = terms.vector(&force);
    if dimension == 3 {
        draw_pin(translation, &name, points[0], links);
    } else {
        let is_anchored = [first, second].into_iter().any(|point| translation.is_at_rest(point));
        let form = if is_anchored { JointForm::Anchor } else { JointForm::Pin };
        draw_joint(translation, &name, form, points[0]);
    }
    let needs = names.iter().map(|name| name.text.as_str()).collect::<Vec<_>>();
    let [first, second] = owners;
    draw_forces(
        translation,
        (&name, LoadOrigin::Joint),
        &needs,
        [(first, points[0]), (second, points[1])],
        force,
    );
    Some(Joint { force, parts: Vec::new() })
}

fn link_of_point(translation: &mut Translation<'_>, point: AstId) -> Option<usize> {
    point_on_link(translation, point).map(|(link, _)| link)
}

/// Returns the name of the body, in the plane or in space, to which a point belongs.
fn name_of_owner(translation: &Translation<'_>, body: Option<usize>, link: Option<usize>) -> String {
    let link = link.zip(translation.space.as_ref()).map(|(link, space)| space.name_of(link));
    let body = body.map(|body| translation.bodies[body].name.text.as_str());
    body.or(link).unwrap_or_default().to_owned()
}

fn hold_slide(
    translation: &mut Translation<'_>,
    statement: &ast::Joint,
    point: AstId,
    line: &Name,
) -> Option<Joint> {
    let body = translation.body_of(point);
    let name = joint_name(translation, statement, "slide");
    let at = scene_point(translation, point, messages::SLIDING_POINT);
    translation.mentioned.push(at);
    let Line { body: carrier, through, angle } = track_of(translation, body, line)?;
    let mut terms = translation.terms();
    let [_, normal] = terms.axes(angle);
    let place = terms.pair(at);
    let gap = terms.projection(normal, place, through);
    let pressure = add_constraint(translation, &format!("{name}_normal"), gap);
    let mut terms = translation.terms();
    let multiplier = terms.name(&pressure.text);
    let force = terms.scale(multiplier, normal);
    let force = terms.tuple(force);
    draw_joint(translation, &name, JointForm::Slide, at);
    let shares = [body, carrier].map(|body| (name_of(translation, body), at));
    draw_forces(translation, (&name, LoadOrigin::Joint), &[&pressure.text], shares, force);
    Some(Joint { force, parts: vec![("normal", multiplier)] })
}

fn hold_roll(
    translation: &mut Translation<'_>,
    statement: &ast::Joint,
    wheel: &Name,
    line: &Name,
    radius: Option<AstId>,
) -> Option<Joint> {
    let name = joint_name(translation, statement, "roll");
    let (wheel, line, radius) = rolling_pair(translation, wheel, line, radius)?;
    let Line { body: carrier, through, angle } = line;
    let Body { origin: hub, .. } = translation.bodies[wheel].clone();
    let mut terms = translation.terms();
    let [tangent, normal] = terms.axes(angle);
    let distance = terms.projection(normal, hub, through);
    let gap = terms.minus(distance, radius);
    let foot = terms.scale(radius, normal);
    let contact = terms.minus_pair(hub, foot);
    let slip = slip_of(translation, wheel, carrier, [tangent, normal], radius);
    let pressure = add_constraint(translation, &format!("{name}_normal"), gap);
    let friction = add_constraint(translation, &format!("{name}_friction"), slip);
    Some(rolling_constraint(
        translation,
        &name,
        [&pressure, &friction],
        [normal, tangent],
        contact,
        [Some(wheel), carrier],
    ))
}

/// Returns a round body and the line on which it rolls.
fn rolling_pair(
    translation: &mut Translation<'_>,
    wheel: &Name,
    line: &Name,
    radius: Option<AstId>,
) -> Option<(usize, Line, AstId)> {
    let radius = radius.map(|radius| mention(translation, radius));
    let span = wheel.span;
    let wheel = carrier(translation, wheel);
    let track = track_of(translation, wheel, line)?;
    let wheel = wheel?;
    let Body { name, angle, .. } = translation.bodies[wheel].clone();
    if translation.terms().is_zero(angle) {
        let message = messages::does_not_turn(format!("`{}`", name.text), messages::TURNED_BY_ROLLING);
        translation.report.error(span, message).help(messages::DOES_NOT_TURN_HELP);
        return None;
    }
    let Some(radius) = radius.or(translation.bodies[wheel].radius) else {
        let name = &translation.bodies[wheel].name.text;
        let error = translation.report.error(translation.origin, messages::no_radius(name));
        error.help(messages::no_radius_help(name));
        return None;
    };
    Some((wheel, track, radius))
}

/// Returns the line with this name, unless it is carried by the body that is to stay on it.
fn track_of(translation: &mut Translation<'_>, body: Option<usize>, line: &Name) -> Option<Line> {
    let track = track(translation, line)?;
    let track = translation.lines[track].clone();
    let own = body.filter(|_| track.body == body);
    let Some(own) = own else { return Some(track) };
    let error =
        translation.report.error(line.span, messages::slides_on_itself(&translation.bodies[own].name.text));
    error.help(messages::PINNED_TO_ITSELF_HELP);
    None
}

/// Returns the velocity at which a wheel slips on a line, which a body may carry. The point of that
/// body below the hub is at the distance n·(hub − origin) − r across the line, which determines the
/// effect of its rotation.
fn slip_of(
    translation: &mut Translation<'_>,
    wheel: usize,
    carrier: Option<usize>,
    [tangent, normal]: [Pair; 2],
    radius: AstId,
) -> AstId {
    let Body { origin: hub, angle, .. } = translation.bodies[wheel].clone();
    let mut terms = translation.terms();
    let velocity = terms.rate_pair(hub);
    let along = terms.inner(tangent, velocity);
    let rate = terms.rate(angle);
    let turning = terms.times(radius, rate);
    let slip = terms.plus(along, turning);
    let Some(carrier) = carrier else { return slip };
    let Body { origin, angle, .. } = translation.bodies[carrier].clone();
    let mut terms = translation.terms();
    let (velocity, rate) = (terms.rate_pair(origin), terms.rate(angle));
    let along = terms.inner(tangent, velocity);
    let slip = terms.minus(slip, along);
    let arm = terms.minus_pair(hub, origin);
    let distance = terms.inner(normal, arm);
    let across = terms.minus(distance, radius);
    let turning = terms.times(rate, across);
    terms.plus(slip, turning)
}

fn rolling_constraint(
    translation: &mut Translation<'_>,
    name: &str,
    multipliers: [&Name; 2],
    directions: [Pair; 2],
    contact: Pair,
    bodies: [Option<usize>; 2],
) -> Joint {
    let mut terms = translation.terms();
    let at = terms.tuple(contact);
    let symbols = multipliers.map(|name| terms.name(&name.text));
    let forces = [0, 1].map(|index| terms.scale(symbols[index], directions[index]));
    let force = terms.plus_pair(forces[0], forces[1]);
    let force = terms.tuple(force);
    let forces = forces.map(|force| terms.tuple(force));
    draw_joint(translation, name, JointForm::Roll, at);
    for ((multiplier, force), part) in multipliers.into_iter().zip(forces).zip(["normal", "friction"]) {
        let shares = bodies.map(|body| (name_of(translation, body), at));
        let name = format!("{name}.{part}");
        draw_forces(translation, (&name, LoadOrigin::Joint), &[&multiplier.text], shares, force);
    }
    Joint { force, parts: vec![("normal", symbols[0]), ("friction", symbols[1])] }
}

/// Adds a constraint of a joint; returns the name of its multiplier.
fn add_constraint(translation: &mut Translation<'_>, wish: &str, value: AstId) -> Name {
    let name = translation.new_name(wish);
    translation.push(StatementKind::Constraint(name.clone(), value));
    translation.joints.push(name.clone());
    name
}

fn draw_joint(translation: &mut Translation<'_>, name: &str, kind: JointForm, at: AstId) {
    let kind = DrawnKind::Joint { name: name.to_owned(), kind };
    translation.drawing.push(Drawn { kind, values: vec![at], needs: Vec::new() });
}

fn name_of(translation: &Translation<'_>, body: Option<usize>) -> Option<String> {
    body.map(|body| translation.bodies[body].name.text.clone())
}
