//! The search for consistent reactions.
//!
//! Contacts that touch either press or part, friction that is at rest either holds or slips in the
//! direction that results:
//!
//! ```text
//! r ≥ 0, rate ≥ 0, r·rate = 0;     |r| ≤ limit and rate = 0, or r = −sign(rate) limit.
//! ```
//!
//! One rule is changed at a time, that of the first reaction that contradicts its rule. This ends
//! with the solution if friction does not couple strongly (Murty's least-index pivoting). Otherwise
//! [Lemke's method](super::lemke) finds rules. It may fail where limits of friction change their
//! signs; all combinations are then tried if they are few. Friction in a plane slips in any
//! direction, which [Newton's method](super::cone) finds. With friction that slips and is strong
//! there may be none: the paradox of Painlevé. Sources: Murty, *Linear Complementarity, Linear and
//! Nonlinear Programming*, §2.2; Pfeiffer, Glocker, *Multibody Dynamics with Unilateral Contacts*,
//! §5.3, §6.
//!
//! # A block on a floor in numbers
//!
//! m = 2 under g = 10, pushed along the floor by 6, friction 0.25 times the normal force; at rest.
//! Reactions are the normal force and friction, rates the accelerations ÿ and ẍ: G = diag(1/2,
//! 1/2), without reactions the rates are (−10, 3).
//!
//! | rules | reactions | rates | |
//! |---|---|---|---|
//! | holds, holds | (20, −6) | (0, 0) | more than 0.25 · 20 = 5 |
//! | holds, slips forwards | (20, −5) | (0, 1/2) | fits |
//!
//! Pushed by 4 instead it holds with (20, −4).

use core::array;

use super::choice::{Choice, Rule, Settled};
use super::reaction_forces::Balance;
use super::slip::{length, present_direction};
use crate::scalar::Scalar;
use crate::tolerance::{BALANCED, BALANCED_BY_SEARCH, HELD_TOGETHER, Roundings};

/// Maximum number of combinations that are tried.
const MOST_COMBINATIONS: u64 = 1_296;

