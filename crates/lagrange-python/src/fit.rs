//! Fits of parameters to data from Python.

use std::path::PathBuf;

use lagrange_dynamic::{DeclaredSystem, FitFailure, FitSettings, FoundFit};
use lagrange_runtime::fit::{Data, DataError};
use numpy::{PyArray1, PyArray2, PyArrayMethods, ToPyArray};
use pyo3::exceptions::{PyOSError, PyTypeError, PyValueError};
use pyo3::types::{PyAnyMethods, PyDict, PyDictMethods};
use pyo3::{Bound, Py, PyAny, PyResult, Python, pyclass, pymethods};

use crate::error::{FitError, with_results};
use crate::interrupt::interruptible;

#[doc = described!(Fit)]
#[pyclass(name = "Fit", module = "lagrange", frozen)]
pub(crate) struct PyFit {
    found: FoundFit,
    /// The system with the fitted parameters.
    system: Py<PyAny>,
}

/// A function that creates a system from parameters and inputs.
type MakeSystem<'a> = &'a dyn Fn(&[f64]) -> PyResult<Py<PyAny>>;

impl PyFit {
    /// Fits a system while other Python threads run. `make` creates the system with the fitted
    /// parameters.
    pub(crate) fn search(
        py: Python<'_>,
        system: &DeclaredSystem,
        settings: &FitSettings,
        make: MakeSystem<'_>,
    ) -> PyResult<Self> {
        check(settings)?;
        let with_system = |found: FoundFit| Ok(PyFit { system: make(&found.fields)?, found });
        let (found, raised) = interruptible(py, |watch| system.fit_watched(settings, watch));
        match (found, raised) {
            (Ok(found), None) => with_system(found),
            (Ok(found), Some(raised)) => {
                Err(with_results(py, raised, "fit", Py::new(py, with_system(found)?)))
            }
            (Err(FitFailure::Unfinished { message, best }), raised) => {
                let error = raised.unwrap_or_else(|| FitError::new_err(message));
                Err(with_results(py, error, "fit", Py::new(py, with_system(*best)?)))
            }
            (Err(_), Some(raised)) => Err(raised),
            (Err(FitFailure::Motion(message)), None) => Err(FitError::new_err(message)),
            (Err(error), None) => Err(PyValueError::new_err(error.to_string())),
        }
    }

    /// Returns a dictionary of the values, by name.
    fn named<'py, T: pyo3::IntoPyObject<'py>>(
        &self,
        py: Python<'py>,
        entries: impl Iterator<Item = T>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let dictionary = PyDict::new(py);
        for (value, entry) in self.found.values.iter().zip(entries) {
            dictionary.set_item(value.name, entry)?;
        }
        Ok(dictionary)
    }
}

/// Checks settings whose errors have different names in Rust.
fn check(settings: &FitSettings) -> PyResult<()> {
    if settings.varied.is_empty() {
        return Err(PyValueError::new_err(
            "nothing varies: name a parameter, as in `vary={\"k\": (0.1, 10)}`",
        ));
    }
    let has_level = |column: &&str| settings.noise.iter().any(|(name, _)| name == column);
    let columns = settings.data.names().count();
    let mut without = settings.data.names().filter(|column| !has_level(column));
    match without.next().filter(|_| columns > 1 || !settings.noise.is_empty()) {
        Some(column) => Err(PyValueError::new_err(format!(
            "column `{column}` needs a noise level, `noise={{\"{column}\": …}}`, by which its residuals count \
             beside those of other columns"
        ))),
        None => Ok(()),
    }
}

#[pymethods]
impl PyFit {
    #[doc = described!(Fit.values)]
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.named(py, self.found.values.iter().map(|value| value.value))
    }

    #[doc = described!(Fit.standard_errors)]
    #[getter]
    fn standard_errors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.named(py, self.found.values.iter().map(|value| value.standard_error))
    }

    #[doc = described!(Fit.covariance)]
    #[getter]
    fn covariance<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray2<f64>>>> {
        self.matrix(py, |covariance, i, j| covariance[i][j])
    }

    #[doc = described!(Fit.correlations)]
    #[getter]
    fn correlations<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray2<f64>>>> {
        self.matrix(py, |covariance, i, j| {
            if i == j { 1.0 } else { covariance[i][j] / (covariance[i][i] * covariance[j][j]).sqrt() }
        })
    }

    #[doc = described!(Fit.weakest)]
    #[getter]
    fn weakest<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let weakest = PyDict::new(py);
        for (name, part) in &self.found.weakest {
            weakest.set_item(name, part)?;
        }
        Ok(weakest)
    }

    #[doc = described!(Fit.weakest_error)]
    #[getter]
    fn weakest_error(&self) -> f64 {
        self.found.weakest_error
    }

    #[doc = described!(Fit.chi_square)]
    #[getter]
    fn chi_square(&self) -> f64 {
        self.found.chi_square
    }

    #[doc = described!(Fit.degrees_of_freedom)]
    #[getter]
    fn degrees_of_freedom(&self) -> usize {
        self.found.degrees_of_freedom
    }

    #[doc = described!(Fit.iterations)]
    #[getter]
    fn iterations(&self) -> usize {
        self.found.iterations
    }

    #[doc = described!(Fit.system)]
    #[getter]
    fn system(&self, py: Python<'_>) -> Py<PyAny> {
        self.system.clone_ref(py)
    }

    #[doc = described!(Fit.start)]
    #[getter]
    fn start<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.found.start.to_pyarray(py)
    }

    fn __str__(&self) -> String {
        self.found.report.clone()
    }

    fn __repr__(&self) -> String {
        let values = self.found.values.iter().map(|value| format!("{} = {}", value.name, value.value));
        format!("<Fit of {}>", values.collect::<Vec<_>>().join(", "))
    }
}

