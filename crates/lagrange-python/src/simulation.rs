//! Runs with settings from Python.

use std::cell::RefCell;

use lagrange_dynamic::{DynamicSystem, Inline, MethodChoice, RunSettings, Visitor};
use lagrange_runtime::simulate::{SimulationError as RunError, Trajectory};
use lagrange_runtime::system::StateVector;
use numpy::ToPyArray;
use pyo3::exceptions::PyValueError;
use pyo3::types::PyAnyMethods;
use pyo3::{Bound, Py, PyAny, PyErr, PyResult, Python};

use crate::error::SimulationError;
use crate::motion::{NewTrajectory, PyTrajectory};

/// Returns the method of a name with its settings; a seed chooses the noise.
///
/// # Errors
/// `ValueError` for settings that the method does not have.
pub(crate) fn chosen(
    name: Option<&str>,
    tolerance: Option<f64>,
    step: Option<f64>,
    seed: Option<u64>,
) -> PyResult<MethodChoice> {
    let method = MethodChoice::new(name, tolerance, step);
    let method = method.map_err(|error| PyValueError::new_err(error.to_string()))?;
    match (seed, &method) {
        (None, _) => Ok(method),
        (Some(seed), MethodChoice::EulerMaruyama { .. } | MethodChoice::StochasticRungeKutta4 { .. }) => {
            Ok(method.with_seed(seed))
        }
        (Some(_), _) => {
            Err(PyValueError::new_err("`seed` chooses the noise of the methods `maruyama` and `stochastic`"))
        }
    }
}

/// A run whose inputs are constant.
pub(crate) struct FreeRun(pub(crate) RunSettings);

/// A run with inputs from a Python function.
pub(crate) struct DrivenRun<'py> {
    pub(crate) settings: RunSettings,
    /// Function of time and state that returns the inputs.
    pub(crate) law: Bound<'py, PyAny>,
}

/// A run that failed.
pub(crate) struct FailedRun {
    message: String,
    is_refusal: bool,
    motion: NewTrajectory,
}

impl FailedRun {
    fn new<const CAPACITY: usize>(failure: &RunError<DynamicSystem<CAPACITY>>) -> Self {
        FailedRun {
            message: failure.to_string(),
            is_refusal: failure.cause.is_refusal(),
            motion: PyTrajectory::new(&failure.trajectory),
        }
    }

    /// Returns the exception: `ValueError` for invalid settings, otherwise one with the motion so
    /// far.
    pub(crate) fn exception(self, py: Python<'_>) -> PyErr {
        if self.is_refusal {
            return PyValueError::new_err(self.message);
        }
        let error = SimulationError::new_err(self.message);
        let set = Py::new(py, self.motion).and_then(|motion| error.value(py).setattr("trajectory", motion));
        set.err().unwrap_or(error)
    }
}

impl Visitor for FreeRun {
    type Output = Result<NewTrajectory, Box<FailedRun>>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        let FreeRun(settings) = self;
        ended(settings.run(system))
    }
}

impl Visitor for DrivenRun<'_> {
    type Output = PyResult<NewTrajectory>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> PyResult<NewTrajectory> {
        let raised = RefCell::new(None);
        let law = |_: &DynamicSystem<CAPACITY>, t: f64, y: Inline<CAPACITY>| {
            self.inputs(t, y.as_ref()).map(|inputs| Inline::of(&inputs)).unwrap_or_else(|error| {
                raised.borrow_mut().get_or_insert(error);
                // An empty vector means missing inputs, which end the run.
                Inline::of(&[])
            })
        };
        let simulation = self.settings.simulation(system).drive(law);
        let motion = ended(self.settings.method.run_driven(simulation, system));
        match raised.into_inner() {
            Some(error) => Err(error),
            None => motion.map_err(|failure| failure.exception(self.law.py())),
        }
    }
}

impl DrivenRun<'_> {
    fn inputs(&self, t: f64, y: &[f64]) -> PyResult<Vec<f64>> {
        let found = self.law.call1((t, y.to_pyarray(self.law.py())))?;
        found.extract::<f64>().map(|input| vec![input]).or_else(|_| found.extract::<Vec<f64>>())
    }
}

fn ended<const CAPACITY: usize>(
    result: Result<Trajectory<DynamicSystem<CAPACITY>>, RunError<DynamicSystem<CAPACITY>>>,
) -> Result<NewTrajectory, Box<FailedRun>> {
    result.map(|motion| PyTrajectory::new(&motion)).map_err(|failure| Box::new(FailedRun::new(&failure)))
}
