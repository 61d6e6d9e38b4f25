//! Errors in making pictures.

use std::fmt::{Debug, Display, Formatter};
use std::io;
use std::path::{Path, PathBuf};

/// The reason why a picture could not be made or written.
#[non_exhaustive]
pub enum DrawError {
    /// A number is not finite; such a moment cannot be drawn.
    NotFinite {
        /// Item to be drawn.
        item: String,
        /// Description of the number.
        what: &'static str,
        /// Time of the moment.
        time: f64,
    },
    /// The scene has no body of this name.
    UnknownBody(String),
    /// The scene has no item of this name to hide or to label.
    UnknownItem(String),
    /// There is no moment, or no item in it has a position.
    NothingToDraw,
    /// The azimuth or the elevation of the view in space is not finite.
    View([f64; 2]),
    /// The picture is too small for its margins, or larger than an image can be.
    Size([f64; 2]),
    /// The extension of the file is not supported.
    Extension {
        /// The file.
        path: PathBuf,
        /// The extensions that can be written.
        known: &'static [&'static str],
    },
    /// Pictures and times do not make a film, for this reason.
    Film(String),
    /// A file could not be written.
    Io {
        /// The file.
        path: PathBuf,
        /// Error of the operating system.
        error: io::Error,
    },
}

/// Returns the error of an invalid film, with a reason.
pub(super) fn refusal(reason: &str) -> DrawError {
    DrawError::Film(reason.to_owned())
}

impl DrawError {
    pub(super) fn extension(path: &Path, known: &'static [&'static str]) -> Self {
        DrawError::Extension { path: path.to_owned(), known }
    }

    /// Converts the result of writing a file.
    pub(super) fn written(path: &Path, result: io::Result<()>) -> Result<(), Self> {
        result.map_err(|error| DrawError::Io { path: path.to_owned(), error })
    }
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
            DrawError::View([azimuth, elevation]) => {
                write!(f, "a scene cannot be seen from azimuth {azimuth} and elevation {elevation}")
            }
            DrawError::Size([width, height]) => {
                write!(f, "a picture cannot have {width} by {height} pixels")
            }
            DrawError::Extension { path, known } => {
                let known = known.join(", ");
                write!(
                    f,
                    "`{}` does not end in the name of a format, which is one of {known}",
                    path.display()
                )
            }
            DrawError::Film(reason) => f.write_str(reason),
            DrawError::Io { path, error } => write!(f, "cannot write `{}`: {error}", path.display()),
        }
    }
}

/// Shows the message, since `main` and `unwrap` print errors by `Debug`.
impl Debug for DrawError {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        write!(f, "DrawError({self})")
    }
}

impl std::error::Error for DrawError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            DrawError::Io { error, .. } => Some(error),
            _ => None,
        }
    }
}
