//! Areas between two curves.

use plotters::style::{Color, RGBColor};
use plotters_backend::DrawingBackend;

use crate::axes::{Drawn, Frame, rounded};
use crate::axis::Axis;

/// The area between two curves over the same abscissae, broken where one is not finite. Bands that lie in each other darken.
#[derive(Clone, PartialEq, Debug)]
pub struct Band {
    /// Name in the legend.
    pub name: String,
    /// Abscissa, lower and upper ordinate of each point, in their order.
    pub points: Vec<(f64, f64, f64)>,
}

/// Opacity of a band.
const OPACITY: f64 = 0.22;

impl Band {
    /// Draws the area.
    pub(crate) fn draw<B: DrawingBackend>(
        &self,
        backend: &mut B,
        frame: &Frame,
        (x, y): (&Axis, &Axis),
        color: RGBColor,
    ) -> Drawn<B> {
        let is_whole = |(x, lower, upper): &(f64, f64, f64)| [x, lower, upper].iter().all(|v| v.is_finite());
        for piece in self.points.split(|point| !is_whole(point)).filter(|piece| piece.len() > 1) {
            let point = |at: f64, value: f64| rounded((frame.x(x.place(at)), frame.y(y.place(value))));
            let below = piece.iter().map(|(at, lower, _)| point(*at, *lower));
            let above = piece.iter().rev().map(|(at, _, upper)| point(*at, *upper));
            backend.fill_polygon(below.chain(above), &color.mix(OPACITY))?;
        }
        Ok(())
    }

    /// Draws a sample of the colour of the band with this index, which lies within all before it.
    pub(crate) fn draw_sample<B: DrawingBackend>(
        backend: &mut B,
        index: usize,
        (left, top): (i32, i32),
        (right, bottom): (i32, i32),
        color: RGBColor,
    ) -> Drawn<B> {
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        (0..=index).try_for_each(|_| backend.fill_polygon(corners, &color.mix(OPACITY)))
    }
}
