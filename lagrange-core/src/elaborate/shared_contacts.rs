//! Two friction statements at one contact.
//!
//! Each direction has its own limit, so the forces of both fill a rectangle instead of the disk of
//! friction in a plane.

use super::elaborator::Elaborator;
use super::messages::events as messages;
use crate::model::ReactionKind;
use lagrange_algebra::calculus::gradient;
use lagrange_expr::expr::{Dependencies, ExprId, Node};
use lagrange_expr::symbol::Role;

/// Returns the index of the contact whose force this is.
pub(super) fn contact_of(elaborator: &Elaborator<'_>, force: ExprId) -> Option<usize> {
    let is_force = |kind: &ReactionKind| matches!(kind, ReactionKind::Contact { .. });
    elaborator.reactions.iter().position(|(reaction, _)| reaction.symbol == force && is_force(&reaction.kind))
}

/// Warns if the last friction acts at the same contact as an earlier one, along another direction.
pub(super) fn warn_of_square(elaborator: &mut Elaborator<'_>) {
    let last = elaborator.reactions.len().saturating_sub(1);
    // Friction in a plane is a cone already: another one at its contact acts on a rotation.
    if is_across(elaborator, last) {
        return;
    }
    let contacts = contacts(elaborator, last);
    let shares = |elaborator: &Elaborator<'_>, other: usize| {
        self::contacts(elaborator, other).into_iter().find(|contact| contacts.contains(contact))
    };
    let is_single =
        |other: &usize| ![*other, other + 1].into_iter().any(|index| is_across(elaborator, index));
    let singles = (0..last).filter(is_single).collect::<Vec<_>>();
    for other in singles {
        if let Some(contact) = shares(elaborator, other)
            && !are_parallel(elaborator, [other, last])
        {
            let [first, second, contact] =
                [other, last, contact].map(|index| elaborator.reactions[index].0.name.clone());
            let [place, earlier] = [last, other].map(|index| elaborator.reactions[index].1);
            let message = messages::square_of_friction(&first, &second, &contact);
            let warning = elaborator.evaluator.report.doubtful(place, message);
            warning.related(earlier.into(), messages::FRICTION_IS_HERE).help(messages::SQUARE_HELP);
            return;
        }
    }
}

/// True if this reaction is the second component of friction in a plane.
fn is_across(elaborator: &Elaborator<'_>, index: usize) -> bool {
    let reaction = elaborator.reactions.get(index);
    reaction.is_some_and(|(reaction, _)| matches!(reaction.kind, ReactionKind::Across { .. }))
}

/// Returns the contacts on whose forces the limits of a friction depend.
fn contacts(elaborator: &Elaborator<'_>, index: usize) -> Vec<usize> {
    let limits = match elaborator.reactions[index].0.kind {
        ReactionKind::Contact { .. } => return Vec::new(),
        ReactionKind::Friction { kinetic, fixed } | ReactionKind::Across { kinetic, fixed } => {
            vec![kinetic, fixed]
        }
        ReactionKind::Smooth { limit, .. } => vec![limit],
    };
    let graph = &elaborator.evaluator.graph;
    let is_free = |id: ExprId| !graph.dependencies(id).intersects(Dependencies::REACTION);
    let parts = graph.reachable_until(&limits, is_free);
    parts.into_iter().filter_map(|part| contact_of(elaborator, part)).collect()
}

/// True if both slip velocities are multiples of each other, apart from the motion of the surface.
fn are_parallel(elaborator: &mut Elaborator<'_>, pair: [usize; 2]) -> bool {
    let slips = pair.map(|index| elaborator.reactions[index].0.velocity);
    let graph = &mut elaborator.evaluator.graph;
    let is_velocity = |id: &ExprId| match graph.node(*id) {
        Node::Symbol(symbol) => matches!(graph.symbols().get(*symbol).role, Role::Velocity(_)),
        _ => false,
    };
    let velocities = graph.reachable(&slips).into_iter().filter(is_velocity).collect::<Vec<_>>();
    let [one, other] = slips.map(|slip| gradient(graph, slip, &velocities));
    (0..velocities.len()).all(|i| {
        (0..i).all(|j| {
            let [along, across] = [(i, j), (j, i)].map(|(i, j)| graph.multiply(one[i], other[j]));
            along == across
        })
    })
}