impl PyFit {
    /// Returns a square matrix of entries derived from the covariance matrix.
    fn matrix<'py>(
        &self,
        py: Python<'py>,
        entry: impl Fn(&[Vec<f64>], usize, usize) -> f64,
    ) -> PyResult<Option<Bound<'py, PyArray2<f64>>>> {
        let Some(covariance) = &self.found.covariance else { return Ok(None) };
        let size = covariance.len();
        let entries = (0..size * size).map(|place| entry(covariance, place / size, place % size));
        entries.collect::<Vec<_>>().to_pyarray(py).reshape([size, size]).map(Some)
    }
}

/// Reads times, `t`, and measured columns, in which `None` is a missing value. The source is a
/// dictionary, a data frame, or the path of a CSV file.
///
/// # Errors
/// `ValueError` if there are no times, or a column is not a list of numbers. `OSError` if a file
/// cannot be read. `TypeError` for anything else.
pub(crate) fn data(table: &Bound<'_, PyAny>) -> PyResult<Data> {
    if let Ok(path) = table.extract::<PathBuf>() {
        return Data::read_csv(path).map_err(|error| match error {
            DataError::Unreadable { .. } => PyOSError::new_err(error.to_string()),
            _ => PyValueError::new_err(error.to_string()),
        });
    }
    let wrong = |name: &str| {
        PyValueError::new_err(format!("the column `{name}` of the data must be an array of numbers"))
    };
    let names = names_of(table)?;
    if !names.iter().any(|name| name == "t") {
        return Err(PyValueError::new_err(format!(
            "the data have no times, `t`; their columns are {}",
            names.join(", ")
        )));
    }
    let times = table.get_item("t")?;
    let mut data = Data::new(times.extract::<Vec<f64>>().map_err(|_| wrong("t"))?);
    for name in names.iter().filter(|name| *name != "t") {
        let values = table.get_item(name)?.extract::<Vec<Option<f64>>>().map_err(|_| wrong(name))?;
        data = data.with(name, values);
    }
    Ok(data)
}

/// Returns the names of the columns of a dictionary, or of a data frame, which may not be a
/// mapping.
fn names_of(table: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    let names = table.call_method0("keys").or_else(|_| table.getattr("columns"));
    let names = names.and_then(|names| names.try_iter()?.map(|name| name?.extract()).collect());
    names.map_err(|_| {
        PyTypeError::new_err("data are a dictionary or a data frame of columns, or the path of a CSV file")
    })
}

/// Reads the varied quantities: names, or a dictionary of bounds, in which `None` means unbounded.
///
/// # Errors
/// `ValueError` for anything else.
pub(crate) fn varied(vary: &Bound<'_, PyAny>) -> PyResult<Vec<(String, [f64; 2])>> {
    const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
    let wrong = |_| {
        PyValueError::new_err(
            "`vary` must be names, or a dictionary of bounds, as in `{\"k\": (0.1, 10), \"c\": None}`",
        )
    };
    let Ok(bounds) = vary.cast::<PyDict>() else {
        let names = vary.extract::<Vec<String>>().map_err(wrong)?;
        return Ok(names.into_iter().map(|name| (name, FREE)).collect());
    };
    let bound = |(name, bounds): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let ends = bounds.extract::<Option<(Option<f64>, Option<f64>)>>().map_err(wrong)?;
        let (low, high) = ends.unwrap_or_default();
        Ok((name.extract::<String>()?, [low.unwrap_or(FREE[0]), high.unwrap_or(FREE[1])]))
    };
    bounds.iter().map(bound).collect()
}
