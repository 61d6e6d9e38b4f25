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
//! hand and halves its steps until the error falls. Where it does not, reactions are replaced by
//! their targets, one after the other for some sweeps. Then it starts again. Of undetermined steps
//! it takes the shortest.
//!
//! The first attempt starts near the shortest forces that hold all rates, with steps of Levenberg
//! and Marquardt. If there are many solutions, they find one close to the start.
//!
//! Sources: Fan, Yuan, "On the quadratic convergence of the Levenberg–Marquardt method without
//! nonsingularity assumption", *Computing* 74 (2005) 23–39; Alart, Curnier, "A mixed formulation
//! for frictional contact problems prone to Newton like solution methods", *Comput. Methods Appl.
//! Mech. Eng.* 92 (1991) 353–375; Jean, "The non-smooth contact dynamics method", *Comput. Methods
//! Appl. Mech. Eng.* 177 (1999) 235–257.
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
mod velocities;

use super::LimitSlope;
use super::choice::{Choice, Rule, Settled};
use super::law::ContactLaw;
use super::reaction_forces::{Balance, unit};
use super::slip::length;
use crate::linalg::vector::dot;
use crate::scalar::Scalar;
use crate::tolerance::BALANCED_BY_SEARCH;

/// Maximum number of reactions of systems whose responses are stored as a matrix.
pub(super) const MOST_DENSE: usize = 64;

/// The problem in units in which reactions change their own rates by one. It contains only the
/// reactions that may act; a place is an index among them. D is K if responses are stored as a
/// matrix. It is zero if they follow from changes of velocities, which suits many reactions, and
/// those that depend on each other.
pub(super) struct Cone<'a, S, const N: usize, const K: usize, const D: usize> {
    law: &'a ContactLaw<'a, S, N, K>,
    /// Number of reactions that may act, and their indices.
    count: usize,
    active: [usize; K],
    /// The place of each reaction; K for those that do not act.
    places: [usize; K],
    choices: [Choice<S>; K],
    /// First index of the slopes of each limit, and the index after the last.
    slopes: [(usize, usize); K],
    /// Units of rates; the units of reactions are their reciprocals.
    units: [S; K],
    /// Derivatives of the rates with respect to the reactions.
    matrix: [[S; K]; D],
    /// Rates without reactions.
    offsets: [S; K],
}

/// Reactions in the units of the problem, with d = r − rate of each.
#[derive(Clone, Copy)]
struct ForcePoint<S, const K: usize> {
    forces: [S; K],
    pulls: [S; K],
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

/// The piece of the target of a reaction, or of both components of a reaction in a plane.
#[derive(Clone, Copy)]
enum TargetPiece<S> {
    /// Zero.
    Absent,
    /// d
    Holds,
    /// `radius` along `direction`. `turning` is the derivative of the direction with respect to d
    /// across it; zero if the direction is known.
    Limited { direction: [S; 2], radius: S, turning: S },
}

impl<S: Scalar, const N: usize, const K: usize> Balance<'_, S, N, K> {
    /// Finds rules among these choices that fit together, and the reactions, by Newton's method.
    /// Undetermined reactions are close to the shortest ones that hold all rates.
    pub(super) fn in_cone(&self, choices: &[Choice<S>; K]) -> Option<Settled<S, K>> {
        let cone = Cone::<_, N, K, K>::new(self.law(), choices, |k, j| self.entry(k, j));
        let shortest = self.reactions(&choices.map(|choice| choice.rule(0)));
        Some(cone.settled(&cone.point(cone.solve(cone.scaled(&shortest))?)))
    }
}

impl<S: Scalar, const N: usize, const K: usize> ContactLaw<'_, S, N, K> {
    /// Finds the reactions that obey the law best, starting from these, such as those of the step
    /// before.
    pub(super) fn near(&self, choices: &[Choice<S>; K], start: &[S; K]) -> Approximation<S, K> {
        let entry = |k: usize, j: usize| dot(&self.terms.rows[k], &self.terms.responses[j]);
        // More reactions than velocities depend on each other if all of them hold.
        if const { K <= MOST_DENSE && K <= N } {
            Cone::<_, N, K, K>::new(self, choices, entry).best(start)
        } else {
            Cone::<_, N, K, 0>::new(self, choices, entry).best(start)
        }
    }
}

