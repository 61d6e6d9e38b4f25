//! Values over two quantities, as a grid of coloured cells.

use crate::axes::{Frame, Side, draw_border, draw_ordinate, points};
use crate::axis::{Axis, Scale};
use crate::colours::mixed;
use crate::image::{Image, Placed};
use crate::label::Label;
use crate::paper::Paper;

/// A grid of cells with one value each, coloured from dark blue for the smallest to yellow for the
/// largest value. Cells whose value is not finite remain
/// blank.
#[derive(Clone, PartialEq, Debug)]
pub struct Cells {
    /// Name of the values.
    pub name: Label,
    /// Scale of the colours.
    pub scale: Scale,
    /// The left and the right edge of the grid.
    pub x: (f64, f64),
    /// Its lower and its upper edge.
    pub y: (f64, f64),
    /// Number of columns.
    pub columns: usize,
    /// Values from left to right, in rows starting at the bottom.
    pub values: Vec<f64>,
}

/// Colours at equal distances from the smallest to the largest value: `viridis` by Stéfan van der
/// Walt and Nathaniel Smith (2015).
const VIRIDIS: [[u8; 3]; 8] = [
    [68, 1, 84],
    [70, 50, 127],
    [54, 92, 141],
    [39, 127, 142],
    [31, 161, 135],
    [74, 194, 109],
    [159, 218, 58],
    [253, 231, 37],
];
/// Layout of the colour bar: its distance from the grid, its width, and the width of its marks and
/// its name.
const GAP: i32 = 12;
const BAR: i32 = 14;
const LABELS: i32 = 62;
/// Number of colours in the bar.
const SHADES: u32 = 256;
/// Approximate number of pixels along a side of the grid, if its cells are larger than a pixel.
const SIDE: u32 = 1000;

impl Cells {
    pub(crate) fn rows(&self) -> usize {
        self.values.len() / self.columns.max(1)
    }

    /// Returns the size of a grid whose cells have a whole number of pixels, for this number of
    /// pixels per unit.
    pub(crate) fn size(&self, pixels: u32) -> (u32, u32) {
        let (columns, rows) = (self.columns as u32, self.rows() as u32);
        let each = (SIDE / columns.max(rows).max(1)).max(1);
        let is_even = columns % pixels == 0 && rows % pixels == 0;
        let each = if is_even { each } else { each.next_multiple_of(pixels) };
        (columns * each / pixels, rows * each / pixels)
    }

    /// Returns the width of the bar on the right.
    pub(crate) fn bar_width() -> i32 {
        points(GAP + BAR + LABELS)
    }

    fn axis(&self, rows: u32) -> Axis {
        Axis::exact(self.scale, self.values.iter().copied(), rows)
    }

    /// Returns the grid in its frame, and the bar next to it.
    pub(crate) fn images(&self, frame: &Frame) -> [Placed; 2] {
        let axis = self.axis(frame.rows());
        let rows = self.values.chunks(self.columns.max(1)).rev();
        let grid = rows.flatten().flat_map(|value| colour(axis.place(*value))).collect();
        let shades = (0..SHADES).rev().map(|shade| f64::from(shade) / f64::from(SHADES - 1));
        let bar = Image { columns: 1, rgba: shades.flat_map(colour).collect() };
        let grid = Image { columns: self.columns as u32, rgba: grid };
        [Placed { image: grid, frame: *frame }, Placed { image: bar, frame: bar_frame(frame) }]
    }

    /// Draws the marks and the name of the bar.
    pub(crate) fn draw_bar(&self, paper: &mut dyn Paper, frame: &Frame) {
        let bar = bar_frame(frame);
        draw_border(paper, &bar);
        draw_ordinate(paper, &bar, Side::Right, &self.axis(frame.rows()), &self.name);
    }
}

fn bar_frame(frame: &Frame) -> Frame {
    let left = frame.right + points(GAP);
    Frame { left, right: left + points(BAR), is_ruled: false, ..*frame }
}

/// Returns red, green, blue and opacity at this place between the smallest and the largest value.
fn colour(place: f64) -> [u8; 4] {
    if !place.is_finite() {
        return [0; 4];
    }
    let place = place.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let below = (place.floor() as usize).min(VIRIDIS.len() - 2);
    let [red, green, blue] = mixed(VIRIDIS[below], VIRIDIS[below + 1], place - below as f64);
    [red, green, blue, u8::MAX]
}
