//! The targets of reactions, the pieces of which they consist, and smooth approximations of them.
//!
//! With the smoothing ε, max(d, 0) is (d + √(d² + ε²))/2, and |d| is √(|d|² + ε²). Friction within
//! the limit R has the target d R/(R + max(|d| − R, 0)), which needs no case.

use core::ops::Range;

use super::{Cone, ForcePoint};
use crate::contact::LimitSlope;
use crate::contact::choice::{Choice, Rule};
use crate::contact::slip::length;
use crate::scalar::{Number, Scalar};

/// The piece of the target of a reaction, or of both components of a reaction in a plane.
#[derive(Clone, Copy)]
pub(super) enum TargetPiece<S> {
    /// Zero.
    Absent,
    /// d
    Holds,
    /// `radius` along `direction`. `turning` is the derivative of the direction with respect to d
    /// across it; zero if the direction is known.
    Limited { direction: [S; 2], radius: S, turning: S },
}

/// The target of a reaction, or of both components of a reaction in a plane, and its derivatives.
#[derive(Clone, Copy)]
pub(super) struct Target<S> {
    pub(super) value: [S; 2],
    pub(super) direction: [S; 2],
    /// Derivatives with respect to d along the direction and across it.
    pub(super) along: S,
    pub(super) across: S,
    /// Derivative along the direction with respect to the limit.
    pub(super) limited: S,
}

impl<S: Scalar> Target<S> {
    /// Returns the target whose derivative is this share of the change of d.
    fn proportional(value: [S; 2], share: S) -> Self {
        Target { value, direction: [S::ONE, S::ZERO], along: share, across: share, limited: S::ZERO }
    }

    /// Returns the share of the change of d by which the target changes, if there is one.
    pub(super) fn share(&self) -> Option<S> {
        (self.along == self.across && self.limited == S::ZERO).then_some(self.along)
    }
}

