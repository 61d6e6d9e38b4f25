//! Numbers and names from Python, whose errors name the argument.

use lagrange_dynamic::DeclaredSystem;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::types::{PyAnyMethods, PyDict, PyDictMethods, PyTypeMethods};
use pyo3::{Bound, PyAny, PyErr, PyResult};

/// A value for all motions, or a value for each of them.
pub(crate) enum PerMotion {
    Same(f64),
    Each(Vec<f64>),
}

impl PerMotion {
    /// Returns the value of a motion.
    pub(crate) fn at(&self, motion: usize) -> f64 {
        match self {
            PerMotion::Same(value) => *value,
            PerMotion::Each(values) => values[motion],
        }
    }

    /// Returns the number of motions, if it is determined.
    pub(crate) fn motions(&self) -> Option<usize> {
        match self {
            PerMotion::Same(_) => None,
            PerMotion::Each(values) => Some(values.len()),
        }
    }
}

/// Returns the numbers of an argument.
///
/// # Errors
/// `TypeError` if it is no array of numbers.
pub(crate) fn numbers(argument: &str, values: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    values.extract().map_err(|_| not(argument, "an array of numbers", values))
}

/// Returns the rows of an argument.
///
/// # Errors
/// `TypeError` if it is no array of rows of numbers.
pub(crate) fn rows(argument: &str, values: &Bound<'_, PyAny>) -> PyResult<Vec<Vec<f64>>> {
    values.extract().map_err(|_| not(argument, "an array of numbers with two dimensions", values))
}

/// Returns the names of an argument; none if it is missing.
///
/// # Errors
/// `TypeError` if it is no list of names.
pub(crate) fn names(argument: &str, values: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<String>> {
    let Some(values) = values else { return Ok(Vec::new()) };
    values.extract().map_err(|_| not(argument, "a list of names", values))
}

/// Returns the error of an argument that is something else.
fn not(argument: &str, wanted: &str, found: &Bound<'_, PyAny>) -> PyErr {
    let found = found.get_type().name().map_or_else(|_| String::new(), |name| format!(", not {name}"));
    PyTypeError::new_err(format!("{argument} must be {wanted}{found}"))
}

/// Returns the numbers of a dictionary.
///
/// # Errors
/// `TypeError` with the name of a value that is no number.
pub(crate) fn pairs(values: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<(String, f64)>> {
    let Some(values) = values else { return Ok(Vec::new()) };
    let pair = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name = name.extract::<String>().map_err(|_| not("names of values", "texts", &name))?;
        let number = value.extract().map_err(|_| not(&format!("`{name}`"), "a number", &value))?;
        Ok((name, number))
    };
    values.iter().map(pair).collect()
}

/// Returns the values of a dictionary: numbers, or arrays with a number for each motion.
///
/// # Errors
/// `ValueError` for anything else.
pub(crate) fn per_motion(values: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<(String, PerMotion)>> {
    let Some(values) = values else { return Ok(Vec::new()) };
    let value = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name = name.extract::<String>()?;
        let each = || value.extract::<Vec<f64>>().map(PerMotion::Each);
        let found = value.extract::<f64>().map(PerMotion::Same).or_else(|_| each());
        let wrong = format!("`{name}` must be a number, or an array with a number for each run");
        Ok((name, found.map_err(|_| PyValueError::new_err(wrong))?))
    };
    values.iter().map(value).collect()
}

/// Returns the declared initial state with other values for some entries.
///
/// # Errors
/// `ValueError` for unknown names, and for entries without a value or out of their declared ranges.
pub(crate) fn start_of(system: &DeclaredSystem, values: &[(String, f64)]) -> PyResult<Vec<f64>> {
    system.start_with(values).map_err(|error| PyValueError::new_err(error.to_string()))
}

/// Checks that all parameters and inputs have values.
///
/// # Errors
/// `ValueError` with the first name without a value.
pub(crate) fn check_values(system: &DeclaredSystem) -> PyResult<()> {
    match system.missing() {
        Some(name) => Err(PyValueError::new_err(format!(
            "`{name}` has no value: set it by `with_parameters({name}=1)`"
        ))),
        None => Ok(()),
    }
}
