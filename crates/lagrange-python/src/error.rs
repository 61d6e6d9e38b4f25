//! Exceptions.

use lagrange_core::diagnostics::{Diagnostic, Report, Severity};
use pyo3::create_exception;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::types::PyAnyMethods;
use pyo3::{Py, PyClass, PyErr, PyResult, Python};

create_exception!(lagrange, DeclarationError, PyValueError, described!(DeclarationError));
create_exception!(lagrange, EquilibriumError, PyRuntimeError, described!(EquilibriumError));
create_exception!(lagrange, FitError, PyRuntimeError, described!(FitError));
create_exception!(lagrange, SimulationError, PyRuntimeError, described!(SimulationError));

/// Returns the exception of a report: the text of all errors, and the position of the first one.
pub(crate) fn declaration_error(py: Python<'_>, report: &Report) -> PyErr {
    let errors = || report.diagnostics().iter().filter(|found| found.severity == Severity::Error);
    let text = errors().map(line).collect::<Vec<_>>().join("\n");
    let error = DeclarationError::new_err(text);
    let first = errors().next();
    let position = first.and_then(|first| first.origin.position());
    let value = error.value(py);
    let set = value
        .setattr("line", position.map(|[line, _]| line))
        .and_then(|()| value.setattr("column", position.map(|[_, column]| column)))
        .and_then(|()| value.setattr("help", first.and_then(|first| first.help.clone())));
    set.err().unwrap_or(error)
}

/// Returns an exception with the results so far as an attribute.
pub(crate) fn with_results<C: PyClass>(
    py: Python<'_>,
    error: PyErr,
    name: &str,
    results: PyResult<Py<C>>,
) -> PyErr {
    let set = results.and_then(|results| error.value(py).setattr(name, results));
    // Some exceptions have no room for attributes. They tell more than the failure to set one.
    set.map_or(error.clone_ref(py), |()| error)
}

/// Formats an error on a line, with its position and help.
fn line(diagnostic: &Diagnostic) -> String {
    let place = match diagnostic.origin.position() {
        Some([line, column]) => format!("line {line}, column {column}: "),
        None => String::new(),
    };
    let help = diagnostic.help.as_ref().map_or(String::new(), |help| format!(" (help: {help})"));
    format!("{place}{}{help}", diagnostic.message)
}
