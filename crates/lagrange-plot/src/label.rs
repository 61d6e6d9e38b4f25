//! Lines of text with symbols in italics and with subscripts.
//!
//! An underscore starts a subscript: `v_P`, or in braces `J_{SP}`.

use tiny_skia::{PathSegment, Point, Transform};

use crate::characters::{escaped, number};
use crate::lettering::{self, Slope};

/// Size of subscripts and their shift below the base line, both relative to the size of the font.
pub const SUBSCRIPT: (f64, f64) = (0.7, 0.2);

/// A piece of a label.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Run {
    /// Its characters.
    pub text: String,
    /// True if it is a subscript.
    pub is_subscript: bool,
}

impl Run {
    /// True for a symbol, which is set in italics: one letter, optionally with dots and primes.
    pub fn is_symbol(&self) -> bool {
        !self.is_subscript && is_symbol(&self.text)
    }
}

/// True for one letter, optionally with dots and primes.
pub(crate) fn is_symbol(text: &str) -> bool {
    let is_beside = |c: char| "′'″‴".contains(c) || lettering::is_accent(c);
    let mut letters = text.trim_end_matches(is_beside).chars();
    letters.next().is_some_and(char::is_alphabetic) && letters.next().is_none()
}

/// A line of text with symbols and subscripts.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Label {
    runs: Vec<Run>,
}

/// Creates a label of plain text, without any notation.
impl From<&str> for Label {
    fn from(text: &str) -> Label {
        Label::default().then(text)
    }
}

/// The part of a text that is placed at its anchor.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Anchor {
    /// The left end.
    Start,
    /// The middle.
    Middle,
    /// The right end.
    End,
}

impl Anchor {
    /// Returns the distance from the place to the left end of a text of a width.
    pub fn offset(self, width: f64) -> f64 {
        match self {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * width,
            Anchor::End => -width,
        }
    }
}

/// A piece of a text with its place.
#[derive(Clone, PartialEq, Debug)]
pub struct Set {
    /// Its characters.
    pub text: String,
    /// Their slope.
    pub slope: Slope,
    /// Their size.
    pub size: f64,
    /// The offset of its base line from the left end of the text's base line, y downwards.
    pub at: [f64; 2],
}

impl Label {
    /// Parses a text in the notation of formulas.
    pub fn parse(text: &str) -> Label {
        let mut label = Label::default();
        let mut rest = text;
        while let Some((plain, behind)) = rest.split_once('_') {
            label.push(plain, false);
            let braced = behind.strip_prefix('{').and_then(|inner| inner.split_once('}'));
            let end = behind.find(|c: char| !c.is_alphanumeric()).unwrap_or(behind.len());
            let (subscript, after) = braced.unwrap_or_else(|| behind.split_at(end));
            // A lone underscore is literal.
            label.push(if subscript.is_empty() { "_" } else { subscript }, !subscript.is_empty());
            rest = after;
        }
        label.push(rest, false);
        label
    }

    /// Appends plain text.
    pub fn then(mut self, text: &str) -> Label {
        self.push(text, false);
        self
    }

    fn push(&mut self, text: &str, is_subscript: bool) {
        if !text.is_empty() {
            self.runs.push(Run { text: text.into(), is_subscript });
        }
    }

    /// Returns the pieces.
    pub fn runs(&self) -> &[Run] {
        &self.runs
    }

