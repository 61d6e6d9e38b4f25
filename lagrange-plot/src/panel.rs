//! One pair of axes with curves.

use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontTransform, IntoFont, RGBColor, ShapeStyle, TextStyle};
use plotters_backend::{DrawingBackend, DrawingErrorKind};

use crate::axis::{Axis, Scale};
use crate::canvas;
use crate::lettering::{FAMILY, LEEWAY, Slope, width};
use crate::thin::{Point, thin};

/// Points of backends to the unit of sizes: curves are drawn to a tenth of it.
pub(crate) const FINENESS: u32 = 10;

/// A pair of axes with curves.
#[derive(Clone, PartialEq, Debug)]
pub struct Panel {
    /// What the abscissa is called.
    pub x: String,
    /// What the ordinate is called.
    pub y: String,
    /// How abscissae are spread.
    pub x_scale: Scale,
    /// How ordinates are spread.
    pub y_scale: Scale,
    /// Whether curves keep away from the ends of the abscissa, too.
    pub has_room: bool,
    /// More than one are named in a legend.
    pub curves: Vec<Curve>,
}

/// Points joined by a line, broken where one is not finite.
#[derive(Clone, PartialEq, Debug)]
pub struct Curve {
    /// What it is called in a legend.
    pub name: String,
    /// Abscissae and ordinates, in their order.
    pub points: Vec<Point>,
}

/// Where a panel lies, in points: left, right, top and bottom of its axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    left: i32,
    right: i32,
    top: i32,
    bottom: i32,
}

/// What is left free around the axes for labels: left, right, top and bottom.
const MARGINS: (u32, u32, u32, u32) = (74, 18, 28, 50);
/// The line before a name in a legend.
const SWATCH: i32 = 18;
const FONT: i32 = 17;
const LINE: i32 = 18;
const TICK: i32 = 5;
/// Room above and below curves in terms of their height.
const ROOM: f64 = 0.05;
/// Width and height that a mark with its label takes.
const MARK: (i32, i32) = (90, 30);
/// Half of the width of a curve, about: points closer than this cannot be told apart.
const COLUMN: f64 = 5.0;
const CURVE: u32 = 14;
/// A curve of a single point is a dot of this size.
const DOT: u32 = 60;

const INK: RGBColor = RGBColor(40, 40, 40);
const GRID: RGBColor = RGBColor(225, 225, 225);
/// After Okabe and Ito, without yellow, which is hard to see on white.
const COLORS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
];
/// Ends and middle of the colours of many curves, falling in luminance from the last to the first.
const RAMP: [RGBColor; 3] = [RGBColor(0, 32, 96), RGBColor(124, 123, 120), RGBColor(235, 210, 60)];

type Drawn<B> = Result<(), DrawingErrorKind<<B as DrawingBackend>::ErrorType>>;

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
        }
    }

    fn x(&self, place: f64) -> f64 {
        f64::from(self.left) + place * f64::from(self.right - self.left)
    }

    fn y(&self, place: f64) -> f64 {
        f64::from(self.bottom) - place * f64::from(self.bottom - self.top)
    }

    /// From the upper left all around.
    fn corners(&self) -> [(i32, i32); 5] {
        let Frame { left, right, top, bottom } = *self;
        [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)]
    }

    /// How many marks such a length has room for.
    fn marks(length: i32, each: i32) -> u32 {
        (length / points(each)).clamp(4, 10).unsigned_abs()
    }
}

fn points(units: i32) -> i32 {
    units * FINENESS as i32
}

/// The nearest whole point.
fn rounded((x, y): Point) -> (i32, i32) {
    (x.round() as i32, y.round() as i32)
}

impl Panel {
    /// Draws axes, curves and legend.
    pub(crate) fn draw<B: DrawingBackend>(&self, backend: &mut B, frame: &Frame) -> Drawn<B> {
        let frame = Frame { right: frame.right - self.legend_width(), ..*frame };
        let columns = Frame::marks(frame.right - frame.left, MARK.0);
        let rows = Frame::marks(frame.bottom - frame.top, MARK.1);
        let x = Axis::new(
            self.x_scale,
            self.range(self.x_scale, |point| point.0),
            if self.has_room { ROOM } else { 0.0 },
            columns,
        );
        let y = Axis::new(self.y_scale, self.range(self.y_scale, |point| point.1), ROOM, rows);
        draw_abscissa(backend, &frame, &x, &self.x)?;
        draw_ordinate(backend, &frame, &y, &self.y)?;
        backend.draw_path(frame.corners(), &line(INK, 10))?;
        for (index, curve) in self.curves.iter().enumerate() {
            let place = |point: &Point| (frame.x(x.place(point.0)), frame.y(y.place(point.1)));
            for piece in thin(curve.points.iter().map(place), COLUMN) {
                let mut path: Vec<(i32, i32)> = piece.into_iter().map(rounded).collect();
                path.dedup();
                let is_dot = path.len() == 1;
                path.extend(path.first().copied().filter(|_| is_dot));
                backend.draw_path(path, &line(self.color(index), if is_dot { DOT } else { CURVE }))?;
            }
        }
        self.draw_legend(backend, &frame)
    }

