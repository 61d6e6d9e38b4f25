//! Contacts, translated to events with an impact and frictions, or to forces.
//!
//! `contact touch = wheel on floor { friction: mu; restitution: e; }` becomes
//! `let touch_gap = …; event touch = touch_gap, falling => impact(e);` and
//! `let touch_slip = …; friction touch_friction = touch_slip, mu * touch;`. Moments against rolling
//! and spinning are frictions along angular velocities. A contact with a stiffness becomes a
//! potential and forces along the rate of the gap and these velocities.

mod coefficients;
mod compliant;
mod faces;
mod geometry;
mod labels;
mod rim;
mod terrain;
mod touched;
mod turning;

use proc_macro2::TokenStream;

use super::drawing::{draw_forces, draw_from_inside};
use super::expressions::is_ground;
use super::messages::contacts as words;
use super::object::{self, Object, Surface};
use super::plain::{Drawn, DrawnKind, LoadOrigin};
use super::space::vectors::{Triple, minus, plus, scale, zero_triple};
use super::surfaces::scene_vector;
use super::touching::{Touching, touching, touching_at};
use super::translation::Translation;
use crate::syntax::ast::{self, Action, AstId, Direction, Event, Friction, Name, StatementKind};
use coefficients::{
    Coefficient, coefficients, compliance, limit, oblige, radius, restitution, turning_coefficients,
};
use compliant::{press, rub_smoothly};
use faces::{between_blocks, block_that_touches, is_between_blocks, surface_of_block};
use geometry::{ContactGeometry, geometry, relative_motion, slip_of};
use labels::check_labels;
pub(super) use labels::{default_compliance, mention_defaults};
use rim::{on_rim, rim_of_shape, stated_rim};
use terrain::over_terrain;
use touched::{is_block, surface_named};
use turning::resist_turning;

pub(super) fn translate_contact(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    docs: &TokenStream,
) {
    let statement = &statement.with_defaults(&translation.compliance);
    let contact = match statement.is_incomplete || check_labels(translation, statement) {
        true => complete_contact(translation, statement),
        false => None,
    };
    let contact = contact.unwrap_or_else(|| broken_contact(translation, statement));
    let name = &statement.name.text;
    let declares = |kind: &StatementKind| match kind {
        StatementKind::Event(event) => event.name.text == *name,
        StatementKind::Let(known, _) => known.text == *name,
        _ => false,
    };
    let event = translation.statements.iter_mut().rfind(|plain| declares(&plain.kind));
    event.into_iter().for_each(|event| event.docs = docs.clone());
    translation.names.declare(&statement.name.text, Object::Contact(contact));
}

fn complete_contact(translation: &mut Translation<'_>, statement: &ast::Contact) -> Option<object::Contact> {
    let coefficients = coefficients(translation, statement);
    let restitution = restitution(translation, statement);
    let radius = radius(translation, statement);
    let compliance = compliance(translation, statement);
    let turning = turning_coefficients(translation, statement);
    let touching = touching_part(translation, statement);
    if touching.is_none() && is_ground(translation, statement.object) {
        // What it would touch is the body that was meant.
        return None;
    }
    let surface = match is_between_blocks(translation, statement) {
        true => surface_of_block(translation, statement),
        // The first body was reported: bodies of different parts do not touch with their faces.
        false if touching.is_none() && is_block(translation, &statement.surface.text) => None,
        false => surface_named(translation, statement),
    };
    let (touching, surface) = (touching?, surface?);
    let (coefficients, restitution, radius) = (coefficients?, restitution?, radius?);
    let (compliance, turning) = (compliance?, turning?);
    if surface.carrier == Some(touching.body) {
        let message = words::touches_itself(&statement.name.text, translation.name_of(touching.body));
        translation.report.error(statement.surface.span, message).help(words::TOUCHES_ITSELF_HELP);
        return None;
    }
    let (touching, geometry) = geometry_of(translation, statement, (touching, &surface), radius)?;
    let motion = relative_motion(translation, &surface, &touching, &geometry);
    let slip = slip_of(translation, &motion, &geometry);
    let gap = translation.bind(&format!("{}_gap", statement.name.text), geometry.gap);
    match &compliance {
        Some(compliance) => press(translation, statement, gap, compliance),
        None => push_event(translation, &statement.name, gap, restitution),
    }
    let grip = coefficients.map(|[_, fixed]| fixed.value);
    let stiction = compliance.as_ref().and_then(|compliance| compliance.stiction);
    let slip = coefficients.map_or(slip, |coefficients| {
        let slip = translation.bind(&format!("{}_slip", statement.name.text), slip);
        let (slips, friction) = ((slip, translation.space.is_some()), (&statement.frictions.sliding, false));
        rub(translation, &statement.name, friction, slips, (coefficients, stiction));
        slip
    });
    let stiction_rate = compliance.and_then(|compliance| compliance.stiction_rate);
    resist_turning(translation, statement, (&motion, &geometry), (turning, stiction_rate));
    let geometry = ContactGeometry { gap, ..geometry };
    if statement.is_inside {
        draw_from_inside(translation, &statement.surface.text);
    }
    let bodies = [Some(touching.body), surface.carrier].map(|body| loaded_name(translation, body?));
    Some(parts_of(translation, statement, &bodies, &geometry, (slip, grip)))
}

