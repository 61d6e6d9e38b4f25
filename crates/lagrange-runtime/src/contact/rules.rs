//! Rules of modes.

use core::array;

use super::choice::{Choice, Rule, Settled};
use super::reaction_forces::Balance;
use super::slip::is_planar;
use super::{Contact, Friction, Mode, Terms};
use crate::scalar::Scalar;

/// The rules of modes.
pub(super) enum Rules<S, const K: usize> {
    /// The rules follow from the modes.
    Known([Rule<S>; K]),
    /// Friction in a plane gives way, in directions that are found together with the forces.
    Found(Settled<S, K>),
}

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Returns the rules of these modes. `None` if a rate is not finite, or if no forces fit
    /// friction that gives way in a plane.
    pub(super) fn rules(&self, modes: &[Mode; K]) -> Option<Rules<S, K>> {
        if !self.rates.iter().all(|rate| rate.is_finite()) {
            return None;
        }
        let rules = array::from_fn(|k| self.rule(modes, k));
        if !modes.iter().any(|mode| matches!(mode, Mode::Friction(Friction::GivesWay(_)))) {
            return Some(Rules::Known(rules));
        }
        let choices = array::from_fn(|k| match modes[k] {
            Mode::Friction(Friction::GivesWay(_)) => Choice::GiveWay,
            Mode::Across(Friction::GivesWay(_)) => Choice::Across,
            _ => Choice::Only(rules[k]),
        });
        Balance::of_forces(self).in_cone(&choices).map(Rules::Found)
    }

    fn rule(&self, modes: &[Mode; K], k: usize) -> Rule<S> {
        match modes[k] {
            Mode::Contact(Contact::Open) => Rule::Absent,
            Mode::Contact(Contact::Closed)
            | Mode::Friction(Friction::Sticks)
            | Mode::Across(Friction::Sticks) => Rule::Holds,
            Mode::Friction(Friction::GivesWay(_)) | Mode::Across(Friction::GivesWay(_)) => Rule::Absent,
            Mode::Friction(friction) => Rule::slipping(self.direction(k, is_planar(modes, k), friction))[0],
            Mode::Across(friction) => Rule::slipping(self.direction(k - 1, true, friction))[1],
            Mode::Smooth => Rule::Smooth,
        }
    }
}
