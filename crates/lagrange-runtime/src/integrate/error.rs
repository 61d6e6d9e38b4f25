//! Reasons why an integration stopped early.

use core::error::Error;
use core::fmt::{Debug, Display, Formatter};

use crate::system::{OdeSystem, StepFailure};

/// The result of an integration of the system M.
pub type Outcome<M, T> = Result<T, IntegrationError<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>>;

/// The error of an integration that stopped before its end; S is the scalar and Y the state.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct IntegrationError<S, Y> {
    /// The reason.
    pub cause: StepFailure<S>,
    /// Time of `state`.
    pub time: S,
    /// The last valid state; finite unless it is the initial one.
    pub state: Y,
}

impl<S: Debug, Y> Display for IntegrationError<S, Y> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        write!(f, "{} (at time {:?})", self.cause, self.time)
    }
}

impl<S: Debug, Y: Debug> Error for IntegrationError<S, Y> {}
