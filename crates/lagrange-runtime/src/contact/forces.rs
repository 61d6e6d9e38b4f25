//! Forces in the modes of a motion, their margins, and redundant supports.
//!
//! If held rates leave forces undetermined, the shortest ones may pull at one point or exceed a
//! limit of friction. Other forces may hold the same rates within all limits; those close to the
//! shortest are then used. If there are none, something gives way: its rate is nonzero under forces
//! within all limits.
//!
//! # A box on two feet in numbers
//!
//! A box of weight 10, twice as wide as high, stands on a slope of 3 in 4. Friction is 0.8 times
//! the normal force. The feet carry normal forces of 8/2 ± 6/4, which are 2.5 and 5.5, and hold 6
//! together. The shortest friction forces are 3 and 3, but the upper foot bears only 0.8·2.5 = 2.
//! The lower foot takes the other 4, within its 4.4: the box rests.

use core::array;

use super::choice::{Choice, Rule};
use super::cone::MOST_DENSE;
use super::law::ContactLaw;
use super::reaction_forces::Balance;
use super::rules::Rules;
use super::slip::{is_planar, length};
use super::{Friction, Mode, Terms};
use crate::linalg::vector::dot;
use crate::scalar::Scalar;
use crate::tolerance::{BALANCED_BY_SEARCH, BOUND};

/// Fraction of the largest possible deceleration by friction above which a slip velocity is
/// expected to stop by itself.
const STOPPING: f64 = 0.5;

/// Computes the reactions of a system in these modes. Open contacts have none. The forces of closed
/// contacts and sticking friction keep gaps closed and slip velocities zero. Slipping friction is
/// at its kinetic limit against the slip. NaN if there are no such reactions.
///
/// If the motion does not determine the reactions, as for a table on four legs, the shortest are
/// taken. Each is measured in the unit in which it changes its own rate. If the shortest pull or
/// exceed a limit, close reactions that do not are taken, if there are any. Systems of more than 64
/// reactions take reactions within all limits at once.
pub fn reactions<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    modes: &[Mode; K],
) -> [S; K] {
    if const { K > MOST_DENSE } {
        let Some(Rules::Known(rules)) = terms.rules(modes) else { return [S::NAN; K] };
        return ContactLaw::of_forces(terms)
            .near(&within_limits(modes, &rules), &[S::ZERO; K])
            .settled
            .reactions;
    }
    Forces::under(terms, modes).reactions
}

/// Returns the choices of forces that hold what these modes hold, within all limits.
fn within_limits<S: Scalar, const K: usize>(modes: &[Mode; K], rules: &[Rule<S>; K]) -> [Choice<S>; K] {
    array::from_fn(|k| match (modes[k], rules[k]) {
        (Mode::Contact(_), Rule::Holds) => Choice::Touch,
        (Mode::Friction(_), Rule::Holds) => Choice::Rest,
        (Mode::Across(_), Rule::Holds) => Choice::Across,
        (_, rule) => Choice::Only(rule),
    })
}

/// The forces of a system in some modes.
pub(super) struct Forces<'a, S, const N: usize, const K: usize> {
    pub(super) balance: Balance<'a, S, N, K>,
    /// The forces under which the motion continues.
    pub(super) reactions: [S; K],
    /// Forces within all limits, if the shortest exceed one.
    within: Option<[S; K]>,
}

impl<'a, S: Scalar, const N: usize, const K: usize> Forces<'a, S, N, K> {
    /// Computes the forces; NaN if there are none.
    pub(super) fn under(terms: &'a Terms<S, N, K>, modes: &[Mode; K]) -> Self {
        let found = terms.rules(modes);
        let rules = match &found {
            None => [Rule::Absent; K],
            Some(Rules::Known(rules)) => *rules,
            Some(Rules::Found(settled)) => settled.rules,
        };
        let balance = Balance::of_active(terms, &rules);
        let reactions = match found {
            None => [S::NAN; K],
            Some(Rules::Found(settled)) => settled.reactions,
            Some(Rules::Known(_)) if rules.iter().all(|rule| *rule == Rule::Absent) => [S::ZERO; K],
            Some(Rules::Known(_)) => balance.reactions(&rules),
        };
        let forces = Forces { balance, reactions, within: None };
        if forces.exceeds_limits(modes, &rules) { forces.within_limits(modes, &rules) } else { forces }
    }

