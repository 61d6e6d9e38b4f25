//! Errors in making units.

use std::error::Error;
use std::fmt::{self, Display, Formatter};
use std::io;

use lagrange_c::Refusal;

use crate::version::Version;

/// The reason why a unit was not made.
#[derive(Debug)]
#[non_exhaustive]
pub enum ExportError {
    /// C cannot compute the system.
    Refused(Refusal),
    /// These variables have no finite value.
    WithoutValue(Vec<String>),
    /// Two variables share this name.
    SameName(String),
    /// This version of the standard has no name for binaries of this platform.
    Platform(Version),
    /// The compiler with this name could not be run.
    NoCompiler(String, io::Error),
    /// The compiler with this name rejected the sources, with this output.
    Compiler(String, String),
    /// Files could not be read or written.
    Files(io::Error),
}

impl Display for ExportError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            ExportError::Refused(refusal) => refusal.fmt(f),
            ExportError::WithoutValue(names) => {
                let names = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
                write!(f, "no finite value at the start: {names}")
            }
            ExportError::SameName(name) => write!(f, "two variables of the unit are called `{name}`"),
            ExportError::Platform(version) => {
                write!(f, "FMI {} has no name for binaries of this platform", version.number())
            }
            ExportError::NoCompiler(name, error) => {
                write!(f, "the C compiler `{name}` does not start ({error}): set CC to another one")
            }
            ExportError::Compiler(name, words) => write!(f, "the C compiler `{name}` failed:\n{words}"),
            ExportError::Files(error) => error.fmt(f),
        }
    }
}

impl Error for ExportError {}

impl From<Refusal> for ExportError {
    fn from(refusal: Refusal) -> ExportError {
        ExportError::Refused(refusal)
    }
}

impl From<io::Error> for ExportError {
    fn from(error: io::Error) -> ExportError {
        ExportError::Files(error)
    }
}
