//! Motions that failed.

use core::fmt::{Debug, Display, Formatter};
use std::string::String;

use crate::simulate::{SimulationError, explain_run};
use crate::system::{MechanicalSystem, StepFailure};

/// A motion that failed, with its last good state and the cause.
#[non_exhaustive]
pub struct Failure<M: MechanicalSystem> {
    /// Index of the motion.
    pub index: usize,
    /// The time of the last good state.
    pub time: M::Scalar,
    /// The last good state; finite, unless the start was not.
    pub state: M::State,
    /// Cause of the failure.
    pub cause: StepFailure<M::Scalar>,
    /// Name of the event that the cause concerns, if any.
    pub name: Option<String>,
}

impl<M: MechanicalSystem> Failure<M> {
    pub(super) fn new(index: usize, error: SimulationError<M>) -> Self {
        let (time, state) = (error.time(), error.state());
        Failure { index, time, state, cause: error.cause, name: error.name }
    }

    /// Returns the cause and time as text.
    #[cfg(feature = "parquet")]
    pub(super) fn why(&self) -> impl Display + '_ {
        Why(self)
    }
}

impl<M: MechanicalSystem> Clone for Failure<M> {
    fn clone(&self) -> Self {
        Failure { name: self.name.clone(), ..*self }
    }
}

impl<M: MechanicalSystem> Debug for Failure<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Failure")
            .field("index", &self.index)
            .field("time", &self.time)
            .field("state", &self.state)
            .field("cause", &self.cause)
            .finish_non_exhaustive()
    }
}

impl<M: MechanicalSystem> Display for Failure<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        write!(f, "motion {}: {}", self.index, Why(self))
    }
}

/// A failure without its motion.
struct Why<'f, M: MechanicalSystem>(&'f Failure<M>);

impl<M: MechanicalSystem> Display for Why<'_, M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        explain_run(&self.0.cause, self.0.name.as_deref(), self.0.time, f)
    }
}
