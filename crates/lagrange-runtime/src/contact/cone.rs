//! The law of contacts and friction as an equation, solved by Newton's method.
//!
//! Reactions r and rates are measured so that a reaction changes its own rate by one. Each reaction
//! of the law is what its *target* makes of d = r − rate:
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
//! First it is tried near the shortest forces that hold all rates, with the steps of Levenberg and
//! Marquardt. These find a solution next to the start where there are many.
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

use core::array;

use super::choice::{Choice, Rule, Settled};
use super::reaction_forces::Balance;
use super::slip::length;
use crate::linalg::singular::{nearest, regular};
use crate::linalg::vector::dot;
use crate::scalar::Scalar;
use crate::tolerance::BALANCED_BY_SEARCH;

/// Newton's method is started so often, each time after twice as many sweeps.
const MOST_STARTS: u32 = 10;
/// Steps of Newton's method from each start.
const MOST_STEPS: u32 = 24;
/// Short steps next to the shortest forces.
const MOST_SHORT_STEPS: u32 = 60;
/// The part of the root of rounding that is added to the diagonal, so that undetermined steps are
/// short.
const DAMPING: f64 = 0.1;
/// A step is halved so often.
const MOST_HALVINGS: i32 = 8;

/// The problem in units in which reactions change their own rates by one.
struct Cone<'a, S, const N: usize, const K: usize> {
    balance: &'a Balance<'a, S, N, K>,
    choices: &'a [Choice<S>; K],
    /// Units of rates; those of reactions are the reciprocals.
    units: [S; K],
    /// Change of the rates with the reactions.
    matrix: [[S; K]; K],
    /// Rates without reactions.
    offsets: [S; K],
}

/// The kind of a step.
#[derive(Clone, Copy)]
enum Step {
    /// Newton's.
    Newton,
    /// That of Levenberg and Marquardt, damped by the error. It stays short where reactions are
    /// all but undetermined.
    Short,
}

/// The piece of the target of a reaction, or of both components of a reaction in a plane.
#[derive(Clone, Copy)]
enum TargetPiece<S> {
    /// Zero.
    Absent,
    /// d
    Holds,
    /// `radius` along `direction`. `turning` is what the direction changes with d across it, zero
    /// if the direction is known.
    Limited { direction: [S; 2], radius: S, turning: S },
}

impl<S: Scalar, const N: usize, const K: usize> Balance<'_, S, N, K> {
    /// Rules out of these choices that fit together, and the reactions, if Newton's method finds
    /// some. Of undetermined reactions it finds some next to the shortest that hold all rates.
    pub(super) fn in_cone(&self, choices: &[Choice<S>; K]) -> Option<Settled<S, K>> {
        let cone = Cone::new(self, choices);
        let shortest = self.reactions(&choices.map(|choice| choice.rule(0)));
        let start = array::from_fn(|k| shortest[k] * cone.units[k]);
        Some(cone.settled(&cone.solve(start)?))
    }
}

impl<'a, S: Scalar, const N: usize, const K: usize> Cone<'a, S, N, K> {
    fn new(balance: &'a Balance<'a, S, N, K>, choices: &'a [Choice<S>; K]) -> Self {
        let mut units = balance.units();
        // A disk stays one.
        for k in (1..K).filter(|&k| choices[k] == Choice::Across) {
            let half = S::from_f64(0.5);
            let unit = (half * (units[k - 1] * units[k - 1] + units[k] * units[k])).sqrt();
            (units[k - 1], units[k]) = (unit, unit);
        }
        let entry = |k: usize, j: usize| balance.entry(k, j) / (units[k] * units[j]);
        let matrix = array::from_fn(|k| array::from_fn(|j| entry(k, j)));
        let offsets = array::from_fn(|k| balance.offset(k) / units[k]);
        Cone { balance, choices, units, matrix, offsets }
    }

    /// The rules by which these reactions act.
    fn settled(&self, forces: &[S; K]) -> Settled<S, K> {
        let mut rules = [Rule::Absent; K];
        for k in (0..K).filter(|&k| self.choices[k] != Choice::Across) {
            let found = match self.piece(forces, k) {
                TargetPiece::Absent => [Rule::Absent; 2],
                TargetPiece::Holds => [Rule::Holds; 2],
                // At its limit, yet held by other forces.
                _ if self.choices[k] == Choice::Rest && self.is_still(forces, k) => [Rule::Holds; 2],
                TargetPiece::Limited { direction, .. } => direction.map(|component| Rule::Slips(-component)),
            };
            rules[k] = if let Choice::Only(rule) = self.choices[k] { rule } else { found[0] };
            if self.is_planar(k) {
                rules[k + 1] = found[1];
            }
        }
        // Rounding of nothing would be a limit.
        let reactions = array::from_fn(|k| match rules[k] {
            Rule::Absent => S::ZERO,
            _ => forces[k] / self.units[k],
        });
        Settled { rules, reactions }
    }

    fn is_planar(&self, k: usize) -> bool {
        self.choices.get(k + 1) == Some(&Choice::Across)
    }