/// Returns the touching part and the geometry of a contact; `None` after an error.
fn geometry_of(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    (touching, surface): (Touching, &Surface),
    radius: Option<AstId>,
) -> Option<(Touching, ContactGeometry)> {
    if is_between_blocks(translation, statement) {
        return between_blocks(translation, statement, (touching, surface), radius);
    }
    oblige_surface(translation, statement, surface);
    let rim = match statement.rim {
        Some(written) => Some(stated_rim(translation, statement, written)?),
        None => rim_of_shape(translation, statement).map(|(rim, ..)| rim),
    };
    if let Some(rim) = rim {
        return on_rim(translation, statement, (rim, radius), (touching, surface));
    }
    let zero = translation.terms().number(0);
    if let Some(own) = touching.radius {
        oblige(translation, statement, words::RADIUS_OF_BODY.to_owned(), own, (zero, true));
    }
    let radius = radius.or(touching.radius).unwrap_or(zero);
    let ball = (touching.center, radius);
    let geometry = match &surface.height {
        Some(height) => over_terrain(translation, statement, (surface, height), ball),
        None => geometry(translation, statement, surface, ball),
    };
    Some((touching, geometry))
}

/// Obliges the stated direction and the radius of a surface to be longer than zero.
fn oblige_surface(translation: &mut Translation<'_>, statement: &ast::Contact, surface: &Surface) {
    let (name, zero) = (&statement.surface.text, translation.terms().number(0));
    if let Some(length) = surface.length {
        oblige(translation, statement, words::length_of_direction(name), length, (zero, false));
    }
    oblige(translation, statement, words::radius_of_surface(name), surface.radius, (zero, false));
}

/// Declares the names of an invalid contact, whose error was reported.
fn broken_contact(translation: &mut Translation<'_>, statement: &ast::Contact) -> object::Contact {
    let invalid = translation.terms().invalid();
    if statement.compliance.way().is_some() {
        for name in statement.names() {
            translation.push(StatementKind::Let(name.clone(), invalid));
        }
    } else {
        push_event(translation, &statement.name, invalid, invalid);
        for friction in statement.names().into_iter().skip(1) {
            push_friction(translation, (friction, false), invalid, [invalid; 2]);
        }
    }
    let parts = PARTS.map(|part| (part, invalid)).to_vec();
    object::Contact { parts }
}

/// Parts of a contact that expressions can refer to.
const PARTS: [&str; 8] = ["normal", "friction", "force", "gap", "slip", "point", "rolling", "spinning"];

fn touching_part(translation: &mut Translation<'_>, statement: &ast::Contact) -> Option<Touching> {
    let name = &statement.name;
    if is_ground(translation, statement.object) {
        let origin = translation.expressions.origin(statement.object);
        let error = translation.report.error(origin, words::ground_touches(&name.text));
        error.help(words::GROUND_TOUCHES_HELP);
        return None;
    }
    if is_between_blocks(translation, statement) {
        return block_that_touches(translation, statement);
    }
    match rim_of_shape(translation, statement) {
        Some((_, link, center)) => Some(touching_at(translation, link, center)),
        None => touching(translation, statement),
    }
}

/// Returns the name of the body on which a force on a body or link acts.
fn loaded_name(translation: &Translation<'_>, body: usize) -> Option<String> {
    let body = match &translation.space {
        Some(space) => space.loaded_link(body)?,
        None => body,
    };
    Some(translation.name_of(body).to_owned())
}

/// Adds a friction of a contact against a slip velocity or an angular velocity, which is a scalar
/// or a pair. Its name is accompanied by whether it is a moment. With a stiction speed it is
/// smooth.
fn rub(
    translation: &mut Translation<'_>,
    contact: &Name,
    friction: (&Name, bool),
    (slip, is_pair): (AstId, bool),
    ([kinetic, fixed], stiction): ([Coefficient; 2], Option<AstId>),
) {
    let normal = translation.terms().name(&contact.text);
    let while_slipping = limit(translation, kinetic, normal);
    if let Some(stiction) = stiction {
        return rub_smoothly(translation, friction.0, (slip, is_pair), (while_slipping, stiction));
    }
    let while_sticking = match fixed.written == kinetic.written {
        true => while_slipping,
        false => limit(translation, fixed, normal),
    };
    push_friction(translation, friction, slip, [while_slipping, while_sticking]);
}

