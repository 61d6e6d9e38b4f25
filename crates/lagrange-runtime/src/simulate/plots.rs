//! Pictures of trajectories.

use std::path::Path;
use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use crate::simulate::builder::ENERGY;
use crate::simulate::trajectory::Trajectory;
use crate::simulate::units::{label_with_unit, unit};
use crate::system::{Description, EntryRange, MechanicalSystem, WithSuffix};
use lagrange_plot::label::Label;
use lagrange_plot::notation::Columns;
use lagrange_plot::{Curve, Figure, Limit, Panel, PlotError, Scale};

/// A column and its points.
type NamedCurve<'n> = (&'n str, Vec<(f64, f64)>);

/// Maximum number of coordinates with a panel each.
const SEPARATE: usize = 4;
/// Sizes of figures and panels.
const WIDE: (u32, u32) = (860, 420);
const SMALL: (u32, u32) = (480, 230);
const SQUARE: (u32, u32) = (560, 520);
/// Energies that change by more than this fraction of their initial value are not plotted relative
/// to it.
const LARGE_DRIFT: f64 = 0.1;
/// A drift that grows by more than this factor after the first tenth of the run is shown on a
/// logarithmic axis.
const GROWTH: f64 = 1e3;

impl<M: MechanicalSystem> Trajectory<M>
where
    M::Scalar: Into<f64>,
{
    /// Plots coordinates and velocities against time. Up to four coordinates have a panel each. For
    /// more coordinates, or a different number of velocities, there is one panel for all
    /// coordinates and one for all velocities. First-order states have a separate panel.
    ///
    /// Here and in all plots, symbols are written as in formulas: θ̇₁ for `theta1_dot`, ẍ for
    /// `x_ddot`, x₂ for `x[2]`. Words, and names whose symbols would be ambiguous, are unchanged.
    /// Units of a declaration follow names, as in x in m: at the axis, or in the legend if units
    /// differ between curves. Dashed lines are bounds of declared ranges. A bound is omitted if it
    /// is farther from the curves than their extent.
    ///
    /// In all plots, the extension of the file selects its format: `svg` for vector graphics and
    /// `png` for pixels.
    ///
    /// # Errors
    /// If the extension is not supported, or the operating system cannot write the file.
    pub fn plot_states(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        const {
            assert!(
                M::FIRST_ORDER_STATES <= M::COORDINATES.len(),
                "first-order states are among the positions"
            );
        }
        const {
            assert!(
                M::FIRST_ORDER_STATES <= M::COORDINATES.len(),
                "first-order states are among the positions"
            );
        }
        let Description { coordinates, first_order_states, .. } = self.description;
        let names = &self.names()[..self.first().as_ref().len()];
        let (positions, velocities) = names.split_at(coordinates.len());
        let (coordinates, states) = positions.split_at(positions.len() - first_order_states);
        let count = coordinates.len();
        let is_grouped = count > SEPARATE || velocities.len() != count;
        let mut panels = match is_grouped {
            true => {
                vec![self.over_time("coordinates", coordinates)?, self.over_time("velocities", velocities)?]
            }
            false => self.pairs(coordinates, velocities)?,
        };
        if let [first, others @ ..] = states {
            let title = if others.is_empty() { first } else { "states" };
            panels.push(self.over_time(title, states)?);
        }
        let (columns, size) = if is_grouped || count == 1 { (1, WIDE) } else { (2, SMALL) };
        Figure { panels, columns, size }.save(path.as_ref())
    }

    /// Plots columns against time, all in one panel.
    ///
    /// # Errors
    /// If no column is named, there is no such column, or the file cannot be written.
    pub fn plot_columns(&self, names: &[&str], path: impl AsRef<Path>) -> Result<(), PlotError> {
        some(names)?;
        let names: Vec<String> = names.iter().map(ToString::to_string).collect();
        let title = if let [name] = &names[..] { name } else { "" };
        Figure { panels: vec![self.over_time(title, &names)?], columns: 1, size: WIDE }.save(path.as_ref())
    }

    /// Plots the velocity of a coordinate against the coordinate.
    ///
    /// # Errors
    /// If there is no such coordinate, or none whose rate is a velocity, or the file cannot be
    /// written.
    pub fn plot_phase(&self, coordinate: &str, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let Description { rates_of, velocities, .. } = self.description;
        let named = rates_of.iter().zip(*velocities).find(|(of, _)| **of == coordinate);
        let velocity = named
            .map_or_else(|| WithSuffix::velocity(coordinate).to_string(), |(_, name)| (*name).to_string());
        self.plot_pair(coordinate, &velocity, path)
    }

    /// Plots one column against another, as for the path of a point.
    ///
    /// # Errors
    /// If there is no such column, or the file cannot be written.
    pub fn plot_pair(&self, x: &str, y: &str, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let points = self.numbers(x)?.into_iter().zip(self.numbers(y)?).collect();
        let panel = self.panel(self.axis(x), y, vec![(y, points)]);
        let panel = Panel { has_room: true, ..self.limited(panel, x) };
        Figure { panels: vec![panel], columns: 1, size: SQUARE }.save(path.as_ref())
    }

    /// Plots columns against another one, all in one panel.
    ///
    /// # Errors
    /// If no column is named, there is no such column, or the file cannot be written.
    pub fn plot_against(&self, x: &str, names: &[&str], path: impl AsRef<Path>) -> Result<(), PlotError> {
        some(names)?;
        let abscissae = self.numbers(x)?;
        let curves = names.iter().map(|name| self.curve(abscissae.iter().copied(), name));
        let curves = curves.collect::<Result<_, PlotError>>()?;
        let title = if let [name] = names { name } else { "" };
        let panel = self.limited(self.panel(self.axis(x), title, curves), x);
        Figure { panels: vec![panel], columns: 1, size: WIDE }.save(path.as_ref())
    }

    /// Plots the deviation of the energy from its initial value E₀ against time, relative to E₀
    /// unless that is too small. The axis is logarithmic if the deviation grows by orders of
    /// magnitude.
    ///
    /// # Errors
    /// If the run did not record its [`energy`](crate::simulate::Simulation::energy), or the file
    /// cannot be written.
    pub fn plot_energy(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let energies = self.numbers(ENERGY).map_err(|_| PlotError::NoEnergy)?;
        let (drift, [signed, absolute], is_relative) = drift(&energies);
        let is_growing = grows(&drift);
        let (name, y_scale) =
            if is_growing { (absolute, Scale::Logarithmic) } else { (signed, Scale::Linear) };
        let y = label_with_unit(Label::parse(name), unit(self.description, ENERGY).filter(|_| !is_relative));
        let shown = drift.iter().map(|drift| if is_growing { drift.abs() } else { *drift });
        let curves = vec![Curve { name: y.clone(), points: self.seconds().zip(shown).collect() }];
        let panel = Panel { x: time_axis(), y, y_scale, curves, ..Panel::default() };
        Figure { panels: vec![panel], columns: 1, size: WIDE }.save(path.as_ref())
    }

    /// Returns a panel for each coordinate, each followed by a panel for its velocity.
    fn pairs(&self, coordinates: &[String], velocities: &[String]) -> Result<Vec<Panel>, PlotError> {
        let names = coordinates.iter().zip(velocities).flat_map(|(q, v)| [q, v]);
        names.map(|name| self.over_time(name, std::slice::from_ref(name))).collect()
    }

    /// Returns a panel of columns against time.
    fn over_time(&self, title: &str, names: &[String]) -> Result<Panel, PlotError> {
        let curves = names.iter().map(|name| self.curve(self.seconds(), name));
        Ok(self.panel(time_axis(), title, curves.collect::<Result<_, PlotError>>()?))
    }

    /// Returns a column over abscissae.
    fn curve<'n>(&self, x: impl Iterator<Item = f64>, name: &'n str) -> Result<NamedCurve<'n>, PlotError> {
        Ok((name, x.zip(self.numbers(name)?).collect()))
    }

    /// Returns a panel for columns. Units are at the axes, or in the legend if they differ between
    /// curves.
    fn panel(&self, x: Label, y: &str, curves: Vec<NamedCurve<'_>>) -> Panel {
        let columns = Columns::new(self.names().iter().map(String::as_str));
        let mut units = curves.iter().map(|(name, _)| unit(self.description, name));
        let first = units.next().flatten();
        let shared = if units.all(|unit| unit == first) { first } else { None };
        let curve = |(name, points): (&str, _)| {
            let unit = unit(self.description, name).filter(|_| shared.is_none());
            Curve { name: label_with_unit(columns.label(name), unit), points }
        };
        let y = label_with_unit(columns.label(y), shared);
        let limits = curves
            .iter()
            .enumerate()
            .flat_map(|(index, (name, _))| self.bounds(name).map(move |bound| Limit::Ordinate(bound, index)));
        let limits = limits.collect();
        Panel { x, y, limits, curves: curves.into_iter().map(curve).collect(), ..Panel::default() }
    }

    /// Adds the bounds of the column on the abscissa to a panel.
    fn limited(&self, mut panel: Panel, x: &str) -> Panel {
        panel.limits.extend(self.bounds(x).map(Limit::Abscissa));
        panel
    }

    /// Returns the finite bounds of the declared range of a column.
    fn bounds(&self, name: &str) -> impl Iterator<Item = f64> {
        let range = self.domain.ranges.iter().find(|range| range.name == name);
        let ends = range.map(EntryRange::ends::<f64>);
        ends.into_iter().flat_map(|(lower, upper)| [lower, upper]).filter(|bound| bound.is_finite())
    }

    /// Returns the label of an axis for a column.
    fn axis(&self, name: &str) -> Label {
        let columns = Columns::new(self.names().iter().map(String::as_str));
        label_with_unit(columns.label(name), unit(self.description, name))
    }

    fn seconds(&self) -> impl Iterator<Item = f64> + '_ {
        self.times().iter().map(|time| (*time).into())
    }

    fn numbers(&self, name: &str) -> Result<Vec<f64>, PlotError> {
        let column = self.column(name).ok_or_else(|| PlotError::UnknownColumn {
            name: name.to_string(),
            known: self.names().to_vec(),
        })?;
        Ok(column.iter().map(|value| (*value).into()).collect())
    }
}

