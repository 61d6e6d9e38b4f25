//! Motions, by column.

use lagrange_dynamic::DynamicSystem;
use lagrange_runtime::simulate::{Ending, Trajectory};
use numpy::{PyArray1, PyArray2, ToPyArray};
use pyo3::types::{PyDict, PyDictMethods};
use pyo3::{Bound, PyAny, PyResult, Python, pyclass, pymethods};

use crate::columns::NamedColumns;

/// A motion: columns by name, and events.
#[pyclass(name = "Trajectory", module = "lagrange", frozen)]
pub(crate) struct PyTrajectory {
    columns: NamedColumns,
    units: Vec<Option<&'static str>>,
    events: Vec<(String, f64, Vec<f64>)>,
    ending: &'static str,
    steps: u64,
}

impl PyTrajectory {
    pub(crate) fn new<const CAPACITY: usize>(motion: &Trajectory<DynamicSystem<CAPACITY>>) -> Self {
        let names = motion.names().iter().map(String::as_str);
        let column = |name: &str| motion.column(name).unwrap_or_default().to_vec();
        let time = [(String::from("t"), Some("s"), motion.times().to_vec())];
        let others = names.map(|name| (name.to_owned(), motion.unit(name), column(name)));
        let (mut names, mut units, mut columns) = (Vec::new(), Vec::new(), Vec::new());
        for (name, unit, column) in time.into_iter().chain(others) {
            names.push(name);
            units.push(unit);
            columns.push(column);
        }
        let event = |event: &lagrange_runtime::simulate::Event<f64, _>| {
            let state: &lagrange_dynamic::Inline<CAPACITY> = &event.state;
            (event.name.clone(), event.time, state.as_ref().to_vec())
        };
        let ending = match motion.ending() {
            Ending::Reached => "reached",
            Ending::Stopped => "stopped",
            Ending::Cancelled => "cancelled",
            _ => "failed",
        };
        PyTrajectory {
            columns: NamedColumns { names, columns, entries: motion.first().as_ref().len() },
            units,
            events: motion.events().iter().map(event).collect(),
            ending,
            steps: motion.work().steps,
        }
    }
}

#[pymethods]
impl PyTrajectory {
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.columns.times().to_pyarray(py)
    }

    #[getter]
    fn names(&self) -> Vec<String> {
        self.columns.names.clone()
    }

    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let units = PyDict::new(py);
        for (name, unit) in self.columns.names.iter().zip(&self.units) {
            units.set_item(name, unit)?;
        }
        Ok(units)
    }

    #[getter]
    fn ending(&self) -> &'static str {
        self.ending
    }

    #[getter]
    fn steps(&self) -> u64 {
        self.steps
    }

    /// States, a row for each sample.
    #[getter]
    fn y<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.columns.states(py)
    }

    /// Events as tuples of name, time and state.
    #[getter]
    fn events<'py>(&self, py: Python<'py>) -> Vec<(String, f64, Bound<'py, PyArray1<f64>>)> {
        let event =
            |(name, time, state): &(String, f64, Vec<f64>)| (name.clone(), *time, state.to_pyarray(py));
        self.events.iter().map(event).collect()
    }

    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.columns.dictionary(py)
    }

    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.columns.frame(py, "pandas")
    }

    fn to_polars<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.columns.frame(py, "polars")
    }

    fn __len__(&self) -> usize {
        self.columns.times().len()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        self.columns.column(py, name)
    }

    fn __repr__(&self) -> String {
        let times = self.columns.times();
        let end = times.last().copied().unwrap_or_default();
        format!(
            "<Trajectory of {} samples until t = {end}, {}: {}>",
            times.len(),
            self.ending,
            self.columns.names.join(", ")
        )
    }
}
