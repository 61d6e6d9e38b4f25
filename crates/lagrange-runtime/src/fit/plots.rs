//! Pictures of fits.

use std::path::Path;
use std::string::ToString;
use std::vec;

use super::fitted::{Fitted, fitted_name};
use crate::simulate::{label_with_unit, time_axis, unit};
use crate::system::ParametricSystem;
use lagrange_plot::notation::Columns;
use lagrange_plot::{Curve, Figure, Panel, PlotError};

/// Width and height of the picture.
const WIDE: (u32, u32) = (860, 420);
/// Number of columns of the table for each of the data.
const COLUMNS: usize = 3;

impl<M: ParametricSystem<Scalar = f64>> Fitted<M> {
    /// Plots a column of the data as dots, and the fitted motion at the same times as a line.
    ///
    /// # Errors
    /// If the data have no column of this name, the extension is neither `svg` nor `png`, or the
    /// file cannot be written.
    pub fn plot(&self, column: &str, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let table = self.table();
        let points = |name: &str| {
            let values = table.column(name)?;
            Some(table.times().iter().copied().zip(values.iter().copied()))
        };
        let (Some(measured), Some(fitted)) = (points(column), points(&fitted_name(column))) else {
            let known = table.names().iter().step_by(COLUMNS).cloned().collect();
            return Err(PlotError::UnknownColumn { name: column.to_string(), known });
        };
        // Points between others that are not finite are not joined by lines.
        let dots = measured.flat_map(|point| [point, (f64::NAN, f64::NAN)]).collect();
        let curves = vec![
            Curve { name: "measured".into(), points: dots },
            Curve { name: "fitted".into(), points: fitted.filter(|(_, value)| value.is_finite()).collect() },
        ];
        let y =
            label_with_unit(Columns::new([column]).label(column), unit(self.system().description(), column));
        let panel = Panel { x: time_axis(), y, curves, ..Panel::default() };
        Figure { panels: vec![panel], columns: 1, size: WIDE }.save(path.as_ref())
    }
}