impl<'a, S: Scalar, const N: usize, const K: usize, const D: usize> Cone<'a, S, N, K, D> {
    /// Builds the problem. `entry` returns the change of a rate with a reaction, which is
    /// symmetric.
    pub(super) fn new(
        law: &'a ContactLaw<'a, S, N, K>,
        all: &[Choice<S>; K],
        entry: impl Fn(usize, usize) -> S,
    ) -> Self {
        let (mut active, mut places, mut count) = ([0; K], [K; K], 0);
        for k in (0..K).filter(|&k| all[k] != Choice::Only(Rule::Absent)) {
            (active[count], places[k], count) = (k, count, count + 1);
        }
        let mut units = [S::ONE; K];
        let mut choices = [Choice::Only(Rule::Absent); K];
        let mut slopes = [(0, 0); K];
        for (place, &k) in active[..count].iter().enumerate() {
            (units[place], choices[place]) = (unit(entry(k, k)), all[k]);
            slopes[place] = law.terms.range_of_slopes(k);
        }
        // Both components have the same unit, so that a disk remains a disk.
        for place in (1..count).filter(|&place| choices[place] == Choice::Across) {
            let half = S::from_f64(0.5);
            let squares = units[place - 1] * units[place - 1] + units[place] * units[place];
            let unit = (half * squares).sqrt();
            (units[place - 1], units[place]) = (unit, unit);
        }
        let (mut matrix, mut offsets) = ([[S::ZERO; K]; D], [S::ZERO; K]);
        for (place, &k) in active[..count].iter().enumerate() {
            offsets[place] = law.offsets[k] / units[place];
        }
        for place in 0..count.min(D) {
            for other in 0..=place {
                let entry = entry(active[place], active[other]) / (units[place] * units[other]);
                (matrix[place][other], matrix[other][place]) = (entry, entry);
            }
        }
        Cone { law, count, active, places, choices, slopes, units, matrix, offsets }
    }

