//! The error of a run that stopped early, with the data recorded so far.

use std::boxed::Box;
use std::error::Error;
use std::fmt::{Debug, Display, Formatter, Result};
use std::string::{String, ToString};

use crate::simulate::table::repeated;
use crate::simulate::trajectory::Trajectory;
use crate::system::{EventName, EventSource, MechanicalSystem, SettingError, StepFailure, explain};

/// The error of a run that stopped before its end.
///
/// The data up to the failure are kept; the last sample is the last good state.
pub struct SimulationError<M: MechanicalSystem> {
    /// Cause of the failure.
    pub cause: StepFailure<M::Scalar>,
    /// Name of the event or column that the cause concerns, if any.
    pub name: Option<String>,
    /// Data recorded up to the failure. Every sample is finite, except that the first is the
    /// initial state as specified.
    pub trajectory: Box<Trajectory<M>>,
}

impl<M: MechanicalSystem> SimulationError<M> {
    /// Creates the error of a run to which the events named in `given` were added.
    pub(super) fn new(cause: StepFailure<M::Scalar>, given: &[String], trajectory: Trajectory<M>) -> Self {
        let name = match (cause, cause.event()) {
            (StepFailure::Setting(SettingError::RepeatedColumn), _) => repeated(trajectory.names()).cloned(),
            (_, Some(EventSource::Declared(name))) => Some(name.to_string()),
            (_, Some(EventSource::Given(index))) => given.get(index).cloned(),
            (_, None) => None,
        };
        SimulationError { cause, name, trajectory: Box::new(trajectory) }
    }

    /// Returns the time of the last good state.
    pub fn time(&self) -> M::Scalar {
        self.trajectory.end_time()
    }

    /// Returns the last good state.
    pub fn state(&self) -> M::State {
        self.trajectory.last()
    }
}

/// Shows the message, since `main` and `unwrap` print errors by `Debug`.
impl<M: MechanicalSystem> Debug for SimulationError<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "SimulationError({self}, in the state {:?})", self.state())
    }
}

impl<M: MechanicalSystem> Display for SimulationError<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        explain_run(&self.cause, self.name.as_deref(), self.time(), f)
    }
}

/// Writes the cause and time of a failure, with the name of the event or column concerned.
pub(crate) fn explain_run<S: Copy + Debug + PartialEq>(
    cause: &StepFailure<S>,
    name: Option<&str>,
    time: S,
    f: &mut Formatter<'_>,
) -> Result {
    match name {
        Some(name) if *cause == StepFailure::Setting(SettingError::RepeatedColumn) => {
            write!(f, "two columns are called `{name}`")?;
        }
        Some(name) => explain(cause, &EventName(name), f)?,
        None => write!(f, "{cause}")?,
    }
    write!(f, " (at time {time:?})")
}

impl<M: MechanicalSystem> Error for SimulationError<M> {}