/// Draws the normal force and the friction on both bodies if there is a drawing; otherwise `touch`
/// would count as needed.
fn draw_contact(
    translation: &mut Translation<'_>,
    name: &Name,
    bodies: &[Option<String>; 2],
    point: Triple,
    forces: impl Iterator<Item = Triple>,
) {
    if !translation.is_drawn {
        return;
    }
    let point = scene_vector(translation, point);
    for (force, part) in forces.zip(["normal", "friction"]) {
        let force = scene_vector(translation, force);
        let name = format!("{}.{part}", name.text);
        let ends = bodies.clone().map(|body| (body, point));
        draw_forces(translation, (&name, LoadOrigin::Contact), &[], ends, force);
    }
}

/// Draws the friction cones on both bodies, if there are friction and a drawing.
fn draw_cones(
    translation: &mut Translation<'_>,
    name: &Name,
    bodies: &[Option<String>; 2],
    (point, pressure): (Triple, Triple),
    coefficient: Option<AstId>,
) {
    let Some(coefficient) = coefficient.filter(|_| translation.is_drawn) else { return };
    let [point, pressure] = [point, pressure].map(|vector| scene_vector(translation, vector));
    let opposite = translation.terms().negative(pressure);
    for (body, normal) in bodies.iter().zip([pressure, opposite]) {
        if body.is_some() {
            let kind = DrawnKind::Cone { name: format!("{}.cone", name.text), body: body.clone() };
            let values = vec![point, normal, coefficient];
            translation.loads.push(Drawn { kind, values, needs: Vec::new() });
        }
    }
}

/// Returns the values of the parts of a contact in expressions, and draws its forces on both
/// bodies.
fn parts_of(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    bodies: &[Option<String>; 2],
    geometry: &ContactGeometry,
    (slip, coefficient): (AstId, Option<AstId>),
) -> object::Contact {
    let is_spatial = translation.space.is_some();
    let mut terms = translation.terms();
    let normal = terms.name(&statement.name.text);
    let mut share = |exists: bool, name: &Name, is_pair: bool| match exists {
        true => terms.name(&name.text),
        false if is_pair => {
            let nothing = terms.zero_pair();
            terms.tuple(nothing)
        }
        false => terms.number(0),
    };
    let frictions = &statement.frictions;
    let friction = share(statement.has_friction(), &frictions.sliding, is_spatial);
    let rolling = share(statement.rolling.is_some(), &frictions.rolling, is_spatial);
    let spinning = share(statement.spinning.is_some(), &frictions.spinning, false);
    let shares = if is_spatial { terms.pair(friction).to_vec() } else { vec![friction] };
    let pressure = scale(&mut terms, normal, geometry.normal);
    let mut grip = zero_triple(&mut terms);
    for (share, tangent) in shares.into_iter().zip(geometry.tangents) {
        let share = scale(&mut terms, share, tangent);
        grip = plus(&mut terms, grip, share);
    }
    let force = plus(&mut terms, pressure, grip);
    let foot = scale(&mut terms, geometry.radius, geometry.normal);
    let point = minus(&mut terms, geometry.center, foot);
    let shares = [pressure, grip].into_iter().take(1 + usize::from(statement.has_friction()));
    draw_contact(translation, &statement.name, bodies, point, shares);
    draw_cones(translation, &statement.name, bodies, (point, pressure), coefficient);
    let [force, point] = [force, point].map(|vector| scene_vector(translation, vector));
    let values = [normal, friction, force, geometry.gap, slip, point, rolling, spinning];
    object::Contact { parts: PARTS.into_iter().zip(values).collect() }
}

fn push_event(translation: &mut Translation<'_>, name: &Name, gap: AstId, restitution: AstId) {
    translation.push(StatementKind::Event(Event {
        name: name.clone(),
        value: gap,
        direction: Direction::Falling,
        direction_span: name.span,
        action: Action::Impact(restitution),
    }));
}

fn push_friction(
    translation: &mut Translation<'_>,
    (name, is_moment): (&Name, bool),
    slip: AstId,
    [kinetic, fixed]: [AstId; 2],
) {
    let fixed = (fixed != kinetic).then_some(fixed);
    translation.push(StatementKind::Friction(Friction {
        name: name.clone(),
        slip,
        kinetic,
        fixed,
        width: None,
        is_moment,
    }));
}
