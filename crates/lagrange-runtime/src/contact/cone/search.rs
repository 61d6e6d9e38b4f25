//! The search for reactions that obey the law.

use core::array;

use super::{Cone, ForcePoint};
use crate::contact::choice::Choice;
use crate::linalg::vector::{combined, difference, dot};
use crate::scalar::Scalar;
use crate::tolerance::{BALANCED_BY_SEARCH, BOUND};

/// Maximum number of starts of Newton's method; each follows twice as many sweeps as the last.
const MOST_STARTS: u32 = 10;
/// Maximum number of steps of Newton's method from each start.
const MOST_STEPS: u32 = 24;
/// Maximum number of short steps close to the shortest forces.
const MOST_SHORT_STEPS: u32 = 60;
/// Term added to the diagonal so that undetermined steps are short, relative to the root of the
/// rounding unit.
const DAMPING: f64 = 0.1;
/// Assumed change of the impulses from step to step, relative to the impulses.
const LEFT: f64 = 1e-2;
/// Maximum number of halvings of a step.
const MOST_HALVINGS: i32 = 8;

/// Factor by which leaps along the change of a sweep may raise the error.
const DRIFT: f64 = 1.01;
/// Maximum number of doublings of a leap.
const MOST_DOUBLINGS: i32 = 16;

/// The kind of a step.
#[derive(Clone, Copy)]
enum Step {
    /// A step of Newton's method.
    Newton,
    /// That of Levenberg and Marquardt, damped by the error. It stays short where reactions are
    /// nearly undetermined.
    Short,
}

/// A search for reactions.
#[derive(Clone, Copy)]
pub(super) struct ForceSearch<S, const K: usize> {
    /// The best reactions so far.
    pub(super) forces: [S; K],
    pub(super) iterations: u32,
    /// True if the reactions equal their targets up to rounding.
    pub(super) is_exact: bool,
    /// The error, relative to the forces, at which the search ends.
    goal: S,
    /// True if forces that are undetermined may become large.
    may_leap: bool,
}

