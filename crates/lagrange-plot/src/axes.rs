//! Axes on paper: where they lie, their marks and what is written beside them.

use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontTransform, IntoFont, RGBColor, ShapeStyle, TextStyle};
use plotters_backend::{DrawingBackend, DrawingErrorKind};

use crate::axis::Axis;
use crate::characters::shown;
use crate::lettering::FAMILY;
use crate::thin::Point;

/// Points of backends to the unit of sizes: curves are drawn to a tenth of it.
pub(crate) const FINENESS: u32 = 10;

/// The place of a panel, in points: left, right, top and bottom of its axes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Frame {
    pub(crate) left: i32,
    pub(crate) right: i32,
    pub(crate) top: i32,
    pub(crate) bottom: i32,
    /// True if lines run across it at all marks.
    pub(crate) is_ruled: bool,
}

/// Margins around the axes for labels: left, right, top and bottom.
const MARGINS: (u32, u32, u32, u32) = (74, 18, 28, 50);
/// The size of letters.
pub(crate) const FONT: i32 = 17;
const TICK: i32 = 5;
/// From an ordinate to the far side of its name.
const NAME: i32 = 66;
/// Width and height that a mark with its label takes.
const MARK: (i32, i32) = (90, 30);
const INK: RGBColor = RGBColor(40, 40, 40);
const GRID: RGBColor = RGBColor(225, 225, 225);

pub(crate) type Drawn<B> = Result<(), DrawingErrorKind<<B as DrawingBackend>::ErrorType>>;

/// The size of a panel whose axes have this size, with labels on the left and below.
pub(crate) fn around((width, height): (u32, u32)) -> (u32, u32) {
    let (left, right, top, bottom) = MARGINS;
    (left + width + right, top + height + bottom)
}

impl Frame {
    /// A panel with this upper left corner and size.
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

    /// From the upper left all around.
    fn corners(&self) -> [(i32, i32); 5] {
        let Frame { left, right, top, bottom, .. } = *self;
        [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)]
    }

    /// Returns the number of ticks that fit below.
    pub(crate) fn columns(&self) -> u32 {
        marks(self.right - self.left, MARK.0)
    }

    /// Returns the number of ticks that fit at a side.
    pub(crate) fn rows(&self) -> u32 {
        marks(self.bottom - self.top, MARK.1)
    }
}

/// Returns the number of ticks that fit along a length.
fn marks(length: i32, each: i32) -> u32 {
    (length / points(each)).clamp(4, 10).unsigned_abs()
}

/// This many units of sizes in points.
pub(crate) fn points(units: i32) -> i32 {
    units * FINENESS as i32
}

/// The nearest whole point.
pub(crate) fn rounded((x, y): Point) -> (i32, i32) {
    (x.round() as i32, y.round() as i32)
}

/// A line around everything that is drawn.
pub(crate) fn draw_border<B: DrawingBackend>(backend: &mut B, frame: &Frame) -> Drawn<B> {
    backend.draw_path(frame.corners(), &line(INK, 10))
}

/// Marks and labels below.
pub(crate) fn draw_abscissa<B: DrawingBackend>(
    backend: &mut B,
    frame: &Frame,
    axis: &Axis,
    name: &str,
) -> Drawn<B> {
    let style = text(HPos::Center, VPos::Top, FontTransform::None);
    for mark in &axis.marks {
        let x = frame.x(mark.place).round() as i32;
        if frame.is_ruled {
            backend.draw_path([(x, frame.top), (x, frame.bottom)], &line(GRID, 10))?;
        }
        backend.draw_path([(x, frame.bottom), (x, frame.bottom + points(TICK))], &line(INK, 10))?;
        write(backend, &mark.label, &style, (x, frame.bottom + points(TICK + 3)))?;
    }
    let below = frame.bottom + points(28);
    write(backend, name, &style, ((frame.left + frame.right) / 2, below))?;
    let style = text(HPos::Right, VPos::Top, FontTransform::None);
    if axis.note.is_empty() { Ok(()) } else { write(backend, &axis.note, &style, (frame.right, below)) }
}

/// The side of an ordinate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Side {
    Left,
    Right,
}

/// Marks and labels at a side.
pub(crate) fn draw_ordinate<B: DrawingBackend>(
    backend: &mut B,
    frame: &Frame,
    side: Side,
    axis: &Axis,
    name: &str,
) -> Drawn<B> {
    let (edge, outwards, beside) = match side {
        Side::Left => (frame.left, -1, HPos::Right),
        Side::Right => (frame.right, 1, HPos::Left),
    };
    let out = |units: i32| edge + outwards * points(units);
    let style = text(beside, VPos::Center, FontTransform::None);
    for mark in &axis.marks {
        let y = frame.y(mark.place).round() as i32;
        if frame.is_ruled {
            backend.draw_path([(frame.left, y), (frame.right, y)], &line(GRID, 10))?;
        }
        backend.draw_path([(out(TICK), y), (edge, y)], &line(INK, 10))?;
        write(backend, &mark.label, &style, (out(TICK + 3), y))?;
    }
    let middle = (frame.top + frame.bottom) / 2;
    let upright = text(HPos::Center, VPos::Top, FontTransform::Rotate270);
    let column = out(if side == Side::Left { NAME } else { NAME - FONT });
    write(backend, name, &upright, (column, middle))?;
    let style = text(HPos::Left, VPos::Bottom, FontTransform::None);
    if axis.note.is_empty() {
        Ok(())
    } else {
        write(backend, &axis.note, &style, (frame.left, frame.top - points(4)))
    }
}

/// Writes what pictures show of a text.
pub(crate) fn write<B: DrawingBackend>(
    backend: &mut B,
    text: &str,
    style: &TextStyle<'_>,
    at: (i32, i32),
) -> Drawn<B> {
    backend.draw_text(&shown(text).collect::<String>(), style, at)
}

pub(crate) fn line(color: RGBColor, width: u32) -> ShapeStyle {
    ShapeStyle { color: color.into(), filled: false, stroke_width: width }
}

pub(crate) fn text(horizontal: HPos, vertical: VPos, transform: FontTransform) -> TextStyle<'static> {
    let font = (FAMILY, points(FONT)).into_font().transform(transform);
    TextStyle::from(font).color(&INK).pos(Pos::new(horizontal, vertical))
}
