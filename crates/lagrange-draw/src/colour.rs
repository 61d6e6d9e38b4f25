//! Colours of drawings: those of Okabe and Ito, *Color Universal Design* (2008), which people with
//! any colour vision can distinguish.

use crate::picture::Colour;

/// Outlines, joints and text.
pub(super) const INK: Colour = Colour([40, 40, 40, 255]);
/// Lines that help.
pub(super) const PALE: Colour = Colour([130, 130, 130, 255]);
pub(super) const HATCHING: Colour = Colour([150, 150, 150, 255]);
/// Colour of the background.
pub(super) const PAPER: Colour = Colour([255, 255, 255, 255]);

/// The colours of what moves and acts.
pub(super) const VELOCITY: Colour = INKS[1];
pub(super) const ACCELERATION: Colour = INKS[4];
pub(super) const FORCE: Colour = INKS[2];
/// Forces without a name.
pub(super) const REST: Colour = INK;
pub(super) const CENTER: Colour = INKS[3];

const INKS: [Colour; 7] = [
    INK,
    Colour([0, 114, 178, 255]),
    Colour([213, 94, 0, 255]),
    Colour([0, 158, 115, 255]),
    Colour([204, 121, 167, 255]),
    Colour([230, 159, 0, 255]),
    Colour([86, 180, 233, 255]),
];

/// Fraction of paper in the colour of a body.
const LIGHTNESS: f64 = 0.78;
/// The order of the colours of bodies: neighbours differ much.
const BODIES: [usize; 6] = [6, 5, 3, 4, 1, 2];

/// The order of the colours of traces.
const TRACES: [usize; 6] = [3, 5, 6, 4, 1, 2];

/// The colour of the trace of this index.
pub(super) fn trace(index: usize) -> Colour {
    INKS[TRACES[index % TRACES.len()]]
}

/// The colour of this number; numbers beyond the last start again.
pub(super) fn ink(number: usize) -> Colour {
    INKS[number % INKS.len()]
}

/// The light colour of the body of this index.
pub(super) fn body(index: usize) -> Colour {
    light(INKS[BODIES[index % BODIES.len()]])
}

/// Returns the colour of the body of this index in pictures of the plane, as CSS has it.
pub fn body_colour(index: usize) -> String {
    let Colour([red, green, blue, _]) = body(index);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Fraction of paper in the colour of a solid, whose shaded faces are darker.
const SOLID: f64 = 0.45;

/// The colour of the solid body of this index where light falls on it.
pub(super) fn solid(index: usize) -> Colour {
    mixed(INKS[BODIES[index % BODIES.len()]], PAPER, SOLID)
}

/// A colour with a part of another, whose opacity stays.
pub(super) fn mixed(Colour(a): Colour, Colour(b): Colour, part: f64) -> Colour {
    let mix = |channel: usize| {
        let [a, b] = [a[channel], b[channel]].map(f64::from);
        (a + part * (b - a)).round().clamp(0.0, 255.0) as u8
    };
    Colour([mix(0), mix(1), mix(2), a[3]])
}

/// Lightens a colour for areas below dark marks.
pub(super) fn light(colour: Colour) -> Colour {
    mixed(colour, PAPER, LIGHTNESS)
}
