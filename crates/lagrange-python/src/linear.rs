//! Equilibria, linear models, modes and regulators.

use lagrange_dynamic::{AnalysisError, DeclaredSystem, FoundEquilibrium, SearchSettings};
use lagrange_runtime::linear::{DenseMatrix, Eigenmode, LinearModel, Stability};
use numpy::{PyArray1, PyArray2, PyArrayMethods, ToPyArray};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::types::{PyAnyMethods, PyComplex, PyDict, PyDictMethods};
use pyo3::{Bound, PyAny, PyErr, PyResult, Python, pyclass, pymethods};

use crate::error::EquilibriumError;
use crate::values::rows;

#[doc = described!(Equilibrium)]
#[pyclass(name = "Equilibrium", module = "lagrange", frozen)]
pub(crate) struct PyEquilibrium {
    found: FoundEquilibrium,
    /// Names of the inputs.
    inputs: Vec<String>,
}

impl PyEquilibrium {
    pub(crate) fn search(
        py: Python<'_>,
        system: &DeclaredSystem,
        settings: SearchSettings,
    ) -> PyResult<Self> {
        let inputs = system.variables().fields[system.programs().layout.parameters..].to_vec();
        let found = py.detach(|| system.equilibrium(settings));
        found.map(|found| PyEquilibrium { found, inputs }).map_err(|error| exception(py, &error))
    }
}

#[pymethods]
impl PyEquilibrium {
    #[doc = described!(Equilibrium.state)]
    #[getter]
    fn state<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.found.state.to_pyarray(py)
    }

    #[doc = described!(Equilibrium.inputs)]
    #[getter]
    fn inputs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let inputs = PyDict::new(py);
        for (name, value) in self.inputs.iter().zip(&self.found.inputs) {
            inputs.set_item(name, value)?;
        }
        Ok(inputs)
    }

    #[doc = described!(Equilibrium.iterations)]
    #[getter]
    fn iterations(&self) -> u32 {
        self.found.iterations
    }

    #[doc = described!(Equilibrium.freedom)]
    #[getter]
    fn freedom(&self) -> usize {
        self.found.freedom
    }

    fn __repr__(&self) -> String {
        format!("<Equilibrium at {:?}>", self.found.state)
    }
}

#[doc = described!(LinearModel)]
#[pyclass(name = "LinearModel", module = "lagrange", frozen)]
pub(crate) struct PyLinearModel(LinearModel);

impl PyLinearModel {
    pub(crate) fn new(py: Python<'_>, system: &DeclaredSystem, time: f64, state: &[f64]) -> PyResult<Self> {
        py.detach(|| system.linearise(time, state)).map(PyLinearModel).map_err(|error| exception(py, &error))
    }
}

#[pymethods]
impl PyLinearModel {
    #[doc = described!(LinearModel.a)]
    #[getter]
    fn a<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        array(py, self.0.a())
    }

    #[doc = described!(LinearModel.b)]
    #[getter]
    fn b<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        array(py, self.0.b())
    }

    #[doc = described!(LinearModel.c)]
    #[getter]
    fn c<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        array(py, self.0.c())
    }

    #[doc = described!(LinearModel.d)]
    #[getter]
    fn d<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        array(py, self.0.d())
    }

    #[doc = described!(LinearModel.states)]
    #[getter]
    fn states(&self) -> Vec<String> {
        self.0.states().to_vec()
    }

    #[doc = described!(LinearModel.inputs)]
    #[getter]
    fn inputs(&self) -> Vec<&'static str> {
        self.0.inputs().to_vec()
    }

    #[doc = described!(LinearModel.outputs)]
    #[getter]
    fn outputs(&self) -> Vec<&'static str> {
        self.0.outputs().to_vec()
    }

    #[doc = described!(LinearModel.modes)]
    fn modes(&self) -> PyResult<Vec<PyMode>> {
        let modes = self.0.modes().map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        let names = modes.components();
        Ok(modes.modes().iter().map(|mode| PyMode { mode: mode.clone(), names: names.to_vec() }).collect())
    }

    #[doc = described!(LinearModel.is_stable)]
    #[getter]
    fn is_stable(&self) -> PyResult<Option<bool>> {
        let modes = self.0.modes().map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        Ok(match modes.stability() {
            Stability::AsymptoticallyStable => Some(true),
            Stability::Unstable => Some(false),
            _ => None,
        })
    }

    #[doc = described!(LinearModel.lqr)]
    fn lqr<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'_, PyAny>,
        r: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let regulator = self.0.lqr(&dense("q", q)?, &dense("r", r)?);
        array(py, &regulator.map_err(|error| PyValueError::new_err(error.to_string()))?.gain)
    }

    fn __repr__(&self) -> String {
        let (states, inputs) = (self.0.states().join(", "), self.0.inputs().join(", "));
        format!("<LinearModel of {states} by {inputs}>")
    }
}

#[doc = described!(Mode)]
#[pyclass(name = "Mode", module = "lagrange", frozen)]
pub(crate) struct PyMode {
    mode: Eigenmode,
    names: Vec<String>,
}

#[pymethods]
impl PyMode {
    #[doc = described!(Mode.eigenvalue)]
    #[getter]
    fn eigenvalue<'py>(&self, py: Python<'py>) -> Bound<'py, PyComplex> {
        PyComplex::from_doubles(py, self.mode.real, self.mode.imaginary)
    }

    #[doc = described!(Mode.natural_frequency)]
    #[getter]
    fn natural_frequency(&self) -> f64 {
        self.mode.natural_frequency()
    }

    #[doc = described!(Mode.frequency)]
    #[getter]
    fn frequency(&self) -> f64 {
        self.mode.frequency()
    }

    #[doc = described!(Mode.damping_ratio)]
    #[getter]
    fn damping_ratio(&self) -> f64 {
        self.mode.damping_ratio()
    }

    #[doc = described!(Mode.shape)]
    #[getter]
    fn shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let shape = PyDict::new(py);
        for (name, (real, imaginary)) in self.names.iter().zip(&self.mode.shape) {
            shape.set_item(name, PyComplex::from_doubles(py, *real, *imaginary))?;
        }
        Ok(shape)
    }

    fn __repr__(&self) -> String {
        format!("<Mode {} ± {}i>", self.mode.real, self.mode.imaginary)
    }
}

fn array<'py>(py: Python<'py>, matrix: &DenseMatrix) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let entries = (0..matrix.rows()).flat_map(|row| matrix.row(row)).copied().collect::<Vec<_>>();
    entries.to_pyarray(py).reshape([matrix.rows(), matrix.columns()])
}

fn dense(name: &str, matrix: &Bound<'_, PyAny>) -> PyResult<DenseMatrix> {
    let rows = rows(&format!("`{name}`"), matrix)?;
    let columns = rows.first().map_or(0, Vec::len);
    match rows.iter().all(|row| row.len() == columns) {
        true => Ok(DenseMatrix::from_fn(rows.len(), columns, |i, j| rows[i][j])),
        false => Err(PyValueError::new_err(format!("the rows of `{name}` differ in length"))),
    }
}

/// Returns `ValueError` for states without a linear model, otherwise an exception with the state at
/// which the search stopped.
fn exception(py: Python<'_>, error: &AnalysisError) -> PyErr {
    let AnalysisError::Search { message, state } = error else {
        return PyValueError::new_err(error.to_string());
    };
    let exception = EquilibriumError::new_err(message.clone());
    let set = exception.value(py).setattr("state", state.to_pyarray(py));
    set.err().unwrap_or(exception)
}
