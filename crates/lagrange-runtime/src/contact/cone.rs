//! The law of contacts and friction as an equation, solved by Newton's method.
//!
//! Reactions r and rates are scaled so that a reaction changes its own rate by one. Each reaction
//! is to equal its *target*, a function of d = r − rate:
//!
//! ```text
//! contact:   r = max(d, 0)
//! friction:  r = d                   where |d| ≤ static limit: it holds
//!            r = kinetic limit·d/|d| beyond: it slips against its force
//! ```
//!
//! In a plane r, rate and d have two components, and the limit is the radius of a disk. It is the
//! section of Coulomb's cone if the limit is μ times a normal force. Friction along a line is the
//! same with one component. Limits are affine in the reactions, with max(d, 0) for those of
//! contacts. The equation is piecewise smooth: Newton's method takes the derivative of the piece at
//! hand. If the error falls neither after a step nor after half of it, it takes the whole step.
//! Of undetermined steps it takes the shortest.
//!
//! On redundant points of one body, reactions may change by much while the rates hardly do, and
//! Newton's method cycles between pieces. The search then starts again in a smooth law. In it,
//! contacts press a little before they touch, and friction yields a little before it slips. This
//! law has one piece. Each time it is nearly met, it becomes twice as sharp, up to rounding.
//!
//! The first attempt starts near the shortest forces that hold all rates, with steps of Levenberg
//! and Marquardt. If there are many solutions, they find one close to the start.
//!
//! Sources: Fan, Yuan, "On the quadratic convergence of the Levenberg–Marquardt method without
//! nonsingularity assumption", *Computing* 74 (2005) 23–39; Alart, Curnier, "A mixed formulation
//! for frictional contact problems prone to Newton like solution methods", *Comput. Methods Appl.
//! Mech. Eng.* 92 (1991) 353–375; Chen, Mangasarian, "A class of smoothing functions for nonlinear
//! and mixed complementarity problems", *Comput. Optim. Appl.* 5 (1996) 97–138.
//!
//! # A block on a floor in numbers
//!
//! m = 1 under g = 10 at rest, pushed along the floor by (3, 4), friction ½ times the normal force.
//! Without reactions the rates are −10 and (3, 4).
//!
//! | step | normal force | d of friction | limit | friction |
//! |---|---|---|---|---|
//! | start | 0 | (−3, −4) | ½·10 | (0, 0) |
//! | it holds, by \|d\| ≤ 5 | 10 | (−3, −4) | 5 | (−3, −4) |
//!
//! With ¼ the limit is 2½: the force is 2½·(−3, −4)/5 = (−1½, −2), and (1½, 2) accelerates it.

mod newton;
mod search;
mod targets;
mod velocities;

use self::targets::TargetPiece;
use super::choice::{Choice, Rule, Settled};
use super::law::ContactLaw;
use super::reaction_forces::{Balance, unit};
use super::slip::length;
use crate::linalg::vector::{UNROLLED, dot, inner};
use crate::scalar::Scalar;
use crate::tolerance::BALANCED_BY_SEARCH;

/// Maximum number of reactions of systems whose responses are stored as a matrix.
pub(super) const MOST_DENSE: usize = 64;

/// The problem in units in which reactions change their own rates by one. It contains only the
/// reactions that may act; a place is an index among them. Responses are stored as a matrix if D is
/// at least their number. D is zero if they follow from changes of velocities, which suits many
/// reactions, and those that depend on each other.
#[derive(Clone, Copy)]
pub(super) struct Cone<'a, S, const N: usize, const K: usize, const D: usize> {
    law: &'a ContactLaw<'a, S, N, K>,
    /// Number of reactions that may act, and their indices.
    count: usize,
    active: [usize; K],
    /// The place of each reaction; K for those that do not act.
    places: [usize; K],
    choices: [Choice<S>; K],
    /// Units of rates; the units of reactions are their reciprocals.
    units: [S; K],
    /// Derivatives of the rates with respect to the reactions.
    matrix: [[S; D]; D],
    /// Rates without reactions.
    offsets: [S; K],
    /// True for impulses over a step. Undetermined ones may become large, and a search ends where
    /// only rounding is left.
    is_of_step: bool,
    /// Size of forces below which the pieces of targets merge smoothly; zero for the law.
    smoothing: S,
    /// Ranges of velocities for each reaction, if there are many velocities. Outside, its row and
    /// response are zero, and so are those on which its limit depends.
    spans: [(usize, usize); K],
}

/// Reactions in the units of the problem, with d = r − rate of each.
#[derive(Clone, Copy)]
struct ForcePoint<S, const K: usize> {
    forces: [S; K],
    pulls: [S; K],
}

