//! Limits of the quantities of a panel.

use crate::axes::{Frame, points};
use crate::axis::{Axis, Scale, range};
use crate::colours::{Colour, INK};
use crate::paper::Paper;

/// A limit of a quantity: a dashed line across the panel. It is omitted where it is farther from
/// the curves than their own extent, since it would compress them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Limit {
    /// A value of the abscissa.
    Abscissa(f64),
    /// A value of the ordinate, with the index of the curve to which it belongs.
    Ordinate(f64, usize),
}

/// Length of a dash and of the gap after it, in units of size.
const DASH: (i32, i32) = (6, 4);
const THIN: u32 = 10;

impl Limit {
    /// Returns the value on the abscissa.
    pub(crate) fn abscissa(&self) -> Option<f64> {
        if let Limit::Abscissa(value) = self { Some(*value) } else { None }
    }

    /// Returns the value on the ordinate.
    pub(crate) fn ordinate(&self) -> Option<f64> {
        if let Limit::Ordinate(value, _) = self { Some(*value) } else { None }
    }

    /// Draws the limit if it is on its axis.
    pub(crate) fn draw(
        &self,
        paper: &mut dyn Paper,
        frame: &Frame,
        (x, y): (&Axis, &Axis),
        colour: impl Fn(usize) -> Colour,
    ) {
        match *self {
            Limit::Abscissa(value) if is_on(x, value) => {
                let across = frame.x(x.place(value)).round() as i32;
                for (from, to) in dashes(frame.top, frame.bottom) {
                    paper.line(&[(across, from), (across, to)], INK, THIN);
                }
            }
            Limit::Ordinate(value, curve) if is_on(y, value) => {
                let down = frame.y(y.place(value)).round() as i32;
                for (from, to) in dashes(frame.left, frame.right) {
                    paper.line(&[(from, down), (to, down)], colour(curve), THIN);
                }
            }
            Limit::Abscissa(_) | Limit::Ordinate(..) => {}
        }
    }
}

/// Returns the values of an axis, and the limits near them.
pub(crate) fn with_limits(values: Vec<f64>, limits: impl Iterator<Item = f64>) -> Vec<f64> {
    let Some((low, high)) = range(Scale::Linear, values.iter().copied()) else { return values };
    let extent = high - low;
    let near = limits.filter(|limit| low - extent <= *limit && *limit <= high + extent);
    values.into_iter().chain(near).collect()
}

fn is_on(axis: &Axis, value: f64) -> bool {
    (0.0..=1.0).contains(&axis.place(value))
}

/// Returns the ends of the dashes between two points.
fn dashes(from: i32, to: i32) -> impl Iterator<Item = (i32, i32)> {
    let (dash, gap) = DASH;
    let starts = (from..to).step_by(points(dash + gap).unsigned_abs() as usize);
    starts.map(move |start| (start, to.min(start + points(dash))))
}
