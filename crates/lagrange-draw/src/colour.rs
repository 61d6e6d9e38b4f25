//! Colours of drawings: those of Okabe and Ito, *Color Universal Design* (2008), which people with
//! any colour vision can distinguish.

use crate::picture::Colour;

/// Colour of outlines, joints and text.
pub(super) const INK: Colour = Colour([40, 40, 40, 255]);
/// Colour of auxiliary lines.
pub(super) const PALE: Colour = Colour([130, 130, 130, 255]);
pub(super) const HATCHING: Colour = Colour([150, 150, 150, 255]);
/// Colour of the background.
pub(super) const PAPER: Colour = Colour([255, 255, 255, 255]);

/// Colour of velocities.
pub(super) const VELOCITY: Colour = INKS[1];
/// Colour of accelerations.
pub(super) const ACCELERATION: Colour = INKS[4];
/// Colour of forces.
pub(super) const FORCE: Colour = INKS[2];
/// Colour of unnamed forces.
pub(super) const REST: Colour = INK;
/// Colour of instantaneous centres.
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

/// Fraction of the background colour in the colour of a body.
const LIGHTNESS: f64 = 0.78;
/// Order of the colours of bodies, in which neighbours differ strongly.
const BODIES: [usize; 6] = [6, 5, 3, 4, 1, 2];

/// Order of the colours of traces.
const TRACES: [usize; 6] = [3, 5, 6, 4, 1, 2];

/// Returns the colour of the trace with this index.
pub(super) fn trace(index: usize) -> Colour {
    INKS[TRACES[index % TRACES.len()]]
}

/// Returns the colour with this number; numbers past the last one wrap around.
pub(super) fn ink(number: usize) -> Colour {
    INKS[number % INKS.len()]
}

/// Returns the light colour of the body with this index.
pub(super) fn body(index: usize) -> Colour {
    light(INKS[BODIES[index % BODIES.len()]])
}

/// Returns the colour of the body with this index in pictures of the plane, in CSS notation.
pub fn body_colour(index: usize) -> String {
    css(body(index))
}

/// Returns an opaque colour in CSS notation.
pub(super) fn css(Colour([red, green, blue, _]): Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Fraction of the background colour in the colour of a solid; its shaded faces are darker.
const SOLID: f64 = 0.45;

/// Returns the colour of the fully lit faces of the solid with this index.
pub(super) fn solid(index: usize) -> Colour {
    mixed(INKS[BODIES[index % BODIES.len()]], PAPER, SOLID)
}

/// Mixes a fraction of another colour into a colour, keeping its opacity.
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