    /// True for a label without characters.
    pub fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }

    /// True if a part of it is a subscript.
    pub fn has_subscript(&self) -> bool {
        self.runs.iter().any(|run| run.is_subscript)
    }

    /// Returns the text without notation.
    pub fn plain(&self) -> String {
        self.runs.iter().map(|run| run.text.as_str()).collect()
    }

    /// Returns the pieces with their places, and the total width.
    pub fn set(&self, size: f64) -> (Vec<Set>, f64) {
        let mut left = 0.0;
        let place = |run: &Run| {
            let (factor, lowered) = if run.is_subscript { SUBSCRIPT } else { (1.0, 0.0) };
            let slope = if run.is_symbol() { Slope::Italic } else { Slope::Upright };
            let piece =
                Set { slope, size: factor * size, at: [left, lowered * size], text: run.text.clone() };
            left += piece.size * lettering::width(&piece.text, slope);
            piece
        };
        (self.runs.iter().map(place).collect(), left)
    }

    /// Returns the width in the embedded font, which is close to that in other fonts.
    pub fn width(&self, size: f64) -> f64 {
        self.set(size).1
    }

    /// Returns an SVG element with the left end, middle or right end of the base line at a place.
    ///
    /// A text with accents is drawn as outlines, since many fonts hide dots above tall letters such
    /// as θ.
    pub fn element(&self, at: [f64; 2], size: f64, anchor: Anchor, attributes: &str) -> String {
        if self.runs.iter().any(|run| run.text.contains(lettering::is_accent)) {
            return self.outlined(at, size, anchor, attributes);
        }
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let ([x, y], letters) = (at.map(number), number(size));
        let content = self.content(size);
        format!("<text x=\"{x}\" y=\"{y}\" font-size=\"{letters}\"{anchor}{attributes}>{content}</text>\n")
    }

    fn outlined(&self, at: [f64; 2], size: f64, anchor: Anchor, attributes: &str) -> String {
        let (pieces, width) = self.set(size);
        let place = |piece: &Set| {
            let [x, y] = [at[0] + anchor.offset(width) + piece.at[0], at[1] + piece.at[1]];
            Transform::from_translate(x as f32, y as f32).pre_scale(piece.size as f32, piece.size as f32)
        };
        let data = |piece: &Set| {
            Some(path_data(lettering::outline(&piece.text, piece.slope)?.transform(place(piece))?.segments()))
        };
        let data: String = pieces.iter().filter_map(data).collect();
        let name = escaped(&self.plain());
        let attributes = format!(" fill-rule=\"nonzero\"{attributes}");
        format!("<g role=\"img\" aria-label=\"{name}\"><path d=\"{data}\"{attributes}/></g>\n")
    }

    /// Returns the content of an SVG text element: symbols in italics, subscripts smaller and
    /// lower.
    ///
    /// Sizes are in the units of the picture, which every viewer supports. Some viewers reject
    /// percentages, or `em` for a part of a text.
    pub fn content(&self, size: f64) -> String {
        let mut content = String::new();
        let mut is_lowered = false;
        for run in &self.runs {
            content += &span(run, size, is_lowered);
            is_lowered = run.is_subscript;
        }
        content
    }

    /// Returns HTML elements: symbols in italics, subscripts as `sub`.
    pub fn html(&self) -> String {
        let piece = |run: &Run| {
            let text = escaped(&run.text);
            match (run.is_subscript, run.is_symbol()) {
                (true, _) => format!("<sub>{text}</sub>"),
                (false, true) => format!("<i>{text}</i>"),
                (false, false) => text,
            }
        };
        self.runs.iter().map(piece).collect()
    }
}

/// Returns the attribute `d` of a path.
fn path_data(segments: impl Iterator<Item = PathSegment>) -> String {
    let point = |point: Point| format!("{} {}", number(point.x.into()), number(point.y.into()));
    let command = |segment| match segment {
        PathSegment::MoveTo(to) => format!("M{}", point(to)),
        PathSegment::LineTo(to) => format!("L{}", point(to)),
        PathSegment::QuadTo(a, to) => format!("Q{} {}", point(a), point(to)),
        PathSegment::CubicTo(a, b, to) => format!("C{} {} {}", point(a), point(b), point(to)),
        PathSegment::Close => "Z".into(),
    };
    segments.map(command).collect()
}

/// Returns one piece of a text in letters of this size; `is_lowered` is true if the previous piece
/// is a subscript.
fn span(run: &Run, size: f64, is_lowered: bool) -> String {
    let (factor, lowered) = SUBSCRIPT;
    let lowered = number(size * lowered);
    let mut attributes = String::new();
    if run.is_subscript && !is_lowered {
        attributes += &format!(" dy=\"{lowered}\"");
    } else if is_lowered && !run.is_subscript {
        attributes += &format!(" dy=\"-{lowered}\"");
    }
    if run.is_subscript {
        attributes += &format!(" font-size=\"{}\"", number(size * factor));
    }
    if run.is_symbol() {
        attributes += " font-style=\"italic\"";
    }
    let text = escaped(&run.text);
    if attributes.is_empty() { text } else { format!("<tspan{attributes}>{text}</tspan>") }
}

#[cfg(test)]
mod tests;