    /// True if undetermined forces exceed one of their limits.
    fn exceeds_limits(&self, modes: &[Mode; K], rules: &[Rule<S>; K]) -> bool {
        let is_held = |k: &usize| rules[*k] == Rule::Holds && !matches!(modes[*k], Mode::Across(_));
        let is_exceeded = (0..K).filter(is_held).any(|k| self.margin(modes, k) < S::ZERO);
        is_exceeded && !self.balance.is_determined(rules)
    }

    /// Searches for forces within all limits. If they do not hold all held rates, the motion
    /// continues with the shortest forces up to the event that ends it.
    fn within_limits(mut self, modes: &[Mode; K], rules: &[Rule<S>; K]) -> Self {
        let found = self.balance.in_cone(&within_limits(modes, rules));
        self.within = found.map(|found| found.reactions);
        if let Some(within) = self.within
            && (0..K).all(|k| {
                rules[k] != Rule::Holds || self.balance.rate(k, &within).abs() <= self.noise(k, &within)
            })
        {
            self.reactions = within;
        }
        self
    }

    /// Bounds the rounding error of a rate under forces found by a search.
    fn noise(&self, k: usize, reactions: &[S; K]) -> S {
        BALANCED_BY_SEARCH.part::<S>() * self.balance.size(k, reactions)
    }

    /// Returns the distance of the force that holds reaction k from its limit, which it may exceed
    /// by rounding. If the shortest force exceeds it by more, the margin is positive as long as
    /// forces within all limits hold.
    pub(super) fn margin(&self, modes: &[Mode; K], k: usize) -> S {
        let in_force = |rate: S| match self.balance.response(k) {
            response if response > S::ZERO => rate / response,
            _ => S::ZERO,
        };
        let rounding = BOUND.part::<S>() * self.balance.size(k, &self.reactions);
        let margin = self.left(modes, k, &self.reactions) + in_force(rounding);
        self.within.map_or(margin, |within| {
            let rate = size(modes, k, |k| self.balance.rate(k, &within));
            margin.max(in_force(self.noise(k, &within) - rate))
        })
    }

    /// True if friction k gives way together with a reaction that has just reached its limit.
    pub(super) fn gives_way(&self, modes: &[Mode; K], k: usize) -> bool {
        let reactions = self.within.as_ref().unwrap_or(&self.reactions);
        let is_held = matches!(modes[k], Mode::Friction(Friction::Sticks));
        is_held && self.left(modes, k, reactions) <= S::epsilon().sqrt() * self.balance.fixed(k, reactions)
    }

    /// True if slip k in a plane decreases by no more than a part of what its friction alone would
    /// cause. Otherwise it would soon be zero.
    pub(super) fn lingers(&self, terms: &Terms<S, N, K>, k: usize) -> bool {
        let (slip, force) = (terms.slip(k, true), [self.reactions[k], self.reactions[k + 1]]);
        let rate = [k, k + 1].map(|k| self.balance.rate(k, &self.reactions));
        let slowing = S::from_f64(STOPPING) * self.balance.response(k) * length(&force);
        dot(&slip, &rate) > -(slowing * length(&slip))
    }

    /// Returns the distance of these forces to the limit of reaction k.
    fn left(&self, modes: &[Mode; K], k: usize, reactions: &[S; K]) -> S {
        match modes[k] {
            Mode::Contact(_) => reactions[k],
            _ => self.balance.fixed(k, reactions) - size(modes, k, |k| reactions[k]),
        }
    }
}

/// The size of what reaction k has, of both components in a plane.
fn size<S: Scalar, const K: usize>(modes: &[Mode; K], k: usize, of: impl Fn(usize) -> S) -> S {
    if is_planar(modes, k) { length(&[of(k), of(k + 1)]) } else { of(k).abs() }
}
