//! Contacts, which are events with an impact, and `friction` statements.
//!
//! Each acts along the gradient of a velocity that is affine in q̇: the rate of its gap, or its
//! slip velocity.

use super::elaborator::{Elaborator, UNKNOWNS};
use super::expression::value_of;
use super::loads::forbid_states;
use super::messages::events as messages;
use super::operand::Operand;
use super::scope::NameKind;
use super::shared_contacts::{contact_of, warn_of_square};
use crate::model::{Action, Bound, Reaction, ReactionKind};
use lagrange_algebra::calculus::{Degree, Degrees};
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{self, AstId, Direction, Name};

/// Adds the contact of `event name = gap, falling => impact(e);`.
pub(super) fn add_contact(elaborator: &mut Elaborator<'_>, event: &ast::Event, restitution: AstId) {
    let gap = gap_and_rate(elaborator, event);
    let restitution = sound_restitution(elaborator, restitution, &event.name);
    if let Some(restitution) = restitution {
        let bound = |bound: i64| {
            let value = elaborator.evaluator.graph.number(bound);
            Some(Bound { value, is_included: true })
        };
        let range = [0, 1].map(bound);
        elaborator.bound_quantity(&event.name, messages::RESTITUTION_OF_CONTACT, restitution, range);
    }
    let parts = gap.and_then(|(gap, velocity)| {
        Some((velocity, ReactionKind::Contact { gap, restitution: restitution? }))
    });
    let index = elaborator.reactions.len() as u32;
    if add_reaction(elaborator, &event.name, NameKind::Contact, parts)
        && let Some(Operand::Scalar(value)) = elaborator.evaluator.value(event.value)
    {
        elaborator.push_event(event, value, Action::Impact(index));
    }
}

/// Adds `friction name = slip, limit;`, with two slip velocities for friction in a plane.
pub(super) fn add_friction(elaborator: &mut Elaborator<'_>, friction: &ast::Friction) {
    let name = &friction.name;
    let slips = slip_velocities(elaborator, friction);
    let kinetic = friction_limit(elaborator, name, friction.kinetic);
    let fixed = match friction.fixed {
        Some(fixed) => friction_limit(elaborator, name, fixed),
        None => kinetic,
    };
    let width = friction.width.map(|width| friction_width(elaborator, width));
    let kind = match width {
        Some(width) => kinetic.zip(width).map(|(limit, width)| ReactionKind::Smooth { limit, width }),
        None => kinetic.zip(fixed).map(|(kinetic, fixed)| ReactionKind::Friction { kinetic, fixed }),
    };
    if let (Some(ReactionKind::Friction { kinetic, fixed }), Some(syntax)) = (kind, friction.fixed) {
        check_order(elaborator, kinetic, fixed, syntax);
    }
    let added = match (slips.as_deref(), kind) {
        (Some(&[slip]), Some(kind)) => add_reaction(elaborator, name, NameKind::Friction, Some((slip, kind))),
        (Some(&[first, second]), Some(ReactionKind::Friction { kinetic, fixed })) => {
            add_plane(elaborator, name, [first, second], [kinetic, fixed]);
            true
        }
        _ => add_reaction(elaborator, name, NameKind::Friction, None),
    };
    if added && !friction.is_moment {
        warn_of_square(elaborator);
    }
}

/// Declares friction in a plane; its name stands for the force vector.
fn add_plane(elaborator: &mut Elaborator<'_>, name: &Name, slips: [ExprId; 2], limits: [ExprId; 2]) {
    let [kinetic, fixed] = limits;
    let kinds = [ReactionKind::Friction { kinetic, fixed }, ReactionKind::Across { kinetic, fixed }];
    let mut force = Vec::new();
    for ((velocity, kind), axis) in slips.into_iter().zip(kinds).zip(["x", "y"]) {
        force.push(push_reaction(elaborator, format!("{}_{axis}", name.text), name, (velocity, kind)));
    }
    elaborator.declare(name, NameKind::Friction, Some(Operand::Vector(force)));
}

