//! Why there is no sum.

use std::error::Error;
use std::fmt::{Display, Formatter, Result};

use lagrange::ensemble::EnsembleError;

/// An ensemble was not summed up over processes. All of them are told.
#[derive(Debug)]
#[non_exhaustive]
pub enum MpiError {
    /// MPI was initialised already.
    Initialized,
    /// This MPI does not allow a process to have threads.
    NoThreads,
    /// The share of this process was not computed.
    Ensemble(EnsembleError),
    /// That of another was not, the first of them.
    Elsewhere {
        /// The rank of that process, whose error says why.
        rank: i32,
    },
    /// A process sent what is no sum of this kind: not all run the same program.
    Garbled {
        /// The rank of that process.
        rank: i32,
    },
}

impl Display for MpiError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            MpiError::Initialized => f.write_str("MPI was initialised already, or has ended"),
            MpiError::NoThreads => f.write_str("this MPI does not allow a process to have threads"),
            MpiError::Ensemble(error) => error.fmt(f),
            MpiError::Elsewhere { rank } => write!(f, "the process with rank {rank} failed, and says why"),
            MpiError::Garbled { rank } => {
                write!(f, "the process with rank {rank} sent something else: all must run the same program")
            }
        }
    }
}

impl Error for MpiError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            MpiError::Ensemble(error) => Some(error),
            _ => None,
        }
    }
}
