//! Systems that cannot be shown on a page.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

use lagrange_c::Refusal;
use lagrange_draw::DrawError;

/// The reason why a system has no page.
#[derive(Debug)]
#[non_exhaustive]
pub enum PageError {
    /// The system cannot be written as JavaScript.
    Script(Refusal),
    /// The initial state cannot be drawn.
    Drawing(DrawError),
    /// The parameter, input or initial value with this name is not finite, or belongs to a
    /// quaternion of zeros.
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
