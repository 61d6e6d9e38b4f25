//! The search for reactions that obey the law.

use core::array;

use super::{Cone, ForcePoint, TriedForces};
use crate::contact::choice::Choice;
use crate::linalg::vector::{combined, difference};
use crate::scalar::Scalar;
use crate::tolerance::{BALANCED_BY_SEARCH, BOUND, STEADY};

/// Maximum number of starts of Newton's method; each follows twice as many sweeps as the last.
const MOST_STARTS: u32 = 10;
/// Maximum number of starts if the error is small already.
const FEW_STARTS: u32 = 2;
/// Maximum number of steps of Newton's method from each start.
const MOST_STEPS: u32 = 24;
/// Maximum number of steps of Newton's method near known reactions.
const MOST_STEPS_NEAR: u32 = 12;
/// Maximum number of short steps close to the shortest forces.
const MOST_SHORT_STEPS: u32 = 60;
/// Term added to the diagonal so that undetermined steps are short, relative to the root of the
/// rounding unit.
const DAMPING: f64 = 0.1;
/// Assumed change of the impulses from step to step, relative to the impulses.
const LEFT: f64 = 1e-2;
/// Error, relative to the forces and to the root of the rounding unit, that may be left if nothing
/// reduces it. Reactions that are not determined have such errors.
const NEARLY: f64 = 1e-2;
/// Maximum number of searches near reactions.
const MOST_ANCHORS: u32 = 3;
/// Number of parts of a step of Newton's method that are tried, each half of the one before. More
/// of them would creep along a piece, where whole steps pass through larger errors to its end.
const MOST_PARTS: i32 = 2;
/// Number of parts of a short step that are tried.
const MOST_SHORT_PARTS: i32 = 8;

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
    pub(super) best: TriedForces<S, K>,
    pub(super) iterations: u32,
    /// True if the reactions equal their targets up to rounding.
    pub(super) is_exact: bool,
    /// The error, relative to the forces, at which the search ends.
    goal: S,
    /// The error, relative to the forces, up to which reactions obey the law.
    rounding: S,
    /// True for impulses over a step. Undetermined ones may become large, and a search ends where
    /// only rounding is left.
    is_of_step: bool,
}