impl<S: Scalar, const N: usize, const K: usize> Balance<'_, S, N, K> {
    /// Finds rules among these choices that fit together; `None` if there are none.
    pub(super) fn settle(&self, choices: &[Choice<S>; K]) -> Option<Settled<S, K>> {
        let choices = &self.law().possible(choices);
        let held = choices.map(|choice| choice.rule(0));
        if choices.contains(&Choice::Across) {
            return self
                .fitting(choices, held)
                .or_else(|| self.in_plane(choices))
                .or_else(|| self.pivot(choices, held));
        }
        self.pivot(choices, held).or_else(|| self.complement(choices)).or_else(|| self.try_all(choices))
    }

    /// Returns the solution of Newton's method, refined to full accuracy and the shortest forces.
    fn in_plane(&self, choices: &[Choice<S>; K]) -> Option<Settled<S, K>> {
        let found = self.in_cone(choices)?;
        self.fitting(choices, found.rules).or(Some(found))
    }

    /// Returns the solution of Lemke's method, refined to full accuracy.
    fn complement(&self, choices: &[Choice<S>; K]) -> Option<Settled<S, K>> {
        let found = self.complementary(choices)?;
        let is_near = || self.contradiction(choices, &found, BALANCED_BY_SEARCH).is_none();
        self.pivot(choices, found.rules).or_else(|| is_near().then_some(found))
    }

    /// Changes one rule at a time, starting from these rules.
    fn pivot(&self, choices: &[Choice<S>; K], mut rules: [Rule<S>; K]) -> Option<Settled<S, K>> {
        for _ in 0..=8 + 4 * K {
            let settled = self.under(rules)?;
            let Some((k, instead)) = self.contradiction(choices, &settled, BALANCED) else {
                return Some(settled);
            };
            rules[k] = instead[0];
            if is_planar(choices, k) {
                rules[k + 1] = instead[1];
            }
        }
        None
    }

    /// Computes the reactions under these rules; `None` if they contradict the rules by more than
    /// the tolerance of searches.
    pub(super) fn confirmed(&self, choices: &[Choice<S>; K], rules: [Rule<S>; K]) -> Option<Settled<S, K>> {
        self.under(rules).filter(|settled| self.contradiction(choices, settled, BALANCED_BY_SEARCH).is_none())
    }

    /// Computes the reactions under these rules; `None` if they contradict the rules.
    fn fitting(&self, choices: &[Choice<S>; K], rules: [Rule<S>; K]) -> Option<Settled<S, K>> {
        self.under(rules).filter(|settled| self.contradiction(choices, settled, BALANCED).is_none())
    }

    fn try_all(&self, choices: &[Choice<S>; K]) -> Option<Settled<S, K>> {
        let count = |choice: &Choice<S>| choice.count() as u64;
        let combinations =
            choices.iter().fold(1, |product: u64, choice| product.saturating_mul(count(choice)));
        if combinations > MOST_COMBINATIONS {
            return None;
        }
        (0..combinations).find_map(|mut number| {
            let rules = choices.map(|choice| {
                let rule = choice.rule((number % count(&choice)) as usize);
                number /= count(&choice);
                rule
            });
            self.fitting(choices, rules)
        })
    }

    fn under(&self, rules: [Rule<S>; K]) -> Option<Settled<S, K>> {
        let reactions = self.reactions(&rules);
        let is_finite = reactions.iter().all(|reaction| reaction.is_finite());
        let is_held = |k: usize| {
            let rounding = HELD_TOGETHER.part::<S>() * self.size(k, &reactions);
            rules[k] != Rule::Holds || self.rate(k, &reactions).abs() <= rounding
        };
        let fits = is_finite && (!self.is_of_impulses() || (0..K).all(is_held));
        fits.then_some(Settled { rules, reactions })
    }

    /// Finds the first reaction that contradicts its rule by more than this many roundings, and the
    /// rules to try instead. The second rule is for a second component.
    fn contradiction(
        &self,
        choices: &[Choice<S>; K],
        settled: &Settled<S, K>,
        roundings: Roundings,
    ) -> Option<(usize, [Rule<S>; 2])> {
        (0..K).find_map(|k| {
            let other = match choices[k] {
                Choice::Only(_) | Choice::Across => None,
                Choice::Touch => self.touch(k, settled, roundings).map(|rule| [rule; 2]),
                Choice::Rest | Choice::GiveWay => self.rest(k, choices, settled, roundings),
            };
            other.map(|rules| (k, rules))
        })
    }

    /// Checks a contact. It is open if it presses by no more than rounding.
    fn touch(
        &self,
        k: usize,
        Settled { rules, reactions }: &Settled<S, K>,
        roundings: Roundings,
    ) -> Option<Rule<S>> {
        let rounding = roundings.part::<S>() * self.size(k, reactions);
        match rules[k] {
            Rule::Holds if reactions[k] * self.response(k) <= rounding => Some(Rule::Absent),
            Rule::Absent if self.rate(k, reactions) < -(rounding + rounding) => Some(Rule::Holds),
            _ => None,
        }
    }

    /// Checks friction. It holds with at most its static limit, and slips in the direction in which
    /// it is driven.
    fn rest(
        &self,
        k: usize,
        choices: &[Choice<S>; K],
        Settled { rules, reactions }: &Settled<S, K>,
        roundings: Roundings,
    ) -> Option<[Rule<S>; 2]> {
        let components =
            |of: &dyn Fn(usize) -> S| [of(k), if is_planar(choices, k) { of(k + 1) } else { S::ZERO }];
        let (rate, force) = (components(&|k| self.rate(k, reactions)), components(&|k| reactions[k]));
        let rounding = roundings.part::<S>() * length(&components(&|k| self.size(k, reactions)));
        let response = components(&|k| self.response(k)).into_iter().fold(S::ZERO, S::max);
        let against = |force: [S; 2]| {
            present_direction(force).map(|direction| direction.map(|component| Rule::Slips(-component)))
        };
        let Rule::Slips(along) = rules[k] else {
            let is_beyond = (length(&force) - self.fixed(k, reactions)) * response > rounding;
            let gives_way = rules[k] == Rule::Holds && (is_beyond || choices[k] == Choice::GiveWay);
            return gives_way.then(|| against(force)).flatten();
        };
        let across = match rules.get(k + 1) {
            Some(Rule::Slips(across)) if is_planar(choices, k) => *across,
            _ => S::ZERO,
        };
        let margin = rounding + rounding;
        let (driven, astray) = (along * rate[0] + across * rate[1], along * rate[1] - across * rate[0]);
        if driven < -margin && choices[k] == Choice::Rest {
            return Some([Rule::Holds; 2]);
        }
        let pull = array::from_fn(|component| force[component] - rate[component] / response);
        (astray.abs() > margin).then(|| against(pull)).flatten()
    }
}

/// True if choice k is that of friction in a plane.
fn is_planar<S: Scalar, const K: usize>(choices: &[Choice<S>; K], k: usize) -> bool {
    choices.get(k + 1) == Some(&Choice::Across)
}
