//! Errors in the search for orbits.

use std::error::Error;
use std::fmt::{Debug, Display, Formatter, Result as Written};
use std::string::String;

/// The reason why no orbit was found.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum OrbitError {
    /// A setting is invalid, for this reason.
    Setting(&'static str),
    /// There is no coordinate of this name to advance.
    UnknownCoordinate {
        /// Requested name.
        name: String,
        /// Names of all coordinates.
        known: &'static [&'static str],
    },
    /// A motion or its derivatives fail, with the message of the run.
    Motion(String),
    /// An event ends a motion at this time.
    Ends(f64),
    /// The search for an orbit of a free period ended at rest, which repeats after any time.
    AtRest,
    /// The search found no orbit near its start. At its end, the motion misses its start by this
    /// distance.
    NotFound {
        /// Distance of the end of the motion from its start.
        distance: f64,
        /// Number of steps.
        iterations: u32,
    },
}

impl Display for OrbitError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        match self {
            OrbitError::Setting(reason) => f.write_str(reason),
            OrbitError::UnknownCoordinate { name, known } => {
                write!(f, "there is no coordinate `{name}`; coordinates are {known:?}")
            }
            OrbitError::Motion(reason) => write!(f, "the motion fails: {reason}"),
            OrbitError::Ends(time) => write!(f, "an event ends the motion at time {time}"),
            OrbitError::AtRest => f.write_str(
                "the search ended at rest: start nearer to an orbit, or with a period nearer to its own",
            ),
            OrbitError::NotFound { distance, iterations } => write!(
                f,
                "after {iterations} steps the motion still misses its start by {distance:e}: \
                 start nearer to an orbit"
            ),
        }
    }
}

/// Shows the message, since `main` and `unwrap` print errors by `Debug`.
impl Debug for OrbitError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        write!(f, "OrbitError({self})")
    }
}

impl Error for OrbitError {}
