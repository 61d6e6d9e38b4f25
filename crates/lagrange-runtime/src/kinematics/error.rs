//! Errors of searches for postures.

use core::error::Error;
use core::fmt::{self, Debug, Display, Formatter};

use crate::system::StepFailure;

/// The reason why no posture was found.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum ReachError<Q, S> {
    /// The goal of this task is not finite, or its matrix is not a rotation.
    Goal {
        /// Index of the task.
        task: usize,
    },
    /// No start can be brought onto the constraints.
    Constrained {
        /// Positions of the last start.
        q: Q,
        /// The constraint.
        cause: StepFailure<S>,
    },
    /// The frames are at their goals, but constraints move this coordinate beyond its limits.
    BeyondLimit {
        /// Positions.
        q: Q,
        /// Name of the coordinate.
        name: &'static str,
    },
    /// There is no coordinate with this name whose rate is a velocity.
    UnknownCoordinate {
        /// Requested name.
        name: &'static str,
        /// Names of all positions.
        known: &'static [&'static str],
    },
    /// The lower limit of this coordinate is not below its upper one.
    Limits {
        /// Name of the coordinate.
        name: &'static str,
    },
    /// Positions, frames or Jacobians are not finite at the start.
    NotFinite,
    /// The search ended short of the goal. It is out of reach, or the search stopped at a posture
    /// from which no step leads nearer.
    Short(Shortfall<Q, S>),
}

/// The nearest posture of a search that ended short of its goal.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Shortfall<Q, S> {
    /// Positions.
    pub q: Q,
    /// Index of the task with the largest error.
    pub task: usize,
    /// The distance to its goal.
    pub distance: S,
    /// The angle to its goal, in rad.
    pub angle: S,
    /// A coordinate that is at its limit, if there is one.
    pub at_limit: Option<&'static str>,
}

impl<Q, S: Debug> Display for ReachError<Q, S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            ReachError::Goal { task } => {
                write!(f, "the goal of task {task} is not finite, or its matrix is no rotation")
            }
            ReachError::Constrained { cause, .. } => {
                write!(f, "the start is too far from positions that satisfy the constraints: {cause}")
            }
            ReachError::BeyondLimit { name, .. } => {
                write!(
                    f,
                    "constraints carry `{name}` beyond its limits: start elsewhere, or search from several `starts`"
                )
            }
            ReachError::UnknownCoordinate { name, known } => {
                write!(f, "`{name}` is no coordinate that can have limits; coordinates are {known:?}")
            }
            ReachError::Limits { name } => {
                write!(f, "the lower limit of `{name}` is not below its upper limit")
            }
            ReachError::NotFinite => f.write_str("the frames are not finite at the start"),
            ReachError::Short(shortfall) => Display::fmt(shortfall, f),
        }
    }
}

impl<Q, S: Debug> Display for Shortfall<Q, S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Shortfall { task, distance, angle, at_limit, .. } = self;
        write!(f, "task {task} is missed by the distance {distance:?} and the angle {angle:?}")?;
        match at_limit {
            Some(name) => write!(f, ", with `{name}` at its limit"),
            None => f.write_str(": move the goal nearer, start elsewhere, or search from several `starts`"),
        }
    }
}

impl<Q: Debug, S: Debug> Error for ReachError<Q, S> {}
