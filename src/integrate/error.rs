//! Why an integration stopped early.

use core::error::Error;
use core::fmt::{Debug, Display, Formatter, Result};

/// Why an integration stopped before its end time; S is the scalar and Y the state.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum IntegrationError<S, Y> {
    /// A nonzero span of time was to be covered in no steps.
    NoSteps,
    /// NaN or infinity appeared in the step that starts here, or stood in the initial state already.
    NotFinite {
        /// Time of `state`.
        time: S,
        /// The last state that was reached; finite unless it is the initial one.
        state: Y,
    },
}

impl<S: Debug, Y> Display for IntegrationError<S, Y> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            IntegrationError::NoSteps => f.write_str("a nonzero span of time needs at least one step"),
            IntegrationError::NotFinite { time, .. } => {
                write!(f, "the state is NaN or infinite in the step from time {time:?}")
            }
        }
    }
}

impl<S: Debug, Y: Debug> Error for IntegrationError<S, Y> {}
