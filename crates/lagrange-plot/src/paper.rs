//! The surface of a figure: lines, areas, images and labels in points.

use crate::colours::Colour;
use crate::label::{Anchor, Label};
use crate::lettering::SMALL;

/// A place in points, from the upper left corner downwards.
pub(crate) type Point = (i32, i32);

/// A surface for drawing: a document or pixels.
pub(crate) trait Paper {
    /// Draws a line through points.
    fn line(&mut self, points: &[Point], colour: Colour, width: u32);
    /// Fills the polygon with these corners.
    fn area(&mut self, corners: &[Point], colour: Colour);
    /// Writes a label in letters of size [`FONT`].
    fn write(&mut self, label: &Label, place: Place);
}

/// The size of letters in points.
pub(crate) const FONT: f64 = 137.0;

/// The place of a label.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Place {
    pub(crate) at: Point,
    pub(crate) anchor: Anchor,
    pub(crate) down: Down,
    /// True if it is rotated about its place, to be read from the right.
    pub(crate) is_turned: bool,
}

/// The vertical position of a label relative to its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Down {
    Below,
    Level,
    Above,
}

impl Down {
    /// Returns the distance from the place down to the base line, in points.
    pub(crate) fn base(self) -> f64 {
        FONT * match self {
            Down::Below => 0.76,
            Down::Level => 0.5 * SMALL,
            Down::Above => -0.5 * SMALL,
        }
    }
}
