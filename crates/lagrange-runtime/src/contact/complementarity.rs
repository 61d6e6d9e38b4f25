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
//! at the answer if friction does not couple strongly (Murty's least-index pivoting). Otherwise
//! [Lemke's method](super::lemke) finds rules. It may fail where limits of friction change their
//! signs; all combinations are then tried if they are few. With friction that slips and is strong
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

use super::choice::{Choice, Settled};
use super::reaction_forces::{Balance, Rule};
use crate::scalar::Scalar;
use crate::tolerance::{BALANCED, BALANCED_BY_SEARCH, HELD_TOGETHER, Roundings};

/// Combinations are not tried if there are more.
const MOST_COMBINATIONS: u64 = 1_296;

impl<S: Scalar, const N: usize, const K: usize> Balance<'_, S, N, K> {
    /// Rules out of these choices that fit together, if there are any.
    pub(super) fn settle(&self, choices: &[Choice; K]) -> Option<Settled<S, K>> {
        let choices = &self.possible(choices);
        self.pivot(choices, choices.map(|choice| choice.rules()[0]))
            .or_else(|| self.complement(choices))
            .or_else(|| self.try_all(choices))
    }

    /// The choices without friction that has no limit, whatever contacts do.
    fn possible(&self, choices: &[Choice; K]) -> [Choice; K] {
        let mut possible = *choices;
        // Limits may hold what was declared before.
        for k in 0..K {
            let may_act = |j: usize| j != k && possible[j] != Choice::Only(Rule::Absent);
            if possible[k] == Choice::Rest && !self.has_limit(k, may_act) {
                possible[k] = Choice::Only(Rule::Absent);
            }
        }
        possible
    }

    /// Returns the solution of Lemke's method, refined to full accuracy.
    fn complement(&self, choices: &[Choice; K]) -> Option<Settled<S, K>> {
        let found = self.complementary(choices)?;
        let is_near = || self.contradiction(choices, &found, BALANCED_BY_SEARCH).is_none();
        self.pivot(choices, found.rules).or_else(|| is_near().then_some(found))
    }

    /// From these rules on.
    fn pivot(&self, choices: &[Choice; K], mut rules: [Rule; K]) -> Option<Settled<S, K>> {
        for _ in 0..=8 + 4 * K {
            let settled = self.under(rules)?;
            let Some((k, rule)) = self.contradiction(choices, &settled, BALANCED) else {
                return Some(settled);
            };
            rules[k] = rule;
        }
        None
    }

    /// Reactions under these rules if they fit together, but for a little more than rounding.
    pub(super) fn confirmed(&self, choices: &[Choice; K], rules: [Rule; K]) -> Option<Settled<S, K>> {
        self.under(rules).filter(|settled| self.contradiction(choices, settled, BALANCED_BY_SEARCH).is_none())
    }

    fn try_all(&self, choices: &[Choice; K]) -> Option<Settled<S, K>> {
        let count = |choice: &Choice| choice.rules().len() as u64;
        let combinations =
            choices.iter().fold(1, |product: u64, choice| product.saturating_mul(count(choice)));
        if combinations > MOST_COMBINATIONS {
            return None;
        }
        (0..combinations).find_map(|mut number| {
            let rules = choices.map(|choice| {
                let rule = choice.rules()[(number % count(&choice)) as usize];
                number /= count(&choice);
                rule
            });
            self.under(rules).filter(|settled| self.contradiction(choices, settled, BALANCED).is_none())
        })
    }

    fn under(&self, rules: [Rule; K]) -> Option<Settled<S, K>> {
        let reactions = self.reactions(&rules);
        let is_finite = reactions.iter().all(|reaction| reaction.is_finite());
        let is_held = |k: usize| {
            let rounding = HELD_TOGETHER.part::<S>() * self.size(k, &reactions);
            rules[k] != Rule::Holds || self.rate(k, &reactions).abs() <= rounding
        };
        let fits = is_finite && (!self.is_of_impulses() || (0..K).all(is_held));
        fits.then_some(Settled { rules, reactions })
    }

    /// The first reaction that contradicts its rule by more than so many roundings, and the rule to
    /// try instead.
    fn contradiction(
        &self,
        choices: &[Choice; K],
        settled: &Settled<S, K>,
        roundings: Roundings,
    ) -> Option<(usize, Rule)> {
        (0..K).find_map(|k| {
            let other = match choices[k] {
                Choice::Only(_) => None,
                Choice::Touch => self.touch(k, settled, roundings),
                Choice::Rest => self.rest(k, settled, roundings),
            };
            other.map(|rule| (k, rule))
        })
    }

    /// A contact that presses by no more than rounding is open.
    fn touch(
        &self,
        k: usize,
        Settled { rules, reactions }: &Settled<S, K>,
        roundings: Roundings,
    ) -> Option<Rule> {
        let rounding = roundings.part::<S>() * self.size(k, reactions);
        match rules[k] {
            Rule::Holds if reactions[k] * self.response(k) <= rounding => Some(Rule::Absent),
            Rule::Absent if self.rate(k, reactions) < -(rounding + rounding) => Some(Rule::Holds),
            _ => None,
        }
    }

    fn rest(
        &self,
        k: usize,
        Settled { rules, reactions }: &Settled<S, K>,
        roundings: Roundings,
    ) -> Option<Rule> {
        let rounding = roundings.part::<S>() * self.size(k, reactions);
        let (rate, reaction) = (self.rate(k, reactions), reactions[k]);
        match rules[k] {
            Rule::Holds if (reaction.abs() - self.fixed(k, reactions)) * self.response(k) > rounding => {
                Some(if reaction < S::ZERO { Rule::Forwards } else { Rule::Backwards })
            }
            Rule::Forwards if rate < -(rounding + rounding) => Some(Rule::Holds),
            Rule::Backwards if rate > rounding + rounding => Some(Rule::Holds),
            _ => None,
        }
    }
}
