//! The colours of a GIF: at most 256 for all its pictures.
//!
//! Boxes of colours are halved across their longest side until there are enough: Heckbert, *Color
//! image quantization for frame buffer display* (1982). Unlike in the source, they are halved in
//! the middle instead of at the median. Pictures are mostly background, and the shades between it
//! and the lines matter.

use std::collections::BTreeMap;

/// Red, green and blue.
pub(super) type Rgb = [u8; 3];

/// Pixel counts of colours.
#[derive(Default)]
pub(super) struct Histogram {
    counts: BTreeMap<Rgb, u64>,
}

impl Histogram {
    /// Counts the pixels of a picture.
    pub(super) fn add(&mut self, rgba: &[u8]) {
        // Neighbouring pixels are mostly equal, and are therefore counted together.
        for run in pixels(rgba).collect::<Vec<_>>().chunk_by(|a, b| a == b) {
            *self.counts.entry(run[0]).or_default() += run.len() as u64;
        }
    }

    /// Returns at most this many representative colours. The most frequent one of each box is
    /// selected, so that areas keep their colour.
    pub(super) fn palette(self, limit: usize) -> Palette {
        // Each box stores the length of its longest side, to avoid recomputing it at every halving
        // of another box.
        let measured = |colours: Vec<(Rgb, u64)>| (longest_side(&colours).1, colours);
        let mut boxes = vec![measured(self.counts.into_iter().collect())];
        while boxes.len() < limit {
            let widest = (0..boxes.len()).max_by_key(|index| boxes[*index].0);
            let Some(index) = widest.filter(|index| boxes[*index].0 > 0) else { break };
            let halves = halve(boxes.swap_remove(index).1);
            boxes.extend(halves.map(measured));
        }
        let most_frequent =
            |(_, colours): &(u8, Vec<(Rgb, u64)>)| colours.iter().max_by_key(|(_, count)| *count).copied();
        let mut colours: Vec<Rgb> =
            boxes.iter().filter_map(most_frequent).map(|(colour, _)| colour).collect();
        colours.sort_unstable();
        Palette { colours, known: BTreeMap::new() }
    }
}

/// Returns the axis and length of the longest side of a box.
fn longest_side(colours: &[(Rgb, u64)]) -> (usize, u8) {
    let side = |axis: usize| {
        let values = || colours.iter().map(|(colour, _)| colour[axis]);
        values().max().unwrap_or(0) - values().min().unwrap_or(0)
    };
    let axis = (0..3).max_by_key(|axis| side(*axis)).unwrap_or(0);
    (axis, side(axis))
}

fn halve(colours: Vec<(Rgb, u64)>) -> [Vec<(Rgb, u64)>; 2] {
    let (axis, length) = longest_side(&colours);
    let low = colours.iter().map(|(colour, _)| colour[axis]).min().unwrap_or(0);
    let (dark, light) = colours.into_iter().partition(|(colour, _)| colour[axis] - low <= length / 2);
    [dark, light]
}

/// Colours with indices.
pub(super) struct Palette {
    pub(super) colours: Vec<Rgb>,
    /// Cached indices of colours.
    known: BTreeMap<Rgb, u8>,
}

impl Palette {
    /// Returns the indices of the nearest colours of all pixels.
    pub(super) fn indices(&mut self, rgba: &[u8]) -> Vec<u8> {
        let mut last = None;
        let index = |colour: Rgb| match last {
            Some((known, index)) if known == colour => index,
            _ => {
                let index = self.index(colour);
                last = Some((colour, index));
                index
            }
        };
        pixels(rgba).map(index).collect()
    }

    fn index(&mut self, colour: Rgb) -> u8 {
        if let Some(index) = self.known.get(&colour) {
            return *index;
        }
        let index = self.nearest(colour) as u8;
        self.known.insert(colour, index);
        index
    }

    /// Returns the index of the nearest colour, the first of several. Colours are sorted by red.
    /// The search proceeds in both directions from the colour's red until the red distance alone
    /// exceeds the best distance.
    fn nearest(&self, colour: Rgb) -> usize {
        let red = self.colours.partition_point(|other| other[0] < colour[0]);
        let mut best = (u32::MAX, 0);
        for side in [&mut (red..self.colours.len()) as &mut dyn Iterator<Item = usize>, &mut (0..red).rev()] {
            for index in side {
                let [r, g, b] =
                    [0, 1, 2].map(|k| u32::from(self.colours[index][k].abs_diff(colour[k])).pow(2));
                if r > best.0 {
                    break;
                }
                best = best.min((r + g + b, index));
            }
        }
        best.1
    }
}

fn pixels(rgba: &[u8]) -> impl Iterator<Item = Rgb> + '_ {
    rgba.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]])
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::{Palette, Rgb};

    #[test]
    fn the_nearest_colour_is_the_first_of_those_that_a_search_through_all_finds() {
        let colour = |k: usize| -> Rgb { [37, 101, 53].map(|step| (k * step % 256 / 8 * 8) as u8) };
        let mut colours: Vec<Rgb> = (0..60).map(colour).collect();
        colours.sort_unstable();
        let palette = Palette { colours, known: BTreeMap::new() };
        for wanted in (0..400).map(|k| [29, 71, 113].map(|step| (k * step % 256) as u8)) {
            let distance = |other: &Rgb| -> u32 {
                other.iter().zip(wanted).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
            };
            let searched = (0..60).min_by_key(|&index| distance(&palette.colours[index]));
            assert_eq!(Some(palette.nearest(wanted)), searched, "{wanted:?}");
        }
    }
}
