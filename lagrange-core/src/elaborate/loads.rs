//! Forces and torques as loads along velocities, by virtual work.
//!
//! A force F at a point p does work at the rate F·ṗ. Its generalised force is ∂(F·ṗ)/∂v. The load
//! therefore acts on the node ṗ itself, and no Jacobian is formed.

use proc_macro2::Span;

use super::elaborator::Elaborator;
use super::expression::value_of;
use super::messages;
use super::operand::Operand;
use crate::model::Load;
use lagrange_algebra::calculus::{Degree, Degrees};
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_language::syntax::ast::{AstId, Expression, Name};

pub(super) fn add_force_on(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId) {
    elaborator.evaluator.scope.resolve(&name.text);
    let Some(index) = elaborator.speed_of(&name.text) else {
        // No scalar is required here, so that a vector on a body is reported only once.
        value_of(&mut elaborator.evaluator, syntax);
        return elaborator.report_no_coordinate(name, messages::FORCE_HELP);
    };
    let velocity = elaborator.speeds[index].0.velocity;
    let force = elaborator.term(syntax, name.span, "a force");
    push_loads(elaborator, &name.text, force.map(|force| (velocity, force.value)));
}

/// Adds the loads of one statement under a unique name.
fn push_loads(
    elaborator: &mut Elaborator<'_>,
    name: &str,
    loads: impl IntoIterator<Item = (ExprId, ExprId)>,
) {
    let is_free = |name: &String| elaborator.loads.iter().all(|load| load.name != *name);
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    let name = std::iter::once(name.to_owned()).chain(numbered).find(is_free).unwrap_or_default();
    elaborator.load_statements.push((name.clone(), elaborator.evaluator.unresolved.statement));
    let load = |(velocity, force)| Load { name: name.clone(), velocity, force };
    elaborator.loads.extend(loads.into_iter().map(load));
}

/// Returns the user's name for the object of a load, or else the name of its kind.
fn name_of(elaborator: &Elaborator<'_>, acted_on: AstId, kind: &str) -> String {
    match elaborator.evaluator.syntax(acted_on) {
        Expression::Name(name) if elaborator.declaration.expressions.is_written(acted_on) => name.clone(),
        _ => kind.to_owned(),
    }
}

pub(super) fn add_force_at(elaborator: &mut Elaborator<'_>, force: AstId, point: AstId) {
    let values = (value_of(&mut elaborator.evaluator, force), value_of(&mut elaborator.evaluator, point));
    let components = elaborator.evaluator.vector(force, "a force at a point");
    let place = elaborator.evaluator.vector(point, "the point of a force");
    let (Some(force_value), Some(point_value)) = values else { return };
    let (Some(components), Some(_)) = (components, place) else { return };
    if !force_value.same_kind(&point_value) {
        let message = messages::kinds_differ("pair", force_value.kind(), point_value.kind());
        elaborator.evaluator.refuse::<()>(point, message, messages::KINDS_HELP);
        return;
    }
    let sound = components.iter().all(|&c| elaborator.forbid_accelerations(force, c, "a force").is_some());
    let velocity = velocity_of(elaborator, point, &point_value, "the point of a force");
    if let (true, Some(velocity)) = (sound, velocity) {
        let name = name_of(elaborator, point, "force");
        push_loads(elaborator, &name, velocity.components().iter().copied().zip(components));
    }
}

/// Adds a force along velocities, which does work at the rate F·u.
pub(super) fn add_force_along(elaborator: &mut Elaborator<'_>, force: AstId, velocity: AstId) {
    let values = [force, velocity].map(|syntax| value_of(&mut elaborator.evaluator, syntax));
    let [Some(forces), Some(velocities)] = values else { return };
    if !forces.same_kind(&velocities) {
        let message = messages::kinds_differ("pair", forces.kind(), velocities.kind());
        elaborator.evaluator.refuse::<()>(velocity, message, messages::KINDS_HELP);
        return;
    }
    let mut loads = Vec::new();
    for (&force_value, &along) in forces.components().iter().zip(velocities.components()) {
        let is_sound = elaborator.forbid_accelerations(force, force_value, "a force").is_some();
        if is_sound && is_affine_in_velocities(elaborator, velocity, along) {
            loads.push((along, force_value));
        }
    }
    // Contact forces have names; their velocities do not occur in the source.
    let kind = match elaborator.evaluator.syntax(force) {
        Expression::Name(name) if !elaborator.declaration.expressions.is_written(force) => name.clone(),
        _ => "force".to_owned(),
    };
    let name = name_of(elaborator, velocity, &kind);
    push_loads(elaborator, &name, loads);
}

/// Reports a place or a velocity that depends on states, since virtual displacements do not change
/// states.
pub(super) fn forbid_states(
    elaborator: &mut Elaborator<'_>,
    syntax: AstId,
    value: ExprId,
    what: &str,
) -> Option<()> {
    elaborator.forbid(&[Dependencies::STATE], (syntax, value), what, messages::states::PLACE_HELP)
}

/// Reports velocities of forces that are not affine in the velocities.
fn is_affine_in_velocities(elaborator: &mut Elaborator<'_>, syntax: AstId, value: ExprId) -> bool {
    let what = "the velocity of a force";
    let known = elaborator.forbid_accelerations(syntax, value, what);
    let known = known.and_then(|()| forbid_states(elaborator, syntax, value, what));
    let mut degrees = Degrees::default();
    degrees.classify(&elaborator.evaluator.graph, &[value]);
    let degree = degrees.of(&elaborator.evaluator.graph, value);
    if known.is_some() && degree == Degree::Nonlinear {
        let origin = elaborator.evaluator.origin(syntax);
        let error = elaborator.evaluator.report.error(origin, messages::NO_VELOCITY);
        error.help(messages::NO_VELOCITY_HELP);
    }
    // A force without motion does no work.
    known.is_some() && degree == Degree::Affine
}

pub(super) fn add_torque(elaborator: &mut Elaborator<'_>, moment: AstId, angle: AstId, keyword: Span) {
    let moment = elaborator.term(moment, keyword, "a torque");
    value_of(&mut elaborator.evaluator, angle);
    let Some(value) = elaborator.evaluator.scalar(angle, "the angle of a torque") else { return };
    let velocity = velocity_of(elaborator, angle, &Operand::Scalar(value), "the angle of a torque");
    if let (Some(moment), Some(Operand::Scalar(velocity))) = (moment, velocity) {
        let name = name_of(elaborator, angle, "torque");
        push_loads(elaborator, &name, [(velocity, moment.value)]);
    }
}

/// Returns the rate of a point or angle, which must be a function of coordinates and time.
fn velocity_of(
    elaborator: &mut Elaborator<'_>,
    syntax: AstId,
    value: &Operand,
    what: &str,
) -> Option<Operand> {
    for &component in value.components() {
        let moving = &[Dependencies::VELOCITY, Dependencies::ACCELERATION];
        elaborator.forbid(moving, (syntax, component), what, messages::PLACE_HELP)?;
        forbid_states(elaborator, syntax, component, what)?;
    }
    elaborator.evaluator.rate(value, syntax)
}
