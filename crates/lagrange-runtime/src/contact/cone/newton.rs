//! Steps of Newton's method from the matrix of responses.

use core::array;

use super::targets::Target;
use super::{Cone, ForcePoint, TriedForces};
use crate::contact::choice::Choice;
use crate::linalg::singular::{nearest, regular};
use crate::scalar::Scalar;

impl<S: Scalar, const N: usize, const K: usize, const D: usize> Cone<'_, S, N, K, D> {
    /// Returns a step of Newton's method with this damping. Undetermined steps are short.
    pub(super) fn newton_step(&self, trial: &TriedForces<S, K>, damping: S) -> [S; K] {
        let (slopes, errors) = (damped(self.slopes(&trial.at), damping), self.leading(&trial.errors));
        self.all(match self.is_of_step {
            true => regular(&slopes, &errors, self.count),
            false => nearest(&slopes, &errors, self.count),
        })
    }

    /// Returns a step of Levenberg's and Marquardt's method with this damping.
    pub(super) fn short_step(&self, trial: &TriedForces<S, K>, damping: S) -> [S; K] {
        let (slopes, errors) = normal(&self.slopes(&trial.at), &self.leading(&trial.errors), self.count);
        self.all(regular(&damped(slopes, damping), &errors, self.count))
    }

    /// Returns the numbers of reactions that may act, followed by zeros.
    fn leading(&self, numbers: &[S; K]) -> [S; D] {
        array::from_fn(|k| if k < self.count { numbers[k] } else { S::ZERO })
    }

    /// Returns numbers of all places.
    fn all(&self, leading: [S; D]) -> [S; K] {
        array::from_fn(|k| if k < self.count { leading[k] } else { S::ZERO })
    }

    /// Computes the derivatives of the reactions minus the targets.
    fn slopes(&self, at: &ForcePoint<S, K>) -> [[S; D]; D] {
        let mut slopes = [[S::ZERO; D]; D];
        for k in (0..self.count).filter(|&k| self.choices[k] != Choice::Across) {
            for component in 0..self.components(k).len() {
                let target = self.slope(at, k, component);
                slopes[k + component] = target.map(|slope| -slope);
                slopes[k + component][k + component] = slopes[k + component][k + component] + S::ONE;
            }
        }
        slopes
    }

    /// Computes the derivative of a component of a target.
    fn slope(&self, at: &ForcePoint<S, K>, k: usize, component: usize) -> [S; D] {
        let target = self.target(at, k);
        match target.share() {
            Some(share) if share == S::ZERO => [S::ZERO; D],
            Some(share) => self.pull_slope(k + component).map(|slope| share * slope),
            None => self.limited_slope(at, k, component, &target),
        }
    }

    /// Computes the derivative of a component of the target of friction k at its limit.
    fn limited_slope(&self, at: &ForcePoint<S, K>, k: usize, component: usize, target: &Target<S>) -> [S; D] {
        let Target { direction, along, across, limited, .. } = *target;
        let own = limited * direction[component];
        let mut slope = self.limit_slope(at, k).map(|slope| own * slope);
        for other in self.components(k).map(|other| other - k) {
            let is_own = if other == component { S::ONE } else { S::ZERO };
            let share = (along - across) * direction[component] * direction[other] + across * is_own;
            if share != S::ZERO {
                let pull = self.pull_slope(k + other);
                slope = array::from_fn(|j| share.multiply_add(pull[j], slope[j]));
            }
        }
        slope
    }

    /// Computes the derivative of one component of d.
    fn pull_slope(&self, k: usize) -> [S; D] {
        let mut slope = self.matrix[k].map(|entry| -entry);
        slope[k] = slope[k] + S::ONE;
        slope
    }

    /// Computes the derivative of the kinetic limit of friction k.
    fn limit_slope(&self, at: &ForcePoint<S, K>, k: usize) -> [S; D] {
        let mut total = [S::ZERO; D];
        for (j, share) in self.shares(at, k) {
            match self.choices[j] {
                Choice::Touch => {
                    let pull = self.pull_slope(j);
                    total = array::from_fn(|i| share.multiply_add(pull[i], total[i]));
                }
                _ => total[j] = total[j] + share,
            }
        }
        total
    }
}

/// Returns the matrix with this value added to its diagonal.
fn damped<S: Scalar, const K: usize>(mut a: [[S; K]; K], damping: S) -> [[S; K]; K] {
    for (k, row) in a.iter_mut().enumerate() {
        row[k] = row[k] + damping;
    }
    a
}

/// Returns the normal equations of the first `count` equations of A x = b.
fn normal<S: Scalar, const K: usize>(a: &[[S; K]; K], b: &[S; K], count: usize) -> ([[S; K]; K], [S; K]) {
    let (mut matrix, mut right) = ([[S::ZERO; K]; K], [S::ZERO; K]);
    for (row, b) in a.iter().zip(b).take(count) {
        for k in 0..count {
            right[k] = row[k].multiply_add(*b, right[k]);
            for j in 0..count {
                matrix[k][j] = row[k].multiply_add(row[j], matrix[k][j]);
            }
        }
    }
    (matrix, right)
}
