//! Runs with settings of Python.

use std::cell::RefCell;

use lagrange_dynamic::{DynamicSystem, Inline, MethodChoice, Visitor};
use lagrange_runtime::integrate::Verner98;
use lagrange_runtime::simulate::{Simulate, Simulation, SimulationError as RunError, Trajectory};
use lagrange_runtime::system::{StateVector, StepFailure};
use numpy::ToPyArray;
use pyo3::exceptions::PyValueError;
use pyo3::types::PyAnyMethods;
use pyo3::{Bound, Py, PyAny, PyErr, PyResult, Python};

use crate::error::SimulationError;
use crate::motion::PyTrajectory;

/// The settings of a run.
pub(crate) struct Run {
    pub(crate) start: Vec<f64>,
    pub(crate) from: f64,
    pub(crate) until: f64,
    pub(crate) every: Option<f64>,
    pub(crate) method: MethodChoice,
    pub(crate) has_energy: bool,
}

/// A run whose inputs are a function of Python.
pub(crate) struct DrivenRun<'py> {
    pub(crate) run: Run,
    /// Takes time and state, and returns the inputs.
    pub(crate) law: Bound<'py, PyAny>,
}

/// A run that failed.
pub(crate) struct FailedRun {
    message: String,
    is_setting: bool,
    motion: PyTrajectory,
}

impl FailedRun {
    fn new<const CAPACITY: usize>(failure: &RunError<DynamicSystem<CAPACITY>>) -> Self {
        FailedRun {
            message: failure.to_string(),
            is_setting: matches!(failure.cause, StepFailure::Setting(_) | StepFailure::OutOfRange(_)),
            motion: PyTrajectory::new(&failure.trajectory),
        }
    }

    /// Returns the exception: `ValueError` for settings, else with what the motion reached.
    pub(crate) fn exception(self, py: Python<'_>) -> PyErr {
        if self.is_setting {
            return PyValueError::new_err(self.message);
        }
        let error = SimulationError::new_err(self.message);
        let set = Py::new(py, self.motion).and_then(|motion| error.value(py).setattr("trajectory", motion));
        set.err().unwrap_or(error)
    }
}

impl Run {
    fn simulation<'a, const CAPACITY: usize>(
        &self,
        system: &'a DynamicSystem<CAPACITY>,
    ) -> Simulation<'a, DynamicSystem<CAPACITY>, Verner98<f64>> {
        let start = system.simulate(system.state(&self.start)).from(self.from);
        let mut simulation = start.until(self.until);
        if let Some(interval) = self.every {
            simulation = simulation.every(interval);
        }
        if system.has_outputs() {
            simulation = simulation.outputs();
        }
        if self.has_energy {
            simulation = simulation.energy();
        }
        simulation
    }
}

impl Visitor for Run {
    type Output = Result<PyTrajectory, Box<FailedRun>>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        ended(self.method.run(self.simulation(system)))
    }
}

impl Visitor for DrivenRun<'_> {
    type Output = PyResult<PyTrajectory>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> PyResult<PyTrajectory> {
        let raised = RefCell::new(None);
        let law = |_: &DynamicSystem<CAPACITY>, t: f64, y: Inline<CAPACITY>| {
            self.inputs(t, y.as_ref()).map(|inputs| Inline::of(&inputs)).unwrap_or_else(|error| {
                raised.borrow_mut().get_or_insert(error);
                // None are missing inputs, with which the run ends.
                Inline::of(&[])
            })
        };
        let motion = ended(self.run.method.run(self.run.simulation(system).drive(law)));
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
) -> Result<PyTrajectory, Box<FailedRun>> {
    result.map(|motion| PyTrajectory::new(&motion)).map_err(|failure| Box::new(FailedRun::new(&failure)))
}
