//! `body` statements.

use super::changing_mass::{matter, may_change, push_influx};
use super::compound::{compound_geometry, visual_outlines};
use super::expressions::{plain_expression, turning};
use super::gravity::weigh;
use super::mass_geometry::{
    MassGeometry, fixed_vector, inertia_of, named_centroid, outline_of, shape_of, vector_of,
};
use super::messages;
use super::object::{Body, Energies, Object};
use super::plain::{Drawn, DrawnKind, Motion, Obligation};
use super::terms::Pair;
use super::translation::Translation;
use crate::syntax::ast::{self, AstId, StatementKind};

pub(super) fn translate_body(translation: &mut Translation<'_>, statement: &ast::Body) {
    let name = &statement.name;
    let angle = body_angle(translation, statement);
    let geometry = match statement.parts.is_empty() {
        true => simple_geometry(translation, statement),
        false => compound_geometry(translation, statement),
    };
    let MassGeometry { mass, inertia, centroid, changes, outlines, radius } = geometry;
    let (center, origin) = body_place(translation, statement, centroid, angle);
    let of_translation = Some(push_translation(translation, mass, center));
    let inertia = inertia.unwrap_or_else(|| translation.terms().number(0));
    translation.obligations.push(Obligation::Inertia { body: name.clone(), inertia });
    let of_rotation = statement.angle.and_then(|_| push_rotation(translation, inertia, angle));
    if changes {
        push_influxes(translation, &name.text, (mass, center), (inertia, angle));
    }
    let energies = Energies { of_translation, of_rotation, potential: None };
    let index = translation.bodies.len();
    let centroid_vector = translation.terms().tuple(centroid);
    translation.motions.push(Motion {
        body: name.clone(),
        center,
        centroid: centroid_vector,
        angle,
        mass,
        inertia,
    });
    let shape = outlines.first().filter(|_| statement.shape.is_some()).cloned();
    let outlines = match statement.visuals.is_empty() {
        true => outlines,
        false => visual_outlines(translation, &statement.visuals),
    };
    let kind = DrawnKind::Body { body: translation.motions.len() - 1, outlines };
    translation.drawing.push(Drawn { kind, values: Vec::new(), needs: Vec::new() });
    let name = name.clone();
    translation.bodies.push(Body {
        name,
        mass,
        inertia,
        center,
        centroid,
        origin,
        angle,
        radius,
        shape,
        energies,
    });
    translation.names.declare(&statement.name.text, Object::Body(index));
    weigh(translation, index);
}

/// Returns the angle, under a separate name unless it is a name itself.
fn body_angle(translation: &mut Translation<'_>, statement: &ast::Body) -> AstId {
    let Some(angle) = statement.angle else { return translation.terms().number(0) };
    let angle = turning(translation, angle);
    translation.mentioned.push(angle);
    match translation.expressions.get(angle) {
        ast::Expression::Name(_)
        | ast::Expression::Number(_)
        | ast::Expression::Quantity(..)
        | ast::Expression::Invalid => angle,
        _ => translation.bind(&format!("{}_angle", statement.name.text), angle),
    }
}

fn simple_geometry(translation: &mut Translation<'_>, statement: &ast::Body) -> MassGeometry {
    let name = &statement.name;
    let mass = mass_of(translation, statement);
    let shape = statement.shape.as_ref().and_then(|shape| shape_of(translation, shape));
    let place = statement.shape.as_ref().map_or(translation.origin, |shape| shape.origin);
    let of_shape =
        shape.as_ref().map(|(solid, dimensions)| inertia_of(translation, solid, mass, dimensions, place));
    let stated = statement.inertia.map(|j| matter(translation, j, &messages::inertia_of(&name.text)));
    if let (Some(stated), Some(of_shape), Some(shape)) = (stated, of_shape, &statement.shape) {
        let obligation =
            Obligation::SameInertia { body: name.clone(), stated, of_shape, shape: shape.origin };
        translation.obligations.push(obligation);
    }
    if stated.is_none() && statement.angle.is_some() {
        report_unknown_inertia(translation, statement);
    }
    let centroid = match statement.centroid {
        Some(centroid) => fixed_vector(translation, centroid, &messages::centroid_of(&name.text)),
        None => named_centroid(translation, &name.text, shape.as_ref(), place),
    };
    let radius = shape.as_ref().and_then(|(solid, dimensions)| Some(dimensions[solid.radius?]));
    let outlines =
        shape.map(|(solid, dimensions)| outline_of(translation, solid, dimensions)).into_iter().collect();
    let inertia = stated.or(of_shape);
    let changes = may_change(translation, name, mass, inertia.into_iter().collect());
    MassGeometry { mass, inertia, centroid, changes, outlines, radius }
}

