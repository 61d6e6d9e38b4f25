//! Why a picture could not be made.

use std::fmt::{Display, Formatter};
use std::io;
use std::path::PathBuf;
use std::string::String;

/// Why a picture could not be made or written.
#[derive(Debug)]
#[non_exhaustive]
pub enum DrawError {
    /// A number is not finite; such a moment cannot be drawn.
    NotFinite {
        /// What was to be drawn.
        item: String,
        /// Which of its numbers.
        what: &'static str,
        /// When.
        time: f64,
    },
    /// The scene has no body of this name.
    UnknownBody(String),
    /// The scene has nothing of this name that could be hidden.
    UnknownItem(String),
    /// There is no moment, or nothing in it that has a place.
    NothingToDraw,
    /// The picture is too small for its margins, or larger than an image can be.
    Size([f64; 2]),
    /// The extension of the file is none of those that can be written.
    Extension(PathBuf),
    /// Pictures and times do not make a film; the text says why.
    Film(String),
    /// What the operating system says.
    Io(io::Error),
}

impl Display for DrawError {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            DrawError::NotFinite { item, what, time } => {
                write!(f, "the {what} of `{item}` is not finite at time {time}")
            }
            DrawError::UnknownBody(name) => write!(f, "the scene has no body `{name}`"),
            DrawError::UnknownItem(name) => write!(f, "the scene has nothing named `{name}`"),
            DrawError::NothingToDraw => f.write_str("there is nothing to draw"),
            DrawError::Size([width, height]) => {
                write!(f, "a picture cannot be {width} by {height} pixels large")
            }
            DrawError::Extension(path) => {
                write!(f, "`{}` does not end in the name of a format that can be written", path.display())
            }
            DrawError::Film(reason) => f.write_str(reason),
            DrawError::Io(error) => Display::fmt(error, f),
        }
    }
}

impl std::error::Error for DrawError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            DrawError::Io(error) => Some(error),
            _ => None,
        }
    }
}

impl From<io::Error> for DrawError {
    fn from(error: io::Error) -> Self {
        DrawError::Io(error)
    }
}
