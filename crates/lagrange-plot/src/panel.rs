//! One pair of axes with its content.

use crate::axes::{
    FINENESS, Frame, Side, around, draw_abscissa, draw_border, draw_ordinate, points, rounded,
};
use crate::axis::{Axis, Scale};
use crate::band::Band;
use crate::cells::Cells;
use crate::colours::{CURVES, Colour};
use crate::image::Placed;
use crate::label::{Anchor, Label};
use crate::lettering::LEEWAY;
use crate::limit::{Limit, with_limits};
use crate::paper::{Down, FONT, Paper, Place};
use crate::thin::{Point, thin};

/// A pair of axes with curves, and optionally a grid of cells and areas behind them.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Panel {
    /// Label of the abscissa.
    pub x: Label,
    /// Label of the ordinate.
    pub y: Label,
    /// Scale of the abscissa.
    pub x_scale: Scale,
    /// Scale of the ordinate.
    pub y_scale: Scale,
    /// True if there is room between curves and the ends of the abscissa, too.
    pub has_room: bool,
    /// Values over both quantities, on linear axes.
    pub cells: Option<Cells>,
    /// Areas, wider ones first.
    pub bands: Vec<Band>,
    /// Limits of quantities, below the curves.
    pub limits: Vec<Limit>,
    /// Curves; if there is more than one, or a band, all are named in a legend.
    pub curves: Vec<Curve>,
}

/// Points joined by a line, interrupted at points that are not finite.
#[derive(Clone, PartialEq, Debug)]
pub struct Curve {
    /// Name in the legend.
    pub name: Label,
    /// Abscissae and ordinates, in drawing order.
    pub points: Vec<Point>,
}

/// Maximum number of names in a title.
const MAX_TITLED: usize = 7;
/// Length of the line in front of a name in a legend.
const SWATCH: i32 = 18;
const LINE: i32 = 18;
/// Room above and below curves, relative to their height.
const ROOM: f64 = 0.05;
/// About half of the width of a curve: closer points cannot be distinguished.
const COLUMN: f64 = 5.0;
const CURVE: u32 = 14;
/// Size of the dot that represents a curve of a single point.
const DOT: u32 = 60;

/// Colours of few curves.
const COLOURS: [Colour; 7] =
    [CURVES[0], CURVES[1], CURVES[2], CURVES[3], CURVES[4], CURVES[5], Colour::new(0x00_00_00, 0xff_ff_ff)];
/// The first, middle and last colour of many curves, with ascending luminance.
const RAMP: [Colour; 3] = [
    Colour::new(0x00_20_60, 0x4a_78_d2),
    Colour::new(0x6e_6c_68, 0xa0_9f_9c),
    Colour::new(0xb8_8e_00, 0xf5_de_5a),
];

impl Panel {
    /// Draws axes, their content, and a legend.
    pub(crate) fn draw(&self, paper: &mut dyn Paper, panel: &Frame) {
        let frame = self.frame(panel);
        let (x, y) = self.axes(&frame);
        draw_abscissa(paper, &frame, &x, &self.x);
        draw_ordinate(paper, &frame, Side::Left, &y, &self.y);
        if let Some(cells) = &self.cells {
            cells.draw_bar(paper, &frame);
        }
        draw_border(paper, &frame);
        for band in &self.bands {
            band.draw(paper, &frame, (&x, &y), COLOURS[0]);
        }
        for limit in &self.limits {
            limit.draw(paper, &frame, (&x, &y), |curve| self.colour(curve));
        }
        for (index, curve) in self.curves.iter().enumerate() {
            curve.draw(paper, &frame, (&x, &y), self.colour(index));
        }
        self.draw_legend(paper, panel);
    }

    /// Returns a description as text.
    pub(crate) fn title(&self) -> String {
        let names = self.names();
        let more = names.len().saturating_sub(MAX_TITLED);
        let named = names.iter().take(MAX_TITLED).map(|name| name.plain()).collect::<Vec<_>>().join(", ");
        let names = if more > 0 { format!("{named} and {more} more") } else { named };
        let ordinate = match (names.is_empty(), self.y.is_empty()) {
            (true, _) => self.y.plain(),
            (false, true) => names,
            (false, false) => format!("{} ({names})", self.y.plain()),
        };
        let parts = [ordinate, self.x.plain()].into_iter().filter(|part| !part.is_empty());
        parts.collect::<Vec<_>>().join(" over ")
    }

    /// Returns the images below all other content.
    pub(crate) fn images(&self, panel: &Frame) -> Vec<Placed> {
        self.cells.iter().flat_map(|cells| cells.images(&self.frame(panel))).collect()
    }

