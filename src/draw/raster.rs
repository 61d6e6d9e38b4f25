//! Pictures in pixels.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::vec::Vec;

use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

use crate::draw::error::DrawError;
use crate::draw::picture::{Anchor, Colour, Mark, Picture, Point, Segment, Style};
use crate::draw::text;

/// PNG files are so many times finer than a screen of 96 dots to the inch.
const FINENESS: f64 = 2.0;
/// Width of the strokes of letters in terms of the size of the font.
const PEN: f64 = 0.085;

/// A picture in pixels, on white.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Pixels {
    /// How many pixels are side by side.
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// Red, green, blue, opacity of each, in rows from the top; all are opaque.
    pub(crate) rgba: Vec<u8>,
}

/// Draws a picture with so many pixels to the pixel of a screen.
pub(crate) fn rasterise(picture: &Picture, scale: f64) -> Result<Pixels, DrawError> {
    let [width, height] = picture.size.map(|side| (side * scale).ceil());
    // Sides beyond those of integers saturate and are refused with the others.
    let pixmap = Pixmap::new(width as u32, height as u32);
    let mut pixmap = pixmap.ok_or(DrawError::Size(picture.size))?;
    pixmap.fill(Color::WHITE);
    for mark in &picture.marks {
        draw(&mut pixmap, mark, Transform::from_scale(scale as f32, scale as f32));
    }
    Ok(Pixels { width: pixmap.width(), height: pixmap.height(), rgba: pixmap.take() })
}

/// Writes a picture as PNG.
pub(super) fn save(picture: &Picture, path: &Path) -> Result<(), DrawError> {
    let pixels = rasterise(picture, FINENESS)?;
    Ok(write(&pixels, &mut BufWriter::new(File::create(path)?))?)
}

fn write(pixels: &Pixels, file: &mut impl Write) -> io::Result<()> {
    let mut encoder = png::Encoder::new(&mut *file, pixels.width, pixels.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    let rgb: Vec<u8> = pixels.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    file.flush()
}

fn draw(pixmap: &mut Pixmap, mark: &Mark, transform: Transform) {
    match mark {
        Mark::Path { segments, style } => draw_path(pixmap, segments, style, transform),
        Mark::Text { at, text, size, anchor, colour } => {
            let segments = letters(*at, text, *size, *anchor);
            let style = Style { stroke: Some(*colour), width: PEN * size, dashes: &[], fill: None };
            draw_path(pixmap, &segments, &style, transform);
        }
    }
}

fn draw_path(pixmap: &mut Pixmap, segments: &[Segment], style: &Style, transform: Transform) {
    let mut builder = PathBuilder::new();
    for segment in segments {
        let point = |[x, y]: Point| (x as f32, y as f32);
        match *segment {
            Segment::Move(to) => builder.move_to(point(to).0, point(to).1),
            Segment::Line(to) => builder.line_to(point(to).0, point(to).1),
            Segment::Curve(a, b, to) => {
                let (a, b, to) = (point(a), point(b), point(to));
                builder.cubic_to(a.0, a.1, b.0, b.1, to.0, to.1);
            }
            Segment::Close => builder.close(),
        }
    }
    // A path of no extent shows nothing.
    let Some(path) = builder.finish() else { return };
    if let Some(fill) = style.fill {
        pixmap.fill_path(&path, &paint(fill), FillRule::EvenOdd, transform, None);
    }
    if let Some(stroke) = style.stroke {
        pixmap.stroke_path(&path, &paint(stroke), &pen(style), transform, None);
    }
}

fn paint(Colour([red, green, blue, opacity]): Colour) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(red, green, blue, opacity);
    paint
}

fn pen(style: &Style) -> Stroke {
    let dashes: Vec<f32> = style.dashes.iter().map(|length| *length as f32).collect();
    Stroke {
        width: style.width as f32,
        line_cap: LineCap::Round,
        line_join: LineJoin::Round,
        dash: StrokeDash::new(dashes, 0.0),
        ..Stroke::default()
    }
}

/// The strokes of a text.
fn letters(at: Point, text: &str, size: f64, anchor: Anchor) -> Vec<Segment> {
    let (lines, width) = text::strokes(text, size);
    let left = match anchor {
        Anchor::Start => at[0],
        Anchor::Middle => at[0] - 0.5 * width,
        Anchor::End => at[0] - width,
    };
    let mut segments = Vec::new();
    for line in lines {
        let mut points = line.iter().map(|[x, y]| [left + x, at[1] + y]);
        segments.extend(points.next().map(Segment::Move));
        segments.extend(points.map(Segment::Line));
    }
    segments
}
