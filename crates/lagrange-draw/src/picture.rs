//! Finished pictures: marks in pixels, from back to front, independent of the format.

use lagrange_plot::label::Anchor;

pub(crate) use lagrange_plot::colours::Colour;

/// A point in pixels, x to the right, y **downwards** from the top left corner.
pub(crate) type Point = [f64; 2];

/// A picture in pixels of 1/96 inch.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Picture {
    /// Width and height.
    pub(crate) size: [f64; 2],
    /// Textual description, for readers who cannot see the picture.
    pub(crate) title: String,
    /// Marks from back to front. Pictures of one film have the same marks in the same order;
    /// invisible ones are empty.
    pub(crate) marks: Vec<Mark>,
}

/// A mark on a picture.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Mark {
    /// Lines and areas.
    Path {
        /// Segments of the path.
        segments: Vec<Segment>,
        /// Style of the path.
        style: Style,
    },
    /// A line of text.
    Text {
        /// Anchor point on the baseline.
        at: Point,
        /// Text; empty if nothing is shown.
        text: String,
        /// Height of the font.
        size: f64,
        /// Position of the anchor point within the text.
        anchor: Anchor,
        /// Colour of the text.
        colour: Colour,
    },
}

impl Mark {
    /// Returns the mark without content.
    pub(crate) fn emptied(mut self) -> Mark {
        match &mut self {
            Mark::Path { segments, .. } => segments.clear(),
            Mark::Text { text, .. } => text.clear(),
        }
        self
    }
}

/// A piece of a path.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Segment {
    /// Starts a line.
    Move(Point),
    /// A straight line.
    Line(Point),
    /// A cubic Bézier curve: two control points and its end.
    Curve(Point, Point, Point),
    /// Closes the line.
    Close,
}

/// The style of a path.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Style {
    /// Colour of the line, if there is one.
    pub(crate) stroke: Option<Colour>,
    /// Width of the line.
    pub(crate) width: f64,
    /// Lengths of dashes and gaps; empty for a solid line.
    pub(crate) dashes: &'static [f64],
    /// Fill colour, if there is one, by the even–odd rule.
    pub(crate) fill: Option<Colour>,
}