/// Declares a reaction, whose name stands for its force; false if its parts are invalid.
fn add_reaction(
    elaborator: &mut Elaborator<'_>,
    name: &Name,
    kind: NameKind,
    parts: Option<(ExprId, ReactionKind)>,
) -> bool {
    let Some(parts) = parts else {
        elaborator.declare(name, kind, None);
        return false;
    };
    let symbol = push_reaction(elaborator, name.text.clone(), name, parts);
    elaborator.declare(name, kind, Some(Operand::Scalar(symbol)));
    true
}

/// Adds a reaction and returns the symbol of its force.
fn push_reaction(
    elaborator: &mut Elaborator<'_>,
    written: String,
    name: &Name,
    (velocity, kind): (ExprId, ReactionKind),
) -> ExprId {
    let role = Role::Reaction(elaborator.reactions.len() as u32);
    let symbol = elaborator.evaluator.graph.symbol(&written, role);
    elaborator.reactions.push((Reaction { name: written, symbol, velocity, kind }, name.span));
    symbol
}

/// Returns a function that is positive where bodies are apart, and its rate.
fn gap_and_rate(elaborator: &mut Elaborator<'_>, event: &ast::Event) -> Option<(ExprId, ExprId)> {
    if event.direction == Direction::Crossing {
        let error = elaborator.evaluator.report.error(event.direction_span, messages::CROSSING_IMPACT);
        error.help(messages::CROSSING_IMPACT_HELP);
    }
    let syntax = event.value;
    value_of(&mut elaborator.evaluator, syntax)?;
    let value = elaborator.evaluator.scalar(syntax, messages::GAP)?;
    let kinds = [&[Dependencies::VELOCITY], UNKNOWNS].concat();
    elaborator.forbid(&kinds, (syntax, value), messages::GAP, messages::GAP_HELP)?;
    forbid_states(elaborator, syntax, value, messages::GAP)?;
    if !elaborator.evaluator.graph.dependencies(value).intersects(Dependencies::COORDINATE) {
        let message = messages::gap_without_coordinate(&event.name.text);
        return elaborator.evaluator.refuse(syntax, message, messages::GAP_HELP);
    }
    let gap = match event.direction {
        Direction::Rising => elaborator.evaluator.graph.negate(value),
        Direction::Falling => value,
        Direction::Crossing => return None,
    };
    match elaborator.evaluator.rate(&Operand::Scalar(gap), syntax)? {
        Operand::Scalar(velocity) => Some((gap, velocity)),
        Operand::Vector(_) | Operand::Matrix(..) => None,
    }
}

fn sound_restitution(elaborator: &mut Elaborator<'_>, syntax: AstId, event: &Name) -> Option<ExprId> {
    let value = elaborator.term(syntax, event.span, messages::RESTITUTION)?.value;
    match elaborator.numeric(value).filter(|number| !(0.0..=1.0).contains(number)) {
        None => Some(value),
        Some(number) => elaborator.evaluator.refuse(
            syntax,
            messages::restitution_out_of_range(number),
            messages::RESTITUTION_HELP,
        ),
    }
}

/// Returns the slip velocity, or both slip velocities of friction in a plane.
fn slip_velocities(elaborator: &mut Elaborator<'_>, friction: &ast::Friction) -> Option<Vec<ExprId>> {
    let (name, syntax) = (&friction.name.text, friction.slip);
    let slip = value_of(&mut elaborator.evaluator, syntax)?;
    let components = slip.components();
    let count = components.len();
    let evaluator = &mut elaborator.evaluator;
    match count {
        1 => {}
        2 if friction.width.is_none() => {}
        2 => return evaluator.refuse(syntax, messages::smooth_plane(name), messages::SMOOTH_PLANE_HELP),
        _ => {
            let message = messages::slip_of_components(name, count);
            return evaluator.refuse(syntax, message, messages::SLIP_OF_COMPONENTS_HELP);
        }
    }
    // Bodies may be unable to slip along one of the two axes, such as links that move in a plane.
    let zero = evaluator.graph.number(0);
    let is_still = components.iter().all(|&velocity| velocity == zero);
    for &velocity in components.iter().filter(|&&velocity| is_still || velocity != zero) {
        check_slip(elaborator, name, (syntax, velocity))?;
    }
    // Sticking preserves the slip velocity, so its rate must be known.
    if friction.width.is_none() {
        elaborator.evaluator.rate(&slip, syntax)?;
    }
    Some(components.to_vec())
}

