//! Ensembles of motions, with initial states and parameters from Python.

use lagrange_dynamic::{DeclaredSystem, EnsembleSettings, FailedMotion};
use numpy::{PyArray1, ToPyArray};
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::types::{PyAnyMethods, PyDict};
use pyo3::{Bound, Py, PyAny, PyRef, PyResult, Python, pyclass, pymethods};

use crate::columns::{NewColumns, PyColumns};
use crate::interrupt::interruptible_on_threads;
use crate::values::{PerMotion, check_values, per_motion};

#[doc = described!(Ensemble)]
#[pyclass(name = "Ensemble", module = "lagrange", extends = PyColumns, frozen)]
pub(crate) struct PyEnsemble {
    failures: Vec<FailedMotion>,
}

impl PyEnsemble {
    /// Computes motions while other Python threads run.
    pub(crate) fn compute(
        py: Python<'_>,
        system: &DeclaredSystem,
        settings: &EnsembleSettings,
    ) -> PyResult<Py<Self>> {
        let ends = interruptible_on_threads(py, |watch| system.ensemble_watched(settings, watch))?;
        let ends = ends.map_err(|error| PyValueError::new_err(error.to_string()))?;
        let names = std::iter::once("t".to_owned()).chain(ends.names).collect();
        let columns = std::iter::once(ends.times).chain(ends.columns).collect();
        let entries = system.state_names().len();
        let columns = NewColumns { names, columns, entries }.share(py);
        Py::new(py, (PyEnsemble { failures: ends.failures }, columns))
    }
}

#[pymethods]
impl PyEnsemble {
    #[doc = described!(Ensemble.failures)]
    #[getter]
    fn failures<'py>(&self, py: Python<'py>) -> Vec<(usize, f64, Bound<'py, PyArray1<f64>>, String)> {
        let failure = |failed: &FailedMotion| {
            (failed.index, failed.time, failed.state.to_pyarray(py), failed.message.clone())
        };
        self.failures.iter().map(failure).collect()
    }

    fn __repr__(slf: PyRef<'_, Self>) -> String {
        let (columns, failed) = (slf.as_super(), slf.failures.len());
        let motions = columns.length(slf.py());
        format!("<Ensemble of {motions} motions, {failed} failed: {}>", columns.names.join(", "))
    }
}

/// Initial states of motions, and varied quantities by name.
type Motions = (Vec<Vec<f64>>, Vec<(String, Vec<f64>)>);

/// Returns the motions from initial states and parameters. Initial states are rows of an array, or
/// numbers and arrays by entry.
///
/// # Errors
/// `ValueError` for wrong shapes, inconsistent numbers of runs, and missing values; `KeyError` for
/// unknown parameters.
pub(crate) fn motions(
    system: &DeclaredSystem,
    starts: Option<&Bound<'_, PyAny>>,
    parameters: Option<&Bound<'_, PyDict>>,
) -> PyResult<Motions> {
    let parameters = per_motion(parameters)?;
    check_all(system, &parameters)?;
    let (entries, rows) = match starts.map(|starts| (starts, starts.cast::<PyDict>())) {
        None => (Vec::new(), None),
        Some((_, Ok(entries))) => (per_motion(Some(entries))?, None),
        Some((rows, Err(_))) => (Vec::new(), Some(states(system, rows)?)),
    };
    let named = entries.iter().chain(&parameters);
    let named = named.filter_map(|(name, value)| Some((name.as_str(), value.motions()?)));
    let motions = number(named.chain(rows.as_ref().map(|rows| ("starts", rows.len()))))?;
    let start = |motion| {
        let values = entries.iter().map(|(name, value)| (name.clone(), value.at(motion)));
        // A motion that starts out of a declared range fails by itself.
        let start = system.unchecked_start(&values.collect::<Vec<_>>());
        start.map_err(|error| PyValueError::new_err(error.to_string()))
    };
    let starts = rows.map_or_else(|| (0..motions).map(start).collect(), Ok)?;
    let each = |value: &PerMotion| (0..motions).map(|motion| value.at(motion)).collect();
    Ok((starts, parameters.iter().map(|(name, value)| (name.clone(), each(value))).collect()))
}

/// Returns the rows of an array.
fn states(system: &DeclaredSystem, rows: &Bound<'_, PyAny>) -> PyResult<Vec<Vec<f64>>> {
    let names = system.state_names();
    let wrong = |_| {
        PyValueError::new_err(format!(
            "`starts` must be an array of shape (runs, {}), with {} in each row",
            names.len(),
            names.join(", ")
        ))
    };
    rows.extract().map_err(wrong)
}

/// Returns the common number of motions of these values.
fn number<'a>(mut lengths: impl Iterator<Item = (&'a str, usize)>) -> PyResult<usize> {
    let unknown = "nothing tells the number of runs: pass an array of starts or of parameters";
    let (first, motions) = lengths.next().ok_or_else(|| PyValueError::new_err(unknown))?;
    match lengths.find(|(_, count)| *count != motions) {
        Some((name, count)) => {
            Err(PyValueError::new_err(format!("`{first}` is for {motions} runs, and `{name}` for {count}")))
        }
        None => Ok(motions),
    }
}

/// Checks that all parameters and inputs have values, including those specified for each motion.
fn check_all(system: &DeclaredSystem, given: &[(String, PerMotion)]) -> PyResult<()> {
    let mut complete = system.clone();
    for (name, _) in given {
        complete.set(name, 1.0).map_err(|error| PyKeyError::new_err(error.to_string()))?;
    }
    check_values(&complete)
}
