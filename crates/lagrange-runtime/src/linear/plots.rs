//! Plots of responses.

use std::path::Path;
use std::vec;
use std::vec::Vec;

use super::frequency::FrequencyResponse;
use super::response::TimeResponse;
use lagrange_plot::label::Label;
use lagrange_plot::{Curve, Figure, Panel, PlotError, Scale};

/// Sizes of figures.
const WIDE: (u32, u32) = (860, 300);
const SQUARE: (u32, u32) = (560, 520);

impl FrequencyResponse {
    /// Plots magnitudes in decibels and phases in degrees over a logarithmic axis of frequencies.
    ///
    /// # Errors
    /// If the extension is neither `svg` nor `png`, or the file cannot be written.
    pub fn plot_bode(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let degrees = self.phases().into_iter().map(f64::to_degrees).collect();
        let panel = |y: &str, values: Vec<f64>| Panel {
            x: Label::parse("angular frequency"),
            y: Label::parse(y),
            x_scale: Scale::Logarithmic,
            curves: vec![curve(y, self.frequencies.iter().copied().zip(values).collect())],
            ..Panel::default()
        };
        let panels = vec![panel("magnitude in dB", self.decibels()), panel("phase in degrees", degrees)];
        Figure { panels, columns: 1, size: WIDE }.save(path.as_ref())
    }

    /// Plots G(iω) in the complex plane, with the point −1.
    ///
    /// # Errors
    /// If the extension is neither `svg` nor `png`, or the file cannot be written.
    pub fn plot_nyquist(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let conjugate = self.values.iter().map(|(real, imaginary)| (*real, -imaginary)).collect();
        let curves = vec![
            curve("positive frequencies", self.values.clone()),
            curve("negative frequencies", conjugate),
            curve("−1", vec![(-1.0, 0.0)]),
        ];
        let (x, y) = (Label::parse("real part"), Label::parse("imaginary part"));
        let panel = Panel { x, y, has_room: true, curves, ..Panel::default() };
        Figure { panels: vec![panel], columns: 1, size: SQUARE }.save(path.as_ref())
    }
}

impl TimeResponse {
    /// Plots the output over time, with its limit.
    ///
    /// # Errors
    /// If the extension is neither `svg` nor `png`, or the file cannot be written.
    pub fn plot(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let points = self.times.iter().copied().zip(self.values.iter().copied()).collect();
        let mut curves = vec![curve(self.names.1, points)];
        if let (Some(limit), [first, .., last]) = (self.limit, &self.times[..]) {
            curves.push(curve("limit", vec![(*first, limit), (*last, limit)]));
        }
        let (x, y) = (Label::parse("time"), Label::parse(self.names.1));
        let panel = Panel { x, y, curves, ..Panel::default() };
        Figure { panels: vec![panel], columns: 1, size: WIDE }.save(path.as_ref())
    }
}

fn curve(name: &str, points: Vec<(f64, f64)>) -> Curve {
    Curve { name: Label::parse(name), points }
}
