//! Colours of all pictures and pages, each on white paper and on a dark ground.
//!
//! Hues follow Okabe and Ito, *Color Universal Design* (2008), and are distinguishable with any
//! colour vision. They are darker or lighter where lines would otherwise contrast too little with
//! the ground (W3C, *Web Content Accessibility Guidelines 2.2*, 1.4.3 and 1.4.11).
//!
//! SVG documents contain the colours on paper as attributes, and a style sheet with their
//! replacements for screens of readers who prefer dark. Printed pages and pixels remain white.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::characters::number;

/// A colour on white paper and on a dark ground.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Colour {
    /// Red, green and blue on paper, each from 0 to 255.
    pub light: [u8; 3],
    /// Red, green and blue on a dark ground.
    pub dark: [u8; 3],
    /// Opacity, from 0 to 255.
    pub opacity: u8,
}

/// Colour of the background.
pub const PAPER: Colour = Colour::new(0xff_ff_ff, 0x17_19_1c);
/// Colour of axes, outlines and text.
pub const INK: Colour = Colour::new(0x28_28_28, 0xe6_e6_e6);
/// Colour of grid lines.
pub const GRID: Colour = Colour::new(0xe1_e1_e1, 0x3d_41_47);
/// Colours of curves: blue, vermilion, green, purple, orange, light blue.
pub const CURVES: [Colour; 6] = [
    Colour::new(0x00_72_b2, 0x56_b4_e9),
    Colour::new(0xd5_5e_00, 0xf0_8a_3c),
    Colour::new(0x00_9e_73, 0x2f_c7_9a),
    Colour::new(0xcc_79_a7, 0xdd_93_bd),
    Colour::new(0xc8_87_00, 0xe6_b4_22),
    Colour::new(0x3e_96_d2, 0x9c_c4_e4),
];
/// Class of SVG documents, to which their style sheets are limited.
pub const CLASS: &str = "lagrange";

/// Least contrast of lines with the ground.
pub const LINES: f64 = 3.0;
/// Least contrast of text with the ground.
const TEXT: f64 = 4.5;
/// Number of fractions of ink tried for text.
const STEPS: u8 = 10;

impl Colour {
    /// Creates an opaque colour from two numbers with digits for red, green and blue.
    pub const fn new(light: u32, dark: u32) -> Colour {
        let [_, a, b, c] = light.to_be_bytes();
        let [_, d, e, f] = dark.to_be_bytes();
        Colour { light: [a, b, c], dark: [d, e, f], opacity: u8::MAX }
    }

    /// Mixes a fraction of another colour into it, keeping its opacity.
    #[must_use]
    pub fn mixed(self, other: Colour, part: f64) -> Colour {
        let (light, dark) = (mixed(self.light, other.light, part), mixed(self.dark, other.dark, part));
        Colour { light, dark, ..self }
    }

    /// Returns the colour of text that names things of this colour: with as little ink as makes it
    /// legible on both grounds.
    #[must_use]
    pub fn text(self) -> Colour {
        let mut mixtures = (0..STEPS).map(|step| self.mixed(INK, f64::from(step) / f64::from(STEPS)));
        mixtures.find(|colour| colour.contrast(PAPER) >= TEXT).unwrap_or(INK)
    }

    /// Returns the contrast with another colour, the smaller one of both grounds: 1 for the same
    /// colour, up to 21.
    pub fn contrast(self, other: Colour) -> f64 {
        contrast(self.light, other.light).min(contrast(self.dark, other.dark))
    }

    /// Returns the colour on paper, in CSS notation.
    pub fn css(self) -> String {
        css(self.light)
    }

    /// Returns the colours on paper and on a dark ground, in CSS notation.
    pub fn pair(self) -> [String; 2] {
        [self.light, self.dark].map(css)
    }

    /// Returns an attribute of an SVG element with the colour on paper, preceded by a blank.
    pub fn paint(self, attribute: &str) -> String {
        let colour = format!(" {attribute}=\"{}\"", self.css());
        if self.opacity == u8::MAX {
            return colour;
        }
        format!("{colour} {attribute}-opacity=\"{}\"", number(f64::from(self.opacity) / 255.0))
    }
}