/// Reports a turning body without a moment of inertia, unless the one of its shape is about its
/// centre of mass.
fn report_unknown_inertia(translation: &mut Translation<'_>, statement: &ast::Body) {
    let name = &statement.name;
    match (&statement.shape, statement.centroid) {
        (None, _) => {
            let error = translation.report.error(name.span, messages::no_inertia(&name.text));
            error.help(messages::NO_INERTIA_HELP);
        }
        (Some(_), Some(centroid)) => {
            let origin = translation.expressions.origin(centroid);
            let error = translation.report.error(origin, messages::unknown_inertia(&name.text));
            error.help(messages::UNKNOWN_INERTIA_HELP);
        }
        (Some(_), None) => {}
    }
}

pub(super) fn mass_of(translation: &mut Translation<'_>, statement: &ast::Body) -> AstId {
    let name = &statement.name;
    let Some(mass) = statement.mass else {
        let error = translation.report.error(name.span, messages::no_mass(&name.text));
        error.help(messages::NO_MASS_HELP);
        return translation.terms().invalid();
    };
    let mass = matter(translation, mass, &messages::mass_of(&name.text));
    translation.obligations.push(Obligation::PositiveMass { body: name.clone(), mass });
    mass
}

/// Returns the centre of mass under a separate name, and the origin of the body-fixed coordinates.
fn body_place(
    translation: &mut Translation<'_>,
    statement: &ast::Body,
    centroid: Pair,
    angle: AstId,
) -> (AstId, Pair) {
    let name = &statement.name.text;
    let stated = match (statement.center, statement.origin) {
        (Some(center), None) => Some((vector_of(translation, center, &messages::center_of(name)), true)),
        (None, Some(origin)) => Some((own_origin(translation, name, origin), false)),
        (given, _) => {
            let message = messages::one_place(name, given.is_some());
            translation.report.error(statement.name.span, message).help(messages::ONE_PLACE_HELP);
            None
        }
    };
    let mut terms = translation.terms();
    let Some((place, is_center)) = stated else {
        let invalid = terms.invalid();
        return (invalid, [invalid, invalid]);
    };
    let arm = terms.turned(centroid, angle);
    let center = if is_center { place } else { terms.plus_pair(place, arm) };
    let center = terms.tuple(center);
    let center = translation.bind(&format!("{name}_center"), center);
    translation.note_place(center, &messages::place_of(name));
    let mut terms = translation.terms();
    let origin = match is_center {
        true => {
            let center = terms.pair(center);
            terms.minus_pair(center, arm)
        }
        false => place,
    };
    translation.obligations.push(Obligation::Moves { body: statement.name.clone(), center, angle });
    (center, origin)
}

/// Returns the origin of the body-fixed coordinates, under a separate name unless it is written by
/// components.
fn own_origin(translation: &mut Translation<'_>, name: &str, origin: AstId) -> Pair {
    let components = vector_of(translation, origin, &messages::origin_of(name));
    match translation.expressions.get(components[0]) {
        ast::Expression::Component(..) => {
            let origin = plain_expression(translation, origin);
            let origin = translation.bind(&format!("{name}_origin"), origin);
            translation.note_place(origin, &messages::place_of(name));
            translation.terms().pair(origin)
        }
        _ => components,
    }
}

fn push_translation(translation: &mut Translation<'_>, mass: AstId, center: AstId) -> AstId {
    let mut terms = translation.terms();
    let velocity = terms.call("dot", &[center]);
    let kinetic = terms.call("kinetic_energy", &[mass, velocity]);
    translation.push(StatementKind::Kinetic(kinetic));
    kinetic
}

fn push_rotation(translation: &mut Translation<'_>, inertia: AstId, angle: AstId) -> Option<AstId> {
    let mut terms = translation.terms();
    let rate = terms.rate(angle);
    if terms.is_zero(rate) || terms.is_zero(inertia) {
        return None;
    }
    let kinetic = terms.call("kinetic_energy", &[inertia, rate]);
    translation.push(StatementKind::Kinetic(kinetic));
    Some(kinetic)
}

/// Adds the loads of matter that leaves or joins a body: of its translation and its rotation.
fn push_influxes(
    translation: &mut Translation<'_>,
    name: &str,
    (mass, center): (AstId, AstId),
    (inertia, angle): (AstId, AstId),
) {
    let mut terms = translation.terms();
    let (velocity, spin) = (terms.call("dot", &[center]), terms.rate(angle));
    push_influx(translation, &format!("{name}_influx"), mass, velocity);
    push_influx(translation, &format!("{name}_spin_influx"), inertia, spin);
}
