//! Detection of steps limited by stability.
//!
//! Two stages lie at the end of a step. The ratio of the differences of their rates and of their
//! states estimates the largest eigenvalue of the Jacobian. The eigenvalue is computed before a
//! system is rejected. Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §IV.2.

use crate::linalg::vector::{l1_distance, l1_norm};
use crate::scalar::{Number, Scalar};
use crate::system::StateVector;
use crate::tolerance::SAME_STATE;

/// Approximate maximum |h λ| of stable steps: 2.9 on the imaginary axis, 4.4 on the negative real
/// one.
pub(super) const STABLE: f64 = 2.9;
/// Number of steps at the limit after which the system counts as stiff.
const MAX_AT_LIMIT: u32 = 15;
/// Number of consecutive steps below the limit after which the system counts as non-stiff.
const ENOUGH_BELOW: u32 = 6;
/// Number of steps per check while there is no suspicion.
const INTERVAL: u64 = 100;
/// Maximum number of remaining steps for which stiffness is not reported.
const BEARABLE: f64 = 1e4;

/// The observed stability limit.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Stiffness {
    at_limit: u32,
    below: u32,
}

/// Number of steps within which stiffness that doubles or halves counts as temporary.
const PASSING: f64 = 2e3;
/// Number of steps after which an earlier limit is discarded.
const FORGOTTEN: u64 = 20 * MAX_AT_LIMIT as u64;

/// An observed stability limit, as a reference for changes of later ones.
///
/// Friction in a plane rotates a slip velocity s at the rate limit/(m |s|). When the body starts or
/// stops, the stability limit changes from step to step, for a small number of steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fading<S> {
    /// The index of a step, and the longest stable step there.
    first: Option<(u64, S)>,
    last: u64,
}

impl<S: Scalar> Fading<S> {
    /// No observation yet.
    pub(super) const UNKNOWN: Self = Fading { first: None, last: 0 };

    /// True if the longest stable step has changed fast enough since the first observation, or
    /// if this is the first one.
    pub(super) fn is_fading(&mut self, steps: u64, limit: S) -> bool {
        let known = self.first.filter(|_| steps - self.last <= FORGOTTEN);
        self.last = steps;
        let Some((first, narrow)) = known else {
            self.first = Some((steps, limit));
            return true;
        };
        let change = (limit / narrow).max(narrow / limit);
        if change > S::from_f64(2.0) {
            self.first = Some((steps, limit));
        }
        change - S::ONE > S::from_f64((steps - first) as f64 / PASSING)
    }
}

/// A state and its rate.
pub(super) type Point<'a, Y> = (&'a Y, &'a Y);

impl Stiffness {
    /// True if this step must be checked.
    pub(super) fn is_due(&self, steps: u64) -> bool {
        self.at_limit > 0 || steps.is_multiple_of(INTERVAL)
    }

    /// Evaluates two stages at the end of an accepted step of length `h` with the remaining time
    /// `ahead`. True if stability probably limits the step length.
    pub(super) fn watch<S: Scalar, Y: StateVector<S>>(
        &mut self,
        lengths: (S, S),
        one: Point<'_, Y>,
        other: Point<'_, Y>,
    ) -> bool {
        self.count(is_at_limit(lengths, one, other, SAME_STATE.part::<S>()))
    }

    /// Counts a step at the limit, or below it. Returns true if the system is probably stiff.
    pub(super) fn count(&mut self, is_at_limit: bool) -> bool {
        if is_at_limit {
            self.below = 0;
            self.at_limit += 1;
        } else {
            self.below += 1;
            if self.below >= ENOUGH_BELOW {
                *self = Stiffness::default();
            }
        }
        self.at_limit >= MAX_AT_LIMIT
    }
}

/// True if more than [`BEARABLE`] steps of length `h` lie ahead, which makes stiffness worth
/// reporting.
#[inline(always)]
pub(super) fn are_many<S: Number>((h, ahead): (S, S)) -> S::Mask {
    S::from_f64(BEARABLE).less((ahead / h).abs())
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