/// Mixes a fraction of a second colour into a first.
pub(crate) fn mixed(from: [u8; 3], to: [u8; 3], part: f64) -> [u8; 3] {
    [0, 1, 2].map(|channel| {
        let [from, to] = [from, to].map(|colour| f64::from(colour[channel]));
        (from + part * (to - from)).round().clamp(0.0, 255.0) as u8
    })
}

/// Returns the linear intensity of a channel. Source: IEC 61966-2-1, *sRGB* (1999).
pub fn linear(channel: u8) -> f64 {
    let value = f64::from(channel) / 255.0;
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

fn contrast(one: [u8; 3], other: [u8; 3]) -> f64 {
    let luminance = |colour: [u8; 3]| {
        let [red, green, blue] = colour.map(linear);
        0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.05
    };
    let (one, other) = (luminance(one), luminance(other));
    one.max(other) / one.min(other)
}

fn css([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Returns the style sheet of an SVG document with these colours and the paper.
pub fn style(colours: impl IntoIterator<Item = Colour>) -> String {
    let mut colours: BTreeMap<_, _> =
        colours.into_iter().chain([PAPER]).map(|colour| (colour.light, colour.dark)).collect();
    // A shade may equal a named colour on paper alone.
    for named in CURVES.into_iter().chain([GRID, INK]) {
        colours.entry(named.light).and_modify(|dark| *dark = named.dark);
    }
    let mut rules = String::new();
    for (light, dark) in colours {
        let (light, dark) = (css(light), css(dark));
        let _ = write!(rules, "[fill=\"{light}\"]{{fill:{dark}}}[stroke=\"{light}\"]{{stroke:{dark}}}");
    }
    format!("<style>@media screen and (prefers-color-scheme:dark){{.{CLASS}{{{rules}}}}}</style>\n")
}

/// Returns the colours of pages as variables in CSS.
pub fn variables() -> String {
    let named = [("ground", PAPER), ("ink", INK), ("faint", GRID), ("accent", CURVES[0])];
    let named = named.map(|(name, colour)| (name.to_owned(), colour)).into_iter();
    let curves = CURVES.iter().enumerate().map(|(index, colour)| (format!("curve-{index}"), *colour));
    let all: Vec<(String, Colour)> = named.chain(curves).collect();
    let list = |side: fn(&Colour) -> [u8; 3]| -> String {
        all.iter().map(|(name, colour)| format!(" --{name}: {};", css(side(colour)))).collect()
    };
    format!(
        ":root {{ color-scheme: light dark;{} }}\n@media (prefers-color-scheme: dark) {{ :root {{{} }} }}\n",
        list(|colour| colour.light),
        list(|colour| colour.dark)
    )
}

#[cfg(test)]
mod tests {
    use super::{CURVES, Colour, INK, LINES, PAPER, TEXT, contrast, style};

    #[test]
    fn contrasts_are_those_of_the_guidelines() {
        assert!((contrast([0; 3], [255; 3]) - 21.0).abs() < 1e-12);
        assert!((contrast([119; 3], [255; 3]) - 4.48).abs() < 0.005);
    }

    #[test]
    fn lines_and_text_contrast_with_both_grounds() {
        for colour in CURVES.into_iter().chain([INK]) {
            assert!(colour.contrast(PAPER) >= LINES, "{colour:?}");
            assert!(colour.text().contrast(PAPER) >= TEXT, "{colour:?}");
        }
        assert!(INK.text() == INK && CURVES[0].text() == CURVES[0], "they are legible without ink");
        assert!(PAPER.text().contrast(PAPER) >= TEXT);
    }

    #[test]
    fn shades_that_look_like_ink_on_paper_do_not_change_text() {
        let shade = Colour::new(0x28_28_28, 0x90_90_90);
        assert_eq!(style([INK, shade]), style([INK]));
    }

    #[test]
    fn a_style_sheet_replaces_each_colour_once() {
        let colour = Colour::new(0x01_02_03, 0x0a_0b_0c);
        assert_eq!(
            style([colour, colour]),
            "<style>@media screen and (prefers-color-scheme:dark){.lagrange{\
             [fill=\"#010203\"]{fill:#0a0b0c}[stroke=\"#010203\"]{stroke:#0a0b0c}\
             [fill=\"#ffffff\"]{fill:#17191c}[stroke=\"#ffffff\"]{stroke:#17191c}}}</style>\n"
        );
    }
}
