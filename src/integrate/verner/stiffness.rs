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

/// What was seen of the limit.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Stiffness {
    at_limit: u32,
    below: u32,
}

/// A state and its rate.
pub(super) type Point<'a, Y> = (&'a Y, &'a Y);

impl Stiffness {
    /// Looks at two stages at the end of an accepted step of length `h`; about the longest stable step once there is
    /// no doubt that it is the limit.
    pub(super) fn watch<S: Scalar, Y: StateVector<S>>(
        &mut self,
        steps: u64,
        h: S,
        one: Point<'_, Y>,
        other: Point<'_, Y>,
    ) -> Option<S> {
        if self.at_limit == 0 && !steps.is_multiple_of(INTERVAL) {
            return None;
        }
        let eigenvalue = (distance(one.1, other.1) / distance(one.0, other.0)).sqrt();
        let stable = S::from_f64(STABLE);
        if (h * eigenvalue).abs() > stable {
            self.below = 0;
            self.at_limit += 1;
        } else {
            self.below += 1;
            if self.below >= ENOUGH_BELOW {
                *self = Stiffness::default();
            }
        }
        (self.at_limit >= MOST_AT_LIMIT).then(|| stable / eigenvalue)
    }
}

/// Square of the Euclidean distance.
fn distance<S: Scalar, Y: StateVector<S>>(a: &Y, b: &Y) -> S {
    a.as_ref().iter().zip(b.as_ref()).fold(S::ZERO, |sum, (a, b)| sum + (*a - *b) * (*a - *b))
}
