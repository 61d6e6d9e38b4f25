//! Starting values for the iterations of an implicit step, by extrapolation of the last step's
//! polynomial.
//!
//! Source: Hairer, Lubich, Wanner, *Geometric Numerical Integration*, §VIII.6.1.

use crate::scalar::Scalar;
use crate::system::StateVector;

/// The weights of the values at the nodes and of one additional value.
type Weights<S, const K: usize> = ([S; K], S);

/// Slopes at the nodes of the last step and at its end, with their extrapolation into the next
/// step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Prediction<S, Y, const K: usize> {
    nodes: [S; K],
    targets: [S; K],
    /// Slopes and length of the last step.
    last: Option<([Y; K], S)>,
    /// For a ratio of the lengths of two steps: weights of the slopes and of the end slope in each
    /// starting value.
    weights: Option<(S, [Weights<S, K>; K])>,
}

impl<S: Scalar, Y: StateVector<S>, const K: usize> Prediction<S, Y, K> {
    /// Creates a prediction without a step. Slopes will be learnt at the nodes and requested at the
    /// targets, both as fractions of a step.
    pub(super) fn new(nodes: [S; K], targets: [S; K]) -> Self {
        Prediction { nodes, targets, last: None, weights: None }
    }

    /// Forgets the last step.
    pub(super) fn forget(&mut self) {
        self.last = None;
    }

    /// Stores the slopes of a step of length `h`.
    pub(super) fn learn(&mut self, slopes: [Y; K], h: S) {
        self.last = Some((slopes, h));
    }

    /// Predicts the slopes of a step of length `h` that begins with the slope `start`.
    #[inline]
    pub(super) fn slopes(&mut self, start: &Y, h: S) -> [Y; K] {
        let Some((slopes, before)) = self.last else {
            return [*start; K];
        };
        let weights = self.weights(h / before);
        weights.map(|(parts, end)| sum(&parts, &slopes, end, start))
    }

    fn weights(&mut self, ratio: S) -> [Weights<S, K>; K] {
        match self.weights {
            Some((known, weights)) if known == ratio => weights,
            _ => {
                let weights = self.targets.map(|node| weights(&self.nodes, S::ONE, S::ONE + node * ratio));
                self.weights = Some((ratio, weights));
                weights
            }
        }
    }
}

/// Returns the weights of the values at the nodes, and of the value at one additional node, in
/// their polynomial at x.
///
/// They follow from Lagrange's formula.
pub(super) fn weights<S: Scalar, const K: usize>(nodes: &[S; K], last: S, x: S) -> Weights<S, K> {
    let mut parts = [S::ONE; K];
    for (i, part) in parts.iter_mut().enumerate() {
        *part = (x - last) / (nodes[i] - last);
        for (j, other) in nodes.iter().enumerate() {
            if i != j {
                *part = *part * (x - *other) / (nodes[i] - *other);
            }
        }
    }
    let end = nodes.iter().fold(S::ONE, |product, node| product * (x - *node) / (last - *node));
    (parts, end)
}

/// Computes Σ part slope + end slope.
#[inline]
pub(super) fn sum<S: Scalar, Y: StateVector<S>, const K: usize>(
    parts: &[S; K],
    slopes: &[Y; K],
    end: S,
    last: &Y,
) -> Y {
    let mut sum = *last;
    for (i, sum) in sum.as_mut().iter_mut().enumerate() {
        *sum = end * *sum;
        for (part, slope) in parts.iter().zip(slopes) {
            *sum = slope.as_ref()[i].multiply_add(*part, *sum);
        }
    }
    sum
}

#[cfg(test)]
mod tests;
