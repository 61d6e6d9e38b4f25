//! Impacts.
//!
//! All contacts that touch take part, those that are closed as well: rates of gaps after an impact and impulses satisfy
//!
//! ```text
//! Λ ≥ 0,  ξ = rate⁺ + e rate⁻ ≥ 0,  Λ ξ = 0,     v⁺ = v⁻ + Σ w Λ,
//! ```
//!
//! which for one contact is v⁺ = v⁻ − (1 + e) W (J W)⁻¹ J v⁻. A contact that would have to pull is left out. Friction whose limit
//! grows with the reactions of contacts acts by the same law as its force: |Λ| ≤ slope of the limit times the impulses, and
//! against the slip that remains; limits that do not grow with reactions are finite forces and give no impulse.
//! Sources: Moreau, "Unilateral contact and dry friction in finite freedom dynamics", in *Nonsmooth Mechanics and Applications*
//! (1988); Glocker, *Set-Valued Force Laws*, §8.

use super::balance::{Balance, Rule};
use super::settle::Choice;
use super::{Mode, Terms};
use crate::integrate::Cause;
use crate::scalar::Scalar;

/// What an impact changed.
pub(super) struct Collision<S, const N: usize, const K: usize> {
    /// The velocities after it.
    pub(super) velocities: [S; N],
    pub(super) impulses: [S; K],
    /// The kinetic energy that all contacts and friction took, by the mean of their rates before and after.
    pub(super) energy_loss: S,
    /// Which rates are zero after it, but for rounding.
    pub(super) is_still: [bool; K],
}

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// The impact in the contacts that touch, from the velocities `v`; coefficients of restitution are zero for friction.
    ///
    /// # Errors
    /// If no impulses fit.
    pub(super) fn impact(
        &self,
        v: &[S; N],
        modes: &[Mode; K],
        is_touching: &[bool; K],
        restitutions: &[S; K],
    ) -> Result<Collision<S, N, K>, Cause<S>> {
        let balance = Balance::of_impulses(self, restitutions);
        let mut choices = [Choice::Only(Rule::Absent); K];
        for k in 0..K {
            choices[k] = match modes[k] {
                Mode::Contact(_) if is_touching[k] => Choice::Touch,
                Mode::Friction(_) | Mode::Smooth if self.has_impulses(k) => Choice::Rest,
                _ => Choice::Only(Rule::Absent),
            };
        }
        let settled = balance
            .settle(&choices)
            .ok_or(Cause::Stuck("no impulses of contacts and friction fit the impact"))?;
        let velocities = self.added(v, &settled.reactions);
        let half = S::from_f64(0.5);
        let (mut energy_loss, mut is_still) = (S::ZERO, [false; K]);
        for k in 0..K {
            let after = self.rates[k] + balance.change(k, &settled.reactions);
            energy_loss = energy_loss - settled.reactions[k] * half * (self.rates[k] + after);
            let is_thrown_back = self.rates[k] * restitutions[k] < S::ZERO;
            is_still[k] = settled.rules[k] == Rule::Holds && !is_thrown_back;
        }
        Ok(Collision { velocities, impulses: settled.reactions, energy_loss, is_still })
    }

    /// Whether the limits of friction k grow with reactions.
    fn has_impulses(&self, k: usize) -> bool {
        let slopes = self.kinetic_slopes[k].iter().chain(&self.static_slopes[k]);
        slopes.copied().any(|slope| slope != S::ZERO)
    }
}
