//! Columns by name, starting with times and states.

use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyKeyError;
use pyo3::types::{PyAnyMethods, PyDict, PyDictMethods};
use pyo3::{Bound, Py, PyAny, PyResult, Python, pyclass, pymethods};

#[doc = described!(Columns)]
#[pyclass(name = "Columns", module = "lagrange", subclass, frozen)]
pub(crate) struct PyColumns {
    pub(crate) names: Vec<String>,
    /// Arrays that nobody can write to, so that all share them.
    arrays: Vec<Py<PyArray1<f64>>>,
    /// Number of entries of the state, the columns after the times.
    pub(crate) entries: usize,
}

/// Columns that Python does not know yet: times, the entries of states, then the others.
pub(crate) struct NewColumns {
    pub(crate) names: Vec<String>,
    pub(crate) columns: Vec<Vec<f64>>,
    /// Number of entries of the state.
    pub(crate) entries: usize,
}

impl NewColumns {
    /// Hands the columns over to NumPy, without copies.
    pub(crate) fn share(self, py: Python<'_>) -> PyColumns {
        let array = |column: Vec<f64>| {
            let array = PyArray1::from_vec(py, column);
            array.readwrite().make_nonwriteable();
            array.unbind()
        };
        let arrays = self.columns.into_iter().map(array).collect();
        PyColumns { names: self.names, arrays, entries: self.entries }
    }
}

impl PyColumns {
    /// Returns the number of times.
    pub(crate) fn length(&self, py: Python<'_>) -> usize {
        self.arrays[0].bind(py).len().unwrap_or_default()
    }

    /// Returns a column.
    pub(crate) fn column<'py>(&self, py: Python<'py>, place: usize) -> PyReadonlyArray1<'py, f64> {
        self.arrays[place].bind(py).readonly()
    }

    /// Returns the states, one for each time.
    pub(crate) fn states(&self, py: Python<'_>) -> Vec<Vec<f64>> {
        let columns = (1..=self.entries).map(|place| self.column(py, place)).collect::<Vec<_>>();
        let columns = columns.iter().map(|column| column.as_array()).collect::<Vec<_>>();
        (0..self.length(py)).map(|row| columns.iter().map(|column| column[row]).collect()).collect()
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
    #[doc = described!(Columns.t)]
    #[getter]
    fn t(&self, py: Python<'_>) -> Py<PyArray1<f64>> {
        self.arrays[0].clone_ref(py)
    }

    #[doc = described!(Columns.y)]
    #[getter]
    fn y<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let states = self.states(py);
        PyArray1::from_iter(py, states.iter().flatten().copied()).reshape([states.len(), self.entries])
    }

    #[doc = described!(Columns.names)]
    #[getter]
    fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    #[doc = described!(Columns.columns)]
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        for (name, array) in self.names.iter().zip(&self.arrays) {
            columns.set_item(name, array)?;
        }
        Ok(columns)
    }

    #[doc = described!(Columns.to_pandas)]
    fn to_pandas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.frame(py, "pandas")
    }

    #[doc = described!(Columns.to_polars)]
    fn to_polars<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.frame(py, "polars")
    }

    fn __len__(&self, py: Python<'_>) -> usize {
        self.length(py)
    }

    fn __getitem__(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyArray1<f64>>> {
        Ok(self.arrays[self.place(name)?].clone_ref(py))
    }
}
