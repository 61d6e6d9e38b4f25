//! Plots of responses.

use std::format;
use std::path::Path;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::frequency::FrequencyResponse;
use super::response::TimeResponse;
use crate::simulate::{label_with_unit, quotient, time_axis};
use lagrange_plot::label::Label;
use lagrange_plot::{Curve, Figure, Panel, PlotError, Scale};

/// Sizes of figures.
const WIDE: (u32, u32) = (860, 300);
const SQUARE: (u32, u32) = (560, 520);

impl FrequencyResponse {
    /// Plots magnitudes in decibels and phases in degrees over a logarithmic axis of frequencies.
    /// If input and output have different units, decibels are relative to one of their quotient.
    ///
    /// # Errors
    /// If the extension is neither `svg` nor `png`, or the file cannot be written.
    pub fn plot_bode(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let degrees = self.phases().into_iter().map(f64::to_degrees).collect();
        let panel = |y: Label, values: Vec<f64>| Panel {
            x: Label::from("angular frequency ").then("ω").then(" in rad/s"),
            y: y.clone(),
            x_scale: Scale::Logarithmic,
            curves: vec![Curve { name: y, points: self.frequencies.iter().copied().zip(values).collect() }],
            ..Panel::default()
        };
        let reference =
            quotient(self.transfer.units).map_or_else(String::new, |unit| format!(" re 1 {unit}"));
        let magnitude = Label::from("magnitude in dB").then(&reference);
        let panels = vec![panel(magnitude, self.decibels()), panel("phase in degrees".into(), degrees)];
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
        let unit = quotient(self.transfer.units);
        let axis = |part: &str| label_with_unit(part.into(), unit.as_deref());
        let (x, y) = (axis("real part"), axis("imaginary part"));
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
        let y = label_with_unit(Label::parse(self.names.1), self.unit);
        let panel = Panel { x: time_axis(), y, curves, ..Panel::default() };
        Figure { panels: vec![panel], columns: 1, size: WIDE }.save(path.as_ref())
    }
}

fn curve(name: &str, points: Vec<(f64, f64)>) -> Curve {
    Curve { name: Label::parse(name), points }
}
