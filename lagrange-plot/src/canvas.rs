//! Pictures in pixels, with smooth lines and letters of our own.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use plotters::style::FontTransform;
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};

use crate::lettering::{self, Point};

/// A picture whose points are finer than its pixels.
pub(crate) struct Canvas {
    /// Points a pixel.
    fineness: f64,
    /// In pixels.
    width: usize,
    height: usize,
    pixels: Vec<[u8; 3]>,
    /// How much of each pixel the line covers that is being drawn.
    cover: Vec<f32>,
}

/// Height of capitals in terms of the size of a font, as the SVG backend understands it.
const CAPITALS: f64 = 0.72 / 1.24;
/// Width of the strokes of letters in terms of the height of capitals.
const PEN: f64 = 0.13;

impl Canvas {
    /// A white picture of a size in points, with this many points a pixel.
    pub(crate) fn new((width, height): (u32, u32), fineness: u32) -> Self {
        let (width, height) = (width.div_ceil(fineness) as usize, height.div_ceil(fineness) as usize);
        Canvas {
            fineness: f64::from(fineness),
            width,
            height,
            pixels: vec![[u8::MAX; 3]; width * height],
            cover: vec![0.0; width * height],
        }
    }

    /// Writes the picture as PNG.
    pub(crate) fn save(&self, path: &Path) -> io::Result<()> {
        let mut file = BufWriter::new(File::create(path)?);
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        writer.finish()?;
        file.flush()
    }

    /// Draws lines through points in pixels; where they overlap, the colour is laid on once.
    fn stroke(&mut self, lines: &[Vec<Point>], width: f64, color: BackendColor) {
        for line in lines {
            for (from, to) in line.iter().zip(&line[1.min(line.len())..]) {
                self.cover_segment(*from, *to, 0.5 * width);
            }
        }
        let reach = 0.5 * width + 1.0;
        let range = |limit: usize, coordinate: fn(&Point) -> f64| {
            let coordinates = || lines.iter().flatten().map(coordinate);
            let (low, high) =
                (coordinates().fold(f64::INFINITY, f64::min), coordinates().fold(-f64::INFINITY, f64::max));
            span(low - reach, high + reach, limit)
        };
        let (columns, rows) = (range(self.width, |point| point.0), range(self.height, |point| point.1));
        for row in rows.0..rows.1 {
            let part = row * self.width + columns.0..row * self.width + columns.1;
            for (pixel, cover) in self.pixels[part.clone()].iter_mut().zip(&mut self.cover[part]) {
                blend(pixel, color, f64::from(*cover));
                *cover = 0.0;
            }
        }
    }

    /// Raises the cover by a segment with round ends.
    fn cover_segment(&mut self, a: Point, b: Point, radius: f64) {
        let reach = radius + 1.0;
        let rows = span(a.1.min(b.1) - reach, a.1.max(b.1) + reach, self.height);
        let along = (b.0 - a.0, b.1 - a.1);
        let length_sq = along.0 * along.0 + along.1 * along.1;
        for row in rows.0..rows.1 {
            let y = row as f64 + 0.5;
            // The part of the segment that is near this row.
            let at = |y: f64| if along.1 == 0.0 { 0.0 } else { ((y - a.1) / along.1).clamp(0.0, 1.0) };
            let ends = if along.1.abs() < 1e-9 { (0.0, 1.0) } else { (at(y - reach), at(y + reach)) };
            let (x0, x1) = (a.0 + ends.0 * along.0, a.0 + ends.1 * along.0);
            let columns = span(x0.min(x1) - reach, x0.max(x1) + reach, self.width);
            for column in columns.0..columns.1 {
                let x = column as f64 + 0.5;
                let (dx, dy) = (x - a.0, y - a.1);
                let s = if length_sq > 0.0 { (dx * along.0 + dy * along.1) / length_sq } else { 0.0 };
                let s = s.clamp(0.0, 1.0);
                let distance = (dx - s * along.0).hypot(dy - s * along.1);
                let cover = (radius + 0.5 - distance).clamp(0.0, 1.0) as f32;
                let known = &mut self.cover[row * self.width + column];
                *known = known.max(cover);
            }
        }
    }

    fn pixel(&self, (x, y): BackendCoord) -> Point {
        (f64::from(x) / self.fineness, f64::from(y) / self.fineness)
    }
}

/// The whole numbers from one number to another, from 0 to a limit.
fn span(from: f64, to: f64, limit: usize) -> (usize, usize) {
    // Conversions saturate at zero.
    let to = (to.ceil() as usize).min(limit);
    ((from.floor() as usize).min(to), to)
}

fn blend(pixel: &mut [u8; 3], color: BackendColor, cover: f64) {
    let part = (color.alpha * cover).clamp(0.0, 1.0);
    for (channel, wanted) in pixel.iter_mut().zip(<[u8; 3]>::from(color.rgb)) {
        let mixed = f64::from(*channel) + part * (f64::from(wanted) - f64::from(*channel));
        *channel = mixed.round() as u8;
    }
}

type Drawn = Result<(), DrawingErrorKind<io::Error>>;

impl DrawingBackend for Canvas {
    type ErrorType = io::Error;

    fn get_size(&self) -> (u32, u32) {
        let points = |pixels: usize| (pixels as f64 * self.fineness) as u32;
        (points(self.width), points(self.height))
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
        let line: Vec<Point> = path.into_iter().map(|point| self.pixel(point)).collect();
        self.stroke(&[line], f64::from(style.stroke_width()) / self.fineness, style.color());
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let ((x0, y0), (x1, y1)) = (upper_left, bottom_right);
        if !fill {
            return self.draw_path([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)], style);
        }
        let (from, to) = (self.pixel(upper_left), self.pixel(bottom_right));
        let (columns, rows) = (span(from.0, to.0, self.width), span(from.1, to.1, self.height));
        for row in rows.0..rows.1 {
            for pixel in &mut self.pixels[row * self.width..][columns.0..columns.1] {
                blend(pixel, style.color(), 1.0);
            }
        }
        Ok(())
    }

    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, at: BackendCoord) -> Drawn {
        let height = CAPITALS * style.size() / self.fineness;
        let (strokes, width) = lettering::strokes(text);
        let anchor = style.anchor();
        let left = match anchor.h_pos {
            HPos::Left => 0.0,
            HPos::Center => -0.5 * width,
            HPos::Right => -width,
        };
        let base = match anchor.v_pos {
            VPos::Top => 1.0,
            VPos::Center => 0.5,
            VPos::Bottom => 0.0,
        };
        let origin = self.pixel(at);
        let place = |(x, y): Point| {
            let (x, y) = (height * (x + left), height * (base - y));
            let (x, y) = match style.transform() {
                FontTransform::None => (x, y),
                FontTransform::Rotate90 => (-y, x),
                FontTransform::Rotate180 => (-x, -y),
                FontTransform::Rotate270 => (y, -x),
            };
            (origin.0 + x, origin.1 + y)
        };
        let lines: Vec<Vec<Point>> =
            strokes.iter().map(|stroke| stroke.iter().map(|point| place(*point)).collect()).collect();
        self.stroke(&lines, PEN * height, style.color());
        Ok(())
    }
}
