//! Contacts with a stiffness: forces that are continuous in the state.
//!
//! At the gap g the depth is δ = max(0, −g). The normal force of Hunt and Crossley is N = k δ
//! max(0, 1 + d δ̇). Its elastic part k δ follows from the potential ½ k δ². The rest, k δ max(d
//! δ̇, −1), acts along ġ, by virtual work on the body and on the carrier of the surface. Since δ̇
//! is zero where the gap is open, its kink is only crossed by a body pulled out faster than the
//! contact springs back.
//!
//! Friction is −μ N s / √(|s|² + v²) against the slip velocity s, in space in both directions. A
//! body that Coulomb's law would hold with the force f creeps at the velocity v f / √((μ N)² − f²).
//! Moments against rolling and spinning are of the same form, with angular velocities.
//!
//! For k = 1000 N/m, d = 0.5 s/m, δ = 0.01 m and δ̇ = 0.2 m/s the normal force is 11 N.
//!
//! Sources: Hunt, Crossley, *Coefficient of restitution interpreted as damping in vibroimpact*,
//! Journal of Applied Mechanics 42 (1975); Wriggers, *Computational Contact Mechanics*, 2nd ed.,
//! §5.2.3, for the square root.

use super::coefficients::ComplianceCoefficients;
use crate::bodies::plain::Obligation;
use crate::bodies::terms::TermWriter;
use crate::bodies::translation::Translation;
use crate::syntax::ast::{self, AstId, Name, StatementKind};

/// Adds the normal force under the name of the contact.
pub(super) fn press(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    gap: AstId,
    compliance: &ComplianceCoefficients,
) {
    let name = &statement.name;
    let &ComplianceCoefficients { stiffness, dissipation, .. } = compliance;
    translation.obligations.push(Obligation::Opens { contact: name.clone(), gap });
    let mut terms = translation.terms();
    let (depth, nothing) = (terms.negative(gap), terms.number(0));
    let depth = terms.if_positive(depth, depth, nothing);
    let depth = translation.bind(&format!("{}_depth", name.text), depth);
    let mut terms = translation.terms();
    let (half, square) = (terms.half(), terms.square(depth));
    let weight = terms.times(half, stiffness);
    let energy = terms.times(weight, square);
    let elastic = terms.times(stiffness, depth);
    translation.push(StatementKind::Potential(energy));
    let normal = match dissipation {
        Some(dissipation) => dissipate(translation, statement, (gap, depth, elastic), dissipation),
        None => elastic,
    };
    translation.optional.insert(name.text.clone());
    translation.push(StatementKind::Let(name.clone(), normal));
}

/// Adds the dissipative part of the normal force; returns the whole force.
fn dissipate(
    translation: &mut Translation<'_>,
    statement: &ast::Contact,
    (gap, depth, elastic): (AstId, AstId, AstId),
    dissipation: AstId,
) -> AstId {
    let mut terms = translation.terms();
    let rate = terms.rate(depth);
    let (share, least) = (terms.times(dissipation, rate), terms.number(-1));
    let share = terms.call("max", &[share, least]);
    let force = terms.times(elastic, share);
    let force = translation.bind(&format!("{}_dissipation", statement.name.text), force);
    let velocity = translation.terms().rate(gap);
    translation.push(StatementKind::ForceAlong { force, velocity });
    translation.terms().plus(elastic, force)
}

/// Adds a friction against a slip velocity or an angular velocity, which is a scalar or a pair.
pub(super) fn rub_smoothly(
    translation: &mut Translation<'_>,
    friction: &Name,
    (slip, is_pair): (AstId, bool),
    (limit, stiction): (AstId, AstId),
) {
    let mut terms = translation.terms();
    let slips = if is_pair { terms.pair(slip).to_vec() } else { vec![slip] };
    let grip = over_speed(&mut terms, limit, [&slips[..], &[stiction]].concat());
    let grip = translation.bind(&format!("{}_grip", friction.text), grip);
    let mut terms = translation.terms();
    let mut forces = Vec::new();
    for slip in slips {
        let against = terms.times(grip, slip);
        forces.push(terms.negative(against));
    }
    let force = if is_pair { terms.vector(&forces) } else { forces[0] };
    translation.push(StatementKind::Let(friction.clone(), force));
    let force = translation.terms().name(&friction.text);
    translation.push(StatementKind::ForceAlong { force, velocity: slip });
}

/// Divides a force by the length of a vector of speeds.
fn over_speed(terms: &mut TermWriter<'_>, force: AstId, speeds: Vec<AstId>) -> AstId {
    let squares = speeds.into_iter().map(|speed| terms.square(speed)).collect::<Vec<_>>();
    let zero = terms.number(0);
    let sum = squares.into_iter().fold(zero, |sum, square| terms.plus(sum, square));
    let length = terms.call("sqrt", &[sum]);
    terms.divide(force, length)
}
