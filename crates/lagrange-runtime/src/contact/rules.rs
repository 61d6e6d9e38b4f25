//! Rules of modes, and the reactions under them.

use core::array;

use super::choice::{Choice, Rule};
use super::reaction_forces::Balance;
use super::slip::is_planar;
use super::{Contact, Friction, Mode, Terms};
use crate::scalar::Scalar;

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// The rules of these modes; none if a rate is not finite, or if friction that gives way has no
    /// direction.
    pub(super) fn rules(&self, modes: &[Mode; K]) -> Option<[Rule<S>; K]> {
        if !self.rates.iter().all(|rate| rate.is_finite()) {
            return None;
        }
        let rules = array::from_fn(|k| self.rule(modes, k));
        if !modes.contains(&Mode::Friction(Friction::GivesWay)) {
            return Some(rules);
        }
        let choices = array::from_fn(|k| match modes[k] {
            Mode::Friction(Friction::GivesWay) => Choice::GiveWay,
            Mode::Across(Friction::GivesWay) => Choice::Across,
            _ => Choice::Only(rules[k]),
        });
        Some(Balance::of_forces(self).in_plane(&choices)?.rules)
    }

    fn rule(&self, modes: &[Mode; K], k: usize) -> Rule<S> {
        match modes[k] {
            Mode::Contact(Contact::Open) => Rule::Absent,
            Mode::Contact(Contact::Closed)
            | Mode::Friction(Friction::Sticks)
            | Mode::Across(Friction::Sticks) => Rule::Holds,
            Mode::Friction(Friction::GivesWay) | Mode::Across(Friction::GivesWay) => Rule::Absent,
            Mode::Friction(friction) => Rule::slipping(self.direction(k, is_planar(modes, k), friction))[0],
            Mode::Across(friction) => Rule::slipping(self.direction(k - 1, true, friction))[1],
            Mode::Smooth => Rule::Smooth,
        }
    }
}

/// Computes the reactions of a system in these modes. Open contacts have none. The forces of closed
/// contacts and sticking friction keep gaps closed and slip velocities zero. Slipping friction is
/// at its kinetic limit against the slip. NaN if there are no such reactions.
///
/// If the motion does not determine reactions, as those of a table on four legs, the shortest are
/// taken. Each is measured in the unit in which it changes its own rate.
pub fn reactions<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    modes: &[Mode; K],
) -> [S; K] {
    let Some(rules) = terms.rules(modes) else { return [S::NAN; K] };
    if rules.iter().all(|rule| *rule == Rule::Absent) {
        return [S::ZERO; K];
    }
    Balance::of_active(terms, &rules).reactions(&rules)
}
