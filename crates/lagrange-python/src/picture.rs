//! Plots and films, displayed by notebooks.

use std::path::PathBuf;

use lagrange_dynamic::DeclaredFilm;
use lagrange_plot::label::Label;
use lagrange_plot::notation::{self, Columns};
use lagrange_plot::{Curve, Figure, Panel, PlotError};
use pyo3::exceptions::{PyKeyError, PyOSError, PyValueError};
use pyo3::{PyErr, PyResult, Python, pyclass, pymethods};

use crate::columns::PyColumns;

/// Width and height of a single panel.
const WIDE: (u32, u32) = (860, 420);
/// Width and height of each of several panels.
const SMALL: (u32, u32) = (480, 230);

#[doc = described!(Plot)]
#[pyclass(name = "Plot", module = "lagrange", frozen)]
pub(crate) struct PyPlot {
    figure: Figure,
    svg: String,
}

impl PyPlot {
    /// Plots columns, each in its own panel, over one of them.
    ///
    /// # Errors
    /// `KeyError` for an unknown column, `ValueError` if there is nothing to plot.
    pub(crate) fn new(
        py: Python<'_>,
        columns: &PyColumns,
        units: &[Option<&str>],
        (names, x): (&[String], &str),
    ) -> PyResult<PyPlot> {
        let labels = Columns::new(columns.names.iter().map(String::as_str));
        let label =
            |name: &str, index: usize| in_unit(labels.label(name), units.get(index).copied().flatten());
        let at = columns.place(x)?;
        let panel = |name: &String| {
            let place = columns.place(name)?;
            let [along, up] = [at, place].map(|place| columns.column(py, place));
            let points = along.as_array().iter().copied().zip(up.as_array().iter().copied()).collect();
            let y = label(name, place);
            let curves = vec![Curve { name: y.clone(), points }];
            Ok(Panel { x: label(x, at), y, curves, ..Panel::default() })
        };
        let panels = names.iter().map(panel).collect::<PyResult<Vec<_>>>()?;
        let (columns, size) = match panels.len() {
            0 => return Err(PyValueError::new_err("a plot needs at least one column")),
            1 => (1, WIDE),
            _ => (2, SMALL),
        };
        let figure = Figure { panels, columns, size };
        let svg = figure.svg().map_err(plot_error)?;
        Ok(PyPlot { figure, svg })
    }
}

#[pymethods]
impl PyPlot {
    #[doc = described!(Plot.svg)]
    #[getter]
    fn svg(&self) -> &str {
        &self.svg
    }

    /// Returns the picture for Jupyter.
    fn _repr_svg_(&self) -> &str {
        &self.svg
    }

    #[doc = described!(Plot.save)]
    fn save(&self, path: PathBuf) -> PyResult<()> {
        self.figure.save(&path).map_err(plot_error)
    }

    fn __repr__(&self) -> String {
        format!("<Plot of {} panels>", self.figure.panels.len())
    }
}

fn plot_error(error: PlotError) -> PyErr {
    match error {
        PlotError::Io { .. } => PyOSError::new_err(error.to_string()),
        PlotError::UnknownColumn { .. } => PyKeyError::new_err(error.to_string()),
        error => PyValueError::new_err(error.to_string()),
    }
}

/// Returns a label followed by a unit, which is omitted for plain numbers.
fn in_unit(label: Label, unit: Option<&str>) -> Label {
    match unit.filter(|unit| *unit != "1") {
        Some(unit) => label.then(&format!(" in {}", notation::unit(unit))),
        None => label,
    }
}

#[doc = described!(Film)]
#[pyclass(name = "Film", module = "lagrange", frozen)]
pub(crate) struct PyFilm {
    film: DeclaredFilm,
    height: u32,
}

impl PyFilm {
    pub(crate) fn new(film: DeclaredFilm, height: u32) -> PyFilm {
        PyFilm { film, height }
    }
}

#[pymethods]
impl PyFilm {
    #[doc = described!(Film.html)]
    #[getter]
    fn html(&self) -> String {
        self.film.html()
    }

    /// Returns the page for Jupyter. A frame isolates its style from that of the notebook.
    fn _repr_html_(&self) -> String {
        let page = self.film.html().replace('&', "&amp;").replace('"', "&quot;");
        let height = self.height;
        format!(
            "<iframe srcdoc=\"{page}\" sandbox=\"allow-scripts\" width=\"100%\" height=\"{height}\" style=\"border: 0\"></iframe>"
        )
    }

    #[doc = described!(Film.save)]
    fn save(&self, path: PathBuf) -> PyResult<()> {
        self.film.save(&path).map_err(|error| match error {
            lagrange_draw::DrawError::Io { .. } => PyOSError::new_err(error.to_string()),
            error => PyValueError::new_err(error.to_string()),
        })
    }

    fn __repr__(&self) -> String {
        "<Film>".to_owned()
    }
}