    /// Returns the size with all labels at which each cell has a whole number of pixels, for this
    /// number of pixels per unit.
    pub(crate) fn size_of_cells(&self, pixels: u32) -> (u32, u32) {
        let (width, height) = around(self.cells.as_ref().map_or((0, 0), |cells| cells.size(pixels)));
        let beside = (self.legend_width() + self.bar_width()).unsigned_abs();
        (width + beside.div_ceil(FINENESS), height)
    }

    /// Returns the place of the axes within the place of the panel with all labels.
    fn frame(&self, panel: &Frame) -> Frame {
        let beside = self.legend_width() + self.bar_width();
        Frame { right: panel.right - beside, is_ruled: self.cells.is_none(), ..*panel }
    }

    fn axes(&self, frame: &Frame) -> (Axis, Axis) {
        let x_room = if self.has_room { ROOM } else { 0.0 };
        let y_room = if self.cells.is_some() { 0.0 } else { ROOM };
        let curves = || self.curves.iter().flat_map(|curve| &curve.points);
        let bands = || self.bands.iter().flat_map(|band| &band.points);
        let (cells_x, cells_y) =
            (self.cells.as_ref().map(|cells| cells.x), self.cells.as_ref().map(|cells| cells.y));
        let both = |(low, high)| [low, high];
        let x = curves().map(|point| point.0).chain(bands().map(|point| point.0));
        let x = x.chain(cells_x.into_iter().flat_map(both));
        let y = curves().map(|point| point.1).chain(bands().flat_map(|point| [point.1, point.2]));
        let y = y.chain(cells_y.into_iter().flat_map(both));
        let x = with_limits(x.collect(), self.limits.iter().filter_map(Limit::abscissa));
        let y = with_limits(y.collect(), self.limits.iter().filter_map(Limit::ordinate));
        (
            Axis::over(self.x_scale, x.into_iter(), x_room, frame.columns()),
            Axis::over(self.y_scale, y.into_iter(), y_room, frame.rows()),
        )
    }

    pub(crate) fn colour(&self, index: usize) -> Colour {
        // The colours of cells include blue.
        let index = index + usize::from(self.cells.is_some());
        if self.curves.len() <= COLOURS.len() {
            return COLOURS[index % COLOURS.len()];
        }
        let place = 2.0 * index as f64 / (self.curves.len() - 1) as f64;
        if place < 1.0 { RAMP[0].mixed(RAMP[1], place) } else { RAMP[1].mixed(RAMP[2], place - 1.0) }
    }

    /// Returns the width in points; zero without cells.
    fn bar_width(&self) -> i32 {
        if self.cells.is_some() { Cells::bar_width() } else { 0 }
    }

    /// Returns the names in the legend.
    fn names(&self) -> Vec<&Label> {
        let bands = self.bands.iter().map(|band| &band.name);
        let names: Vec<_> = bands.chain(self.curves.iter().map(|curve| &curve.name)).collect();
        if names.len() < 2 { Vec::new() } else { names }
    }

    /// Returns the width in points; zero for a single curve.
    fn legend_width(&self) -> i32 {
        let longest = self.names().into_iter().map(|name| name.width(FONT)).reduce(f64::max);
        longest.map_or(0, |longest| points(SWATCH + 16) + (longest * LEEWAY) as i32)
    }

    fn draw_legend(&self, paper: &mut dyn Paper, panel: &Frame) {
        let names = self.names();
        let left = self.frame(panel).right + self.bar_width() + points(8);
        let pitch = points(LINE).min((panel.bottom - panel.top) / names.len().max(1) as i32);
        for (index, name) in names.into_iter().enumerate() {
            let y = panel.top + points(LINE) / 2 + pitch * index as i32;
            let right = left + points(SWATCH);
            if let Some(curve) = index.checked_sub(self.bands.len()) {
                paper.line(&[(left, y), (right, y)], self.colour(curve), 2 * CURVE);
            } else {
                let half = pitch / 3;
                Band::draw_sample(paper, index, (left, y - half), (right, y + half), COLOURS[0]);
            }
            let at = (left + points(SWATCH + 6), y);
            paper.write(name, Place { at, anchor: Anchor::Start, down: Down::Level, is_turned: false });
        }
    }
}

impl Curve {
    fn draw(&self, paper: &mut dyn Paper, frame: &Frame, (x, y): (&Axis, &Axis), colour: Colour) {
        let place = |point: &Point| (frame.x(x.place(point.0)), frame.y(y.place(point.1)));
        for piece in thin(self.points.iter().map(place), COLUMN) {
            let mut path: Vec<(i32, i32)> = piece.into_iter().map(rounded).collect();
            path.dedup();
            let is_dot = path.len() == 1;
            path.extend(path.first().copied().filter(|_| is_dot));
            paper.line(&path, colour, if is_dot { DOT } else { CURVE });
        }
    }
}
