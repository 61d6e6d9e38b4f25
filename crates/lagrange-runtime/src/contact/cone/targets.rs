//! The targets of reactions, and the pieces of which they consist.

use core::ops::Range;

use super::{Cone, ForcePoint};
use crate::contact::LimitSlope;
use crate::contact::choice::{Choice, Rule};
use crate::contact::slip::length;
use crate::scalar::Scalar;

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
            let [first, second] = self.target(at, k);
            errors[k] = first - at.forces[k];
            if self.is_planar(k) {
                errors[k + 1] = second - at.forces[k + 1];
            }
        }
        errors
    }

    pub(super) fn target(&self, at: &ForcePoint<S, K>, k: usize) -> [S; 2] {
        match self.piece(at, k) {
            TargetPiece::Absent => [S::ZERO; 2],
            TargetPiece::Holds => self.pull(at, k),
            TargetPiece::Limited { direction, radius, .. } => direction.map(|component| radius * component),
        }
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
    pub(super) fn pull(&self, at: &ForcePoint<S, K>, k: usize) -> [S; 2] {
        [at.pulls[k], if self.is_planar(k) { at.pulls[k + 1] } else { S::ZERO }]
    }

    /// Returns the slopes of the limits of friction k, with the places of reactions that may act.
    pub(super) fn slopes_of(&self, k: usize) -> impl Iterator<Item = (usize, &LimitSlope<S>)> {
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
    pub(super) fn shares(&self, at: &ForcePoint<S, K>, k: usize) -> impl Iterator<Item = (usize, S)> {
        let is_free = matches!(self.choices[k], Choice::Rest | Choice::GiveWay);
        let side = if is_free { self.side(at, k) } else { S::ONE };
        let presses = |j: usize| self.choices[j] != Choice::Touch || self.pull(at, j)[0] > S::ZERO;
        let slopes = self.slopes_of(k).filter(move |(j, slope)| slope.kinetic != S::ZERO && presses(*j));
        slopes.map(move |(j, slope)| (j, side * slope.kinetic * self.units[k] / self.units[j]))
    }
}