impl<S: Scalar, const N: usize, const K: usize, const D: usize> Cone<'_, S, N, K, D> {
    /// Finds reactions that equal their targets up to rounding, starting near these or from zero.
    pub(super) fn solve(&self, near: [S; K]) -> Option<[S; K]> {
        let mut search = ForceSearch {
            best: self.tried(near),
            iterations: 0,
            is_exact: false,
            goal: S::epsilon(),
            rounding: BALANCED_BY_SEARCH.part(),
            is_of_step: false,
        };
        let is_found = self.descend(&mut search, Step::Short, MOST_SHORT_STEPS)
            || self.restart(&mut search, MOST_STARTS);
        is_found.then_some(search.best.at.forces)
    }

    /// Finds the reactions of the least error, starting from these.
    pub(super) fn follow(&self, start: [S; K]) -> ForceSearch<S, K> {
        let (best, goal) = (self.tried(start), step_goal::<S>());
        let is_steady = best.error <= goal * self.scale(&start);
        let mut search = ForceSearch {
            best,
            iterations: 0,
            is_exact: false,
            goal: if is_steady { goal.min(STEADY.part()) } else { goal },
            // That of each reaction, in a norm of all. In single precision it would be a few
            // percent.
            rounding: (BALANCED_BY_SEARCH.part::<S>() * S::from_f64(self.count.max(1) as f64).sqrt())
                .min(S::epsilon().sqrt()),
            is_of_step: true,
        };
        search.is_exact =
            self.descend(&mut search, Step::Newton, MOST_STEPS_NEAR) || self.fall_back(&mut search, &start);
        search
    }

    /// Searches from zero by alternating sweeps and Newton's method.
    fn restart(&self, search: &mut ForceSearch<S, K>, most: u32) -> bool {
        let mut forces = [S::ZERO; K];
        (0..most).any(|start| {
            let share = S::from_f64(if start % 2 == 0 { 1.0 } else { 0.5 });
            let (mut at, mut before) = (self.point(forces), forces);
            for _ in 0..1 << start {
                before = at.forces;
                self.sweep(&mut at, share);
            }
            search.best = self.tried(match search.is_of_step {
                true => self.leap(&at.forces, &difference(&at.forces, &before)),
                false => at.forces,
            });
            let is_found = self.descend(search, Step::Newton, MOST_STEPS);
            forces = search.best.at.forces;
            is_found
        })
    }

    /// Repeats this change as often as the error stays about the same, in powers of two.
    ///
    /// Where reactions are undetermined, each sweep changes them by the same small amount. This may
    /// last thousands of sweeps, until one of them sticks or slips.
    fn leap(&self, from: &[S; K], change: &[S; K]) -> [S; K] {
        let after = |doublings: i32| combined(from, S::from_f64(2.0).powi(doublings), change);
        let error = |forces: &[S; K]| self.tried(*forces).error;
        let allowed = S::from_f64(DRIFT) * error(from);
        let is_allowed = |doublings: &i32| error(&after(*doublings)) <= allowed;
        (0..MOST_DOUBLINGS).take_while(is_allowed).last().map_or(*from, after)
    }

    /// Searches near the start, then from zero, and then by short steps; keeps the best reactions
    /// found.
    fn fall_back(&self, search: &mut ForceSearch<S, K>, start: &[S; K]) -> bool {
        let mut centre = *start;
        for _ in 0..MOST_ANCHORS {
            if self.improved(search, |search| self.settle(search, &centre)) {
                return true;
            }
            centre = search.best.at.forces;
        }
        if self.is_within(search, nearly()) {
            return self.improved(search, |search| self.restart(search, FEW_STARTS));
        }
        self.improved(search, |search| self.restart(search, MOST_STARTS))
            || self.descend(search, Step::Short, MOST_SHORT_STEPS)
    }

    /// Searches for reactions close to these, which are in part undetermined.
    fn settle(&self, search: &mut ForceSearch<S, K>, centre: &[S; K]) -> bool {
        let anchored = self.anchored(centre);
        search.best = anchored.tried(*centre);
        anchored.descend(search, Step::Newton, MOST_STEPS_NEAR);
        search.best = self.tried(search.best.at.forces);
        self.descend(search, Step::Newton, MOST_STEPS_NEAR / 2)
    }

    /// Searches, and keeps the reactions before it if they are better.
    fn improved(
        &self,
        search: &mut ForceSearch<S, K>,
        find: impl FnOnce(&mut ForceSearch<S, K>) -> bool,
    ) -> bool {
        let before = search.best;
        let is_found = find(search);
        if !is_found && before.error <= search.best.error {
            search.best = before;
        }
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
            for (k, target) in self.components(k).zip(targets) {
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

    /// Finds the reactions of least error by at most so many steps. If no part of a step reduces
    /// the error, the whole step is taken, as the next piece may reduce it. Returns true if the
    /// reactions equal their targets up to rounding.
    fn descend(&self, search: &mut ForceSearch<S, K>, kind: Step, most: u32) -> bool {
        let half = S::from_f64(0.5);
        let mut present = search.best;
        for _ in 0..most {
            let best = search.best.error;
            if best <= search.goal * self.scale(&search.best.at.forces) {
                break;
            }
            present = self.stepped(&present, kind);
            search.iterations += 1;
            if present.error < best {
                search.best = present;
            }
            let is_slow = search.best.error > half * best;
            if search.is_of_step && is_slow && self.is_within(search, search.rounding.min(nearly())) {
                break;
            }
        }
        self.is_balanced(search)
    }

    /// True if the best reactions equal their targets up to rounding.
    fn is_balanced(&self, search: &ForceSearch<S, K>) -> bool {
        self.is_within(search, search.rounding)
    }

    /// True if the least error is within this one, relative to the forces.
    fn is_within(&self, search: &ForceSearch<S, K>, relative: S) -> bool {
        search.best.error <= relative * self.scale(&search.best.at.forces)
    }

    /// Returns the largest of these reactions and of the rates without reactions.
    pub(super) fn scale(&self, forces: &[S; K]) -> S {
        let pairs = forces.iter().zip(&self.offsets).take(self.count);
        pairs.fold(S::ZERO, |size, (force, offset)| size.max(force.abs().max(offset.abs())))
    }

    /// Returns the end of the longest part of a step that reduces the error, or of the whole step.
    fn stepped(&self, present: &TriedForces<S, K>, kind: Step) -> TriedForces<S, K> {
        let least = (S::from_f64(DAMPING) * S::epsilon().sqrt()).max(self.compliance);
        let short = || present.error / self.scale(&present.at.forces);
        let step = match kind {
            Step::Newton if D == 0 => self.step_of_velocities(present, least),
            Step::Short if D == 0 => self.step_of_velocities(present, least.max(short())),
            Step::Newton => self.newton_step(present, least),
            Step::Short => self.short_step(present, short()),
        };
        let reached =
            |part: S| self.tried(array::from_fn(|k| step[k].multiply_add(part, present.at.forces[k])));
        let parts = match kind {
            Step::Newton => MOST_PARTS,
            Step::Short => MOST_SHORT_PARTS,
        };
        let halves = (0..parts).map(|halvings| reached(S::from_f64(0.5).powi(halvings)));
        { halves }.find(|end| end.error < present.error).unwrap_or_else(|| reached(S::ONE))
    }
}

/// Returns the error, relative to the forces, that may be left if nothing reduces it.
fn nearly<S: Scalar>() -> S {
    S::from_f64(NEARLY) * S::epsilon().sqrt()
}

/// Returns the error, relative to the forces, at which the search for impulses over a step ends.
/// Damping leaves about this part of the change from step to step. Impulses that hardly change from
/// step to step repeat their error and are therefore determined more accurately.
fn step_goal<S: Scalar>() -> S {
    (S::from_f64(LEFT * DAMPING) * S::epsilon().sqrt()).max(BOUND.part::<S>())
}
