//! Whether a step is longer than stability allows.
//!
//! An explicit method grows without bound along an eigenvector of the Jacobian whose eigenvalue λ has h |λ| beyond a
//! limit of the method. How much rates differ between two stages hints at it for nothing, but mistakes differences of
//! scale between the components for stiffness; only after a hint is the largest eigenvalue computed, by power iteration
//! with differences of rates. Two multiplications at a time, so that the coordinates and velocities of an oscillation
//! may be of different sizes. Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §IV.2; Golub, Van
//! Loan, *Matrix Computations*, §7.3.

use crate::constraint::inner;
use crate::scalar::Scalar;
use crate::system::StateVector;

/// Pairs of multiplications with the Jacobian: the estimate errs by some per cent where two eigenvalues are close.
const ITERATIONS: u32 = 4;
/// The differences of states from which the Jacobian is found are this part of the change of a step.
const PART: f64 = 1e-3;
/// What a look costs.
pub(super) const EVALUATIONS: u64 = 1 + 2 * ITERATIONS as u64;
/// After hints that came to nothing, no more steps than this pass without another look.
const LONGEST_WAIT: u32 = 31;

/// Decides when hints are followed.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Watch {
    /// Steps until hints count again.
    wait: u32,
    /// How long the last wait was.
    waited: u32,
}

impl Watch {
    /// Whether to look, given this hint.
    #[inline]
    pub(super) fn follows(&mut self, is_hint: bool) -> bool {
        if self.wait > 0 {
            self.wait -= 1;
            return false;
        }
        if is_hint {
            self.waited = LONGEST_WAIT.min(2 * self.waited + 1);
            self.wait = self.waited;
        } else {
            self.waited = self.waited.saturating_sub(1);
        }
        is_hint
    }
}

/// The magnitude of the largest eigenvalue of ∂`rates`/∂y at `y`, unless the motion grows along it as that of an
/// upright pendulum does, which is no matter of the method; NaN if it cannot be told.
///
/// The iteration starts in `direction` with differences that are a small part of `change`, the change of a step, so that
/// they are felt as far as the step is and no farther.
#[cold]
pub(super) fn largest_eigenvalue<S: Scalar, Y: StateVector<S>>(
    mut rates: impl FnMut(&Y) -> Y,
    y: &Y,
    change: S,
    direction: &Y,
) -> S {
    let size = S::from_f64(PART) * if change > S::ZERO { change } else { length(direction) };
    let at = rates(y);
    let mut times_jacobian = |w: &Y| combined(&rates(&combined(y, S::ONE, w)), -S::ONE, &at);
    let mut w = scaled(direction, size);
    let (mut square, mut grows) = (S::ZERO, false);
    for _ in 0..ITERATIONS {
        let once = times_jacobian(&w);
        let first = scaled(&once, size);
        let twice = times_jacobian(&first);
        square = (length(&once) / size) * (length(&twice) / size);
        let turned = inner(&w, &twice) <= S::ZERO || inner(&w, &first) < -inner(&w, &w) / S::from_f64(2.0);
        grows = !turned;
        w = scaled(&twice, size);
    }
    if grows { S::ZERO } else { square.sqrt() }
}

/// The sum of magnitudes, which neither overflows nor underflows where the components do not.
#[inline]
pub(super) fn length<S: Scalar, Y: StateVector<S>>(y: &Y) -> S {
    y.as_ref().iter().fold(S::ZERO, |sum, component| sum + component.abs())
}

/// The length of the difference.
#[inline]
pub(super) fn distance<S: Scalar, Y: StateVector<S>>(a: &Y, b: &Y) -> S {
    a.as_ref().iter().zip(b.as_ref()).fold(S::ZERO, |sum, (a, b)| sum + (*a - *b).abs())
}

/// The vector of this length in the direction of `y`.
fn scaled<S: Scalar, Y: StateVector<S>>(y: &Y, size: S) -> Y {
    combined(&Y::ZERO, size / length(y), y)
}

/// a + c b
#[inline]
pub(super) fn combined<S: Scalar, Y: StateVector<S>>(a: &Y, c: S, b: &Y) -> Y {
    let mut sum = *a;
    for (a, b) in sum.as_mut().iter_mut().zip(b.as_ref()) {
        *a = b.multiply_add(c, *a);
    }
    sum
}

#[cfg(test)]
mod tests;
