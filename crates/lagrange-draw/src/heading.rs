//! Titles above pictures and notes below them. Long ones are broken into lines or set in smaller
//! letters.

use crate::colour::{INK, REST};
use crate::picture::Mark;
use crate::view::{BORDER, MARGIN};
use lagrange_plot::label::{Anchor, Label};
use lagrange_plot::lettering::LEEWAY;

/// A typeset title.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Heading {
    size: f64,
    lines: Vec<String>,
}

/// Default font size.
const FONT: f64 = 16.0;
/// Factor by which the font size is reduced until the title fits.
const SMALLER: f64 = 0.9;
/// Font size of notes relative to titles.
const NOTE: f64 = 0.8;
/// Line spacing relative to the font size.
const LINE: f64 = 1.2;
/// Space below the last line, in pixels.
const BELOW: f64 = 4.0;
/// Maximum number of lines.
const MAX_LINES: usize = 3;
/// Maximum fraction of the picture's height.
const SHARE: f64 = 0.25;
/// Minimum font size.
const LEAST: f64 = 0.5;

/// Sets a note in small letters; an empty text gives no lines.
pub(super) fn note(text: &str, size: [f64; 2]) -> Heading {
    let Heading { size, lines } = lines(text, size);
    // Lines broken for larger letters also fit in smaller ones.
    Heading { size: NOTE * size, lines }
}

/// A word of a title, with its width in letters of size 1 with and without a preceding blank.
struct Word<'t> {
    text: &'t str,
    width: f64,
    behind_blank: f64,
}

impl Word<'_> {
    fn new(text: &str) -> Word<'_> {
        Word { text, width: width(text), behind_blank: width(&format!(" {text}")) }
    }

    /// Returns the number of opening minus closing braces.
    fn braces(&self) -> isize {
        self.text.matches('{').count() as isize - self.text.matches('}').count() as isize
    }
}

/// Returns the width of a text in letters of size 1.
fn width(text: &str) -> f64 {
    Label::parse(text).width(1.0)
}

/// Sets a title in the largest letters that fit above a picture of this size.
pub(super) fn lines(title: &str, [across, down]: [f64; 2]) -> Heading {
    let room = across - 2.0 * BORDER;
    // Widths are measured once, since long titles are broken at many sizes.
    let words = title.split_whitespace().map(Word::new).collect::<Vec<_>>();
    let mut size = FONT;
    loop {
        let lines = wrapped(&words, room / (LEEWAY * size));
        let is_narrow = lines.iter().all(|(_, width)| LEEWAY * width * size <= room);
        let is_low = lines.len() <= 1 || lines.len() as f64 * LINE * size <= SHARE * down;
        // A picture without any room is rejected for its size.
        if (is_narrow && is_low && lines.len() <= MAX_LINES) || size < LEAST || room.is_nan() {
            return Heading { size, lines: lines.into_iter().map(|(line, _)| line).collect() };
        }
        size *= SMALLER;
    }
}

/// Breaks lines at blanks that would exceed this length in letters of size 1, and returns each with
/// its width.
fn wrapped(words: &[Word<'_>], longest: f64) -> Vec<(String, f64)> {
    let mut lines: Vec<(String, f64)> = Vec::new();
    let mut braces = 0;
    for word in words {
        match lines.last_mut() {
            // Blanks within braces belong to a subscript.
            Some((line, width)) if braces > 0 || *width + word.behind_blank <= longest => {
                line.push(' ');
                line.push_str(word.text);
                *width += word.behind_blank;
            }
            _ => {
                lines.push((word.text.to_string(), word.width));
                braces = 0;
            }
        }
        braces += word.braces();
    }
    lines
}

/// Returns the height below the margin in pixels.
pub(super) fn height(heading: &Heading) -> f64 {
    match heading.lines.len() {
        0 => 0.0,
        count => heading.size + LINE * heading.size * (count - 1) as f64 + 0.2 * heading.size + BELOW,
    }
}

/// Returns the marks of the lines, centred at the top.
pub(super) fn marks(heading: &Heading, [across, _]: [f64; 2]) -> Vec<Mark> {
    let size = heading.size;
    let mark = |(index, text): (usize, &String)| Mark::Text {
        at: [0.5 * across, MARGIN + size * (1.0 + LINE * index as f64)],
        text: text.clone(),
        size,
        anchor: Anchor::Middle,
        colour: INK,
    };
    heading.lines.iter().enumerate().map(mark).collect()
}

/// Returns the marks of the lines, centred at the bottom.
pub(super) fn marks_below(heading: &Heading, size: [f64; 2]) -> Vec<Mark> {
    let shift = size[1] - 2.0 * MARGIN - height(heading);
    let mut marks = marks(heading, size);
    for mark in &mut marks {
        if let Mark::Text { at, colour, .. } = mark {
            at[1] += shift + BELOW;
            *colour = REST;
        }
    }
    marks
}

#[cfg(test)]
mod tests {
    use super::width;
    use super::{FONT, LINE, lines};

    const LONG: &str = "A step ladder whose right foot slips along the floor, and the instantaneous centre of rotation of \
                        its right half, with the circle on which it runs";

    #[test]
    fn no_title_is_wider_than_its_picture_nor_is_a_word_lost() {
        for [across, down] in [[640.0, 400.0], [320.0, 320.0], [120.0, 90.0]] {
            for title in
                [LONG, "Antidisestablishmentarianisms_of_electroencephalographs", "Short", "J_{S P} of it"]
            {
                let heading = lines(title, [across, down]);
                assert!(heading.lines.iter().all(|line| heading.size * width(line) <= across), "{heading:?}");
                assert!(heading.lines.len() as f64 * LINE * heading.size <= 0.3 * down);
                assert_eq!(heading.lines.join(" "), title);
            }
        }
    }

    #[test]
    fn what_fits_stays_as_it_is_and_what_is_long_is_broken_before_it_shrinks() {
        let short = lines("Short", [640.0, 400.0]);
        assert_eq!((short.size, short.lines.len()), (FONT, 1));
        let long = lines(LONG, [640.0, 400.0]);
        assert_eq!((long.size, long.lines.len()), (FONT, 2));
        assert!(lines(LONG, [120.0, 90.0]).size < FONT);
    }
}
