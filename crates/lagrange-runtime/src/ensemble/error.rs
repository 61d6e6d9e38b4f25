//! Errors of ensembles.

use core::fmt::{Debug, Display, Formatter};
use std::any::Any;
use std::error::Error;
use std::io;
use std::path::PathBuf;
use std::string::{String, ToString};

/// An error that kept an ensemble from being computed completely. Failed motions are not errors:
/// they are listed among the failures of the results.
#[non_exhaustive]
pub enum EnsembleError {
    /// A setting is invalid; the text describes it.
    Setting(String),
    /// A closure of the user panicked.
    Panicked {
        /// Index of the first motion in which a closure panicked.
        motion: usize,
        /// Message of the panic.
        message: String,
    },
    /// The progress callback panicked.
    ProgressPanicked {
        /// Message of the panic.
        message: String,
    },
    /// The progress callback cancelled it.
    Cancelled {
        /// Number of finished motions.
        motions: u64,
    },
    /// The operating system did not start the requested number of threads.
    Threads(String),
    /// A file could not be read or written. Finished files are kept.
    File {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system or the format.
        source: io::Error,
    },
    /// The folder contains a file that is named like a part and is not one.
    ForeignFile(PathBuf),
    /// A part has changed since it was written, or has the name of another part.
    Damaged {
        /// Path of the file.
        path: PathBuf,
        /// Reason.
        why: String,
    },
    /// The folder contains a part of another ensemble.
    OtherEnsemble {
        /// Path of the file.
        path: PathBuf,
        /// Property of the ensemble in the file that differs, and the property of this one.
        differs: [String; 2],
    },
    /// Another process writes the same parts to the folder, or a process was killed on another
    /// machine.
    Locked {
        /// Path of the lock file.
        path: PathBuf,
        /// Process that holds the lock, as described in the file.
        holder: String,
    },
}

impl Display for EnsembleError {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        match self {
            EnsembleError::Setting(what) => f.write_str(what),
            EnsembleError::Panicked { motion, message } => write!(f, "motion {motion} panicked: {message}"),
            EnsembleError::ProgressPanicked { message } => {
                write!(f, "the progress callback panicked: {message}")
            }
            EnsembleError::Cancelled { motions } => write!(f, "cancelled after {motions} motions"),
            EnsembleError::Threads(what) => write!(f, "threads could not be started: {what}"),
            EnsembleError::File { path, source } => write!(f, "`{}`: {source}", path.display()),
            EnsembleError::ForeignFile(path) => write!(
                f,
                "`{}` is named like a part of an ensemble, but another version wrote it or its end is damaged: \
                save to another folder, or delete it",
                path.display()
            ),
            EnsembleError::Damaged { path, why } => {
                write!(f, "`{}` is damaged: {why}; delete it to recompute it", path.display())
            }
            EnsembleError::OtherEnsemble { path, differs: [there, here] } => {
                write!(f, "`{}` is a part of another ensemble: ", path.display())?;
                match (there.as_str(), here.as_str()) {
                    ("", "") => f.write_str("its settings were specified in another order")?,
                    ("", here) => write!(f, "its settings lack `{here}`")?,
                    (there, "") => write!(f, "its settings contain `{there}`, unlike those here")?,
                    (there, here) => write!(f, "its settings contain `{there}` instead of `{here}`")?,
                }
                f.write_str("; undo the change, or save to another folder")
            }
            EnsembleError::Locked { path, holder } => write!(
                f,
                "`{}` states that {holder} is writing to this folder; if that process was killed, delete the file and start again",
                path.display()
            ),
        }
    }
}

/// Shows the message, since `main` and `unwrap` print errors by `Debug`.
impl Debug for EnsembleError {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        write!(f, "EnsembleError({self})")
    }
}

impl Error for EnsembleError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            EnsembleError::File { source, .. } => Some(source),
            _ => None,
        }
    }
}

/// Returns the message of a panic.
pub(super) fn panic_message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "without a message".into())
}