    /// True if the rates of friction k are zero but for rounding.
    fn is_still(&self, forces: &[S; K], k: usize) -> bool {
        let rate = |k: usize| self.offsets[k] + dot(&self.matrix[k], forces);
        let rates = [rate(k), if self.is_planar(k) { rate(k + 1) } else { S::ZERO }];
        length(&rates) <= BALANCED_BY_SEARCH.part::<S>() * self.scale(forces)
    }

    /// Reactions that are their targets but for rounding, near these or from zero on.
    fn solve(&self, near: [S; K]) -> Option<[S; K]> {
        let mut forces = near;
        if self.descend(&mut forces, Step::Short) {
            return Some(forces);
        }
        forces = [S::ZERO; K];
        (0..MOST_STARTS).find_map(|start| {
            let share = S::from_f64(if start % 2 == 0 { 1.0 } else { 0.5 });
            for _ in 0..1 << start {
                self.sweep(&mut forces, share);
            }
            self.descend(&mut forces, Step::Newton).then_some(forces)
        })
    }

    /// Moves one reaction after the other by this share of the way to its target. Half of it ends
    /// some cycles.
    fn sweep(&self, forces: &mut [S; K], share: S) {
        for k in (0..K).filter(|&k| self.choices[k] != Choice::Across) {
            let [first, second] = self.target(forces, k);
            forces[k] = share.multiply_add(first - forces[k], forces[k]);
            if self.is_planar(k) {
                forces[k + 1] = share.multiply_add(second - forces[k + 1], forces[k + 1]);
            }
        }
    }

    /// Goes to the reactions of least error that such steps find. Where no part of a step makes the
    /// error smaller, the next piece may. True if they are their targets but for rounding.
    fn descend(&self, forces: &mut [S; K], kind: Step) -> bool {
        let mut present = (*forces, size(&self.errors(forces)));
        let mut best = present;
        let most = match kind {
            Step::Newton => MOST_STEPS,
            Step::Short => MOST_SHORT_STEPS,
        };
        for _ in 0..most {
            if best.1 <= S::epsilon() * self.scale(&best.0) {
                break;
            }
            present = self.stepped(&present, kind);
            if present.1 < best.1 {
                best = present;
            }
        }
        *forces = best.0;
        best.1 <= BALANCED_BY_SEARCH.part::<S>() * self.scale(forces)
    }

    /// The largest of these reactions and of the rates without any.
    fn scale(&self, forces: &[S; K]) -> S {
        forces.iter().chain(&self.offsets).fold(S::ZERO, |size, value| size.max(value.abs()))
    }

    /// The end of the longest part of a step that makes the error smaller, or of the whole step,
    /// and the error there.
    fn stepped(&self, (forces, error): &([S; K], S), kind: Step) -> ([S; K], S) {
        let (slopes, errors) = (self.slopes(forces), self.errors(forces));
        let step = match kind {
            Step::Newton => nearest(&damped(slopes, S::from_f64(DAMPING) * S::epsilon().sqrt()), &errors, K),
            Step::Short => {
                let (slopes, errors) = normal(&slopes, &errors);
                regular(&damped(slopes, *error / self.scale(forces)), &errors)
            }
        };
        let reached = |part: S| {
            let end = array::from_fn(|k| step[k].multiply_add(part, forces[k]));
            (end, size(&self.errors(&end)))
        };
        let halves = (0..MOST_HALVINGS).map(|halvings| reached(S::from_f64(0.5).powi(halvings)));
        { halves }.find(|(_, least)| least < error).unwrap_or_else(|| reached(S::ONE))
    }

    /// Targets less reactions.
    fn errors(&self, forces: &[S; K]) -> [S; K] {
        let mut errors = [S::ZERO; K];
        for k in (0..K).filter(|&k| self.choices[k] != Choice::Across) {
            let [first, second] = self.target(forces, k);
            errors[k] = first - forces[k];
            if self.is_planar(k) {
                errors[k + 1] = second - forces[k + 1];
            }
        }
        errors
    }

    fn target(&self, forces: &[S; K], k: usize) -> [S; 2] {
        match self.piece(forces, k) {
            TargetPiece::Absent => [S::ZERO; 2],
            TargetPiece::Holds => self.pull(forces, k),
            TargetPiece::Limited { direction, radius, .. } => direction.map(|component| radius * component),
        }
    }

    fn piece(&self, forces: &[S; K], k: usize) -> TargetPiece<S> {
        let known = |component: S| {
            let limit = self.limit(forces, k, self.balance.limit(k));
            TargetPiece::Limited { direction: [-component, S::ZERO], radius: limit, turning: S::ZERO }
        };
        match self.choices[k] {
            Choice::Only(Rule::Absent) | Choice::Across => TargetPiece::Absent,
            Choice::Only(Rule::Holds) => TargetPiece::Holds,
            Choice::Only(Rule::Slips(component)) => known(component * self.side(forces, k)),
            Choice::Only(Rule::Smooth) => known(S::ONE),
            Choice::Touch if self.pull(forces, k)[0] > S::ZERO => TargetPiece::Holds,
            Choice::Touch => TargetPiece::Absent,
            Choice::Rest | Choice::GiveWay => self.friction(forces, k),
        }
    }

