//! Errors for systems and initial states that cannot be run, and for unknown names.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

use lagrange_runtime::system::OutOfRange;

use crate::reactions::MAX_COUNTS;

/// The reason why a system cannot be run.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Refusal {
    /// The system has rigid contacts or friction, and exceeds the size supported for them.
    Touching {
        /// Number of velocities.
        velocities: usize,
        /// Number of forces of contacts and friction; two for friction in a plane.
        forces: usize,
    },
    /// The system calls these functions of the user's crate.
    Functions(Vec<String>),
    /// The system exceeds the supported size.
    TooLarge {
        /// Number of entries of the state, or of constraints or inputs if larger.
        entries: usize,
        /// Maximum number of entries.
        most: usize,
    },
}

impl Display for Refusal {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::Touching { velocities, forces } => {
                let [most_velocities, most_forces] = MAX_COUNTS;
                write!(
                    f,
                    "there are {velocities} velocities and {forces} forces of contacts and friction, "
                )?;
                write!(f, "more than the {most_velocities} and {most_forces} that run without compilation")
            }
            Refusal::Functions(names) => {
                write!(f, "functions of a crate are known to compiled code only: {}", quoted(names))
            }
            Refusal::TooLarge { entries, most } => {
                let what = "entries of the state, constraints or inputs";
                write!(f, "there are {entries} {what}, more than the {most} that run without compilation")
            }
        }
    }
}

impl Error for Refusal {}

/// A name that a system does not have.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NoSuchName {
    /// The name.
    pub name: String,
    /// Known names.
    pub known: Vec<String>,
}

impl Display for NoSuchName {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.known[..] {
            [] => write!(f, "there is no `{}`, nor anything else to set", self.name),
            known => write!(f, "there is no `{}`; known are {}", self.name, quoted(known)),
        }
    }
}

impl Error for NoSuchName {}

/// The reason why values of entries do not determine a state in which a system may start.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum StartError {
    /// The state has no such entry.
    Unknown(NoSuchName),
    /// This entry has no value.
    Missing(String),
    /// This entry is out of its declared range.
    OutOfRange(OutOfRange<f64>),
}

impl Display for StartError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            StartError::Unknown(NoSuchName { name, known }) => {
                write!(f, "the state has no `{name}`; known are {}", quoted(known))
            }
            StartError::Missing(name) => write!(f, "the start of `{name}` is missing or NaN"),
            StartError::OutOfRange(error) => error.fmt(f),
        }
    }
}

impl Error for StartError {}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
