//! Pictures in pixels.

use std::io::BufWriter;
use std::path::Path;

use crate::error::DrawError;
use crate::picture::{Colour, Mark, Picture, Point, Segment, Style};
use lagrange_files as files;
use lagrange_plot::label::{Anchor, Label};
use lagrange_plot::pixels::{Path as Line, PathBuilder, Pixels, Transform};

/// Resolution of PNG files relative to a screen of 96 dots per inch.
const FINENESS: f64 = 2.0;

/// Draws a picture with `scale` pixels per screen pixel.
pub(crate) fn rasterise(picture: &Picture, scale: f64) -> Result<Pixels, DrawError> {
    // Sides beyond the range of integers saturate and are rejected with other large ones.
    let size = picture.size.map(|side| (side * scale).ceil() as u32);
    let mut pixels = Pixels::white(size, scale).ok_or(DrawError::Size(picture.size))?;
    for mark in &picture.marks {
        match mark {
            Mark::Path { segments, style } => draw(&mut pixels, segments, style),
            Mark::Text { at, text, size, anchor, colour } => {
                write(&mut pixels, *at, text, *size, *anchor, *colour);
            }
        }
    }
    Ok(pixels)
}

/// Writes a picture as PNG.
pub(super) fn save(picture: &Picture, path: &Path) -> Result<(), DrawError> {
    let pixels = rasterise(picture, FINENESS)?;
    let written = files::save(path, |error| error, |file| pixels.save(&mut BufWriter::new(file)));
    DrawError::written(path, written)
}

fn draw(pixels: &mut Pixels, segments: &[Segment], style: &Style) {
    // A path of no extent shows nothing.
    let Some(line) = line(segments) else { return };
    if let Some(fill) = style.fill {
        pixels.fill(&line, fill);
    }
    if let Some(stroke) = style.stroke {
        pixels.stroke(&line, stroke, style.width, style.dashes);
    }
}

fn line(segments: &[Segment]) -> Option<Line> {
    let mut line = PathBuilder::new();
    let point = |[x, y]: Point| (x as f32, y as f32);
    for segment in segments {
        match *segment {
            Segment::Move(to) => line.move_to(point(to).0, point(to).1),
            Segment::Line(to) => line.line_to(point(to).0, point(to).1),
            Segment::Curve(a, b, to) => {
                let (a, b, to) = (point(a), point(b), point(to));
                line.cubic_to(a.0, a.1, b.0, b.1, to.0, to.1);
            }
            Segment::Close => line.close(),
        }
    }
    line.finish()
}

fn write(pixels: &mut Pixels, at: Point, text: &str, size: f64, anchor: Anchor, colour: Colour) {
    let (pieces, width) = Label::parse(text).set(size);
    let left = anchor.offset(width);
    for piece in pieces {
        let [x, y] = [at[0] + left + piece.at[0], at[1] + piece.at[1]];
        let size = piece.size as f32;
        let place = Transform::from_translate(x as f32, y as f32).pre_scale(size, size);
        pixels.write(&piece.text, piece.slope, place, colour);
    }
}

#[cfg(test)]
mod tests {

    use super::rasterise;
    use crate::colour::{INK, body};
    use crate::geometry::polyline;
    use crate::picture::{Mark, Picture, Segment, Style};
    use lagrange_plot::label::{Anchor, Label};
    use lagrange_plot::lettering::CAPITALS;

    fn square(low: f64, high: f64) -> Vec<Segment> {
        polyline([[low, low], [high, low], [high, high], [low, high]], true)
    }