impl<S: Scalar, const N: usize, const K: usize, const D: usize> Cone<'_, S, N, K, D> {
    /// Finds reactions that equal their targets up to rounding, starting near these or from zero.
    pub(super) fn solve(&self, near: [S; K]) -> Option<[S; K]> {
        let mut search =
            ForceSearch { forces: near, iterations: 0, goal: S::epsilon(), is_exact: false, may_leap: false };
        let is_found = self.descend(&mut search, Step::Short) || self.restart(&mut search);
        is_found.then_some(search.forces)
    }

    /// Finds the reactions of the least error, starting from these.
    pub(super) fn follow(&self, start: [S; K]) -> ForceSearch<S, K> {
        let mut search =
            ForceSearch { forces: start, iterations: 0, is_exact: false, goal: step_goal(), may_leap: true };
        search.is_exact = self.descend(&mut search, Step::Newton) || self.fall_back(&mut search);
        search
    }

    /// Searches from zero by alternating sweeps and Newton's method.
    fn restart(&self, search: &mut ForceSearch<S, K>) -> bool {
        search.forces = [S::ZERO; K];
        (0..MOST_STARTS).any(|start| {
            let share = S::from_f64(if start % 2 == 0 { 1.0 } else { 0.5 });
            let (mut at, mut before) = (self.point(search.forces), search.forces);
            for _ in 0..1 << start {
                before = at.forces;
                self.sweep(&mut at, share);
            }
            search.forces = match search.may_leap {
                true => self.leap(&at.forces, &difference(&at.forces, &before)),
                false => at.forces,
            };
            self.descend(search, Step::Newton)
        })
    }

    /// Repeats this change as often as the error stays about the same, in powers of two.
    ///
    /// Where reactions are undetermined, each sweep changes them by the same small amount. This may
    /// last thousands of sweeps, until one of them sticks or slips.
    fn leap(&self, from: &[S; K], change: &[S; K]) -> [S; K] {
        let after = |doublings: i32| combined(from, S::from_f64(2.0).powi(doublings), change);
        let error = |forces: &[S; K]| size(&self.errors(&self.point(*forces)));
        let allowed = S::from_f64(DRIFT) * error(from);
        let is_allowed = |doublings: &i32| error(&after(*doublings)) <= allowed;
        (0..MOST_DOUBLINGS).take_while(is_allowed).last().map_or(*from, after)
    }

    /// Searches from zero, and then by short steps; keeps the best reactions found.
    fn fall_back(&self, search: &mut ForceSearch<S, K>) -> bool {
        let mut best = *search;
        let error = |forces: [S; K]| size(&self.errors(&self.point(forces)));
        let is_found = self.restart(search);
        if is_found || error(search.forces) < error(best.forces) {
            best.forces = search.forces;
        }
        let is_found = is_found || {
            search.forces = best.forces;
            let is_found = self.descend(search, Step::Short);
            best.forces = search.forces;
            is_found
        };
        search.forces = best.forces;
        is_found
    }

    /// Moves each reaction in turn by this fraction of the way to its target. A fraction of one
    /// half ends some cycles.
    fn sweep(&self, at: &mut ForcePoint<S, K>, share: S) {
        let mut velocities = if D == 0 { self.velocities(&at.forces) } else { [S::ZERO; N] };
        for k in (0..self.count).filter(|&k| self.choices[k] != Choice::Across) {
            if D == 0 {
                self.refresh(at, k, &velocities);
            }
            let targets = self.target(at, k);
            let components = if self.is_planar(k) { 2 } else { 1 };
            for (k, target) in (k..k + components).zip(targets) {
                let change = share * (target - at.forces[k]);
                at.forces[k] = at.forces[k] + change;
                at.pulls[k] = at.pulls[k] + change;
                for (pull, row) in at.pulls.iter_mut().zip(&self.matrix).take(self.count) {
                    *pull = (-change).multiply_add(row[k], *pull);
                }
                if D == 0 {
                    self.kick(&mut velocities, k, change);
                }
            }
        }
        if D == 0 {
            *at = self.point(at.forces);
        }
    }

    /// Finds the reactions of least error by such steps. If no part of a step reduces the error,
    /// the whole step is taken, as the next piece may reduce it. Returns true if the reactions
    /// equal their targets up to rounding.
    fn descend(&self, search: &mut ForceSearch<S, K>, kind: Step) -> bool {
        let start = self.point(search.forces);
        let mut present = (start, size(&self.errors(&start)));
        let mut best = present;
        let most = match kind {
            Step::Newton => MOST_STEPS,
            Step::Short => MOST_SHORT_STEPS,
        };
        for _ in 0..most {
            if best.1 <= search.goal * self.scale(&best.0.forces) {
                break;
            }
            present = self.stepped(&present, kind);
            search.iterations += 1;
            if present.1 < best.1 {
                best = present;
            }
        }
        search.forces = best.0.forces;
        best.1 <= BALANCED_BY_SEARCH.part::<S>() * self.scale(&search.forces)
    }

    /// Returns the largest of these reactions and of the rates without reactions.
    pub(super) fn scale(&self, forces: &[S; K]) -> S {
        forces.iter().chain(&self.offsets[..self.count]).fold(S::ZERO, |size, value| size.max(value.abs()))
    }

    /// Returns the end of the longest part of a step that reduces the error, or of the whole step,
    /// and the error there.
    fn stepped(&self, (at, error): &(ForcePoint<S, K>, S), kind: Step) -> (ForcePoint<S, K>, S) {
        let least = S::from_f64(DAMPING) * S::epsilon().sqrt();
        let step = match kind {
            Step::Newton if D == 0 => self.step_of_velocities(at, least),
            Step::Short if D == 0 => self.step_of_velocities(at, least.max(*error / self.scale(&at.forces))),
            Step::Newton => self.newton_step(at, least),
            Step::Short => self.short_step(at, *error / self.scale(&at.forces)),
        };
        let reached = |part: S| {
            let end = self.point(array::from_fn(|k| step[k].multiply_add(part, at.forces[k])));
            (end, size(&self.errors(&end)))
        };
        let halves = (0..MOST_HALVINGS).map(|halvings| reached(S::from_f64(0.5).powi(halvings)));
        { halves }.find(|(_, least)| least < error).unwrap_or_else(|| reached(S::ONE))
    }
}

/// Returns the error, relative to the forces, at which the search for impulses over a step ends.
/// Damping leaves about this part of the change from step to step.
fn step_goal<S: Scalar>() -> S {
    (S::from_f64(LEFT * DAMPING) * S::epsilon().sqrt()).max(BOUND.part::<S>())
}

/// Returns the norm of a vector; infinite if a component is not finite.
fn size<S: Scalar, const K: usize>(vector: &[S; K]) -> S {
    let square = dot(vector, vector);
    if square.is_finite() { square.sqrt() } else { S::ONE / S::ZERO }
}