/// Reactions, and how far they are from their targets.
#[derive(Clone, Copy)]
struct TriedForces<S, const K: usize> {
    at: ForcePoint<S, K>,
    /// Targets minus reactions.
    errors: [S; K],
    /// The norm of the errors; infinite if one is not finite.
    error: S,
}

/// Reactions, the rules by which they act, and how far they are from the law.
pub(super) struct Approximation<S, const K: usize> {
    pub(super) settled: Settled<S, K>,
    /// The largest rate by which a reaction misses its target, and the index of this reaction.
    pub(super) residual: (S, usize),
    /// True if the residual is no more than rounding.
    pub(super) is_exact: bool,
    /// Number of steps of Newton's method.
    pub(super) iterations: u32,
}

impl<S: Scalar, const N: usize, const K: usize> Balance<'_, S, N, K> {
    /// Finds rules among these choices that fit together, and the reactions, by Newton's method.
    /// Undetermined reactions are close to the shortest ones that hold all rates.
    pub(super) fn in_cone(&self, choices: &[Choice<S>; K]) -> Option<Settled<S, K>> {
        let cone = Cone::<_, N, K, K>::new(self.law(), choices, false, |k, j| self.entry(k, j));
        let shortest = self.reactions(&choices.map(|choice| choice.rule(0)));
        Some(cone.settled(&cone.point(cone.solve(cone.scaled(&shortest))?)))
    }
}

impl<S: Scalar, const N: usize, const K: usize> ContactLaw<'_, S, N, K> {
    /// Finds the reactions that obey the law best, starting from these, such as those of the step
    /// before.
    pub(super) fn near(&self, choices: &[Choice<S>; K], start: &[S; K]) -> Approximation<S, K> {
        let entry = |k: usize, j: usize| inner(&self.rows[k], &self.terms.responses[j]);
        // More reactions than velocities depend on each other. Without their matrix, zeros among
        // many velocities are skipped.
        let count = choices.iter().filter(|choice| **choice != Choice::Only(Rule::Absent)).count();
        if const { K <= MOST_DENSE && K <= N } {
            return Cone::<_, N, K, K>::new(self, choices, true, entry).best(start);
        }
        let by_matrix = (const { N <= UNROLLED } && count <= N)
            .then(|| Cone::<_, N, K, N>::new(self, choices, true, entry).best(start));
        let inexact = match by_matrix {
            Some(found) if found.is_exact => return found,
            other => other,
        };
        // Few reactions may depend on each other, too, as at two corners of a body.
        let mut found = Cone::<_, N, K, 0>::new(self, choices, true, entry).best(start);
        if let Some(other) = inexact {
            found.iterations += other.iterations;
            if !found.is_exact && other.residual.0 < found.residual.0 {
                found = Approximation { iterations: found.iterations, ..other };
            }
        }
        found
    }
}

impl<'a, S: Scalar, const N: usize, const K: usize, const D: usize> Cone<'a, S, N, K, D> {
    /// Builds the problem. `entry` returns the change of a rate with a reaction, which is
    /// symmetric.
    pub(super) fn new(
        law: &'a ContactLaw<'a, S, N, K>,
        all: &[Choice<S>; K],
        is_of_step: bool,
        entry: impl Fn(usize, usize) -> S,
    ) -> Self {
        let (mut active, mut places, mut count) = ([0; K], [K; K], 0);
        for k in (0..K).filter(|&k| all[k] != Choice::Only(Rule::Absent)) {
            (active[count], places[k], count) = (k, count, count + 1);
        }
        let mut units = [S::ONE; K];
        let mut choices = [Choice::Only(Rule::Absent); K];
        let mut spans = [(0, 0); K];
        for (place, &k) in active[..count].iter().enumerate() {
            (units[place], choices[place]) = (unit(entry(k, k)), all[k]);
            if const { D == 0 && N > UNROLLED } {
                // Reactions on which limits depend come first.
                let limiting = law.slopes(k).iter().map(|slope| places[slope.reaction]);
                let limiting = limiting.filter(|other| *other < place);
                spans[place] = limiting.fold(law.span(k), |span, other| joined(span, spans[other]));
                if all[k] == Choice::Across {
                    let span = joined(spans[place - 1], spans[place]);
                    (spans[place - 1], spans[place]) = (span, span);
                }
            }
        }
        // Both components have the same unit, so that a disk remains a disk.
        for place in (1..count).filter(|&place| choices[place] == Choice::Across) {
            let half = S::from_f64(0.5);
            let squares = units[place - 1] * units[place - 1] + units[place] * units[place];
            let unit = (half * squares).sqrt();
            (units[place - 1], units[place]) = (unit, unit);
        }
        let (mut matrix, mut offsets) = ([[S::ZERO; D]; D], [S::ZERO; K]);
        for (place, &k) in active[..count].iter().enumerate() {
            offsets[place] = law.offsets[k] / units[place];
        }
        for place in 0..count.min(D) {
            for other in 0..=place {
                let entry = entry(active[place], active[other]) / (units[place] * units[other]);
                (matrix[place][other], matrix[other][place]) = (entry, entry);
            }
        }
        Cone {
            law,
            count,
            active,
            places,
            choices,
            units,
            matrix,
            offsets,
            is_of_step,
            smoothing: S::ZERO,
            spans,
        }
    }

