//! A recorded motion, the content of films.

use std::borrow::Cow;
use std::fmt::Debug;

use crate::error::DrawError;
use crate::picture::Picture;
use crate::timeline::Timeline;

/// A motion recorded by a drawing.
pub trait Recorded: Clone + PartialEq + Debug {
    /// The extension of files in this space's format.
    const FORMAT: &'static str;

    /// Returns the picture of each moment.
    fn pictures(&self) -> Cow<'_, [Picture]>;

    /// Returns the motion as an HTML page.
    fn page(&self, timeline: &Timeline) -> String;

    /// Returns the content of a file in this space's format.
    ///
    /// # Errors
    /// If the file would be larger than its format allows.
    fn file(&self, timeline: &Timeline) -> Result<Vec<u8>, DrawError>;
}
