//! Dimensions of the arguments of bodies, lines, connectors and joints.

use super::quantities::{is_of_numbers, with_unit};
use crate::syntax::ast::{
    AstId, Body, Compliance, Connector, ConnectorKind, Contact, ElementaryMotion, Expression, Expressions,
    Joint, JointKind, Mobilizer, Name, Part, SceneStatement, Shape, Surface, SurfaceKind,
};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::units::Unit;

/// A value after a label.
#[derive(Clone, Debug)]
pub(super) struct Label {
    /// The value.
    pub(super) value: AstId,
    /// The unit of the value or of its components.
    pub(super) unit: Unit,
    /// Description: `the mass of a body`.
    pub(super) what: &'static str,
}

/// A coherent unit as a product of powers.
type Powers = &'static [(&'static str, i8)];

const PLAIN: Powers = &[];
const MASS: Powers = &[("kg", 1)];
const LENGTH: Powers = &[("m", 1)];
const INERTIA: Powers = &[("kg", 1), ("m", 2)];
const ACCELERATION: Powers = &[("m", 1), ("s", -2)];
const SPEED: Powers = &[("m", 1), ("s", -1)];
const RATE: Powers = &[("rad", 1), ("s", -1)];
const PER_SPEED: Powers = &[("s", 1), ("m", -1)];
const FORCE: Powers = &[("N", 1)];
const STIFFNESS: Powers = &[("N", 1), ("m", -1)];
const DAMPING: Powers = &[("N", 1), ("s", 1), ("m", -1)];
const TORSION: Powers = &[("N", 1), ("m", 1)];
const TORSION_DAMPING: Powers = &[("N", 1), ("m", 1), ("s", 1)];
const ANGLE: Powers = &[("rad", 1)];

/// A replaceable value, its unit and its description.
type LabelRow<'a> = (&'a mut AstId, Powers, &'static str);

/// Writes units after the plain numbers at labels, and after the names of joint coordinates.
pub(super) fn label(statement: &mut SceneStatement, expressions: &mut Expressions) -> Vec<Label> {
    if let SceneStatement::Mobilizer(joint) = statement {
        name_coordinates(joint);
    }
    let rows = rows(statement).into_iter().filter_map(|(value, powers, what)| {
        let unit = Unit::coherent_of(powers, expressions.origin(*value))?;
        *value = measured(expressions, *value, &unit);
        Some(Label { value: *value, unit, what })
    });
    rows.collect()
}

/// Returns a number, or a vector with numeric components, in a unit.
fn measured(expressions: &mut Expressions, value: AstId, unit: &Unit) -> AstId {
    if let Expression::Tuple(parts) = expressions.get(value).clone() {
        let origin = expressions.origin(value);
        let parts = parts.into_iter().map(|part| measured(expressions, part, unit)).collect();
        return expressions.add(Expression::Tuple(parts), origin);
    }
    // Zero has any dimension, and must remain recognisable as zero.
    let is_zero = matches!(expressions.get(value), Expression::Number(number) if number.is_zero());
    let is_measured = !unit.dimension.is_none() && !is_zero && is_of_numbers(expressions, value);
    if is_measured { with_unit(expressions, value, unit) } else { value }
}

fn name_coordinates(joint: &mut Mobilizer) {
    let units = joint.kind.motions().iter().filter_map(|motion| match motion {
        ElementaryMotion::Turn(_) => Some(ANGLE),
        ElementaryMotion::Slide(_) => Some(LENGTH),
        ElementaryMotion::Advance | ElementaryMotion::Orientation => None,
    });
    for (name, powers) in joint.coordinates.iter_mut().zip(units) {
        give_unit(name, powers);
    }
}

fn give_unit(name: &mut Name, powers: Powers) {
    name.unit = Unit::coherent_of(powers, Origin::from(name.span)).map(Box::new);
}

fn rows(statement: &mut SceneStatement) -> Vec<LabelRow<'_>> {
    match statement {
        SceneStatement::Gravity(value) => vec![(value, ACCELERATION, "gravity")],
        SceneStatement::Body(body) => of_body(body),
        SceneStatement::Surface(surface) => of_surface(surface),
        SceneStatement::Contact(contact) => of_contact(contact),
        SceneStatement::Contacts(defaults) => of_compliance(&mut defaults.compliance).collect(),
        SceneStatement::Connector(connector) => of_connector(connector),
        SceneStatement::Joint(Joint { kind, .. }) => match kind {
            JointKind::Pin { first, second } => {
                vec![(first, LENGTH, "a point of a joint"), (second, LENGTH, "a point of a joint")]
            }
            JointKind::Slide { point, .. } => vec![(point, LENGTH, "a point of a joint")],
            JointKind::Roll { radius, .. } => {
                radius.iter_mut().map(|value| (value, LENGTH, "the radius of a wheel")).collect()
            }
        },
        SceneStatement::Mobilizer(joint) => of_mobilizer(joint),
        SceneStatement::Frame(_) => Vec::new(),
    }
}

fn of_body(body: &mut Body) -> Vec<LabelRow<'_>> {
    let Body {
        mass, inertia, tensor, center, origin, centroid, angle, angles, shape, parts, visuals, ..
    } = body;
    let single = [
        (mass, MASS, "the mass of a body"),
        (inertia, INERTIA, "the inertia of a body"),
        (center, LENGTH, "the centre of a body"),
        (origin, LENGTH, "the origin of a body"),
        (centroid, LENGTH, "the centroid of a body"),
        (angle, PLAIN, "the angle of a body"),
        (angles, PLAIN, "an angle of a body"),
    ];
    let single = single.into_iter().filter_map(|(value, powers, what)| Some((value.as_mut()?, powers, what)));
    let tensor = tensor.iter_mut().flatten().map(|value| (value, INERTIA, "the inertia of a body"));
    let parts = parts.iter_mut().chain(visuals).flat_map(of_part);
    single.chain(tensor).chain(shape.iter_mut().flat_map(of_shape)).chain(parts).collect()
}

