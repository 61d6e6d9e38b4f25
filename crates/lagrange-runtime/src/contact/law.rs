//! Rates without reactions, and the limits of friction.

use super::choice::{Choice, Rule};
use super::{LimitSlope, Terms};
use crate::linalg::vector::dot;
use crate::scalar::Scalar;

/// All that the law of contacts and friction depends on, except the changes of rates with
/// reactions.
#[derive(Clone, Copy)]
pub(super) struct ContactLaw<'a, S, const N: usize, const K: usize> {
    pub(super) terms: &'a Terms<S, N, K>,
    /// The gradients of rates, in the coordinates of the responses.
    pub(super) rows: &'a [[S; N]; K],
    /// First index of the slopes of each limit, and the index after the last.
    pub(super) ranges: [(usize, usize); K],
    /// Rates without reactions.
    pub(super) offsets: [S; K],
    /// The time over which forces act: one for forces, and the length of a step for impulses over
    /// it. It is zero for impacts, to which finite forces do not contribute.
    pub(super) presence: S,
}

impl<'a, S: Scalar, const N: usize, const K: usize> ContactLaw<'a, S, N, K> {
    /// Returns the law for forces and the rates of rates.
    pub(super) fn of_forces(terms: &'a Terms<S, N, K>) -> Self {
        let offsets = core::array::from_fn(|k| dot(&terms.rows[k], &terms.free) + terms.drifts[k]);
        Self::new(terms, offsets, S::ONE)
    }

    pub(super) fn new(terms: &'a Terms<S, N, K>, offsets: [S; K], presence: S) -> Self {
        ContactLaw { terms, rows: &terms.rows, ranges: terms.ranges_of_slopes(), offsets, presence }
    }

    /// Returns the kinetic limit of friction k without reactions.
    pub(super) fn kinetic(&self, k: usize) -> S {
        self.presence * self.terms.kinetic[k]
    }

    /// Returns the static limit of friction k without reactions.
    pub(super) fn fixed(&self, k: usize) -> S {
        self.presence * self.terms.fixed[k]
    }

    /// Returns the slopes of the limits of friction k.
    pub(super) fn slopes(&self, k: usize) -> &'a [LimitSlope<S>] {
        let (from, to) = self.ranges[k];
        &self.terms.slopes[from..to]
    }

    /// Returns the range of velocities outside which the row and the response of reaction k are
    /// zero.
    pub(super) fn span(&self, k: usize) -> (usize, usize) {
        let is_present = |i: &usize| self.rows[k][*i] != S::ZERO || self.terms.responses[k][*i] != S::ZERO;
        let from = (0..N).find(is_present).unwrap_or(N);
        (from, (from..N).rfind(is_present).map_or(from, |last| last + 1))
    }

    /// True if friction k has a limit if these reactions may act.
    pub(super) fn has_limit(&self, k: usize, may_act: impl Fn(usize) -> bool) -> bool {
        let is_present = self.kinetic(k).abs() + self.fixed(k).abs() != S::ZERO;
        is_present || self.slopes(k).iter().any(|slope| slope.is_present() && may_act(slope.reaction))
    }

    /// Removes friction that has no limit in any mode of the contacts from these choices.
    pub(super) fn possible(&self, choices: &[Choice<S>; K]) -> [Choice<S>; K] {
        let mut possible = *choices;
        // Limits may include reactions that were declared before.
        for k in 0..K {
            let may_act = |j: usize| j != k && possible[j] != Choice::Only(Rule::Absent);
            if matches!(possible[k], Choice::Rest | Choice::GiveWay) && !self.has_limit(k, may_act) {
                possible[k] = Choice::Only(Rule::Absent);
                if choices.get(k + 1) == Some(&Choice::Across) {
                    possible[k + 1] = possible[k];
                }
            }
        }
        possible
    }
}