fn check_slip(
    elaborator: &mut Elaborator<'_>,
    name: &str,
    (syntax, velocity): (AstId, ExprId),
) -> Option<()> {
    elaborator.forbid_accelerations(syntax, velocity, messages::SLIP)?;
    let evaluator = &mut elaborator.evaluator;
    if !evaluator.graph.dependencies(velocity).intersects(Dependencies::VELOCITY) {
        return evaluator.refuse(syntax, messages::slip_without_velocity(name), messages::SLIP_HELP);
    }
    if degree_in(elaborator, velocity, Dependencies::VELOCITY) == Degree::Nonlinear {
        return elaborator.evaluator.refuse(syntax, messages::nonlinear_slip(name), messages::SLIP_HELP);
    }
    forbid_states(elaborator, syntax, velocity, messages::SLIP)
}

fn friction_limit(elaborator: &mut Elaborator<'_>, name: &Name, syntax: AstId) -> Option<ExprId> {
    value_of(&mut elaborator.evaluator, syntax)?;
    let limit = elaborator.evaluator.scalar(syntax, messages::LIMIT)?;
    let kinds = &[Dependencies::ACCELERATION];
    elaborator.forbid(kinds, (syntax, limit), messages::LIMIT, messages::LIMIT_HELP)?;
    let forces = Dependencies::MULTIPLIER | Dependencies::REACTION;
    if degree_in(elaborator, limit, forces) == Degree::Nonlinear {
        let message = messages::nonlinear_limit(&name.text);
        return elaborator.evaluator.refuse(syntax, &message, messages::NONLINEAR_LIMIT_HELP);
    }
    // The force of a contact is never negative.
    let (share, force) = elaborator.evaluator.graph.split_coefficient(limit);
    let share = contact_of(elaborator, force).map(|_| share.to_f64());
    match elaborator.numeric(limit).or(share).filter(|&number| number < 0.0) {
        None => Some(limit),
        Some(number) => elaborator.evaluator.refuse(
            syntax,
            messages::negative_limit(number),
            messages::NEGATIVE_LIMIT_HELP,
        ),
    }
}

fn check_order(elaborator: &mut Elaborator<'_>, kinetic: ExprId, fixed: ExprId, syntax: AstId) {
    let margin = elaborator.evaluator.graph.subtract(fixed, kinetic);
    if elaborator.numeric(margin).is_some_and(|margin| margin < 0.0) {
        let origin = elaborator.evaluator.origin(syntax);
        let error = elaborator.evaluator.report.error(origin, messages::STATIC_BELOW_KINETIC);
        error.help(messages::STATIC_BELOW_KINETIC_HELP);
    }
}

fn friction_width(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<ExprId> {
    let width = elaborator.constant_in_motion(syntax, messages::WIDTH)?;
    match elaborator.numeric(width).filter(|&number| number <= 0.0) {
        None => Some(width),
        Some(number) => {
            elaborator.evaluator.refuse(syntax, messages::width_not_positive(number), messages::WIDTH_HELP)
        }
    }
}

fn degree_in(elaborator: &Elaborator<'_>, value: ExprId, kinds: Dependencies) -> Degree {
    let graph = &elaborator.evaluator.graph;
    let mut degrees = Degrees::in_terms_of(kinds);
    degrees.classify(graph, &[value]);
    degrees.of(graph, value)
}
