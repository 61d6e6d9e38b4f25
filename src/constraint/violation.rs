//! Which constraint does not hold, and by how much.

use core::error::Error;
use core::fmt::{Debug, Display, Formatter};

/// A constraint that does not hold where it must.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Violation<S> {
    /// The name of the constraint that is violated most.
    pub constraint: &'static str,
    /// What is left of it: c, or dc/dt if `is_of_velocities`.
    pub residual: S,
    /// Whether the positions satisfy the constraint and the velocities do not.
    pub is_of_velocities: bool,
}

impl<S: Debug> Display for Violation<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        let Violation { constraint, residual, is_of_velocities } = self;
        let what = if *is_of_velocities { "the velocities violate" } else { "the positions violate" };
        write!(f, "{what} the constraint `{constraint}`, which comes to {residual:?} instead of 0")
    }
}

impl<S: Debug> Error for Violation<S> {}
