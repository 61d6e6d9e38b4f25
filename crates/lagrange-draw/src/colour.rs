//! Colours of drawings.

use lagrange_plot::colours::CURVES;

use crate::picture::Colour;

pub(super) use lagrange_plot::colours::{INK, PAPER};

/// Colour of auxiliary lines.
pub(super) const PALE: Colour = Colour::new(0x82_82_82, 0x9a_9e_a4);
pub(super) const HATCHING: Colour = Colour::new(0x91_91_91, 0x86_8a_90);
/// Colour of solid ground.
pub(super) const GROUND: Colour = Colour::new(0xd6_d6_d6, 0x3d_41_47);
/// Colour of faces without light.
pub(super) const SHADOW: Colour = Colour::new(0x28_28_28, 0x28_28_28);

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

const INKS: [Colour; 7] = [INK, CURVES[0], CURVES[1], CURVES[2], CURVES[3], CURVES[4], CURVES[5]];

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

/// Returns the colour of the body with this index in pictures of the plane, on paper and on a dark
/// ground.
pub fn body_colour(index: usize) -> [String; 2] {
    body(index).pair()
}

/// Returns the colours of marks of the plane by name, each on paper and on a dark ground.
pub fn named_colours() -> [(&'static str, [String; 2]); 5] {
    [("ground", PAPER), ("ink", INK), ("pale", PALE), ("hatching", HATCHING), ("load", FORCE)]
        .map(|(name, colour)| (name, colour.pair()))
}

/// Fraction of the background colour in the colour of a solid; its shaded faces are darker.
const SOLID: f64 = 0.45;

/// Returns the colour of the fully lit faces of the solid with this index.
pub(super) fn solid(index: usize) -> Colour {
    INKS[BODIES[index % BODIES.len()]].mixed(PAPER, SOLID)
}

/// Lightens a colour for areas below dark marks.
pub(super) fn light(colour: Colour) -> Colour {
    colour.mixed(PAPER, LIGHTNESS)
}

#[cfg(test)]
mod tests {
    use super::{BODIES, HATCHING, INK, INKS, PALE, PAPER, body, light};
    use lagrange_plot::colours::LINES;

    #[test]
    fn lines_contrast_with_both_grounds_and_rims_and_names_with_bodies() {
        for colour in INKS.into_iter().chain([PALE, HATCHING]) {
            assert!(colour.contrast(PAPER) >= LINES, "{colour:?}");
        }
        for index in 0..BODIES.len() {
            assert!(body(index).contrast(INK) >= 4.5, "{:?}", body(index));
        }
        assert!(INKS.iter().all(|colour| light(*colour).contrast(*colour) >= 2.0), "rims of areas");
    }
}
