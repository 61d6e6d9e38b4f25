//! Columns by name, of which the first are times and states.

use numpy::{PyArray1, PyArray2, PyArrayMethods, ToPyArray};
use pyo3::exceptions::PyKeyError;
use pyo3::types::{PyAnyMethods, PyDict, PyDictMethods};
use pyo3::{Bound, PyAny, PyResult, Python};

/// Columns of equal length: times, the entries of states, then the others.
pub(crate) struct NamedColumns {
    /// Times, then the other columns.
    pub(crate) names: Vec<String>,
    pub(crate) columns: Vec<Vec<f64>>,
    /// Number of entries of the state, the columns behind the times.
    pub(crate) entries: usize,
}

impl NamedColumns {
    /// Returns the times.
    pub(crate) fn times(&self) -> &[f64] {
        &self.columns[0]
    }

    /// Returns the states, a row for each time.
    pub(crate) fn states<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows = self.times().len();
        let row = |row: usize| self.columns[1..=self.entries].iter().map(move |column| column[row]);
        PyArray1::from_iter(py, (0..rows).flat_map(row)).reshape([rows, self.entries])
    }

    /// Returns all columns by name.
    pub(crate) fn dictionary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        for (name, column) in self.names.iter().zip(&self.columns) {
            columns.set_item(name, column.to_pyarray(py))?;
        }
        Ok(columns)
    }

    /// Returns all columns as the `DataFrame` of a module.
    pub(crate) fn frame<'py>(&self, py: Python<'py>, module: &str) -> PyResult<Bound<'py, PyAny>> {
        py.import(module)?.getattr("DataFrame")?.call1((self.dictionary(py)?,))
    }

    /// Returns the column of a name.
    ///
    /// # Errors
    /// `KeyError` if there is none.
    pub(crate) fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        match self.names.iter().position(|known| known == name) {
            Some(index) => Ok(self.columns[index].to_pyarray(py)),
            None => Err(PyKeyError::new_err(format!(
                "there is no column `{name}`; there are {}",
                self.names.join(", ")
            ))),
        }
    }
}
