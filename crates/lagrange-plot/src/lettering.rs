//! Letters as outlines of an embedded font, so that pixel images are the same everywhere.
//!
//! The font is STIX Two, made for mathematics, reduced to the letters of labels and named Lagrange
//! Letters. `letters/` contains it with its licence, the SIL Open Font License 1.1, and
//! `tools/letters.py` creates it. It is parsed by `ttf-parser`. Pairs of letters are kerned, and
//! accents are placed above their letters. Ligatures are not supported, nor are scripts other than
//! letter by letter from left to right. Missing characters appear as a box with a question mark.

use std::sync::LazyLock;

use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, GlyphId, OutlineBuilder, Rect};

use crate::characters::shown;

/// The font family for viewers with their own fonts: the complete embedded font, or others of
/// similar width.
pub const FAMILY: &str =
    "'STIX Two Text', 'STIX Two Math', 'Latin Modern Roman', Cambria, 'Times New Roman', Times, serif";

/// Maximum ratio of the width of viewers' fonts to the embedded font, which determines widths.
pub const LEEWAY: f64 = 1.06;

/// Height of capitals relative to the size of the font.
pub const CAPITALS: f64 = 0.657;
/// Height of small letters relative to the size of the font.
pub const SMALL: f64 = 0.473;

/// The slope of letters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Slope {
    /// Upright, for words, numbers and signs.
    Upright,
    /// Italic, for symbols. Characters without italics in the font are upright.
    Italic,
}

static UPRIGHT: LazyLock<Face<'static>> = LazyLock::new(|| face(include_bytes!("../letters/upright.ttf")));
static ITALIC: LazyLock<Face<'static>> = LazyLock::new(|| face(include_bytes!("../letters/italic.ttf")));

fn face(data: &'static [u8]) -> Face<'static> {
    Face::parse(data, 0).expect("the embedded fonts are fonts")
}

/// Returns the outline of a line of text for a font of size 1. The origin is at the left end of the
/// base line, with y downwards. `None` if nothing is visible.
pub fn outline(text: &str, slope: Slope) -> Option<Path> {
    let mut pen = Pen { path: PathBuilder::new(), at: (0.0, 0.0), unit: 1.0 };
    set(text, slope, |letter, at| {
        pen.at = at;
        pen.unit = unit(letter.face);
        // Blanks have no outline.
        letter.face.outline_glyph(letter.glyph, &mut pen);
    });
    pen.path.finish()
}

/// Returns the width of a line of text for a font of size 1, up to the start of the next letter.
pub fn width(text: &str, slope: Slope) -> f64 {
    f64::from(set(text, slope, |_, _| {}))
}

/// A glyph of one of the fonts.
#[derive(Clone, Copy)]
struct Letter {
    face: &'static Face<'static>,
    glyph: GlyphId,
}

impl Letter {
    fn of(character: char, slope: Slope) -> Letter {
        let faces: &[&'static Face<'static>] = match slope {
            Slope::Upright => &[&UPRIGHT],
            Slope::Italic => &[&ITALIC, &UPRIGHT],
        };
        let known = faces.iter().find_map(|face| Some(Letter { face, glyph: face.glyph_index(character)? }));
        // The first glyph of a font represents all missing ones.
        known.unwrap_or(Letter { face: &UPRIGHT, glyph: GlyphId(0) })
    }

    /// Returns the width relative to the size of the font.
    fn width(self) -> f32 {
        unit(self.face) * f32::from(self.face.glyph_hor_advance(self.glyph).unwrap_or(0))
    }

    /// Returns the additional distance of the next letter.
    fn kerning(self, next: Letter) -> f32 {
        let tables = self.face.tables().kern.into_iter().flat_map(|kern| kern.subtables);
        let found = tables.filter_map(|table| table.glyphs_kerning(self.glyph, next.glyph)).next();
        if std::ptr::eq(self.face, next.face) { unit(self.face) * f32::from(found.unwrap_or(0)) } else { 0.0 }
    }

    /// Returns the offset from this letter to its accent: above its middle, along its slope, and
    /// higher for tall letters.
    fn accented(self, accent: Letter) -> Option<(f32, f32)> {
        let [letter, mark] = [self, accent].map(|drawn| drawn.face.glyph_bounding_box(drawn.glyph));
        let (letter, mark) = (letter?, mark?);
        let middle =
            |area: Rect| [area.x_min + area.x_max, area.y_min + area.y_max].map(|sum| 0.5 * f32::from(sum));
        let ([x, y], [over, above]) = (middle(letter), middle(mark));
        let raised = f32::from((letter.y_max - self.face.x_height().unwrap_or(0)).max(0));
        let slope = -self.face.italic_angle().to_radians().tan();
        Some((unit(self.face) * (x + slope * (above + raised - y) - over), -unit(self.face) * raised))
    }
}

/// Returns the reciprocal of the number of font units per size.
fn unit(face: &Face<'_>) -> f32 {
    f32::from(face.units_per_em()).recip()
}

/// True if a character is an accent on the previous one.
pub fn is_accent(character: char) -> bool {
    matches!(character, '\u{300}'..='\u{314}' | '\u{20d0}'..='\u{20dc}')
}

/// Calls `each` with each letter and its place, y downwards, and returns the total width.
fn set(text: &str, slope: Slope, mut each: impl FnMut(Letter, (f32, f32))) -> f32 {
    let (mut end, mut last): (f32, Option<(Letter, f32)>) = (0.0, None);
    for character in shown(text) {
        let letter = Letter::of(character, slope);
        let place = last.filter(|_| is_accent(character)).and_then(|(base, x)| {
            let (across, down) = base.accented(letter)?;
            Some((x + across, down))
        });
        if let Some(place) = place {
            each(letter, place);
            continue;
        }
        let start = end + last.map_or(0.0, |(before, _)| before.kerning(letter));
        each(letter, (start, 0.0));
        end = start + letter.width();
        last = Some((letter, start));
    }
    end
}

/// A pen that draws a glyph at a place.
struct Pen {
    path: PathBuilder,
    at: (f32, f32),
    unit: f32,
}

impl Pen {
    fn point(&self, x: f32, y: f32) -> (f32, f32) {
        (self.at.0 + self.unit * x, self.at.1 - self.unit * y)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.point(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.point(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.point(x1, y1), self.point(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.point(x1, y1), self.point(x2, y2), self.point(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests;
