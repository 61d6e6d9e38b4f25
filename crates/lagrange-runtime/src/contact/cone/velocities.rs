//! Steps of Newton's method in the space of velocities, for many reactions.
//!
//! With the rows J and responses W of the reactions, G = J W is never formed. Let A be the
//! derivative of r − target with respect to r for constant velocities, and P that of the target
//! with respect to d. A step δ changes the velocities by x = W δ and obeys
//!
//! ```text
//! A δ + P J x = target − r.
//! ```
//!
//! A couples a friction only to the reactions on which its limit depends. These come before it.
//! Hence δ = y − Z x follows row by row, and (1 + W Z) x = W y has the size of the velocities. A
//! reaction that is held has a zero in A, which damping replaces. Constraint forces in limits
//! depend on reactions that follow; this part of the derivative is omitted. Source: Woodbury's
//! identity, as in Todorov, "Convex and analytically-invertible dynamics with contacts and
//! constraints", *ICRA* (2014) 6054–6061.
//!
//! # A held reaction in numbers
//!
//! A mass of 1 with the velocity −3 is held: J = W = 1, P = 1. With the damping 0.01, y = 3/0.01
//! and Z = 1/0.01. Then x = 300/101, and the step is 300 − 100 x = 2.97: an error of 1 % remains,
//! and the next step removes 99 % of it.

use core::array;

use super::{Cone, ForcePoint, TargetPiece};
use crate::contact::choice::Choice;
use crate::linalg::singular::regular;
use crate::linalg::vector::{add, combined, dot};
use crate::scalar::Scalar;

/// A step of a reaction as a function of the change x of the velocities: `fixed` − `slope`·x.
#[derive(Clone, Copy)]
struct Affine<S, const N: usize> {
    fixed: S,
    slope: [S; N],
}

impl<S: Scalar, const N: usize> Affine<S, N> {
    fn times(&self, factor: S) -> Self {
        Affine { fixed: self.fixed * factor, slope: self.slope.map(|entry| entry * factor) }
    }

    fn plus(&self, other: &Self) -> Self {
        Affine { fixed: self.fixed + other.fixed, slope: combined(&self.slope, S::ONE, &other.slope) }
    }
}

impl<S: Scalar, const N: usize, const K: usize, const D: usize> Cone<'_, S, N, K, D> {
    /// Returns the velocities due to these reactions.
    pub(super) fn velocities(&self, forces: &[S; K]) -> [S; N] {
        let mut velocities = [S::ZERO; N];
        for k in (0..self.count).filter(|&k| forces[k] != S::ZERO) {
            self.kick(&mut velocities, k, forces[k]);
        }
        velocities
    }

    /// Adds the velocities due to a reaction.
    pub(super) fn kick(&self, velocities: &mut [S; N], k: usize, force: S) {
        add(velocities, force / self.units[k], &self.law.terms.responses[self.active[k]]);
    }

    /// Returns rate k at these velocities.
    pub(super) fn rate(&self, k: usize, velocities: &[S; N]) -> S {
        dot(&self.law.terms.rows[self.active[k]], velocities) / self.units[k]
    }

    /// Computes d of friction or contact k, and of the reactions that its limit depends on, at the
    /// velocities due to all reactions.
    pub(super) fn refresh(&self, at: &mut ForcePoint<S, K>, k: usize, velocities: &[S; N]) {
        let own = if self.is_planar(k) { [k, k + 1] } else { [k, k] };
        for k in self.slopes_of(k).map(|(place, _)| place).chain(own) {
            at.pulls[k] = at.forces[k] - self.offsets[k] - self.rate(k, velocities);
        }
    }

    /// Returns a step of Newton's method with this damping.
    pub(super) fn step_of_velocities(&self, at: &ForcePoint<S, K>, damping: S) -> [S; K] {
        let errors = self.errors(at);
        let mut steps = [Affine { fixed: S::ZERO, slope: [S::ZERO; N] }; K];
        let (mut columns, mut right) = ([[S::ZERO; N]; N], [S::ZERO; N]);
        for (i, column) in columns.iter_mut().enumerate() {
            column[i] = S::ONE;
        }
        for k in 0..self.count {
            if self.choices[k] != Choice::Across {
                let found = self.affine_steps(at, &errors, &steps, k, damping);
                let components = if self.is_planar(k) { 2 } else { 1 };
                steps[k..k + components].copy_from_slice(&found[..components]);
            }
            let (step, response) = (&steps[k], &self.law.terms.responses[self.active[k]]);
            self.kick(&mut right, k, step.fixed);
            // Slopes are sparse: rates depend on the velocities between the contact and the ground.
            for (column, slope) in columns.iter_mut().zip(&step.slope).filter(|(_, slope)| **slope != S::ZERO)
            {
                add(column, *slope / self.units[k], response);
            }
        }
        let matrix = array::from_fn(|i| array::from_fn(|j| columns[j][i]));
        let change = regular(&matrix, &right, N);
        array::from_fn(|k| steps[k].fixed - dot(&steps[k].slope, &change))
    }

    /// Returns the steps of both components of reaction k. `before` are those of the reactions
    /// before it.
    fn affine_steps(
        &self,
        at: &ForcePoint<S, K>,
        errors: &[S; K],
        before: &[Affine<S, N>; K],
        k: usize,
        damping: S,
    ) -> [Affine<S, N>; 2] {
        let places = if self.is_planar(k) { [k, k + 1] } else { [k, k] };
        let (free, held) = (S::ONE / (S::ONE + damping), S::ONE / damping);
        match self.piece(at, k) {
            TargetPiece::Absent => places.map(|k| Affine { fixed: errors[k] * free, slope: [S::ZERO; N] }),
            TargetPiece::Holds => {
                places.map(|k| Affine { fixed: errors[k], slope: self.scaled_row(k) }.times(held))
            }
            TargetPiece::Limited { direction, turning, .. } => {
                // The parts of both components along the direction and across it.
                let across = [-direction[1], direction[0]];
                let errors = places.map(|k| errors[k]);
                let rows = places.map(|k| self.scaled_row(k));
                let limit = self.limit_step(at, before, k);
                let along = Affine { fixed: dot(&direction, &errors) + limit.fixed, ..limit }.times(free);
                let slope = array::from_fn(|i| turning * dot(&across, &rows.map(|row| row[i])));
                let turned = Affine { fixed: dot(&across, &errors), slope };
                let turned = turned.times(S::ONE / (S::ONE + damping - turning));
                array::from_fn(|c| along.times(direction[c]).plus(&turned.times(across[c])))
            }
        }
    }

    /// Returns the row of reaction k in the units of the problem.
    fn scaled_row(&self, k: usize) -> [S; N] {
        let unit = S::ONE / self.units[k];
        self.law.terms.rows[self.active[k]].map(|entry| entry * unit)
    }

    /// Returns the step of the kinetic limit of friction k.
    fn limit_step(&self, at: &ForcePoint<S, K>, before: &[Affine<S, N>; K], k: usize) -> Affine<S, N> {
        let mut limit = Affine { fixed: S::ZERO, slope: [S::ZERO; N] };
        for (j, share) in self.shares(at, k).filter(|(j, _)| *j < k) {
            limit.fixed = share.multiply_add(before[j].fixed, limit.fixed);
            add(&mut limit.slope, share, &before[j].slope);
            if self.choices[j] == Choice::Touch {
                add(&mut limit.slope, share / self.units[j], &self.law.terms.rows[self.active[j]]);
            }
        }
        limit
    }
}