impl<S: Scalar, const N: usize, const K: usize, const D: usize> Cone<'_, S, N, K, D> {
    pub(super) fn is_planar(&self, k: usize) -> bool {
        self.choices.get(k + 1) == Some(&Choice::Across)
    }

    /// Returns the places of the components of a reaction.
    pub(super) fn components(&self, k: usize) -> Range<usize> {
        if self.is_planar(k) { k..k + 2 } else { k..k + 1 }
    }

    /// Computes the targets minus the reactions.
    pub(super) fn errors(&self, at: &ForcePoint<S, K>) -> [S; K] {
        let mut errors = [S::ZERO; K];
        for k in (0..self.count).filter(|&k| self.choices[k] != Choice::Across) {
            let [first, second] = self.target(at, k).value;
            errors[k] = first - at.forces[k];
            if self.is_planar(k) {
                errors[k + 1] = second - at.forces[k + 1];
            }
        }
        errors
    }

    pub(super) fn target(&self, at: &ForcePoint<S, K>, k: usize) -> Target<S> {
        match self.choices[k] {
            Choice::Touch if self.smoothing > S::ZERO => {
                let (value, share) = self.positive(at.pulls[k]);
                Target::proportional([value, S::ZERO], share)
            }
            Choice::Rest | Choice::GiveWay if self.smoothing > S::ZERO => self.smooth_friction(at, k),
            _ => self.sharp(at, k),
        }
    }

    /// Returns the target without smoothing.
    fn sharp(&self, at: &ForcePoint<S, K>, k: usize) -> Target<S> {
        match self.piece(at, k) {
            TargetPiece::Absent => Target::proportional([S::ZERO; 2], S::ZERO),
            TargetPiece::Holds => Target::proportional(self.pull(at, k), S::ONE),
            TargetPiece::Limited { direction, radius, turning } => Target {
                value: direction.map(|component| radius * component),
                direction,
                along: S::ZERO,
                across: turning,
                limited: S::ONE,
            },
        }
    }

    /// Returns the smooth target of friction k.
    fn smooth_friction(&self, at: &ForcePoint<S, K>, k: usize) -> Target<S> {
        let pull = self.pull(at, k);
        let (length, size) = (length(&pull), length(&[length(&pull), self.smoothing]));
        let radius = self.radius(at, k, size);
        let (beyond, slope) = match self.choices[k] {
            Choice::Rest => self.positive(size - radius),
            _ => (size - radius, S::ONE),
        };
        let whole = radius + beyond;
        let across = (radius / whole).min(S::ONE);
        let direction = match length > S::ZERO {
            true => pull.map(|component| component / length),
            false => [S::ONE, S::ZERO],
        };
        Target {
            value: pull.map(|component| component * across),
            direction,
            along: across - radius * slope * length * length / (size * whole * whole),
            across,
            limited: length * (whole - radius * (S::ONE - slope)) / (whole * whole),
        }
    }

    /// Returns the positive part of a number, smoothed, and its derivative.
    fn positive(&self, number: S) -> (S, S) {
        if self.smoothing == S::ZERO {
            return if number > S::ZERO { (number, S::ONE) } else { (S::ZERO, S::ZERO) };
        }
        let half = S::from_f64(0.5);
        let size = length(&[number, self.smoothing]);
        (half * (number + size), half * (S::ONE + number / size))
    }

    pub(super) fn piece(&self, at: &ForcePoint<S, K>, k: usize) -> TargetPiece<S> {
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
        let radius = self.radius(at, k, size);
        if self.choices[k] == Choice::Rest && size <= radius {
            return TargetPiece::Holds;
        }
        if size == S::ZERO {
            return TargetPiece::Absent;
        }
        let turning = if self.is_planar(k) { (radius / size).min(S::ONE) } else { S::ZERO };
        TargetPiece::Limited { direction: pull.map(|component| component / size), radius, turning }
    }

    /// Returns the limit of friction k if d has this size: the static one while it may hold.
    fn radius(&self, at: &ForcePoint<S, K>, k: usize, size: S) -> S {
        let [kinetic, fixed] = self.limits(at, k).map(Number::abs);
        if self.choices[k] == Choice::Rest && size <= fixed.max(kinetic) {
            fixed.max(kinetic)
        } else {
            kinetic
        }
    }

    /// Returns d.
    pub(super) fn pull(&self, at: &ForcePoint<S, K>, k: usize) -> [S; 2] {
        [at.pulls[k], if self.is_planar(k) { at.pulls[k + 1] } else { S::ZERO }]
    }

    /// Returns the slopes of the limits of friction k, with the places of reactions that may act.
    pub(super) fn slopes_of(&self, k: usize) -> impl Iterator<Item = (usize, &LimitSlope<S>)> {
        let slopes = self.law.slopes(self.active[k]).iter();
        slopes.map(|slope| (self.places[slope.reaction], slope)).filter(|(place, _)| *place < K)
    }

    /// Computes the kinetic and the static limit of friction k from their values without reactions
    /// and their slopes.
    fn limits(&self, at: &ForcePoint<S, K>, k: usize) -> [S; 2] {
        let reaction = self.active[k];
        let free = [self.law.kinetic(reaction), self.law.fixed(reaction)];
        let limits = self.slopes_of(k).fold(free, |[kinetic, fixed], (j, slope)| {
            let pressing = match self.choices[j] {
                Choice::Touch => self.positive(at.pulls[j]).0,
                _ => at.forces[j],
            };
            let pressing = pressing / self.units[j];
            [slope.kinetic.multiply_add(pressing, kinetic), slope.fixed.multiply_add(pressing, fixed)]
        });
        limits.map(|limit| self.units[k] * limit)
    }

    /// Computes the kinetic limit of friction k.
    fn kinetic(&self, at: &ForcePoint<S, K>, k: usize) -> S {
        self.limits(at, k)[0]
    }

    /// Returns the sign of the kinetic limit, whose absolute value is the radius.
    fn side(&self, at: &ForcePoint<S, K>, k: usize) -> S {
        let is_reversed = self.kinetic(at, k) < S::ZERO;
        if is_reversed { -S::ONE } else { S::ONE }
    }

    /// Returns the derivatives of the kinetic limit of friction k, or of its absolute value if the
    /// direction is free, with their places. They refer to d of contacts that press, and to forces
    /// of others.
    pub(super) fn shares(&self, at: &ForcePoint<S, K>, k: usize) -> impl Iterator<Item = (usize, S)> {
        let is_free = matches!(self.choices[k], Choice::Rest | Choice::GiveWay);
        let side = if is_free { self.side(at, k) } else { S::ONE };
        let pressing = |j: usize| match self.choices[j] {
            Choice::Touch => self.positive(at.pulls[j]).1,
            _ => S::ONE,
        };
        let shares = self.slopes_of(k).map(move |(j, slope)| (j, slope.kinetic * pressing(j)));
        let acting = shares.filter(|(_, share)| *share != S::ZERO);
        acting.map(move |(j, share)| (j, side * share * self.units[k] / self.units[j]))
    }
}
