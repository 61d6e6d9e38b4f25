//! Work–precision diagrams.

use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::measurement::{MeasuredRun, Measurement};
use super::report::Report;
use lagrange_plot::label::Label;
use lagrange_plot::{Curve, Figure, Panel, Scale};

const SIZE: (u32, u32) = (860, 420);
/// Errors above this only indicate that the motion was lost.
const LOST: f64 = 10.0;

/// Draws time against error. The upper panels contain methods on the first system, in its original
/// and in canonical variables. The lower one contains variants with the most accurate method.
pub(super) fn diagram(report: &Report) -> Figure {
    let first = report.rows.first();
    let is_first = |row: &MeasuredRun| {
        first.is_some_and(|first| row.scalar == first.scalar && row.variant == first.variant)
    };
    let is_canonical = |row: &MeasuredRun| {
        let kind = first.and_then(|first| row.variant.strip_prefix(&first.variant)?.strip_prefix(", "));
        kind.is_some() && first.is_some_and(|first| row.scalar == first.scalar)
    };
    let best =
        report.measured().min_by(|(_, a), (_, b)| a.error.total_cmp(&b.error)).map(|(row, _)| &row.method);
    let variants =
        curves(report, |row| Some(&row.method) == best, |row| format!("{}, {}", row.variant, row.scalar));
    let mut panels = vec![panel("time in µs", curves(report, is_first, |row| row.method.clone()))];
    let canonical = curves(report, is_canonical, |row| row.method.clone());
    if !canonical.is_empty() {
        panels.push(panel("time in µs, canonical", canonical));
    }
    panels.push(panel(&format!("time in µs, {}", best.map_or("", String::as_str)), variants));
    Figure { panels, columns: 1, size: SIZE }
}

/// Returns the curves of the selected rows, one for each name.
fn curves(
    report: &Report,
    wanted: impl Fn(&MeasuredRun) -> bool,
    name: impl Fn(&MeasuredRun) -> String,
) -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    for (row, Measurement { error, seconds, .. }) in report.measured().filter(|(row, _)| wanted(row)) {
        // Zero cannot be shown on a logarithmic axis.
        if !(error < LOST && error > 0.0) {
            continue;
        }
        let name = Label::from(name(row).as_str());
        let point = (error, 1e6 * seconds);
        match curves.iter_mut().find(|curve| curve.name == name) {
            Some(curve) => curve.points.push(point),
            None => curves.push(Curve { name, points: vec![point] }),
        }
    }
    curves
}

fn panel(y: &str, curves: Vec<Curve>) -> Panel {
    Panel {
        x: "error at the end".into(),
        y: y.into(),
        x_scale: Scale::Logarithmic,
        y_scale: Scale::Logarithmic,
        has_room: true,
        curves,
        ..Panel::default()
    }
}
