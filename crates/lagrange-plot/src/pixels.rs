//! Pixels of all pictures: areas, lines and letters with smooth edges on white, by `tiny-skia`, and
//! their PNG files.

use std::io::{self, Write};

pub use tiny_skia::{Path, PathBuilder, Transform};

use tiny_skia::{
    FillRule, FilterQuality, IntSize, LineCap, LineJoin, Paint, Pixmap, PixmapPaint, PixmapRef, Stroke,
    StrokeDash,
};

use crate::colours::Colour;
use crate::lettering::{self, Slope};

/// A picture of opaque pixels.
#[derive(Clone, PartialEq, Debug)]
pub struct Pixels {
    pixmap: Pixmap,
    /// The transformation from drawing units to pixels.
    transform: Transform,
}

impl Pixels {
    /// Creates a white picture with this number of pixels, with `scale` pixels per drawing unit.
    /// `None` without pixels, or if they do not fit into memory.
    pub fn white([width, height]: [u32; 2], scale: f64) -> Option<Pixels> {
        let size = IntSize::from_wh(width, height)?;
        let bytes = (width as usize).checked_mul(height as usize)?.checked_mul(4)?;
        let mut rgba = Vec::new();
        rgba.try_reserve_exact(bytes).ok()?;
        rgba.resize(bytes, u8::MAX);
        let pixmap = Pixmap::from_vec(rgba, size)?;
        Some(Pixels { pixmap, transform: Transform::from_scale(scale as f32, scale as f32) })
    }

    /// Returns the width in pixels.
    pub fn width(&self) -> u32 {
        self.pixmap.width()
    }

    /// Returns the height in pixels.
    pub fn height(&self) -> u32 {
        self.pixmap.height()
    }

    /// Returns red, green, blue and opacity of each pixel, in rows starting at the top.
    pub fn rgba(&self) -> &[u8] {
        self.pixmap.data()
    }

    /// Fills an area by the even-odd rule.
    pub fn fill(&mut self, area: &Path, colour: Colour) {
        self.pixmap.fill_path(area, &paint(colour), FillRule::EvenOdd, self.transform, None);
    }

    /// Draws lines with round ends; overlaps of lines are not darker.
    pub fn stroke(&mut self, lines: &Path, colour: Colour, width: f64, dashes: &[f64]) {
        let dashes: Vec<f32> = dashes.iter().map(|length| *length as f32).collect();
        let pen = Stroke {
            width: width as f32,
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            dash: StrokeDash::new(dashes, 0.0),
            ..Stroke::default()
        };
        self.pixmap.stroke_path(lines, &paint(colour), &pen, self.transform, None);
    }

    /// Draws an image between these edges on the left, above, on the right and below. The image
    /// consists of rows of pixels with red, green, blue and opacity. Each of its pixels remains a
    /// rectangle of one colour; opacities are zero or full.
    pub fn place(&mut self, rgba: &[u8], [width, height]: [u32; 2], [left, top, right, bottom]: [f64; 4]) {
        let Some(image) = PixmapRef::from_bytes(rgba, width, height) else { return };
        let (wide, high) = ((right - left) / f64::from(width), (bottom - top) / f64::from(height));
        let within = Transform::from_row(wide as f32, 0.0, 0.0, high as f32, left as f32, top as f32);
        let paint = PixmapPaint { quality: FilterQuality::Nearest, ..PixmapPaint::default() };
        self.pixmap.draw_pixmap(0, 0, image, &paint, self.transform.pre_concat(within), None);
    }

    /// Writes a line of text. The transformation maps it from a font of size 1 to its place. The
    /// text starts at the origin on the base line, with y downwards.
    pub fn write(&mut self, text: &str, slope: Slope, place: Transform, colour: Colour) {
        let Some(outline) = lettering::outline(text, slope) else { return };
        let transform = self.transform.pre_concat(place);
        // Parts of a letter may overlap.
        self.pixmap.fill_path(&outline, &paint(colour), FillRule::Winding, transform, None);
    }

    /// Writes the picture as PNG.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn save(&self, file: &mut impl Write) -> io::Result<()> {
        let mut encoder = png::Encoder::new(&mut *file, self.width(), self.height());
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        let rgb: Vec<u8> =
            self.rgba().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        writer.write_image_data(&rgb)?;
        writer.finish()?;
        file.flush()
    }
}

/// Returns the colour on paper.
fn paint(Colour { light: [red, green, blue], opacity, .. }: Colour) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(red, green, blue, opacity);
    paint
}
