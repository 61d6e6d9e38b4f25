//! Axes of figures: their places, marks and labels.

use crate::axis::Axis;
use crate::colours::{GRID, INK};
use crate::label::{Anchor, Label};
use crate::paper::{Down, Paper, Place};
use crate::thin::Point;

/// Number of points per unit of size: curves are drawn to a tenth of a unit.
pub(crate) const FINENESS: u32 = 10;

/// The place of a panel, in points: left, right, top and bottom of its axes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Frame {
    pub(crate) left: i32,
    pub(crate) right: i32,
    pub(crate) top: i32,
    pub(crate) bottom: i32,
    /// True if grid lines cross it at all marks.
    pub(crate) is_ruled: bool,
}

/// Margins around the axes for labels: left, right, top and bottom.
const MARGINS: (u32, u32, u32, u32) = (74, 18, 28, 50);
const TICK: i32 = 5;
/// Distances from an ordinate to the far side of its name on the left, and to the near side on the
/// right.
const NAMES: [i32; 2] = [66, 49];
/// Width and height of a mark with its label.
const MARK: (i32, i32) = (90, 30);
const THIN: u32 = 10;

/// Returns the size of a panel whose axes have this size, with labels on the left and below.
pub(crate) fn around((width, height): (u32, u32)) -> (u32, u32) {
    let (left, right, top, bottom) = MARGINS;
    (left + width + right, top + height + bottom)
}

impl Frame {
    /// Creates a panel with this upper left corner and size.
    pub(crate) fn new(corner: (u32, u32), size: (u32, u32)) -> Self {
        let (left, right, top, bottom) = MARGINS;
        let points = |units: u32| (units * FINENESS) as i32;
        Frame {
            left: points(corner.0 + left),
            right: points(corner.0 + size.0.saturating_sub(right)),
            top: points(corner.1 + top),
            bottom: points(corner.1 + size.1.saturating_sub(bottom)),
            is_ruled: true,
        }
    }

    pub(crate) fn x(&self, place: f64) -> f64 {
        f64::from(self.left) + place * f64::from(self.right - self.left)
    }

    pub(crate) fn y(&self, place: f64) -> f64 {
        f64::from(self.bottom) - place * f64::from(self.bottom - self.top)
    }

    /// Returns the corners, starting at the upper left.
    fn corners(&self) -> [(i32, i32); 5] {
        let Frame { left, right, top, bottom, .. } = *self;
        [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)]
    }

    /// Returns the number of ticks that fit along the abscissa.
    pub(crate) fn columns(&self) -> u32 {
        marks(self.right - self.left, MARK.0)
    }

    /// Returns the number of ticks that fit along an ordinate.
    pub(crate) fn rows(&self) -> u32 {
        marks(self.bottom - self.top, MARK.1)
    }
}

/// Returns the number of ticks that fit along a length.
fn marks(length: i32, each: i32) -> u32 {
    (length / points(each)).clamp(4, 10).unsigned_abs()
}

/// Converts units of size to points.
pub(crate) fn points(units: i32) -> i32 {
    units * FINENESS as i32
}

/// Returns the nearest whole point.
pub(crate) fn rounded((x, y): Point) -> (i32, i32) {
    (x.round() as i32, y.round() as i32)
}

/// Draws a border around the axes.
pub(crate) fn draw_border(paper: &mut dyn Paper, frame: &Frame) {
    paper.line(&frame.corners(), INK, THIN);
}

/// Draws marks and labels of the abscissa.
pub(crate) fn draw_abscissa(paper: &mut dyn Paper, frame: &Frame, axis: &Axis, name: &Label) {
    let place = |at, anchor| Place { at, anchor, down: Down::Below, is_turned: false };
    for mark in &axis.marks {
        let x = frame.x(mark.place).round() as i32;
        if frame.is_ruled {
            paper.line(&[(x, frame.top), (x, frame.bottom)], GRID, THIN);
        }
        paper.line(&[(x, frame.bottom), (x, frame.bottom + points(TICK))], INK, THIN);
        let at = (x, frame.bottom + points(TICK + 3));
        paper.write(&mark.label.as_str().into(), place(at, Anchor::Middle));
    }
    let below = frame.bottom + points(28);
    paper.write(name, place(((frame.left + frame.right) / 2, below), Anchor::Middle));
    if !axis.note.is_empty() {
        paper.write(&axis.note.as_str().into(), place((frame.right, below), Anchor::End));
    }
}

/// The side of an ordinate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Side {
    Left,
    Right,
}

/// Draws marks and labels of an ordinate.
pub(crate) fn draw_ordinate(paper: &mut dyn Paper, frame: &Frame, side: Side, axis: &Axis, name: &Label) {
    let (edge, outwards, anchor, column) = match side {
        Side::Left => (frame.left, -1, Anchor::End, NAMES[0]),
        Side::Right => (frame.right, 1, Anchor::Start, NAMES[1]),
    };
    let out = |units: i32| edge + outwards * points(units);
    for mark in &axis.marks {
        let y = frame.y(mark.place).round() as i32;
        if frame.is_ruled {
            paper.line(&[(frame.left, y), (frame.right, y)], GRID, THIN);
        }
        paper.line(&[(out(TICK), y), (edge, y)], INK, THIN);
        let place = Place { at: (out(TICK + 3), y), anchor, down: Down::Level, is_turned: false };
        paper.write(&mark.label.as_str().into(), place);
    }
    let at = (out(column), (frame.top + frame.bottom) / 2);
    paper.write(name, Place { at, anchor: Anchor::Middle, down: Down::Below, is_turned: true });
    if !axis.note.is_empty() {
        let at = (frame.left, frame.top - points(4));
        let place = Place { at, anchor: Anchor::Start, down: Down::Above, is_turned: false };
        paper.write(&axis.note.as_str().into(), place);
    }
}
