//! Runs with settings from Python.

use std::cell::RefCell;

use lagrange_dynamic::{DeclaredSystem, DynamicSystem, Inline, MethodChoice, RunSettings, Visitor, Watch};
use lagrange_runtime::simulate::{SimulationError as RunError, Trajectory};
use lagrange_runtime::system::StateVector;
use numpy::ToPyArray;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::types::PyAnyMethods;
use pyo3::{Bound, PyAny, PyErr, PyResult, Python};

use crate::error::{SimulationError, with_results};
use crate::motion::NewTrajectory;
use crate::values::numbers;

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
    match seed {
        None => Ok(method),
        Some(seed) if method.has_seed() => Ok(method.with_seed(seed)),
        Some(_) => {
            Err(PyValueError::new_err("`seed` chooses the noise of the methods `maruyama` and `stochastic`"))
        }
    }
}

/// A run whose inputs are constant.
pub(crate) struct FreeRun<'a>(pub(crate) RunSettings, pub(crate) Watch<'a>);

/// A run with inputs from a Python function.
pub(crate) struct DrivenRun<'py> {
    settings: RunSettings,
    /// Function of time and state that returns the inputs.
    law: Bound<'py, PyAny>,
    /// Number of inputs.
    count: usize,
}

/// A run that failed.
pub(crate) struct FailedRun {
    message: String,
    is_refusal: bool,
    motion: NewTrajectory,
}

impl FailedRun {
    fn new<const CAPACITY: usize>(failure: &RunError<DynamicSystem<CAPACITY>>) -> Self {
        let is_refusal = failure.cause.is_refusal();
        FailedRun {
            // A run that is refused has no time.
            message: if is_refusal { failure.cause.to_string() } else { failure.to_string() },
            is_refusal,
            motion: NewTrajectory::of(&failure.trajectory),
        }
    }

    /// Returns the exception: `ValueError` for invalid settings, otherwise one with the motion so
    /// far.
    pub(crate) fn exception(self, py: Python<'_>) -> PyErr {
        if self.is_refusal {
            return PyValueError::new_err(self.message);
        }
        with_results(py, SimulationError::new_err(self.message), "trajectory", self.motion.share(py))
    }
}

impl Visitor for FreeRun<'_> {
    type Output = Result<NewTrajectory, Box<FailedRun>>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        let FreeRun(settings, watch) = self;
        ended(settings.run_watched(system, watch))
    }
}

impl Visitor for DrivenRun<'_> {
    type Output = PyResult<NewTrajectory>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> PyResult<NewTrajectory> {
        let raised = RefCell::new(None);
        let law = |_: &DynamicSystem<CAPACITY>, t: f64, y: Inline<CAPACITY>| {
            let mut raised = raised.borrow_mut();
            // Steps are tried again after an interruption.
            let found = if raised.is_none() { self.inputs(t, y.as_ref()) } else { Ok(Vec::new()) };
            // An empty vector means missing inputs, which end the run.
            Inline::of(&found.unwrap_or_else(|error| {
                *raised = Some(error);
                Vec::new()
            }))
        };
        let simulation = self.settings.simulation(system).drive(law);
        let motion = ended(self.settings.method.run_driven(simulation, system));
        match raised.into_inner() {
            Some(error) => {
                let motion = motion.unwrap_or_else(|failure| failure.motion);
                Err(with_results(self.law.py(), error, "trajectory", motion.share(self.law.py())))
            }
            None => motion.map_err(|failure| failure.exception(self.law.py())),
        }
    }
}

impl<'py> DrivenRun<'py> {
    pub(crate) fn new(settings: RunSettings, law: Bound<'py, PyAny>, system: &DeclaredSystem) -> Self {
        DrivenRun { settings, law, count: system.programs().layout.inputs }
    }

    fn inputs(&self, t: f64, y: &[f64]) -> PyResult<Vec<f64>> {
        let found = self.law.call1((t, y.to_pyarray(self.law.py())))?;
        let one = found.extract::<f64>().map(|input| vec![input]);
        let inputs = one.or_else(|_| numbers("the result of `inputs`", &found))?;
        match (inputs.len(), self.count) {
            (given, count) if given == count => Ok(inputs),
            (given, count) => {
                let [values, inputs] = [given, count].map(|count| if count == 1 { "" } else { "s" });
                Err(PyValueError::new_err(format!(
                    "`inputs` returns {given} value{values} for {count} input{inputs}"
                )))
            }
        }
    }
}