    /// The least and the largest finite value; on a logarithmic axis, of those above zero.
    fn range(&self, scale: Scale, value: impl Fn(&Point) -> f64) -> Option<(f64, f64)> {
        let values = self.curves.iter().flat_map(|curve| curve.points.iter().map(&value));
        let shown = values.filter(|value| value.is_finite() && (scale == Scale::Linear || *value > 0.0));
        shown.fold(None, |range, value| {
            let (low, high) = range.unwrap_or((value, value));
            Some((f64::min(low, value), f64::max(high, value)))
        })
    }

    fn color(&self, index: usize) -> RGBColor {
        if self.curves.len() <= COLORS.len() {
            return COLORS[index % COLORS.len()];
        }
        let place = 2.0 * index as f64 / (self.curves.len() - 1) as f64;
        let (from, to, part) =
            if place < 1.0 { (RAMP[0], RAMP[1], place) } else { (RAMP[1], RAMP[2], place - 1.0) };
        let mix =
            |from: u8, to: u8| (f64::from(from) + part * (f64::from(to) - f64::from(from))).round() as u8;
        RGBColor(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
    }

    /// In points; none for a single curve.
    fn legend_width(&self) -> i32 {
        if self.curves.len() < 2 {
            return 0;
        }
        let longest = self.curves.iter().map(|curve| width(&curve.name, Slope::Upright)).fold(0.0, f64::max);
        points(SWATCH + 16) + (longest * LEEWAY * canvas::FONT * f64::from(points(FONT))) as i32
    }

    fn draw_legend<B: DrawingBackend>(&self, backend: &mut B, frame: &Frame) -> Drawn<B> {
        if self.curves.len() < 2 {
            return Ok(());
        }
        let room = (frame.bottom - frame.top) / self.curves.len() as i32;
        for (index, curve) in self.curves.iter().enumerate() {
            let pitch = points(LINE).min(room);
            let (x, y) = (frame.right + points(8), frame.top + points(LINE) / 2 + pitch * index as i32);
            backend.draw_path([(x, y), (x + points(SWATCH), y)], &line(self.color(index), 2 * CURVE))?;
            let style = text(HPos::Left, VPos::Center, FontTransform::None);
            backend.draw_text(&curve.name, &style, (x + points(SWATCH + 6), y))?;
        }
        Ok(())
    }
}

fn draw_abscissa<B: DrawingBackend>(backend: &mut B, frame: &Frame, axis: &Axis, name: &str) -> Drawn<B> {
    let style = text(HPos::Center, VPos::Top, FontTransform::None);
    for mark in &axis.marks {
        let x = frame.x(mark.place).round() as i32;
        backend.draw_path([(x, frame.top), (x, frame.bottom)], &line(GRID, 10))?;
        backend.draw_path([(x, frame.bottom), (x, frame.bottom + points(TICK))], &line(INK, 10))?;
        backend.draw_text(&mark.label, &style, (x, frame.bottom + points(TICK + 3)))?;
    }
    let below = frame.bottom + points(28);
    backend.draw_text(name, &style, ((frame.left + frame.right) / 2, below))?;
    let style = text(HPos::Right, VPos::Top, FontTransform::None);
    if axis.note.is_empty() { Ok(()) } else { backend.draw_text(&axis.note, &style, (frame.right, below)) }
}

fn draw_ordinate<B: DrawingBackend>(backend: &mut B, frame: &Frame, axis: &Axis, name: &str) -> Drawn<B> {
    let style = text(HPos::Right, VPos::Center, FontTransform::None);
    for mark in &axis.marks {
        let y = frame.y(mark.place).round() as i32;
        backend.draw_path([(frame.left, y), (frame.right, y)], &line(GRID, 10))?;
        backend.draw_path([(frame.left - points(TICK), y), (frame.left, y)], &line(INK, 10))?;
        backend.draw_text(&mark.label, &style, (frame.left - points(TICK + 3), y))?;
    }
    let middle = (frame.top + frame.bottom) / 2;
    let upright = text(HPos::Center, VPos::Top, FontTransform::Rotate270);
    backend.draw_text(name, &upright, (frame.left - points(66), middle))?;
    let style = text(HPos::Left, VPos::Bottom, FontTransform::None);
    if axis.note.is_empty() {
        Ok(())
    } else {
        backend.draw_text(&axis.note, &style, (frame.left, frame.top - points(4)))
    }
}

fn line(color: RGBColor, width: u32) -> ShapeStyle {
    ShapeStyle { color: color.into(), filled: false, stroke_width: width }
}

fn text(horizontal: HPos, vertical: VPos, transform: FontTransform) -> TextStyle<'static> {
    let font = (FAMILY, points(FONT)).into_font().transform(transform);
    TextStyle::from(font).color(&INK).pos(Pos::new(horizontal, vertical))
}
