//! The small system that reactions solve.
//!
//! A reaction r_k changes its rates by G r, with G_kj = d_k·w_j. These rates are accelerations of
//! gaps and slip velocities for forces, and these velocities themselves for impulses. The rule of a
//! reaction is that it is absent, that it holds its rate at zero, or that it is friction at its
//! limit.
//!
//! Reactions are scaled by √G_kk, which makes them comparable in any units. If held rates leave
//! reactions undetermined, as for a table on four legs, the shortest in this scale are taken. The
//! motion does not depend on this choice.

use core::array;

use super::choice::Rule;
use super::law::ContactLaw;
use super::{LimitSlope, Terms};
use crate::linalg::singular::{is_singular, nearest, solve};
use crate::linalg::vector::dot;
use crate::scalar::{Number, Scalar};

/// Rates without reactions, and their changes with the reactions.
#[derive(Clone, Copy)]
pub(super) struct Balance<'a, S, const N: usize, const K: usize> {
    law: ContactLaw<'a, S, N, K>,
    /// G
    matrix: [[S; K]; K],
    /// Magnitude of the terms in the offsets, the scale for rounding tests.
    sizes: [S; K],
    /// True if rates that cannot be held together are an error; otherwise they are held as closely
    /// as possible.
    is_exact: bool,
}

impl<'a, S: Scalar, const N: usize, const K: usize> Balance<'a, S, N, K> {
    /// Builds the problem for forces and the rates of rates.
    pub(super) fn of_forces(terms: &'a Terms<S, N, K>) -> Self {
        Balance { matrix: terms.matrix(), ..Self::without_responses(terms) }
    }

    /// Builds the problem for forces under known rules. Absent reactions are excluded, with their
    /// rates and effects.
    pub(super) fn of_active(terms: &'a Terms<S, N, K>, rules: &[Rule<S>; K]) -> Self {
        let mut balance = Self::without_responses(terms);
        let acts = |k: &usize| rules[*k] != Rule::Absent;
        for k in (0..K).filter(acts) {
            for j in (0..K).filter(acts) {
                balance.matrix[k][j] = dot(&terms.rows[k], &terms.responses[j]);
            }
        }
        balance
    }

    fn without_responses(terms: &'a Terms<S, N, K>) -> Self {
        let size = |k: usize| terms.size_of(k, &terms.free) + terms.drifts[k].abs();
        let (sizes, matrix) = (array::from_fn(size), [[S::ZERO; K]; K]);
        Balance { law: ContactLaw::of_forces(terms), matrix, sizes, is_exact: true }
    }

    /// Builds the problem for impulses and the post-impact values rate⁺ + e rate⁻, which are zero
    /// or positive.
    pub(super) fn of_impulses(terms: &'a Terms<S, N, K>, rates: &[S; K], restitutions: &[S; K]) -> Self {
        let offsets: [S; K] = array::from_fn(|k| match rates[k] {
            rate if rate < S::ZERO => rate + restitutions[k] * rate,
            rate => rate,
        });
        Self::at_an_instant(terms, offsets, true)
    }

    /// Lets these contacts approach with a fraction of the largest slip velocity that their
    /// friction meets.
    pub(super) fn approached(mut self, part: S, contacts: &[bool; K]) -> Self {
        let units = self.units();
        let meets_friction = |k: &usize| !contacts[*k] && self.law.has_limit(*k, |j| contacts[j]);
        let slips = (0..K).filter(meets_friction).map(|k| self.law.offsets[k].abs() / units[k]);
        let largest = slips.fold(S::ZERO, S::max);
        for k in (0..K).filter(|k| contacts[*k]) {
            self.law.offsets[k] = self.law.offsets[k] - part * largest * units[k];
            self.sizes[k] = self.law.offsets[k].abs();
        }
        self
    }

    /// Builds the problem for changes of the state that remove these values. For a state at rest up
    /// to rounding, they need not be consistent.
    pub(super) fn of_values(terms: &'a Terms<S, N, K>, values: [S; K]) -> Self {
        Self::at_an_instant(terms, values, false)
    }

