//! Detection of steps limited by stability, for explicit methods with adaptive steps.
//!
//! Each method has a hint that costs nothing, which is looked at in every hundredth step. If hints
//! persist, the largest eigenvalue of the Jacobian is computed. Source: Hairer, Wanner, *Solving
//! Ordinary Differential Equations II*, §IV.2.

use super::method::Work;
use super::stability::{EVALUATIONS, largest_eigenvalue};
use crate::linalg::vector::l1_norm;
use crate::scalar::{Number, Scalar};
use crate::system::{OdeSystem, StepFailure, have_modes};

/// Number of steps at the limit after which the system counts as stiff.
const MAX_AT_LIMIT: u32 = 15;
/// Number of consecutive steps below the limit after which the system counts as non-stiff.
const ENOUGH_BELOW: u32 = 6;
/// Number of steps per check while there is no suspicion.
const INTERVAL: u64 = 100;
/// Maximum number of remaining steps for which stiffness is not reported.
const BEARABLE: f64 = 1e4;
/// Minimum ratio of an eigenvalue times the state to the rates of the motion for the eigenvalue to
/// count as fast.
const FAST: f64 = 100.0;
/// Minimum relative change of the state in a step for the motion to count as moving.
const SLOWEST: f64 = 1e-9;

/// Counts of steps at the stability limit.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Stiffness {
    at_limit: u32,
    below: u32,
}

impl Stiffness {
    /// True if this step must be checked.
    pub(super) fn is_due(&self, steps: u64) -> bool {
        self.at_limit > 0 || steps.is_multiple_of(INTERVAL)
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

/// True if an eigenvalue of this magnitude is fast beside the motion of a state of this size at
/// this speed.
#[inline(always)]
pub(super) fn is_fast<S: Number>(eigenvalue: S, (size, speed): (S, S)) -> S::Mask {
    (S::from_f64(FAST) * speed).less(eigenvalue * size)
}

/// The stability limit of a method.
#[derive(Clone, Copy, Debug)]
pub(super) struct StabilityLimit<S> {
    /// Approximate maximum |h λ| of stable steps.
    pub(super) stable: S,
    /// Fraction of the longest stable step above which steps count as limited by stability.
    pub(super) near: S,
}

/// A state and its rate.
pub(super) type Point<'a, Y> = (&'a Y, &'a Y);

/// A step that seems to be limited by stability.
#[derive(Clone, Copy, Debug)]
pub(super) struct LimitedStep<'a, S, Y> {
    pub(super) t: S,
    pub(super) h: S,
    /// A state of the step, with its rate.
    pub(super) point: Point<'a, Y>,
    /// The direction of fastest growth.
    pub(super) direction: Y,
    /// The change of the state in the step.
    pub(super) change: S,
}

/// The detection of stiffness in a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct StiffnessTest<S> {
    counts: Stiffness,
    fading: Fading<S>,
}

impl<S: Scalar> StiffnessTest<S> {
    pub(super) fn new() -> Self {
        StiffnessTest { counts: Stiffness::default(), fading: Fading::UNKNOWN }
    }

    /// True if this step must be checked.
    pub(super) fn is_due(&self, steps: u64) -> bool {
        self.counts.is_due(steps)
    }

    /// Counts a step at the limit, or below it. Returns true if the system is probably stiff.
    pub(super) fn count(&mut self, is_at_limit: bool) -> bool {
        self.counts.count(is_at_limit)
    }

    /// Stops with an error if the largest eigenvalue confirms that stability limits steps.
    #[cold]
    pub(super) fn refuse<M: OdeSystem<Scalar = S> + ?Sized>(
        &mut self,
        system: &M,
        LimitedStep { t, h, point: (y, rate), direction, change }: LimitedStep<'_, S, M::State>,
        (StabilityLimit { stable, near }, tolerance): (StabilityLimit<S>, S),
        work: &mut Work,
    ) -> Result<(), StepFailure<S>> {
        let eigenvalue = largest_eigenvalue(|y| system.rhs(t, y), y, change, &direction);
        work.evaluations += EVALUATIONS;
        self.counts = Stiffness::default();
        let limit = stable / eigenvalue;
        let (size, speed) = (l1_norm(y), l1_norm(rate));
        // A motion that is slower than its tolerance, or has ended, may continue with the steps
        // that stability permits.
        let goes_on = speed * h.abs() > S::from_f64(SLOWEST) * size;
        let is_limited = h.abs() > near * limit && goes_on && is_fast(eigenvalue, (size, speed));
        if !is_limited || self.fading.is_fading(work.steps, limit) {
            return Ok(());
        }
        let wants_jacobian = !have_modes(system.events()) && system.jacobian(t, y).is_none();
        Err(StepFailure::Stiff { limit, tolerance, wants_jacobian })
    }
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
struct Fading<S> {
    /// The index of a step, and the longest stable step there.
    first: Option<(u64, S)>,
    last: u64,
}

impl<S: Scalar> Fading<S> {
    /// No observation yet.
    const UNKNOWN: Self = Fading { first: None, last: 0 };

    /// True if the longest stable step has changed fast enough since the first observation, or
    /// if this is the first one.
    fn is_fading(&mut self, steps: u64, limit: S) -> bool {
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
