//! Systems that no page can show.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

use lagrange_c::Refusal;
use lagrange_draw::DrawError;

/// The reason why there is no page of a system.
#[derive(Debug)]
#[non_exhaustive]
pub enum PageError {
    /// The system cannot be written as JavaScript.
    Script(Refusal),
    /// Its drawing at the start is not possible.
    Drawing(DrawError),
    /// The parameter, the input or the entry of the start of this name is not finite, or belongs to
    /// a quaternion of zeros.
    NotFinite(String),
}

impl Display for PageError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            PageError::Script(refusal) => refusal.fmt(f),
            PageError::Drawing(error) => write!(f, "the drawing at the start: {error}"),
            PageError::NotFinite(name) => {
                write!(f, "`{name}` is not finite at the start, or belongs to a quaternion of zeros")
            }
        }
    }
}

impl Error for PageError {}

impl From<Refusal> for PageError {
    fn from(refusal: Refusal) -> PageError {
        PageError::Script(refusal)
    }
}

impl From<DrawError> for PageError {
    fn from(error: DrawError) -> PageError {
        PageError::Drawing(error)
    }
}
