//! Figures in pixels.

use crate::axes::Frame;
use crate::colours::{Colour, INK};
use crate::image::Placed;
use crate::label::Label;
use crate::paper::{FONT, Paper, Place, Point};
use crate::pixels::{Path, PathBuilder, Pixels, Transform};

/// A picture whose points are smaller than its pixels.
pub(crate) struct Canvas {
    pub(crate) pixels: Pixels,
}

impl Canvas {
    /// Creates a white picture of a size in points, with this number of points per pixel; `None` if
    /// it is too large.
    pub(crate) fn new(size: (u32, u32), fineness: u32) -> Option<Self> {
        let pixels = [size.0, size.1].map(|side| side.div_ceil(fineness));
        Some(Canvas { pixels: Pixels::white(pixels, 1.0 / f64::from(fineness))? })
    }

    /// Draws an image into its frame.
    pub(crate) fn place(&mut self, Placed { image, frame }: &Placed) {
        let Frame { left, right, top, bottom, .. } = *frame;
        self.pixels.place(
            &image.rgba,
            [image.columns, image.rows()],
            [left, top, right, bottom].map(f64::from),
        );
    }
}

/// Returns the line through points; `None` for a single point that is not repeated.
fn line(points: &[Point]) -> Option<Path> {
    let mut line = PathBuilder::new();
    for (x, y) in points {
        let (x, y) = (*x as f32, *y as f32);
        if line.is_empty() { line.move_to(x, y) } else { line.line_to(x, y) }
    }
    line.finish()
}

impl Paper for Canvas {
    fn line(&mut self, points: &[Point], colour: Colour, width: u32) {
        if let Some(line) = line(points) {
            self.pixels.stroke(&line, colour, f64::from(width), &[]);
        }
    }

    fn area(&mut self, corners: &[Point], colour: Colour) {
        if let Some(area) = line(corners) {
            self.pixels.fill(&area, colour);
        }
    }

    fn write(&mut self, label: &Label, Place { at, anchor, down, is_turned }: Place) {
        let (pieces, width) = label.set(FONT);
        let left = anchor.offset(width);
        let degrees = if is_turned { 270.0 } else { 0.0 };
        let place = Transform::from_translate(at.0 as f32, at.1 as f32).pre_rotate(degrees);
        for piece in pieces {
            let (x, y, size) = (left + piece.at[0], down.base() + piece.at[1], piece.size as f32);
            let place = place.pre_translate(x as f32, y as f32).pre_scale(size, size);
            self.pixels.write(&piece.text, piece.slope, place, INK);
        }
    }
}
