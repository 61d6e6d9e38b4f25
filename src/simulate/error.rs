//! Why a run stopped early, and what it had found until then.

use std::boxed::Box;
use std::error::Error;
use std::fmt::{Debug, Display, Formatter, Result};

use crate::integrate::Cause;
use crate::simulate::trajectory::Trajectory;
use crate::system::MechanicalSystem;

/// A run stopped before its end.
///
/// What was found until then is kept; its last sample is the last good state.
pub struct SimulationError<M: MechanicalSystem> {
    /// Why.
    pub cause: Cause<M::Scalar>,
    /// What was found until then. Every sample is finite, except that the first is the initial state as it was given.
    pub trajectory: Box<Trajectory<M>>,
}

impl<M: MechanicalSystem> SimulationError<M> {
    /// The time of the last good state.
    pub fn time(&self) -> M::Scalar {
        self.trajectory.end_time()
    }

    /// The last good state.
    pub fn state(&self) -> M::State {
        self.trajectory.last()
    }
}

impl<M: MechanicalSystem> Debug for SimulationError<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.debug_struct("SimulationError")
            .field("cause", &self.cause)
            .field("time", &self.time())
            .field("state", &self.state())
            .finish_non_exhaustive()
    }
}

impl<M: MechanicalSystem> Display for SimulationError<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{} (at time {:?})", self.cause, self.time())
    }
}

impl<M: MechanicalSystem> Error for SimulationError<M> {}
