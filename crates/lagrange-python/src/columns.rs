//! Columns by name, starting with times and states.

use numpy::{PyArray1, PyArray2, PyArrayMethods, ToPyArray};
use pyo3::exceptions::PyKeyError;
use pyo3::types::{PyAnyMethods, PyDict, PyDictMethods};
use pyo3::{Bound, PyAny, PyResult, Python, pyclass, pymethods};

/// Columns of equal length: times, the entries of states, then the others. Trajectories and
/// ensembles extend them.
#[pyclass(name = "Columns", module = "lagrange", subclass, frozen)]
pub(crate) struct PyColumns {
    /// Times, then the other columns.
    pub(crate) names: Vec<String>,
    pub(crate) columns: Vec<Vec<f64>>,
    /// Number of entries of the state, the columns after the times.
    pub(crate) entries: usize,
}

impl PyColumns {
    /// Returns the times.
    pub(crate) fn times(&self) -> &[f64] {
        &self.columns[0]
    }

    /// Returns the index of a column.
    ///
    /// # Errors
    /// `KeyError` if there is no column of this name.
    pub(crate) fn place(&self, name: &str) -> PyResult<usize> {
        self.names.iter().position(|known| known == name).ok_or_else(|| {
            PyKeyError::new_err(format!("there is no column `{name}`; there are {}", self.names.join(", ")))
        })
    }

    /// Returns all columns as the `DataFrame` of a module.
    fn frame<'py>(&self, py: Python<'py>, module: &str) -> PyResult<Bound<'py, PyAny>> {
        py.import(module)?.getattr("DataFrame")?.call1((self.columns(py)?,))
    }
}

#[pymethods]
impl PyColumns {
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.times().to_pyarray(py)
    }

    /// States, a row for each time.
    #[getter]
    fn y<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows = self.times().len();
        let row = |row: usize| self.columns[1..=self.entries].iter().map(move |column| column[row]);
        PyArray1::from_iter(py, (0..rows).flat_map(row)).reshape([rows, self.entries])
    }

    #[getter]
    fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        for (name, column) in self.names.iter().zip(&self.columns) {
            columns.set_item(name, column.to_pyarray(py))?;
        }
        Ok(columns)
    }

    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.frame(py, "pandas")
    }

    fn to_polars<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.frame(py, "polars")
    }

    fn __len__(&self) -> usize {
        self.times().len()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(self.columns[self.place(name)?].to_pyarray(py))
    }
}