/// Returns the label of the time axis, in SI units as everywhere.
pub(crate) fn time_axis() -> Label {
    Label::from("time ").then("t").then(" in s")
}

/// Returns an error for a plot without columns.
fn some(names: &[&str]) -> Result<(), PlotError> {
    if names.is_empty() { Err(PlotError::NoColumns) } else { Ok(()) }
}

/// Returns the deviations of energies from the first, their labels with and without sign, and true
/// if they are relative to the first.
fn drift(energies: &[f64]) -> (Vec<f64>, [&'static str; 2], bool) {
    let start = energies.first().copied().unwrap_or(0.0);
    let drift: Vec<f64> = energies.iter().map(|energy| energy - start).collect();
    let largest = drift.iter().copied().map(f64::abs).fold(0.0, f64::max);
    if start != 0.0 && largest < LARGE_DRIFT * start.abs() {
        let names = ["(E − E_0)/|E_0|", "|E − E_0|/|E_0|"];
        return (drift.iter().map(|drift| drift / start.abs()).collect(), names, true);
    }
    (drift, ["E − E_0", "|E − E_0|"], false)
}

/// True if a drift grows by orders of magnitude.
fn grows(drift: &[f64]) -> bool {
    let largest = |drift: &[f64]| drift.iter().copied().map(f64::abs).fold(0.0, f64::max);
    let early = largest(&drift[..drift.len().div_ceil(10).max(2).min(drift.len())]);
    early > 0.0 && largest(drift) > GROWTH * early
}