    /// The piece of friction that holds or slips.
    fn friction(&self, forces: &[S; K], k: usize) -> TargetPiece<S> {
        let pull = self.pull(forces, k);
        let size = length(&pull);
        let radius = self.limit(forces, k, self.balance.limit(k)).abs();
        let fixed = self.limit(forces, k, self.balance.static_limit(k)).abs().max(radius);
        if self.choices[k] == Choice::Rest && size <= fixed {
            return TargetPiece::Holds;
        }
        if size == S::ZERO {
            return TargetPiece::Absent;
        }
        let turning = if self.is_planar(k) { (radius / size).min(S::ONE) } else { S::ZERO };
        TargetPiece::Limited { direction: pull.map(|component| component / size), radius, turning }
    }

    /// d
    fn pull(&self, forces: &[S; K], k: usize) -> [S; 2] {
        let own = |k: usize| forces[k] - self.offsets[k] - dot(&self.matrix[k], forces);
        [own(k), if self.is_planar(k) { own(k + 1) } else { S::ZERO }]
    }

    /// A limit of friction k, given without reactions and by its slopes.
    fn limit(&self, forces: &[S; K], k: usize, (free, slopes): (S, &[S; K])) -> S {
        let mut limit = free;
        for j in (0..K).filter(|&j| slopes[j] != S::ZERO) {
            let pressing = match self.choices[j] {
                Choice::Touch => self.pull(forces, j)[0].max(S::ZERO),
                _ => forces[j],
            };
            limit = limit + slopes[j] * pressing / self.units[j];
        }
        self.units[k] * limit
    }

    /// The sign of the kinetic limit, which counts by its size.
    fn side(&self, forces: &[S; K], k: usize) -> S {
        let is_reversed = self.limit(forces, k, self.balance.limit(k)) < S::ZERO;
        if is_reversed { -S::ONE } else { S::ONE }
    }

    /// Derivatives of reactions less targets.
    fn slopes(&self, forces: &[S; K]) -> [[S; K]; K] {
        let mut slopes = [[S::ZERO; K]; K];
        for k in (0..K).filter(|&k| self.choices[k] != Choice::Across) {
            let components = if self.is_planar(k) { 2 } else { 1 };
            for component in 0..components {
                let target = self.slope(forces, k, component);
                slopes[k + component] = target.map(|slope| -slope);
                slopes[k + component][k + component] = slopes[k + component][k + component] + S::ONE;
            }
        }
        slopes
    }

    /// Derivative of a component of a target.
    fn slope(&self, forces: &[S; K], k: usize, component: usize) -> [S; K] {
        match self.piece(forces, k) {
            TargetPiece::Absent => [S::ZERO; K],
            TargetPiece::Holds => self.pull_slope(k + component),
            TargetPiece::Limited { direction, turning, .. } => {
                let mut slope = self.limit_slope(forces, k).map(|slope| direction[component] * slope);
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

    /// Derivative of one component of d.
    fn pull_slope(&self, k: usize) -> [S; K] {
        let mut slope = self.matrix[k].map(|entry| -entry);
        slope[k] = slope[k] + S::ONE;
        slope
    }

    /// Derivative of the kinetic limit of friction k, by size where its direction is free.
    fn limit_slope(&self, forces: &[S; K], k: usize) -> [S; K] {
        let (_, slopes) = self.balance.limit(k);
        let is_free = matches!(self.choices[k], Choice::Rest | Choice::GiveWay);
        let side = if is_free { self.side(forces, k) } else { S::ONE };
        let mut total = [S::ZERO; K];
        for j in (0..K).filter(|&j| slopes[j] != S::ZERO) {
            let share = side * slopes[j] * self.units[k] / self.units[j];
            match self.choices[j] {
                Choice::Touch if self.pull(forces, j)[0] > S::ZERO => {
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

/// The size of a vector; infinite if it holds something that is not finite.
fn size<S: Scalar, const K: usize>(vector: &[S; K]) -> S {
    let square = dot(vector, vector);
    if square.is_finite() { square.sqrt() } else { S::ONE / S::ZERO }
}

/// A with this added to its diagonal.
fn damped<S: Scalar, const K: usize>(mut a: [[S; K]; K], damping: S) -> [[S; K]; K] {
    for (k, row) in a.iter_mut().enumerate() {
        row[k] = row[k] + damping;
    }
    a
}

/// The normal equations of A x = b.
fn normal<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K]) -> ([[S; K]; K], [S; K]) {
    let columns: [[S; K]; K] = array::from_fn(|k| array::from_fn(|row| a[row][k]));
    let matrix = array::from_fn(|k| array::from_fn(|j| dot(&columns[k], &columns[j])));
    (matrix, array::from_fn(|k| dot(&columns[k], b)))
}
