//! The search for reactions that obey the law.

use core::array;

use super::{Cone, TriedForces};
use crate::scalar::Scalar;
use crate::tolerance::{BALANCED_BY_SEARCH, BOUND, STEADY};

/// Maximum number of steps of Newton's method near known reactions.
const MOST_STEPS_NEAR: u32 = 12;
/// Maximum number of short steps close to the shortest forces.
const MOST_SHORT_STEPS: u32 = 60;
/// Factors of the smoothing from one smooth law to the next. Some problems need short strides.
const STRIDES: [f64; 3] = [0.5, 0.7, 0.8];
/// Error after a search along smooth laws, as a multiple of `NEARLY`, from which another one
/// follows.
const TRIFLE: f64 = 4.0;
/// Maximum number of steps in one smooth law.
const PATIENCE: u32 = 20;
/// Term added to the diagonal so that undetermined steps are short, relative to the root of the
/// rounding unit.
const DAMPING: f64 = 0.1;
/// Assumed change of the impulses from step to step, relative to the impulses.
const LEFT: f64 = 1e-2;
/// Error, relative to the forces and to the root of the rounding unit, that may be left if nothing
/// reduces it. Reactions that are not determined have such errors.
const NEARLY: f64 = 1e-2;
/// Largest error, relative to the forces and to the root of the rounding unit, with which impulses
/// obey the law. It matters in single precision, where the roundings of a search would be a few
/// percent. The root itself misses the limit of residuals where a small body has large rates.
const LARGEST: f64 = 0.1;

/// The kind of a step.
#[derive(Clone, Copy, PartialEq)]
enum Step {
    /// A step of Newton's method.
    Newton,
    /// That of Levenberg and Marquardt, damped by the error. It stays short where reactions are
    /// nearly undetermined.
    Short,
    /// A step of Newton's method in a smooth law.
    Smooth,
}

impl Step {
    /// Returns the number of parts that are tried, each half of the one before. More parts of a
    /// step of Newton's method would creep along a piece, where whole steps pass through larger
    /// errors to its end.
    const fn parts(self) -> i32 {
        match self {
            Step::Newton => 2,
            Step::Short => 8,
            Step::Smooth => 12,
        }
    }
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
        };
        let is_found =
            self.descend(&mut search, Step::Short, MOST_SHORT_STEPS) || self.sharpen(&mut search, &near);
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
            // That of each reaction, in a norm of all.
            rounding: (BALANCED_BY_SEARCH.part::<S>() * S::from_f64(self.count.max(1) as f64).sqrt())
                .min(S::from_f64(LARGEST) * S::epsilon().sqrt()),
        };
        search.is_exact =
            self.descend(&mut search, Step::Newton, MOST_STEPS_NEAR) || self.sharpen(&mut search, &start);
        search
    }

    /// Searches along smooth laws from these reactions, in ever shorter strides, and then from
    /// zero. Small errors that are left after one search are left after others as well.
    fn sharpen(&self, search: &mut ForceSearch<S, K>, start: &[S; K]) -> bool {
        let ends = |search: &ForceSearch<S, K>| self.is_within(search, S::from_f64(TRIFLE) * nearly());
        for stride in STRIDES {
            if self.approach(search, start, S::from_f64(stride)) || (self.is_of_step && ends(search)) {
                return self.is_balanced(search);
            }
        }
        self.approach(search, &[S::ZERO; K], S::from_f64(STRIDES[1]))
    }

    /// Searches along smooth approximations of the law. Each time one is nearly met, its smoothing
    /// is multiplied by this stride. Keeps the best reactions.
    fn approach(&self, search: &mut ForceSearch<S, K>, start: &[S; K], stride: S) -> bool {
        let half = S::from_f64(0.5);
        let mut smooth = *self;
        smooth.smoothing = self.scale(start);
        let (mut present, mut patience) = (smooth.tried(*start), PATIENCE);
        while patience > 0 && !self.is_balanced(search) {
            present = smooth.stepped(&present, Step::Smooth);
            (patience, search.iterations) = (patience - 1, search.iterations + 1);
            let sharp = self.tried(present.at.forces);
            if sharp.error < search.best.error {
                search.best = sharp;
            }
            if present.error < half * smooth.smoothing {
                smooth.smoothing = stride * smooth.smoothing;
                (present, patience) = (smooth.tried(present.at.forces), PATIENCE);
            }
        }
        self.descend(search, Step::Newton, MOST_STEPS_NEAR)
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
            if self.is_of_step && is_slow && self.is_within(search, search.rounding.min(nearly())) {
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

    /// Returns the end of the longest part of a step that reduces the error. If there is none, it
    /// is the end of the whole step, or of the best part in a smooth law.
    fn stepped(&self, present: &TriedForces<S, K>, kind: Step) -> TriedForces<S, K> {
        let least = S::from_f64(DAMPING) * S::epsilon().sqrt();
        let short = || present.error / self.scale(&present.at.forces);
        let step = match kind {
            Step::Short if D == 0 => self.step_of_velocities(present, least.max(short())),
            Step::Short => self.short_step(present, short()),
            _ if D == 0 => self.step_of_velocities(present, least),
            _ => self.newton_step(present, least),
        };
        let reached =
            |part: S| self.tried(array::from_fn(|k| step[k].multiply_add(part, present.at.forces[k])));
        let mut best = reached(S::ONE);
        for halvings in 1..kind.parts() {
            if best.error < present.error {
                break;
            }
            let end = reached(S::from_f64(0.5).powi(halvings));
            if end.error < present.error || (kind == Step::Smooth && end.error < best.error) {
                best = end;
            }
        }
        best
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