    fn at_an_instant(terms: &'a Terms<S, N, K>, offsets: [S; K], is_exact: bool) -> Self {
        let (law, sizes) = (ContactLaw::new(terms, offsets, S::ZERO), offsets.map(Number::abs));
        Balance { law, matrix: terms.matrix(), sizes, is_exact }
    }

    /// True if the rates without reactions, and their changes with reactions, are finite.
    pub(super) fn is_finite(&self) -> bool {
        self.matrix.iter().chain([&self.law.offsets]).flatten().all(|entry| entry.is_finite())
    }

    /// True if reactions are impulses.
    pub(super) fn is_of_impulses(&self) -> bool {
        self.is_exact && self.law.presence == S::ZERO
    }

    /// Returns rate k under these reactions.
    pub(super) fn rate(&self, k: usize, reactions: &[S; K]) -> S {
        self.law.offsets[k] + self.change(k, reactions)
    }

    /// Returns the change of rate k under these reactions.
    pub(super) fn change(&self, k: usize, reactions: &[S; K]) -> S {
        dot(&self.matrix[k], reactions)
    }

    /// Returns the size of the terms of this sum.
    pub(super) fn size(&self, k: usize, reactions: &[S; K]) -> S {
        let parts = self.matrix[k].iter().zip(reactions);
        parts.fold(self.sizes[k], |sum, (g, r)| sum + (*g * *r).abs())
    }

    /// Returns the change of a reaction's own rate per unit of the reaction.
    pub(super) fn response(&self, k: usize) -> S {
        self.matrix[k][k]
    }

    /// Returns G in row k and column j.
    pub(super) fn entry(&self, k: usize, j: usize) -> S {
        self.matrix[k][j]
    }

    /// Returns rate k without reactions.
    pub(super) fn offset(&self, k: usize) -> S {
        self.law.offsets[k]
    }