    /// Returns a square with a hole, and a letter next to it.
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
        assert_eq!((pixels.width(), pixels.height()), (120, 80));
        let pixel = |x: usize, y: usize| {
            let start = 4 * (y * 120 + x);
            [0, 1, 2].map(|channel| pixels.rgba()[start + channel])
        };
        assert_eq!(pixel(20, 20), body(0).light);
        assert_eq!(pixel(40, 40), [255; 3], "the hole");
        assert_eq!(pixel(40, 10), INK.light);
        assert_eq!(pixel(2, 2), [255; 3]);
        let dark = (90..96).filter(|x| pixel(*x, 40) != [255; 3]).count();
        assert!(dark > 0, "the letter");
    }

    /// Returns columns and rows from the first to the last with ink, in units of the picture.
    fn inked(picture: &Picture) -> [[f64; 2]; 2] {
        let pixels = rasterise(picture, 4.0).expect("fits");
        let width = pixels.width() as usize;
        let dark = (0..pixels.rgba().len() / 4).filter(|index| pixels.rgba()[4 * index] < 128);
        let places: Vec<[usize; 2]> = dark.map(|index| [index % width, index / width]).collect();
        [0, 1].map(|axis| {
            let along = || places.iter().map(|place| place[axis]);
            [along().min().expect("ink"), along().max().expect("ink") + 1].map(|end| end as f64 / 4.0)
        })
    }

    /// The anchor of a text in the document is its start, middle or end, on the baseline.
    #[test]
    fn letters_are_where_the_document_has_them() {
        let wide = Label::parse("HEH_2").width(20.0);
        for (anchor, left) in [(Anchor::Start, 0.0), (Anchor::Middle, 0.5 * wide), (Anchor::End, wide)] {
            let text = |text: &str| Mark::Text {
                at: [90.0, 40.0],
                text: text.into(),
                size: 20.0,
                anchor,
                colour: INK,
            };
            let picture = |mark| Picture { size: [180.0, 60.0], title: String::new(), marks: vec![mark] };
            let [columns, rows] = inked(&picture(text("HEH_2")));
            assert!(
                (columns[0] - (90.0 - left)).abs() < 1.0 && (columns[1] - (90.0 - left + wide)).abs() < 1.0
            );
            // Capitals stand on the baseline; a subscript of half the size extends below it.
            assert!(
                (rows[0] - (40.0 - 20.0 * CAPITALS)).abs() < 0.5 && (rows[1] - 44.0).abs() < 0.5,
                "{rows:?}"
            );
            let [_, rows] = inked(&picture(text("H")));
            assert!((rows[1] - 40.0).abs() < 0.5, "{rows:?}");
        }
    }

    #[test]
    fn what_the_font_lacks_is_seen() {
        let picture = |text: &str| {
            let mark = Mark::Text {
                at: [10.0, 40.0],
                text: text.into(),
                size: 20.0,
                anchor: Anchor::Start,
                colour: INK,
            };
            Picture { size: [180.0, 60.0], title: String::new(), marks: vec![mark] }
        };
        let [columns, rows] = inked(&picture("\u{1f980}"));
        assert!(columns[1] - columns[0] > 8.0 && rows[1] - rows[0] > 12.0, "{columns:?} {rows:?}");
        assert_eq!(rasterise(&picture("字"), 1.0).ok(), rasterise(&picture("\u{1f980}"), 1.0).ok());
    }

    #[test]
    fn files_hold_the_same_pixels() {
        let pixels = rasterise(&picture(), 2.0).expect("fits");
        let mut file = Vec::new();
        pixels.save(&mut file).expect("writes");
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("reads");
        let mut read = vec![0; reader.output_buffer_size().expect("fits")];
        let info = reader.next_frame(&mut read).expect("reads");
        assert_eq!((info.width, info.height), (pixels.width(), pixels.height()));
        let rgb: Vec<u8> = pixels.rgba().chunks(4).flat_map(|pixel| pixel[..3].to_vec()).collect();
        assert_eq!(read, rgb);
    }

    #[test]
    fn pictures_without_pixels_are_refused() {
        let empty = Picture { size: [0.0, 40.0], ..picture() };
        assert!(rasterise(&empty, 2.0).is_err());
        assert!(rasterise(&Picture { size: [f64::NAN, 1.0], ..picture() }, 2.0).is_err());
    }
}
