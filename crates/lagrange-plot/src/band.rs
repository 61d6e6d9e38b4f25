//! Areas between two curves.

use crate::axes::{Frame, rounded};
use crate::axis::Axis;
use crate::colours::Colour;
use crate::label::Label;
use crate::paper::{Paper, Point};

/// The area between two curves over the same abscissae, interrupted at points that are not finite.
/// Nested bands appear darker.
#[derive(Clone, PartialEq, Debug)]
pub struct Band {
    /// Name in the legend.
    pub name: Label,
    /// Abscissa, lower and upper ordinate of each point, in their order.
    pub points: Vec<(f64, f64, f64)>,
}

/// Opacity of a band, from 0 to 255.
const OPACITY: u8 = 56;

impl Band {
    /// Draws the area.
    pub(crate) fn draw(&self, paper: &mut dyn Paper, frame: &Frame, (x, y): (&Axis, &Axis), colour: Colour) {
        let is_whole = |(x, lower, upper): &(f64, f64, f64)| [x, lower, upper].iter().all(|v| v.is_finite());
        for piece in self.points.split(|point| !is_whole(point)).filter(|piece| piece.len() > 1) {
            let point = |at: f64, value: f64| rounded((frame.x(x.place(at)), frame.y(y.place(value))));
            let below = piece.iter().map(|(at, lower, _)| point(*at, *lower));
            let above = piece.iter().rev().map(|(at, _, upper)| point(*at, *upper));
            paper.area(&below.chain(above).collect::<Vec<_>>(), Colour { opacity: OPACITY, ..colour });
        }
    }

    /// Draws a sample of the colour of the band with this index, which lies within all previous
    /// bands.
    pub(crate) fn draw_sample(
        paper: &mut dyn Paper,
        index: usize,
        (left, top): Point,
        (right, bottom): Point,
        colour: Colour,
    ) {
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        (0..=index).for_each(|_| paper.area(&corners, Colour { opacity: OPACITY, ..colour }));
    }
}