    /// Returns the rates without reactions, and the limits of friction.
    pub(super) fn law(&self) -> &ContactLaw<'a, S, N, K> {
        &self.law
    }

    /// Returns the units of rates; those of reactions are the reciprocals.
    pub(super) fn units(&self) -> [S; K] {
        array::from_fn(|k| unit(self.response(k)))
    }

    /// Returns the kinetic limit of friction k while it slips, with the computed sign.
    pub(super) fn kinetic(&self, k: usize, reactions: &[S; K]) -> S {
        let slopes = self.law.slopes(k).iter();
        slopes.fold(self.law.kinetic(k), |sum, slope| sum + slope.kinetic * reactions[slope.reaction])
    }

    /// Returns the static limit of friction k while it sticks; never below the kinetic one.
    pub(super) fn fixed(&self, k: usize, reactions: &[S; K]) -> S {
        let slopes = self.law.slopes(k).iter();
        let fixed =
            slopes.fold(self.law.fixed(k), |sum, slope| sum + slope.fixed * reactions[slope.reaction]);
        fixed.abs().max(self.kinetic(k, reactions).abs())
    }

    /// Computes the reactions under these rules; NaN if there are none.
    ///
    /// A limit that becomes negative, such as that of a guide pressed from its other side, counts
    /// by its magnitude. The system is then solved again with the opposite sign.
    pub(super) fn reactions(&self, rules: &[Rule<S>; K]) -> [S; K] {
        let is_reversed = |k: usize| rules[k] == Rule::Smooth && self.law.terms.rates[k] < S::ZERO;
        let expected = array::from_fn(|k| if is_reversed(k) { -S::ONE } else { S::ONE });
        let mut signs = expected;
        for _ in 0..=K {
            let reactions = self.solve(rules, &signs, &expected);
            let mut is_consistent = true;
            for k in 0..K {
                let is_limited = matches!(rules[k], Rule::Slips(_) | Rule::Smooth);
                let is_negative = || self.kinetic(k, &reactions) * signs[k] < S::ZERO;
                if is_limited && is_negative() && !self.is_beyond(k, rules, &reactions) {
                    signs[k] = -signs[k];
                    is_consistent = false;
                }
            }
            if is_consistent {
                return reactions;
            }
        }
        [S::NAN; K]
    }

    /// True if the limit of friction k belongs to a contact that pulls. Such states are beyond the
    /// event by which the contact opens. Methods evaluate them before they find the event, and need
    /// a smooth continuation of the motion.
    fn is_beyond(&self, k: usize, rules: &[Rule<S>; K], reactions: &[S; K]) -> bool {
        self.law.slopes(k).iter().any(|&LimitSlope { reaction: j, kinetic, .. }| {
            rules[j] == Rule::Holds && kinetic > S::ZERO && reactions[j] < S::ZERO
        })
    }

    /// Returns the limits of the holding friction, relative to which forces count as rounding.
    /// Without other forces, several points of a body at rest hold only the rounding of its
    /// velocity.
    fn held_limits(&self, rules: &[Rule<S>; K], units: &[S; K]) -> S {
        let held = (0..K).filter(|&k| rules[k] == Rule::Holds);
        held.fold(S::ZERO, |sum, k| sum + (self.law.kinetic(k).abs() + self.law.fixed(k).abs()) * units[k])
    }

    /// True if held rates determine the forces that hold them.
    pub(super) fn is_determined(&self, rules: &[Rule<S>; K]) -> bool {
        let units = self.units();
        let held = |k: usize| rules[k] == Rule::Holds;
        let matrix: [[S; K]; K] = array::from_fn(|k| {
            array::from_fn(|j| match held(k) && held(j) {
                true => self.matrix[k][j] / (units[k] * units[j]),
                false if k == j => S::ONE,
                false => S::ZERO,
            })
        });
        !is_singular(&matrix)
    }

    /// Computes the reactions under these rules if the limits have these signs.
    fn solve(&self, rules: &[Rule<S>; K], signs: &[S; K], expected: &[S; K]) -> [S; K] {
        let units = self.units();
        let factor = |k: usize| match rules[k] {
            Rule::Slips(component) => component * signs[k] * expected[k],
            _ => signs[k] * expected[k],
        };
        // Absent reactions are excluded: their rounding errors would have signs, by which limits
        // are judged.
        let (mut active, mut count) = ([0; K], 0);
        for k in (0..K).filter(|k| rules[*k] != Rule::Absent) {
            active[count] = k;
            count += 1;
        }
        let slope = |k: usize, j: usize| {
            let slope = self.law.slopes(k).iter().find(|slope| slope.reaction == j);
            slope.map_or(S::ZERO, |slope| slope.kinetic)
        };
        let entry = |k: usize, j: usize| match rules[k] {
            Rule::Holds => self.matrix[k][j] / (units[k] * units[j]),
            _ => {
                let own = if j == k { S::ONE } else { S::ZERO };
                own + factor(k) * slope(k, j) * units[k] / units[j]
            }
        };
        let right = |k: usize| match rules[k] {
            Rule::Holds => -self.law.offsets[k] / units[k],
            _ => -(factor(k) * self.law.kinetic(k) * units[k]),
        };
        let (mut matrix, mut rights) = ([[S::ZERO; K]; K], [S::ZERO; K]);
        for (row, &k) in active[..count].iter().enumerate() {
            rights[row] = right(k);
            for (place, &j) in matrix[row].iter_mut().zip(&active[..count]) {
                *place = entry(k, j);
            }
        }
        let found = match self.is_exact {
            true => solve(&matrix, &rights, count, self.held_limits(rules, &units)),
            false => nearest(&matrix, &rights, count),
        };
        let mut reactions = [S::ZERO; K];
        for (found, &k) in found.iter().zip(&active[..count]) {
            reactions[k] = *found / units[k];
        }
        reactions
    }
}

/// Returns the unit of a rate that a reaction changes by this response.
pub(super) fn unit<S: Scalar>(response: S) -> S {
    if response > S::ZERO { response.sqrt() } else { S::ONE }
}

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Computes G, whose row k contains the change of rate k with each reaction.
    fn matrix(&self) -> [[S; K]; K] {
        array::from_fn(|k| array::from_fn(|j| dot(&self.rows[k], &self.responses[j])))
    }

    /// Returns the size of the terms of d_k·x.
    pub(super) fn size_of(&self, k: usize, x: &[S; N]) -> S {
        self.rows[k].iter().zip(x).fold(S::ZERO, |sum, (d, x)| sum + (*d * *x).abs())
    }
}