/// Inputs that are linear between samples, and constant before and after them.
pub(crate) struct SampledInputs {
    times: Vec<f64>,
    /// All inputs at each time.
    rows: Vec<Vec<f64>>,
}

impl SampledInputs {
    /// Returns the inputs of a pair of times and values, of one input or in rows of all `count`.
    ///
    /// # Errors
    /// `TypeError` for anything else; `ValueError` for wrong lengths, times that decrease, and
    /// numbers that are not finite.
    pub(crate) fn new(inputs: &Bound<'_, PyAny>, count: usize) -> PyResult<Self> {
        let pair = inputs.extract::<(Bound<'_, PyAny>, Bound<'_, PyAny>)>().map_err(|_| {
            PyTypeError::new_err(
                "`inputs` must be a function of time and state, or a pair of times and values; set constants \
                 by `with_parameters`",
            )
        });
        let (times, values) = pair?;
        let times = numbers("times of `inputs`", &times)?;
        let one = values.extract::<Vec<f64>>();
        let rows = match one {
            Ok(values) => values.into_iter().map(|value| vec![value]).collect(),
            Err(_) => values.extract::<Vec<Vec<f64>>>().map_err(|_| {
                PyTypeError::new_err(
                    "values of `inputs` must be an array of numbers, with a column for each input if there \
                     are several",
                )
            })?,
        };
        let wrong = |message: String| Err(PyValueError::new_err(message));
        if times.is_empty() || rows.len() != times.len() {
            return wrong(format!("{} values of inputs for {} times", rows.len(), times.len()));
        }
        if let Some(row) = rows.iter().find(|row| row.len() != count) {
            return wrong(format!("{} values at a time for {count} inputs", row.len()));
        }
        if let Some(pair) = times.windows(2).find(|pair| pair[1] < pair[0]) {
            return wrong(format!("times of inputs decrease from {} to {}", pair[0], pair[1]));
        }
        if !times.iter().chain(rows.iter().flatten()).all(|number| number.is_finite()) {
            return wrong("times and values of inputs must be finite".into());
        }
        Ok(SampledInputs { times, rows })
    }

    fn at<const CAPACITY: usize>(&self, t: f64) -> Inline<CAPACITY> {
        let next = self.times.partition_point(|time| *time <= t);
        let mut inputs = Inline::of(&self.rows[next.saturating_sub(1)]);
        if next > 0 && next < self.times.len() {
            let [from, to] = [next - 1, next].map(|place| self.times[place]);
            let part = (t - from) / (to - from);
            for (input, end) in inputs.as_mut().iter_mut().zip(&self.rows[next]) {
                *input += part * (end - *input);
            }
        }
        inputs
    }
}

/// A run whose inputs are samples. Steps end at their times.
pub(crate) struct SampledRun<'a> {
    pub(crate) settings: RunSettings,
    pub(crate) inputs: SampledInputs,
    pub(crate) watch: Watch<'a>,
}

impl Visitor for SampledRun<'_> {
    type Output = Result<NewTrajectory, Box<FailedRun>>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        let SampledRun { settings, inputs, watch } = self;
        let law = |_: &DynamicSystem<CAPACITY>, t: f64, _: Inline<CAPACITY>| inputs.at(t);
        let simulation = settings.simulation(system).drive(law).restart_at(inputs.times.iter().copied());
        ended(settings.method.run_driven(simulation.cancel_when(|| watch(0.0)), system))
    }
}

fn ended<const CAPACITY: usize>(
    result: Result<Trajectory<DynamicSystem<CAPACITY>>, RunError<DynamicSystem<CAPACITY>>>,
) -> Result<NewTrajectory, Box<FailedRun>> {
    result.map(|motion| NewTrajectory::of(&motion)).map_err(|failure| Box::new(FailedRun::new(&failure)))
}
