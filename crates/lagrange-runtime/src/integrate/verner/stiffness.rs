//! A hint at steps limited by stability, from two stages at the end of a step.
//!
//! The ratio of the differences of their rates and of their states estimates the largest eigenvalue
//! of the Jacobian. Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §IV.2.

use crate::integrate::stiffness::{Point, StabilityLimit, are_many};
use crate::linalg::vector::{l1_distance, l1_norm};
use crate::scalar::{Number, Scalar};
use crate::system::StateVector;

/// Approximate maximum |h λ| of stable steps: 2.9 on the imaginary axis, 4.4 on the negative real
/// one.
const STABLE: f64 = 2.9;
/// Fraction of the longest stable step above which steps count as limited by stability.
const NEAR: f64 = 0.7;

/// Returns the stability limit of the pair.
pub(super) fn stability<S: Scalar>() -> StabilityLimit<S> {
    StabilityLimit { stable: S::from_f64(STABLE), near: S::from_f64(NEAR) }
}

/// True if a step with these ends is at the stability limit with many others ahead. States whose
/// relative difference is below `rounding` do not count.
#[inline(always)]
pub(super) fn is_at_limit<S: Number, Y: StateVector<S>>(
    (h, ahead): (S, S),
    one: Point<'_, Y>,
    other: Point<'_, Y>,
    rounding: S,
) -> S::Mask {
    let change = l1_distance(one.0, other.0);
    let eigenvalue = l1_distance(one.1, other.1) / change;
    let is_at_limit = S::from_f64(STABLE).less((h * eigenvalue).abs());
    are_many((h, ahead)) & is_at_limit & (rounding * l1_norm(one.0)).less(change)
}