    /// Finds the reactions of the least error, starting from these.
    pub(super) fn best(&self, start: &[S; K]) -> Approximation<S, K> {
        let search = self.follow(self.scaled(start));
        let (settled, residual) = (self.settled(&search.best.at), self.residual(&search.best));
        Approximation { settled, residual, is_exact: search.is_exact, iterations: search.iterations }
    }

    /// Converts these reactions to the units of the problem.
    fn scaled(&self, reactions: &[S; K]) -> [S; K] {
        let mut forces = [S::ZERO; K];
        for (place, &k) in self.active[..self.count].iter().enumerate() {
            forces[place] = reactions[k] * self.units[place];
        }
        forces
    }

    fn point(&self, forces: [S; K]) -> ForcePoint<S, K> {
        let mut pulls = [S::ZERO; K];
        let velocities = if D == 0 { self.velocities(&forces) } else { [S::ZERO; N] };
        for k in 0..self.count {
            let change = match self.matrix.get(k) {
                Some(row) => {
                    let parts = row.iter().take(self.count).zip(&forces);
                    parts.fold(S::ZERO, |sum, (entry, force)| entry.multiply_add(*force, sum))
                }
                None => self.rate(k, &velocities),
            };
            pulls[k] = forces[k] - self.offsets[k] - change;
        }
        ForcePoint { forces, pulls }
    }

    /// Evaluates these reactions.
    fn tried(&self, forces: [S; K]) -> TriedForces<S, K> {
        let at = self.point(forces);
        let errors = self.errors(&at);
        let square = dot(&errors, &errors);
        let error = if square.is_finite() { square.sqrt() } else { S::ONE / S::ZERO };
        TriedForces { at, errors, error }
    }

    /// Returns the largest rate by which one of these reactions misses its target, and its index.
    fn residual(&self, trial: &TriedForces<S, K>) -> (S, usize) {
        let mut worst = (S::ZERO, 0);
        for (place, &k) in self.active[..self.count].iter().enumerate() {
            let error = trial.errors[place].abs() * self.units[place];
            if error > worst.0 || !error.is_finite() {
                worst = (error, k);
            }
        }
        worst
    }

    /// Returns the rules by which these reactions act.
    fn settled(&self, at: &ForcePoint<S, K>) -> Settled<S, K> {
        let (mut rules, mut reactions) = ([Rule::Absent; K], [S::ZERO; K]);
        let rounding = BALANCED_BY_SEARCH.part::<S>() * self.scale(&at.forces);
        for place in (0..self.count).filter(|&place| self.choices[place] != Choice::Across) {
            let found = match self.piece(at, place) {
                TargetPiece::Absent => [Rule::Absent; 2],
                TargetPiece::Holds => [Rule::Holds; 2],
                // At its limit, but other forces hold it as well.
                _ if self.choices[place] == Choice::Rest && self.speed(at, place) <= rounding => {
                    [Rule::Holds; 2]
                }
                TargetPiece::Limited { direction, .. } => direction.map(|component| Rule::Slips(-component)),
            };
            let k = self.active[place];
            rules[k] = if let Choice::Only(rule) = self.choices[place] { rule } else { found[0] };
            if self.is_planar(place) {
                rules[k + 1] = found[1];
            }
        }
        // Reactions that do not act would only have rounding errors as limits.
        for (place, &k) in self.active[..self.count].iter().enumerate() {
            if rules[k] != Rule::Absent {
                reactions[k] = at.forces[place] / self.units[place];
            }
        }
        Settled { rules, reactions }
    }

    /// Returns the length of the rates of friction k.
    fn speed(&self, at: &ForcePoint<S, K>, k: usize) -> S {
        let rate = |k: usize| at.forces[k] - at.pulls[k];
        let rates = [rate(k), if self.is_planar(k) { rate(k + 1) } else { S::ZERO }];
        length(&rates)
    }
}

/// Returns the range that contains both.
fn joined(one: (usize, usize), other: (usize, usize)) -> (usize, usize) {
    match (one.0 < one.1, other.0 < other.1) {
        (true, true) => (one.0.min(other.0), one.1.max(other.1)),
        (true, false) => one,
        _ => other,
    }
}
