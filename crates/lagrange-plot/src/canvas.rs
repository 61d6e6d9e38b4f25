//! A pixel backend for `plotters`.

use std::io;

use plotters::style::FontTransform;
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};
use tiny_skia::Rect;

use crate::axes::Frame;
use crate::image::Placed;
use crate::lettering::{self, SMALL, Slope};
use crate::pixels::{Colour, Path, PathBuilder, Pixels, Transform};

/// A picture whose points are finer than its pixels.
pub(crate) struct Canvas {
    /// In points.
    size: (u32, u32),
    pub(crate) pixels: Pixels,
}

/// The size of a font as the SVG backend understands it, in terms of what it is given.
pub(crate) const FONT: f64 = 1.0 / 1.24;
/// Distance from the top of a text to its baseline in that backend: as written, and as a fraction of the
/// font size.
const TOP: (&str, f64) = ("0.76em", 0.76);
/// Likewise below the middle.
const MIDDLE: (&str, f64) = ("0.5ex", 0.5 * SMALL);
/// Likewise below the bottom.
const BOTTOM: (&str, f64) = ("-0.5ex", -0.5 * SMALL);
/// All that it writes.
pub(crate) const LOWERED: [(&str, f64); 3] = [TOP, MIDDLE, BOTTOM];

impl Canvas {
    /// A white picture of a size in points, with this many points a pixel; none if it is too large.
    pub(crate) fn new(size: (u32, u32), fineness: u32) -> Option<Self> {
        let pixels = [size.0, size.1].map(|side| side.div_ceil(fineness));
        Some(Canvas { size, pixels: Pixels::white(pixels, 1.0 / f64::from(fineness))? })
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

fn colour(BackendColor { alpha, rgb: (red, green, blue) }: BackendColor) -> Colour {
    // Conversions saturate.
    [red, green, blue, (255.0 * alpha).round() as u8]
}

/// The line through points, of which there is none through a single one that is not repeated.
fn line(points: impl IntoIterator<Item = BackendCoord>) -> Option<Path> {
    let mut line = PathBuilder::new();
    for (x, y) in points {
        let (x, y) = (x as f32, y as f32);
        if line.is_empty() { line.move_to(x, y) } else { line.line_to(x, y) }
    }
    line.finish()
}

type Drawn = Result<(), DrawingErrorKind<io::Error>>;

impl DrawingBackend for Canvas {
    type ErrorType = io::Error;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        self.draw_rect(point, (point.0 + 1, point.1 + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        if let Some(line) = line(path) {
            self.pixels.stroke(&line, colour(style.color()), f64::from(style.stroke_width()), &[]);
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Drawn {
        if let Some(area) = line(corners) {
            self.pixels.fill(&area, colour(style.color()));
        }
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (x0, y0): BackendCoord,
        (x1, y1): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        if !fill {
            return self.draw_path([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)], style);
        }
        if let Some(area) = Rect::from_ltrb(x0 as f32, y0 as f32, x1 as f32, y1 as f32) {
            self.pixels.fill(&PathBuilder::from_rect(area), colour(style.color()));
        }
        Ok(())
    }

    /// Draws a text at the place of the SVG backend.
    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, at: BackendCoord) -> Drawn {
        let (size, anchor) = (FONT * style.size(), style.anchor());
        let left = match anchor.h_pos {
            HPos::Left => 0.0,
            HPos::Center => -0.5,
            HPos::Right => -1.0,
        } * lettering::width(text, Slope::Upright);
        let (_, base) = match anchor.v_pos {
            VPos::Top => TOP,
            VPos::Center => MIDDLE,
            VPos::Bottom => BOTTOM,
        };
        let degrees = match style.transform() {
            FontTransform::None => 0.0,
            FontTransform::Rotate90 => 90.0,
            FontTransform::Rotate180 => 180.0,
            FontTransform::Rotate270 => 270.0,
        };
        let place = Transform::from_translate(at.0 as f32, at.1 as f32)
            .pre_rotate(degrees)
            .pre_scale(size as f32, size as f32)
            .pre_translate(left as f32, base as f32);
        self.pixels.write(text, Slope::Upright, place, colour(style.color()));
        Ok(())
    }
}
