//! Coordinates, orientations and velocities: the components of the state.

use super::elaborator::Elaborator;
use super::expression::value_of;
use super::messages::{self, names};
use super::operand::Operand;
use super::scope::NameKind;
use crate::model::{Coordinate, EntryLimits, Orientation, Speed};
use lagrange_expr::expr::ExprId;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Name, Quaternion};

/// Components of a quaternion, the scalar part first, that enter each rate, with the factors among
/// the components of the angular velocity, and signs. They represent q̇ = ½ q ⊗ (0, ω) for ω in the
/// turned axes (Featherstone, *Rigid Body Dynamics Algorithms*, §4.5).
const QUATERNION_RATES: [[(usize, usize, i64); 3]; 4] = [
    [(1, 0, -1), (2, 1, -1), (3, 2, -1)],
    [(0, 0, 1), (2, 2, 1), (3, 1, -1)],
    [(0, 1, 1), (3, 0, 1), (1, 2, -1)],
    [(0, 2, 1), (1, 1, 1), (2, 0, -1)],
];

pub(super) fn define_coordinate(elaborator: &mut Elaborator<'_>, name: &Name) {
    let index = elaborator.coordinates.len();
    let speed = match elaborator.named_velocities.get(&name.text) {
        Some(speed) => (speed.text.clone(), 0),
        None => (name.text.clone(), 1),
    };
    let velocity = define_speed(elaborator, name, Some(index), speed);
    let position = elaborator.evaluator.graph.symbol(&name.text, Role::Coordinate(index as u32));
    define_position(elaborator, name, position, velocity);
}

/// Defines a unit quaternion of positions, with three velocities.
pub(super) fn define_quaternion(elaborator: &mut Elaborator<'_>, quaternion: &Quaternion) {
    if is_declared_before(elaborator, quaternion) {
        return;
    }
    let orientation =
        Orientation { position: elaborator.coordinates.len(), velocity: elaborator.speeds.len() };
    let graph = &mut elaborator.evaluator.graph;
    let symbol = |(index, name): (usize, &Name)| {
        graph.symbol(&name.text, Role::Coordinate((orientation.position + index) as u32))
    };
    let positions = quaternion.positions.iter().enumerate().map(symbol).collect::<Vec<_>>();
    let velocities = quaternion.velocities.each_ref().map(|name| {
        let velocity = define_speed(elaborator, name, None, (name.text.clone(), 0));
        elaborator.declare(name, NameKind::Velocity, Some(Operand::Scalar(velocity)));
        velocity
    });
    for ((name, &position), products) in quaternion.positions.iter().zip(&positions).zip(QUATERNION_RATES) {
        let graph = &mut elaborator.evaluator.graph;
        let half = |sign: i64| &Number::HALF * &Number::from(sign);
        let terms = products.map(|(q, w, sign)| (graph.multiply(positions[q], velocities[w]), half(sign)));
        let rate = graph.sum(Number::ZERO, terms);
        define_position(elaborator, name, position, rate);
    }
    elaborator.orientations.push(orientation);
}

/// True for a second orientation of the same name, which is reported once.
fn is_declared_before(elaborator: &mut Elaborator<'_>, quaternion: &Quaternion) -> bool {
    let first = elaborator.evaluator.scope.find(&quaternion.positions[0].text);
    let is_quaternion = elaborator.evaluator.scope.is_velocity(&quaternion.velocities[0].text);
    let Some(first) = first.filter(|_| is_quaternion).map(|entry| entry.span) else { return false };
    let name = &quaternion.name;
    let report = &mut *elaborator.evaluator.report;
    let error = report.error(name.span, names::declared_twice(&name.text)).help(messages::OTHER_NAME_HELP);
    error.related(first.into(), names::first_declared(&name.text, "orientation"));
    true
}

/// Adds a position, whose symbol already exists, with its rate.
fn define_position(elaborator: &mut Elaborator<'_>, name: &Name, position: ExprId, rate: ExprId) {
    elaborator.evaluator.graph.set_rate(position, rate);
    let limits = EntryLimits::default();
    let coordinate = Coordinate { name: name.text.clone(), position, rate, is_state: false, limits };
    elaborator.coordinates.push((coordinate, name.span));
    elaborator.declare(name, NameKind::Coordinate, Some(Operand::Scalar(position)));
}

/// Adds a velocity, given by its base name and the number of dots.
fn define_speed(
    elaborator: &mut Elaborator<'_>,
    place: &Name,
    coordinate: Option<usize>,
    (name, dots): (String, u8),
) -> ExprId {
    let index = elaborator.speeds.len() as u32;
    let graph = &mut elaborator.evaluator.graph;
    let velocity = graph.dotted_symbol(&name, Role::Velocity(index), dots);
    let acceleration = graph.dotted_symbol(&name, Role::Acceleration(index), dots + 1);
    let name = if dots == 0 { name } else { format!("{name}_dot") };
    let limits = EntryLimits::default();
    elaborator.speeds.push((Speed { name, coordinate, velocity, acceleration, limits }, place.span));
    velocity
}

/// Handles `velocity u = dot(x);`, which names the rate of a coordinate.
pub(super) fn name_velocity(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId) {
    let value = value_of(&mut elaborator.evaluator, syntax);
    let named = elaborator.declaration.expressions.rate_of_name(syntax);
    let coordinate =
        named.and_then(|named| elaborator.coordinates.iter().find(|(known, _)| known.name == named));
    let rate = coordinate.map(|(coordinate, _)| coordinate.rate);
    let is_named = rate.is_some_and(|rate| {
        elaborator.speeds.iter().any(|(speed, _)| speed.velocity == rate && speed.name == name.text)
    });
    if value.is_some() && !is_named {
        let origin = elaborator.evaluator.origin(syntax);
        elaborator.evaluator.report.error(origin, names::NO_RATE_TO_NAME).help(names::VELOCITY_HELP);
    }
    elaborator.declare(name, NameKind::Velocity, rate.map(Operand::Scalar));
}
