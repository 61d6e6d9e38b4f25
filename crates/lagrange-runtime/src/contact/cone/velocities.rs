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

use super::targets::Target;
use super::{Cone, ForcePoint, TriedForces};
use crate::contact::choice::Choice;
use crate::linalg::ordered::solve_in_order;
use crate::linalg::vector::{UNROLLED, add_scaled, dot, inner};
use crate::scalar::Scalar;

/// A step of a reaction as a function of the change x of the velocities: `fixed` − `slope`·x.
#[derive(Clone, Copy)]
struct Affine<S, const N: usize> {
    fixed: S,
    slope: [S; N],
}

impl<S: Scalar, const N: usize> Affine<S, N> {
    const ZERO: Self = Affine { fixed: S::ZERO, slope: [S::ZERO; N] };
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
        let (from, to) = self.range(k);
        add_scaled(&mut velocities[from..to], force / self.units[k], self.response(k));
    }

    /// Returns rate k at these velocities.
    pub(super) fn rate(&self, k: usize, velocities: &[S; N]) -> S {
        let (from, to) = self.range(k);
        inner(self.row(k), &velocities[from..to]) / self.units[k]
    }

    /// Returns a range of velocities outside which all that depends on reaction k is zero.
    fn range(&self, k: usize) -> (usize, usize) {
        if const { N <= UNROLLED } { (0, N) } else { self.spans[k] }
    }

    /// Returns the part of the row of reaction k that is not zero.
    fn row(&self, k: usize) -> &[S] {
        let (from, to) = self.range(k);
        &self.law.rows[self.active[k]][from..to]
    }

    /// Returns the part of the response to reaction k that is not zero.
    fn response(&self, k: usize) -> &[S] {
        let (from, to) = self.range(k);
        &self.law.terms.responses[self.active[k]][from..to]
    }

    /// Returns a step of Newton's method with this damping.
    pub(super) fn step_of_velocities(&self, trial: &TriedForces<S, K>, damping: S) -> [S; K] {
        let mut steps = [Affine::ZERO; K];
        let (mut matrix, mut right) = ([[S::ZERO; N]; N], [S::ZERO; N]);
        for (i, row) in matrix.iter_mut().enumerate() {
            row[i] = S::ONE;
        }
        for k in (0..self.count).filter(|&k| self.choices[k] != Choice::Across) {
            if self.set_steps(trial, &mut steps, k, damping) {
                for k in self.components(k) {
                    self.couple(&mut matrix, &mut right, k, &steps[k]);
                }
            }
        }
        let change = solve_in_order(&matrix, &right);
        let slope = |k: usize| {
            let (from, to) = self.range(k);
            inner(&steps[k].slope[from..to], &change[from..to])
        };
        array::from_fn(|k| if k < self.count { steps[k].fixed - slope(k) } else { S::ZERO })
    }

    /// Adds W Z and W y of reaction k.
    fn couple(&self, matrix: &mut [[S; N]; N], right: &mut [S; N], k: usize, step: &Affine<S, N>) {
        let (from, to) = self.range(k);
        let (factor, slope) = (S::ONE / self.units[k], &step.slope[from..to]);
        let lines = matrix[from..to].iter_mut().zip(&mut right[from..to]);
        let responses = lines.zip(self.response(k)).filter(|(_, response)| **response != S::ZERO);
        for ((line, right), response) in responses {
            let share = *response * factor;
            *right = share.multiply_add(step.fixed, *right);
            add_scaled(&mut line[from..to], share, slope);
        }
    }

    /// Computes the steps of both components of reaction k, after those of the reactions before it.
    /// Returns true if they change velocities.
    fn set_steps(
        &self,
        trial: &TriedForces<S, K>,
        steps: &mut [Affine<S, N>; K],
        k: usize,
        damping: S,
    ) -> bool {
        let target = self.target(&trial.at, k);
        let Some(share) = target.share() else {
            self.set_limited(trial, steps, k, &target, damping);
            return true;
        };
        let factor = S::ONE / (S::ONE - share + damping);
        for k in self.components(k) {
            steps[k].fixed = trial.errors[k] * factor;
            if share != S::ZERO {
                let (from, to) = self.range(k);
                add_scaled(&mut steps[k].slope[from..to], share * factor / self.units[k], self.row(k));
            }
        }
        share != S::ZERO || trial.errors[self.components(k)].iter().any(|error| *error != S::ZERO)
    }

    /// Computes the steps of friction k near its limit: along its direction with d and the limit,
    /// and across it as it turns.
    fn set_limited(
        &self,
        trial: &TriedForces<S, K>,
        steps: &mut [Affine<S, N>; K],
        k: usize,
        target: &Target<S>,
        damping: S,
    ) {
        let limit = self.limit_step(&trial.at, steps, k);
        let Target { direction, along, across, limited, .. } = *target;
        let factors = [along, across].map(|share| S::ONE / (S::ONE - share + damping));
        let normal = [-direction[1], direction[0]];
        let components = self.components(k);
        let other = components.end - 1;
        let errors = [trial.errors[k], trial.errors[other]];
        let ahead = factors[0] * limited.multiply_add(limit.fixed, dot(&direction, &errors));
        let aside = factors[1] * dot(&normal, &errors);
        let shares = [factors[0] * along / self.units[k], factors[1] * across / self.units[k]];
        let (from, to) = self.range(k);
        let rows = self.row(k).iter().zip(self.row(other));
        for (c, step) in steps[components].iter_mut().enumerate() {
            step.fixed = ahead * direction[c] + aside * normal[c];
            let own = factors[0] * limited * direction[c];
            let [first, second] = array::from_fn(|o| {
                shares[0] * direction[c] * direction[o] + shares[1] * normal[c] * normal[o]
            });
            let entries = step.slope[from..to].iter_mut().zip(&limit.slope[from..to]).zip(rows.clone());
            for ((entry, limit), (one, two)) in entries {
                *entry = own * *limit + first * *one + second * *two;
            }
        }
    }

    /// Returns the step of the kinetic limit of friction k.
    fn limit_step(&self, at: &ForcePoint<S, K>, before: &[Affine<S, N>; K], k: usize) -> Affine<S, N> {
        let mut limit = Affine::ZERO;
        for (j, share) in self.shares(at, k).filter(|(j, _)| *j < k) {
            let (from, to) = self.range(j);
            limit.fixed = share.multiply_add(before[j].fixed, limit.fixed);
            add_scaled(&mut limit.slope[from..to], share, &before[j].slope[from..to]);
            if self.choices[j] == Choice::Touch {
                add_scaled(&mut limit.slope[from..to], share / self.units[j], self.row(j));
            }
        }
        limit
    }
}
