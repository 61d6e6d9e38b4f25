//! The stability limit of explicit steps.
//!
//! The result of an explicit method grows without bound along an eigenvector of the Jacobian if h
//! |λ| exceeds a limit of the method. The difference of rates between two stages indicates this
//! without extra evaluations, but may confuse differences of scale between components with
//! stiffness. Only after such a hint is the largest eigenvalue computed, by power iteration with
//! differences of rates. The last powers yield both eigenvalues of an oscillation. Source: Hairer,
//! Wanner, *Solving Ordinary Differential Equations II*, §IV.2; Golub, Van Loan, *Matrix
//! Computations*, §7.3.

use crate::linalg::vector::{combined, l1_norm, scaled};
use crate::scalar::Scalar;
use crate::system::StateVector;

/// Number of multiplications by the Jacobian. The estimate is inaccurate by a few per cent if more
/// than two eigenvalues are close.
const MULTIPLICATIONS: u32 = 8;
/// Size of the differences of states for the Jacobian, relative to the change in a step.
const PART: f64 = 1e-3;
/// Relative contribution to the powers below which a second eigenvalue is ignored.
const SINGLE: f64 = 1e-4;
/// Number of evaluations per check.
pub(super) const EVALUATIONS: u64 = 1 + MULTIPLICATIONS as u64;
/// Maximum number of steps without another check after hints that were not confirmed.
const LONGEST_WAIT: u32 = 31;

/// Decides whether hints are followed up.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Watch {
    /// Number of steps until hints count again.
    wait: u32,
    /// Length of the last wait.
    waited: u32,
}

impl Watch {
    /// True if a check is due, given this hint.
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

    /// True if there were recent hints.
    #[inline]
    pub(super) fn is_awake(&self) -> bool {
        self.wait > 0 || self.waited > 0
    }
}

/// Computes the magnitude of the largest eigenvalue of ∂`rates`/∂y at `y`. It is ignored if the
/// motion itself grows along it, as for an upright pendulum, independent of the method. NaN if it
/// cannot be determined.
///
/// The iteration starts in `direction`. Its differences are a small fraction of `change`, the
/// change in a step, so that they do not extend beyond the step.
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

/// The direction of a vector after multiplication by the Jacobian, and the ratio of its lengths.
#[derive(Clone, Copy, Debug)]
struct Power<S, Y> {
    vector: Y,
    factor: S,
}

/// An eigenvalue with the largest magnitude.
#[derive(Clone, Copy, Debug)]
struct Dominant<S> {
    magnitude: S,
    /// True if its real part is positive and larger than its imaginary part.
    grows: bool,
}

/// Computes the dominant eigenvalue from successive powers of the Jacobian applied to a vector, and
/// from the product of the Jacobian and the last power.
///
/// A conjugate pair rotates vectors in a plane and stretches them differently there, depending on
/// the units of the components. However, any component z of the powers follows zₖ₊₂ = 2a zₖ₊₁ − b
/// zₖ, where a ± √(a² − b) are the two dominant eigenvalues. Four values determine a and b; the
/// largest component is used. The determinant z₁² − z₀z₂ is the same in every phase of an
/// oscillation and vanishes if there is a single eigenvalue, z₃/z₂. Source: Wilkinson, *The
/// Algebraic Eigenvalue Problem*, ch. 9, §§ 12–14.
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
