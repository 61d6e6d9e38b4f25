//! Whether stability limits the steps.
//!
//! Two stages lie at the end of a step. How much their rates differ for how much their states do estimates the largest
//! eigenvalue of the Jacobian. Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, §IV.2.

use crate::scalar::Scalar;
use crate::system::StateVector;

/// The method is stable up to |h λ| about this: 2.9 on the imaginary axis, 4.4 on the negative real one.
const STABLE: f64 = 2.9;
/// This many steps at the limit tell that the system is stiff;
const MOST_AT_LIMIT: u32 = 15;
/// so many below it in turn tell that it is not.
const ENOUGH_BELOW: u32 = 6;
/// As long as there is no suspicion, one step in so many is looked at.
const INTERVAL: u64 = 100;
/// If no more steps than this are ahead, the system is not stiff enough to bother.
const BEARABLE: f64 = 1e4;
/// States that differ by less than this many roundings say nothing.
const ROUNDINGS: f64 = 1e3;

/// What was seen of the limit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stiffness<S> {
    at_limit: u32,
    below: u32,
    /// The smallest eigenvalue seen at the limit.
    eigenvalue: S,
}

/// A state and its rate.
pub(super) type Point<'a, Y> = (&'a Y, &'a Y);

impl<S: Scalar> Stiffness<S> {
    pub(super) fn new() -> Self {
        Stiffness { at_limit: 0, below: 0, eigenvalue: S::ZERO }
    }

    /// Whether this step is to be looked at.
    pub(super) fn is_due(&self, steps: u64) -> bool {
        self.at_limit > 0 || steps.is_multiple_of(INTERVAL)
    }

    /// Looks at two stages at the end of an accepted step of length `h` with `ahead` to go; about the longest stable
    /// step once there is no doubt that it is the limit.
    pub(super) fn watch<Y: StateVector<S>>(
        &mut self,
        (h, ahead): (S, S),
        one: Point<'_, Y>,
        other: Point<'_, Y>,
    ) -> Option<S> {
        let (change, size) = (distance(one.0, other.0), distance(one.0, &Y::ZERO));
        let rounding = S::from_f64(ROUNDINGS) * S::epsilon();
        let is_many = (ahead / h).abs() > S::from_f64(BEARABLE);
        let eigenvalue = (distance(one.1, other.1) / change).sqrt();
        let is_at_limit = (h * eigenvalue).abs() > S::from_f64(STABLE);
        if is_many && is_at_limit && change > rounding * rounding * size {
            self.eigenvalue = if self.at_limit == 0 { eigenvalue } else { eigenvalue.min(self.eigenvalue) };
            self.below = 0;
            self.at_limit += 1;
        } else {
            self.below += 1;
            if self.below >= ENOUGH_BELOW {
                *self = Stiffness::new();
            }
        }
        (self.at_limit >= MOST_AT_LIMIT).then(|| S::from_f64(STABLE) / self.eigenvalue)
    }
}

/// Square of the Euclidean distance.
fn distance<S: Scalar, Y: StateVector<S>>(a: &Y, b: &Y) -> S {
    a.as_ref().iter().zip(b.as_ref()).fold(S::ZERO, |sum, (a, b)| sum + (*a - *b) * (*a - *b))
}
