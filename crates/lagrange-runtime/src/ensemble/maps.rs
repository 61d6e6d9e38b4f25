//! Pictures of many motions.

use std::path::Path;
use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use super::ends::Ends;
use super::grid::Grid;
use super::samples::Samples;
use crate::simulate::{PlotError, TIME, label_with_unit, time_axis, unit};
use crate::system::{MechanicalSystem, description_of_type};
use lagrange_plot::notation::Columns;
use lagrange_plot::{Band, Cells, Curve, Figure, Panel, Scale};

/// A picture of values over the two quantities of a [`Grid`], one colour per value. The smallest
/// value is dark blue, the largest yellow. Values that are not finite, as for failed motions, are
/// white.
#[derive(Clone, PartialEq, Debug)]
pub struct Map {
    cells: Cells,
    panel: Panel,
}

impl Map {
    /// Creates a picture of these values, one per cell of the grid, in the order of cell indices.
    ///
    /// # Errors
    /// If the number of values differs from the number of cells, or a range of the grid is not
    /// finite and ascending.
    pub fn new(grid: &Grid, name: &str, values: Vec<f64>) -> Result<Self, PlotError> {
        if values.len() != grid.len() || values.is_empty() {
            return Err(PlotError::Cells { values: values.len(), cells: grid.len() });
        }
        let bounds = |quantity: &super::grid::Quantity| {
            quantity.bounds().ok_or_else(|| PlotError::Range(quantity.name.clone()))
        };
        let (x, y) = (bounds(&grid.x)?, bounds(&grid.y)?);
        let label = |name: &str| Columns::new([&*grid.x.name, &*grid.y.name, name]).label(name);
        let cells = Cells { name: label(name), scale: Scale::Linear, x, y, columns: grid.x.cells, values };
        let panel = Panel { x: label(&grid.x.name), y: label(&grid.y.name), ..Panel::default() };
        Ok(Map { cells, panel })
    }

    /// Uses a logarithmic colour scale.
    pub fn logarithmic(mut self) -> Self {
        self.cells.scale = Scale::Logarithmic;
        self
    }

    /// Sets the label of the colour scale, which is the name of the column by default.
    pub fn named(mut self, name: &str) -> Self {
        self.cells.name = name.into();
        self
    }

    /// Draws a line through points on top of the cells, broken at points that are not finite.
    /// Several lines are named in a legend.
    pub fn curve(mut self, name: &str, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.panel.curves.push(Curve { name: name.into(), points: points.into_iter().collect() });
        self
    }

    /// Writes the picture: `svg` or `png`, by its extension. Every cell is a square of whole
    /// pixels. A row is at most 1000 pixels wide, or one pixel per cell if there are more cells.
    ///
    /// # Errors
    /// If the extension is not supported, or the operating system cannot write the file.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        Figure::of_cells(Panel { cells: Some(self.cells.clone()), ..self.panel.clone() }).save(path.as_ref())
    }
}

impl<M: MechanicalSystem> Ends<M>
where
    M::Scalar: Into<f64>,
{
    /// Creates a picture of a column, or of the times `t` at which motions ended, over the grid of
    /// their starts. Labels of columns and parameters include units, if the declaration specifies
    /// them.
    ///
    /// # Errors
    /// If there is no such column, these motions do not cover all cells, or a range of the grid is
    /// not ascending.
    pub fn map(&self, grid: &Grid, column: &str) -> Result<Map, PlotError> {
        let values = if column == TIME { Some(self.times()) } else { self.column(column) };
        let values = values.ok_or_else(|| unknown(column, self.names()))?;
        let columns =
            Columns::new(self.names().iter().map(String::as_str).chain([&*grid.x.name, &*grid.y.name]));
        let label = |name: &str| label_with_unit(columns.label(name), unit(description_of_type::<M>(), name));
        let mut map = Map::new(grid, column, values.iter().map(|value| (*value).into()).collect())?;
        map.cells.name = label(column);
        (map.panel.x, map.panel.y) = (label(&grid.x.name), label(&grid.y.name));
        Ok(map)
    }
}

/// The bands of a plot of quantiles: the name of each, and its lower and upper quantile.
const BANDS: [(&str, f64, f64); 2] = [("90 %", 0.05, 0.95), ("50 %", 0.25, 0.75)];
const SIZE: (u32, u32) = (860, 420);

impl<M: MechanicalSystem> Samples<M>
where
    M::Scalar: Into<f64>,
{
    /// Plots how a column spreads over time: its median, and the bands that contain 50 % and 90 %
    /// of the motions. Values are computed by [`quantiles`](Self::quantiles).
    ///
    /// # Errors
    /// If there is no such column, or the file cannot be written.
    pub fn plot_quantiles(&self, column: &str, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let parts: Vec<f64> = BANDS.iter().flat_map(|(_, low, high)| [*low, *high]).chain([0.5]).collect();
        let names = self.iter().next().map_or(&[][..], |(_, motion)| motion.names());
        let quantiles = self.quantiles(column, &parts).ok_or_else(|| unknown(column, names))?;
        let times: Vec<f64> = self.times().iter().map(|time| (*time).into()).collect();
        let band = |((name, ..), pair): (&(&str, f64, f64), &[Vec<f64>])| {
            let points = times.iter().zip(&pair[0]).zip(&pair[1]);
            let points = points.map(|((time, low), high)| (*time, *low, *high)).collect();
            Band { name: (*name).into(), points }
        };
        let bands = BANDS.iter().zip(quantiles.chunks_exact(2)).map(band).collect();
        let median = times.iter().copied().zip(quantiles.last().into_iter().flatten().copied()).collect();
        let curves = vec![Curve { name: "median".into(), points: median }];
        let label = Columns::new(names.iter().map(String::as_str)).label(column);
        let y = label_with_unit(label, unit(description_of_type::<M>(), column));
        let panel = Panel { x: time_axis(), y, bands, curves, ..Panel::default() };
        Figure { panels: vec![panel], columns: 1, size: SIZE }.save(path.as_ref())
    }
}

fn unknown(name: &str, known: &[String]) -> PlotError {
    PlotError::UnknownColumn { name: name.to_string(), known: known.to_vec() }
}
