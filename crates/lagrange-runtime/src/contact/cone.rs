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

mod search;

use core::array;

use super::choice::{Choice, Rule, Settled};
use super::reaction_forces::Balance;
use super::slip::length;
use crate::scalar::Scalar;
use crate::tolerance::BALANCED_BY_SEARCH;

/// The problem in units in which reactions change their own rates by one. It contains only the
/// reactions that may act; a place is an index among them.
pub(super) struct Cone<'a, S, const N: usize, const K: usize> {
    balance: &'a Balance<'a, S, N, K>,
    /// Number of reactions that may act, and their indices.
    count: usize,
    active: [usize; K],
    choices: [Choice<S>; K],
    /// Units of rates; the units of reactions are their reciprocals.
    units: [S; K],
    /// Derivatives of the rates with respect to the reactions.
    matrix: [[S; K]; K],
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
        let cone = Cone::new(self, choices);
        let shortest = self.reactions(&choices.map(|choice| choice.rule(0)));
        Some(cone.settled(&cone.point(cone.solve(cone.scaled(&shortest))?)))
    }

    /// Finds the reactions that obey the law best, starting from these, such as those of the step
    /// before.
    pub(super) fn near(&self, choices: &[Choice<S>; K], start: &[S; K]) -> Approximation<S, K> {
        let cone = Cone::new(self, choices);
        let search = cone.follow(cone.scaled(start));
        let end = cone.point(search.forces);
        let (settled, residual) = (cone.settled(&end), cone.residual(&end));
        Approximation { settled, residual, is_exact: search.is_exact, iterations: search.iterations }
    }
}

impl<'a, S: Scalar, const N: usize, const K: usize> Cone<'a, S, N, K> {
    fn new(balance: &'a Balance<'a, S, N, K>, all: &[Choice<S>; K]) -> Self {
        let all_units = balance.units();
        let (mut active, mut count) = ([0; K], 0);
        for k in (0..K).filter(|&k| all[k] != Choice::Only(Rule::Absent)) {
            (active[count], count) = (k, count + 1);
        }
        let mut units = [S::ONE; K];
        let mut choices = [Choice::Only(Rule::Absent); K];
        for (place, &k) in active[..count].iter().enumerate() {
            (units[place], choices[place]) = (all_units[k], all[k]);
        }
        // Both components have the same unit, so that a disk remains a disk.
        for place in (1..count).filter(|&place| choices[place] == Choice::Across) {
            let half = S::from_f64(0.5);
            let squares = units[place - 1] * units[place - 1] + units[place] * units[place];
            let unit = (half * squares).sqrt();
            (units[place - 1], units[place]) = (unit, unit);
        }
        let (mut matrix, mut offsets) = ([[S::ZERO; K]; K], [S::ZERO; K]);
        for (place, &k) in active[..count].iter().enumerate() {
            offsets[place] = balance.offset(k) / units[place];
            for (other, &j) in active[..count].iter().enumerate() {
                matrix[place][other] = balance.entry(k, j) / (units[place] * units[other]);
            }
        }
        Cone { balance, count, active, choices, units, matrix, offsets }
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
        for k in 0..self.count {
            pulls[k] = forces[k] - self.offsets[k] - self.change(k, &forces);
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

    /// Computes the change of rate k due to these reactions.
    fn change(&self, k: usize, forces: &[S; K]) -> S {
        let parts = self.matrix[k][..self.count].iter().zip(forces);
        parts.fold(S::ZERO, |sum, (entry, force)| entry.multiply_add(*force, sum))
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
        let fixed = self.limit(at, k, self.balance.static_limit(self.active[k])).abs().max(radius);
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

    /// Computes a limit of friction k from its value without reactions and its slopes.
    fn limit(&self, at: &ForcePoint<S, K>, k: usize, (free, slopes): (S, &[S; K])) -> S {
        let mut limit = free;
        for (j, slope) in self.active[..self.count].iter().map(|&j| slopes[j]).enumerate() {
            if slope == S::ZERO {
                continue;
            }
            let pressing = match self.choices[j] {
                Choice::Touch => self.pull(at, j)[0].max(S::ZERO),
                _ => at.forces[j],
            };
            limit = limit + slope * pressing / self.units[j];
        }
        self.units[k] * limit
    }

    /// Computes the kinetic limit of friction k.
    fn kinetic(&self, at: &ForcePoint<S, K>, k: usize) -> S {
        self.limit(at, k, self.balance.limit(self.active[k]))
    }

    /// Returns the sign of the kinetic limit, whose absolute value is the radius.
    fn side(&self, at: &ForcePoint<S, K>, k: usize) -> S {
        let is_reversed = self.kinetic(at, k) < S::ZERO;
        if is_reversed { -S::ONE } else { S::ONE }
    }

    /// Computes the derivatives of the reactions minus the targets.
    fn slopes(&self, at: &ForcePoint<S, K>) -> [[S; K]; K] {
        let mut slopes = [[S::ZERO; K]; K];
        for k in (0..self.count).filter(|&k| self.choices[k] != Choice::Across) {
            let components = if self.is_planar(k) { 2 } else { 1 };
            for component in 0..components {
                let target = self.slope(at, k, component);
                slopes[k + component] = target.map(|slope| -slope);
                slopes[k + component][k + component] = slopes[k + component][k + component] + S::ONE;
            }
        }
        slopes
    }

    /// Computes the derivative of a component of a target.
    fn slope(&self, at: &ForcePoint<S, K>, k: usize, component: usize) -> [S; K] {
        match self.piece(at, k) {
            TargetPiece::Absent => [S::ZERO; K],
            TargetPiece::Holds => self.pull_slope(k + component),
            TargetPiece::Limited { direction, turning, .. } => {
                let mut slope = self.limit_slope(at, k).map(|slope| direction[component] * slope);
                for other in (0..2).filter(|_| turning != S::ZERO) {
                    let own = if other == component { S::ONE } else { S::ZERO };
                    let share = turning * (own - direction[component] * direction[other]);
                    let pull = self.pull_slope(k + other);
                    slope = array::from_fn(|j| share.multiply_add(pull[j], slope[j]));
                }
                slope
            }
        }
    }

    /// Computes the derivative of one component of d.
    fn pull_slope(&self, k: usize) -> [S; K] {
        let mut slope = self.matrix[k].map(|entry| -entry);
        slope[k] = slope[k] + S::ONE;
        slope
    }

    /// Computes the derivative of the kinetic limit of friction k, or of its absolute value if the
    /// direction is free.
    fn limit_slope(&self, at: &ForcePoint<S, K>, k: usize) -> [S; K] {
        let (_, slopes) = self.balance.limit(self.active[k]);
        let is_free = matches!(self.choices[k], Choice::Rest | Choice::GiveWay);
        let side = if is_free { self.side(at, k) } else { S::ONE };
        let mut total = [S::ZERO; K];
        for (j, slope) in self.active[..self.count].iter().map(|&j| slopes[j]).enumerate() {
            if slope == S::ZERO {
                continue;
            }
            let share = side * slope * self.units[k] / self.units[j];
            match self.choices[j] {
                Choice::Touch if self.pull(at, j)[0] > S::ZERO => {
                    let pull = self.pull_slope(j);
                    total = array::from_fn(|i| share.multiply_add(pull[i], total[i]));
                }
                Choice::Touch => {}
                _ => total[j] = total[j] + share,
            }
        }
        total
    }
}
