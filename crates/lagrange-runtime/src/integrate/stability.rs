//! The stability limit of explicit steps.
//!
//! An explicit method grows without bound along an eigenvector of the Jacobian whose eigenvalue λ
//! has h |λ| beyond a limit of the method. The difference of rates between two stages hints at it
//! without extra evaluations, but mistakes differences of scale between the components for
//! stiffness. Only after a hint is the largest eigenvalue computed, by power iteration with
//! differences of rates. Its last powers give the two eigenvalues of an oscillation together.
//! Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §IV.2; Golub, Van Loan, *Matrix
//! Computations*, §7.3.

use crate::linalg::vector::{combined, l1_norm, scaled};
use crate::scalar::Scalar;
use crate::system::StateVector;

/// Multiplications with the Jacobian: the estimate errs by some per cent where more than two
/// eigenvalues are close.
const MULTIPLICATIONS: u32 = 8;
/// The differences of states from which the Jacobian is found are this part of the change of a
/// step.
const PART: f64 = 1e-3;
/// A second eigenvalue that shows in the powers by less than this does not count beside the first.
const SINGLE: f64 = 1e-4;
/// Number of evaluations per check.
pub(super) const EVALUATIONS: u64 = 1 + MULTIPLICATIONS as u64;
/// After hints that came to nothing, no more steps than this pass without another look.
const LONGEST_WAIT: u32 = 31;

/// Decides when hints are followed.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Watch {
    /// Steps until hints count again.
    wait: u32,
    /// Length of the last wait.
    waited: u32,
}

impl Watch {
    /// True if to look, given this hint.
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

    /// True if it remembers hints.
    #[inline]
    pub(super) fn is_awake(&self) -> bool {
        self.wait > 0 || self.waited > 0
    }
}

/// Computes the magnitude of the largest eigenvalue of ∂`rates`/∂y at `y`. It is ignored if the
/// motion grows along it, as that of an upright pendulum does, independent of the method. NaN if it
/// cannot be determined.
///
/// The iteration starts in `direction`. Its differences are a small part of `change`, the change of
/// a step, so that they reach as far as the step and no farther.
#[cold]
pub(super) fn largest_eigenvalue<S: Scalar, Y: StateVector<S>>(
    mut rates: impl FnMut(&Y) -> Y,
    y: &Y,
    change: S,
    direction: &Y,
) -> S {
    let size = S::from_f64(PART) * if change > S::ZERO { change } else { l1_norm(direction) };
    let at = rates(y);
    let mut times_jacobian = |w: &Y| combined(&rates(&combined(y, S::ONE, w)), -S::ONE, &at);
    let mut w = scaled(direction, size);
    let mut powers = [Power { vector: w, factor: S::ONE }; 3];
    for _ in 1..MULTIPLICATIONS {
        let next = times_jacobian(&w);
        w = scaled(&next, size);
        powers = [powers[1], powers[2], Power { vector: w, factor: l1_norm(&next) / size }];
    }
    let found = dominant(&powers, &times_jacobian(&w));
    if found.grows { S::ZERO } else { found.magnitude }
}

/// Estimates the eigenvalue with differences as small as rounding allows, independent of any step;
/// `None` if nothing moves.
#[cold]
pub(super) fn eigenvalue_at<S: Scalar, Y: StateVector<S>>(
    mut rates: impl FnMut(&Y) -> Y,
    y: &Y,
) -> Option<S> {
    let root = S::epsilon().sqrt();
    let size = root * if l1_norm(y) > S::ZERO { l1_norm(y) } else { S::ONE };
    let at = rates(y);
    let bent = rates(&combined(y, S::ONE, &scaled(&at, size)));
    let direction = combined(&bent, -S::ONE, &at);
    let found = largest_eigenvalue(rates, y, size / S::from_f64(PART), &direction);
    (found > S::ZERO).then_some(found)
}

/// The direction of a vector that was multiplied by the Jacobian, and by how much that made it
/// longer.
#[derive(Clone, Copy, Debug)]
struct Power<S, Y> {
    vector: Y,
    factor: S,
}

/// An eigenvalue of the largest magnitude.
#[derive(Clone, Copy, Debug)]
struct Dominant<S> {
    magnitude: S,
    /// True if its real part is positive and larger than its imaginary part.
    grows: bool,
}

/// The dominant eigenvalue, given successive powers of the Jacobian on a vector and what it makes
/// of the last of these.
///
/// A conjugate pair turns vectors in a plane and stretches them differently there, according to the
/// units of the components. However, any component z of the powers follows zₖ₊₂ = 2a zₖ₊₁ − b zₖ,
/// where a ± √(a² − b) are the two dominant eigenvalues. Four values determine a and b; the largest
/// component is used. The determinant z₁² − z₀z₂ is the same in every phase of an oscillation and
/// vanishes if there is a single eigenvalue, z₃/z₂. Source: Wilkinson, *The Algebraic Eigenvalue
/// Problem*, ch. 9, §§ 12–14.
fn dominant<S: Scalar, Y: StateVector<S>>(
    [first, second, third]: &[Power<S, Y>; 3],
    last: &Y,
) -> Dominant<S> {
    let long = l1_norm(last) / l1_norm(&third.vector);
    let size = |k: usize| third.vector.as_ref()[k].abs().multiply_add(long, last.as_ref()[k].abs());
    let largest = (0..last.as_ref().len()).fold(0, |best, k| if size(k) > size(best) { k } else { best });
    let at = |y: &Y| y.as_ref()[largest];
    let (z0, z1) = (at(&first.vector), second.factor * at(&second.vector));
    let scale = second.factor * third.factor;
    let (z2, z3) = (scale * at(&third.vector), scale * at(last));
    let determinant = z1 * z1 - z0 * z2;
    if determinant.abs() <= S::from_f64(SINGLE) * (z1 * z1).max((z0 * z2).abs()) {
        let stretch = z3 / z2;
        return Dominant { magnitude: stretch.abs(), grows: stretch > S::ZERO };
    }
    let a = (z1 * z2 - z0 * z3) / determinant / S::from_f64(2.0);
    let b = (z2 * z2 - z1 * z3) / determinant;
    let discriminant = a * a - b;
    if discriminant < S::ZERO {
        return Dominant { magnitude: b.sqrt(), grows: a > S::ZERO && a * a > -discriminant };
    }
    let root = if a < S::ZERO { a - discriminant.sqrt() } else { a + discriminant.sqrt() };
    Dominant { magnitude: root.abs(), grows: root > S::ZERO }
}

#[cfg(test)]
mod tests;