fn of_shape(shape: &mut Shape) -> impl Iterator<Item = LabelRow<'_>> {
    shape.dimensions.iter_mut().map(|value| (value, LENGTH, "a dimension of a solid"))
}

fn of_part(part: &mut Part) -> Vec<LabelRow<'_>> {
    let Part { shape, mass, at, angle, turned, .. } = part;
    let single = [
        (mass, MASS, "the mass of a part"),
        (at, LENGTH, "the position of a part"),
        (angle, PLAIN, "the angle of a part"),
        (turned, PLAIN, "an angle of a part"),
    ];
    let single = single.into_iter().filter_map(|(value, powers, what)| Some((value.as_mut()?, powers, what)));
    single.chain(of_shape(shape)).collect()
}

fn of_surface(surface: &mut Surface) -> Vec<LabelRow<'_>> {
    let Surface { kind, place, direction, radius, height, .. } = surface;
    let what = if *kind == SurfaceKind::Line { "a point of a line" } else { "the position of a surface" };
    let place = place.iter_mut().map(|value| (value, LENGTH, what));
    // The length of a normal or an axis is irrelevant.
    let angle = direction.iter_mut().filter(|_| *kind == SurfaceKind::Line);
    let angle = angle.map(|value| (value, PLAIN, "the angle of a line"));
    let radius = radius.iter_mut().map(|value| (value, LENGTH, "the radius of a surface"));
    let height = height.iter_mut().map(|value| (value, LENGTH, "the height of a terrain"));
    place.chain(angle).chain(radius).chain(height).collect()
}

fn of_contact(contact: &mut Contact) -> Vec<LabelRow<'_>> {
    let Contact { object, radius, rim, friction, kinetic, fixed, restitution, .. } = contact;
    let coefficients = [friction, kinetic, fixed].into_iter().flatten();
    let coefficients = coefficients.map(|value| (value, PLAIN, "a coefficient of friction"));
    let radius = radius.iter_mut().map(|value| (value, LENGTH, "the radius of a contact"));
    let rim = rim.iter_mut().map(|value| (value, LENGTH, "the radius of a rim"));
    let restitution = restitution.iter_mut().map(|value| (value, PLAIN, "a coefficient of restitution"));
    let turning = [
        (&mut contact.rolling, LENGTH, "a coefficient of rolling friction"),
        (&mut contact.spinning, LENGTH, "a coefficient of spinning friction"),
    ];
    let turning =
        turning.into_iter().filter_map(|(value, powers, what)| Some((value.as_mut()?, powers, what)));
    let object = [(object, LENGTH, "a point of a contact")];
    object
        .into_iter()
        .chain(radius)
        .chain(rim)
        .chain(coefficients)
        .chain(restitution)
        .chain(turning)
        .chain(of_compliance(&mut contact.compliance))
        .collect()
}

fn of_compliance(compliance: &mut Compliance) -> impl Iterator<Item = LabelRow<'_>> {
    let rows = [
        (&mut compliance.stiffness, STIFFNESS, "the stiffness of a contact"),
        (&mut compliance.penetration, LENGTH, "the penetration of a contact"),
        (&mut compliance.load, FORCE, "the load of a contact"),
        (&mut compliance.dissipation, PER_SPEED, "the dissipation of a contact"),
        (&mut compliance.stiction, SPEED, "the stiction speed of a contact"),
        (&mut compliance.stiction_rate, RATE, "the angular stiction speed of a contact"),
    ];
    rows.into_iter().filter_map(|(value, powers, what)| Some((value.as_mut()?, powers, what)))
}

fn of_connector(connector: &mut Connector) -> Vec<LabelRow<'_>> {
    let Connector { kind, from, to, stiffness, rest, damping, .. } = connector;
    let is_straight = matches!(kind, ConnectorKind::Spring | ConnectorKind::Damper);
    let rows = if is_straight {
        [
            (from, LENGTH, "an end of it"),
            (to, LENGTH, "an end of it"),
            (stiffness, STIFFNESS, "the stiffness of a spring"),
            (rest, LENGTH, "the length of a spring at rest"),
            (damping, DAMPING, "the damping of a damper"),
        ]
    } else {
        [
            (from, PLAIN, "an end of it"),
            (to, PLAIN, "an end of it"),
            (stiffness, TORSION, "the stiffness of a torsion spring"),
            (rest, PLAIN, "the angle of a torsion spring at rest"),
            (damping, TORSION_DAMPING, "the damping of a torsion damper"),
        ]
    };
    rows.into_iter().filter_map(|(value, powers, what)| Some((value.as_mut()?, powers, what))).collect()
}

fn of_mobilizer(joint: &mut Mobilizer) -> Vec<LabelRow<'_>> {
    let Mobilizer { kind, at, turned, pitch, damping, .. } = joint;
    let resistance = match kind.motions() {
        [ElementaryMotion::Slide(_)] => DAMPING,
        _ => TORSION_DAMPING,
    };
    let rows = [
        (at, LENGTH, "the position of a joint"),
        (turned, PLAIN, "an angle of a joint"),
        (pitch, LENGTH, "the pitch of a screw"),
        (damping, resistance, "the damping of a joint"),
    ];
    rows.into_iter().filter_map(|(value, powers, what)| Some((value.as_mut()?, powers, what))).collect()
}
