//! Motions, by column.

use lagrange_dynamic::DynamicSystem;
use lagrange_runtime::simulate::{Ending, Trajectory};
use numpy::{PyArray1, PyArray2, PyArrayMethods, ToPyArray};
use pyo3::exceptions::PyKeyError;
use pyo3::types::{PyAnyMethods, PyDict, PyDictMethods};
use pyo3::{Bound, PyAny, PyResult, Python, pyclass, pymethods};

/// A motion: columns by name, and events.
#[pyclass(name = "Trajectory", module = "lagrange", frozen)]
pub(crate) struct PyTrajectory {
    /// Times, then the other columns.
    names: Vec<String>,
    units: Vec<Option<&'static str>>,
    columns: Vec<Vec<f64>>,
    /// Number of entries of the state, the columns behind the time.
    entries: usize,
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
            names,
            units,
            columns,
            entries: motion.first().as_ref().len(),
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
        self.columns[0].to_pyarray(py)
    }

    #[getter]
    fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let units = PyDict::new(py);
        for (name, unit) in self.names.iter().zip(&self.units) {
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
        let rows = self.columns[0].len();
        let entries =
            (0..rows).flat_map(|row| self.columns[1..=self.entries].iter().map(move |column| column[row]));
        PyArray1::from_iter(py, entries).reshape([rows, self.entries])
    }

    /// Events as tuples of name, time and state.
    #[getter]
    fn events<'py>(&self, py: Python<'py>) -> Vec<(String, f64, Bound<'py, PyArray1<f64>>)> {
        let event =
            |(name, time, state): &(String, f64, Vec<f64>)| (name.clone(), *time, state.to_pyarray(py));
        self.events.iter().map(event).collect()
    }

    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        for (name, column) in self.names.iter().zip(&self.columns) {
            columns.set_item(name, column.to_pyarray(py))?;
        }
        Ok(columns)
    }

    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("pandas")?.getattr("DataFrame")?.call1((self.columns(py)?,))
    }

    fn to_polars<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("polars")?.getattr("DataFrame")?.call1((self.columns(py)?,))
    }

    fn __len__(&self) -> usize {
        self.columns[0].len()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        match self.names.iter().position(|known| known == name) {
            Some(index) => Ok(self.columns[index].to_pyarray(py)),
            None => Err(PyKeyError::new_err(format!(
                "there is no column `{name}`; there are {}",
                self.names.join(", ")
            ))),
        }
    }

    fn __repr__(&self) -> String {
        let end = self.columns[0].last().copied().unwrap_or_default();
        format!(
            "<Trajectory of {} samples until t = {end}, {}: {}>",
            self.columns[0].len(),
            self.ending,
            self.names.join(", ")
        )
    }
}
