//! Pictures in pixels.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

use crate::error::DrawError;
use crate::picture::{Anchor, Colour, Mark, Picture, Point, Segment, Style};
use crate::text;

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
    let file = File::create(path);
    DrawError::written(path, file.and_then(|file| write(&pixels, &mut BufWriter::new(file))))
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

#[cfg(test)]
mod tests {

    use super::{rasterise, write};
    use crate::colour::{INK, body};
    use crate::geometry::polyline;
    use crate::picture::{Anchor, Colour, Mark, Picture, Segment, Style};

    fn square(low: f64, high: f64) -> Vec<Segment> {
        polyline([[low, low], [high, low], [high, high], [low, high]], true)
    }

    /// A square with a hole and a letter beside it.
    fn picture() -> Picture {
        let segments = [square(5.0, 35.0), square(15.0, 25.0)].concat();
        let style = Style { stroke: Some(INK), width: 2.0, dashes: &[], fill: Some(body(0)) };
        let text =
            Mark::Text { at: [45.0, 25.0], text: "I".into(), size: 14.0, anchor: Anchor::Start, colour: INK };
        let title = String::new();
        Picture { size: [60.0, 40.0], title, marks: [Mark::Path { segments, style }, text].into() }
    }

    #[test]
    fn holes_are_holes_and_lines_have_their_colours() {
        let pixels = rasterise(&picture(), 2.0).expect("fits");
        assert_eq!((pixels.width, pixels.height), (120, 80));
        let pixel = |x: usize, y: usize| {
            let start = 4 * (y * 120 + x);
            Colour([0, 1, 2, 3].map(|channel| pixels.rgba[start + channel]))
        };
        assert_eq!(pixel(20, 20), body(0));
        assert_eq!(pixel(40, 40), Colour([255; 4]), "the hole");
        assert_eq!(pixel(40, 10), INK);
        assert_eq!(pixel(2, 2), Colour([255; 4]));
        let dark = (90..96).filter(|x| pixel(*x, 40) != Colour([255; 4])).count();
        assert!(dark > 0, "the letter");
    }

    #[test]
    fn files_hold_the_same_pixels() {
        let pixels = rasterise(&picture(), 2.0).expect("fits");
        let mut file = Vec::new();
        write(&pixels, &mut file).expect("writes");
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("reads");
        let mut read = vec![0; reader.output_buffer_size().expect("fits")];
        let info = reader.next_frame(&mut read).expect("reads");
        assert_eq!((info.width, info.height), (pixels.width, pixels.height));
        let rgb: Vec<u8> = pixels.rgba.chunks(4).flat_map(|pixel| pixel[..3].to_vec()).collect();
        assert_eq!(read, rgb);
    }

    #[test]
    fn pictures_without_pixels_are_refused() {
        let empty = Picture { size: [0.0, 40.0], ..picture() };
        assert!(rasterise(&empty, 2.0).is_err());
        assert!(rasterise(&Picture { size: [f64::NAN, 1.0], ..picture() }, 2.0).is_err());
    }
}