    /// Finds the reactions of the least error, starting from these.
    pub(super) fn best(&self, start: &[S; K]) -> Approximation<S, K> {
        let search = self.follow(self.scaled(start));
        let end = self.point(search.forces);
        let (settled, residual) = (self.settled(&end), self.residual(&end));
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
                    let parts = row[..self.count].iter().zip(&forces);
                    parts.fold(S::ZERO, |sum, (entry, force)| entry.multiply_add(*force, sum))
                }
                None => self.rate(k, &velocities),
            };
            pulls[k] = forces[k] - self.offsets[k] - change;
        }
        ForcePoint { forces, pulls }
    }

    /// Returns the largest rate by which one of these reactions misses its target, and its index.
    fn residual(&self, at: &ForcePoint<S, K>) -> (S, usize) {
        let errors = self.errors(at);
        let mut worst = (S::ZERO, 0);
        for (place, &k) in self.active[..self.count].iter().enumerate() {
            let error = errors[place].abs() * self.units[place];
            if error > worst.0 || !error.is_finite() {
                worst = (error, k);
            }
        }
        worst
    }

    /// Returns the rules by which these reactions act.
    fn settled(&self, at: &ForcePoint<S, K>) -> Settled<S, K> {
        let (mut rules, mut reactions) = ([Rule::Absent; K], [S::ZERO; K]);
        for place in (0..self.count).filter(|&place| self.choices[place] != Choice::Across) {
            let found = match self.piece(at, place) {
                TargetPiece::Absent => [Rule::Absent; 2],
                TargetPiece::Holds => [Rule::Holds; 2],
                // At its limit, but other forces hold it as well.
                _ if self.choices[place] == Choice::Rest && self.is_still(at, place) => [Rule::Holds; 2],
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

    fn is_planar(&self, k: usize) -> bool {
        self.choices.get(k + 1) == Some(&Choice::Across)
    }

    /// True if the rates of friction k are zero up to rounding.
    fn is_still(&self, at: &ForcePoint<S, K>, k: usize) -> bool {
        let rate = |k: usize| at.forces[k] - at.pulls[k];
        let rates = [rate(k), if self.is_planar(k) { rate(k + 1) } else { S::ZERO }];
        length(&rates) <= BALANCED_BY_SEARCH.part::<S>() * self.scale(&at.forces)
    }

    /// Computes the targets minus the reactions.
    fn errors(&self, at: &ForcePoint<S, K>) -> [S; K] {
        let mut errors = [S::ZERO; K];
        for k in (0..self.count).filter(|&k| self.choices[k] != Choice::Across) {
            let [first, second] = self.target(at, k);
            errors[k] = first - at.forces[k];
            if self.is_planar(k) {
                errors[k + 1] = second - at.forces[k + 1];
            }
        }
        errors
    }

    fn target(&self, at: &ForcePoint<S, K>, k: usize) -> [S; 2] {
        match self.piece(at, k) {
            TargetPiece::Absent => [S::ZERO; 2],
            TargetPiece::Holds => self.pull(at, k),
            TargetPiece::Limited { direction, radius, .. } => direction.map(|component| radius * component),
        }
    }

    fn piece(&self, at: &ForcePoint<S, K>, k: usize) -> TargetPiece<S> {
        let known = |component: S| {
            let limit = self.kinetic(at, k);
            TargetPiece::Limited { direction: [-component, S::ZERO], radius: limit, turning: S::ZERO }
        };
        match self.choices[k] {
            Choice::Only(Rule::Absent) | Choice::Across => TargetPiece::Absent,
            Choice::Only(Rule::Holds) => TargetPiece::Holds,
            Choice::Only(Rule::Slips(component)) => known(component * self.side(at, k)),
            Choice::Only(Rule::Smooth) => known(S::ONE),
            Choice::Touch if self.pull(at, k)[0] > S::ZERO => TargetPiece::Holds,
            Choice::Touch => TargetPiece::Absent,
            Choice::Rest | Choice::GiveWay => self.friction(at, k),
        }
    }

    /// Returns the piece of friction that holds or slips.
    fn friction(&self, at: &ForcePoint<S, K>, k: usize) -> TargetPiece<S> {
        let pull = self.pull(at, k);
        let size = length(&pull);
        let radius = self.kinetic(at, k).abs();
        let fixed = self.fixed(at, k).abs().max(radius);
        if self.choices[k] == Choice::Rest && size <= fixed {
            return TargetPiece::Holds;
        }
        if size == S::ZERO {
            return TargetPiece::Absent;
        }
        let turning = if self.is_planar(k) { (radius / size).min(S::ONE) } else { S::ZERO };
        TargetPiece::Limited { direction: pull.map(|component| component / size), radius, turning }
    }

    /// Returns d.
    fn pull(&self, at: &ForcePoint<S, K>, k: usize) -> [S; 2] {
        [at.pulls[k], if self.is_planar(k) { at.pulls[k + 1] } else { S::ZERO }]
    }

    /// Returns the slopes of the limits of friction k, with the places of reactions that may act.
    fn slopes_of(&self, k: usize) -> impl Iterator<Item = (usize, &LimitSlope<S>)> {
        let (from, to) = self.slopes[k];
        let slopes = self.law.terms.slopes[from..to].iter();
        slopes.map(|slope| (self.places[slope.reaction], slope)).filter(|(place, _)| *place < K)
    }

    /// Computes a limit of friction k from its value without reactions and its slopes.
    fn limit(&self, at: &ForcePoint<S, K>, k: usize, free: S, slope: fn(&LimitSlope<S>) -> S) -> S {
        let limit = self.slopes_of(k).fold(free, |limit, (j, entry)| {
            let pressing = match self.choices[j] {
                Choice::Touch => self.pull(at, j)[0].max(S::ZERO),
                _ => at.forces[j],
            };
            limit + slope(entry) * pressing / self.units[j]
        });
        self.units[k] * limit
    }

    /// Computes the static limit of friction k.
    fn fixed(&self, at: &ForcePoint<S, K>, k: usize) -> S {
        self.limit(at, k, self.law.fixed(self.active[k]), |slope| slope.fixed)
    }

    /// Computes the kinetic limit of friction k.
    fn kinetic(&self, at: &ForcePoint<S, K>, k: usize) -> S {
        self.limit(at, k, self.law.kinetic(self.active[k]), |slope| slope.kinetic)
    }

    /// Returns the sign of the kinetic limit, whose absolute value is the radius.
    fn side(&self, at: &ForcePoint<S, K>, k: usize) -> S {
        let is_reversed = self.kinetic(at, k) < S::ZERO;
        if is_reversed { -S::ONE } else { S::ONE }
    }

    /// Returns the derivatives of the kinetic limit of friction k, or of its absolute value if the
    /// direction is free, with their places. They refer to d of contacts that press, and to forces
    /// of others.
    fn shares(&self, at: &ForcePoint<S, K>, k: usize) -> impl Iterator<Item = (usize, S)> {
        let is_free = matches!(self.choices[k], Choice::Rest | Choice::GiveWay);
        let side = if is_free { self.side(at, k) } else { S::ONE };
        let presses = |j: usize| self.choices[j] != Choice::Touch || self.pull(at, j)[0] > S::ZERO;
        let slopes = self.slopes_of(k).filter(move |(j, slope)| slope.kinetic != S::ZERO && presses(*j));
        slopes.map(move |(j, slope)| (j, side * slope.kinetic * self.units[k] / self.units[j]))
    }
}
