//! Which zeros count.

use crate::scalar::Scalar;

/// How a function passes zero as the integration proceeds; in backward time, as time runs backwards.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// Either.
    Crossing,
}

impl Direction {
    /// Whether a change from a value of the sign of `before` to one of the sign of `after`, not zero, counts.
    pub(super) fn counts<S: Scalar>(self, before: S, after: S) -> bool {
        let (rises, falls) = (before < S::ZERO && after > S::ZERO, before > S::ZERO && after < S::ZERO);
        match self {
            Direction::Rising => rises,
            Direction::Falling => falls,
            Direction::Crossing => rises || falls,
        }
    }
}
