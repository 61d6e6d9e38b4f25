//! Sheets of paper: a title above, a note below, and marks and text between them.

use crate::error::DrawError;
use crate::geometry::subtract;
use crate::heading::{self, Heading};
use crate::labels::{self, Sheet};
use crate::look::Look;
use crate::picture::{Mark, Picture, Point};
use crate::view::{BORDER, MARGIN};

/// The sheets of a drawing.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Paper {
    size: [f64; 2],
    title: String,
    /// Title above, and note below the drawing.
    heading: [Heading; 2],
}

impl Paper {
    /// Creates paper for a drawing with this note, which may be empty.
    pub(super) fn new(look: &Look, note: &str) -> Paper {
        let heading = [heading::lines(&look.title, look.size), heading::note(note, look.size)];
        Paper { size: look.size, title: look.title.clone(), heading }
    }

    /// Returns the corners of the area within margins of this width.
    pub(super) fn window(&self, margin: f64) -> Result<[Point; 2], DrawError> {
        let [above, below] = self.heading.each_ref().map(heading::height);
        let window = [[margin, margin + above], [self.size[0] - margin, self.size[1] - margin - below]];
        let room = subtract(window[1], window[0]);
        let is_there = room.iter().all(|side| *side > 0.0) && self.size.iter().all(|side| side.is_finite());
        if is_there { Ok(window) } else { Err(DrawError::Size(self.size)) }
    }

    /// Finishes pictures: the marks of each, then labels, title and note.
    pub(super) fn finished(&self, scenes: Vec<(Vec<Mark>, Sheet)>) -> Vec<Picture> {
        let [width, height] = self.size;
        let (marks, sheets): (Vec<_>, Vec<_>) = scenes.into_iter().unzip();
        // Labels may use the margins, except those of the title and the note.
        let [above, below] = self.heading.each_ref().map(heading::height);
        let below = if below > 0.0 { MARGIN + below } else { BORDER };
        let labels = labels::labels(&sheets, [[BORDER, MARGIN + above], [width - BORDER, height - below]]);
        let mut heading = heading::marks(&self.heading[0], self.size);
        heading.extend(heading::marks_below(&self.heading[1], self.size));
        let picture = |(marks, labels): (Vec<Mark>, Vec<Mark>)| Picture {
            size: self.size,
            title: self.title.clone(),
            marks: marks.into_iter().chain(labels).chain(heading.clone()).collect(),
        };
        marks.into_iter().zip(labels).map(picture).collect()
    }
}
