//! Motions, by column.

use lagrange_dynamic::DynamicSystem;
use lagrange_runtime::simulate::{Ending, Trajectory};
use numpy::{PyArray1, ToPyArray};
use pyo3::types::{PyDict, PyDictMethods};
use pyo3::{Bound, Py, PyRef, PyResult, Python, pyclass, pymethods};

use crate::columns::{NewColumns, PyColumns};
use crate::picture::PyPlot;

#[doc = described!(Trajectory)]
#[pyclass(name = "Trajectory", module = "lagrange", extends = PyColumns, frozen)]
pub(crate) struct PyTrajectory {
    units: Vec<Option<&'static str>>,
    events: Vec<(String, f64, Vec<f64>)>,
    ending: &'static str,
    steps: u64,
}

/// A motion that Python does not know yet.
pub(crate) struct NewTrajectory(PyTrajectory, NewColumns);

impl NewTrajectory {
    /// Returns a motion and its columns.
    pub(crate) fn of<const CAPACITY: usize>(motion: &Trajectory<DynamicSystem<CAPACITY>>) -> NewTrajectory {
        let names = motion.names().iter().map(String::as_str);
        let column = |name: &str| motion.column(name).unwrap_or_default().to_vec();
        let time = [(String::from("t"), Some("s"), motion.times().to_vec())];
        let others = names.map(|name| (name.to_owned(), motion.unit(name), column(name)));
        let (mut names, mut units, mut columns) = (Vec::new(), Vec::new(), Vec::new());
        for (name, unit, column) in time.into_iter().chain(others) {
            names.push(name);
            units.push(unit);
            columns.push(column);
        }
        let event = |event: &lagrange_runtime::simulate::Event<f64, _>| {
            let state: &lagrange_dynamic::Inline<CAPACITY> = &event.state;
            (event.name.clone(), event.time, state.as_ref().to_vec())
        };
        let ending = match motion.ending() {
            Ending::Reached => "reached",
            Ending::Stopped => "stopped",
            Ending::Cancelled => "cancelled",
            _ => "failed",
        };
        let events = motion.events().iter().map(event).collect();
        let own = PyTrajectory { units, events, ending, steps: motion.work().steps };
        NewTrajectory(own, NewColumns { names, columns, entries: motion.first().as_ref().len() })
    }

    /// Returns the object of Python.
    ///
    /// # Errors
    /// If it has no room.
    pub(crate) fn share(self, py: Python<'_>) -> PyResult<Py<PyTrajectory>> {
        Py::new(py, (self.0, self.1.share(py)))
    }
}

#[pymethods]
impl PyTrajectory {
    #[doc = described!(Trajectory.units)]
    #[getter]
    fn units<'py>(slf: PyRef<'py, Self>) -> PyResult<Bound<'py, PyDict>> {
        let units = PyDict::new(slf.py());
        for (name, unit) in slf.as_super().names.iter().zip(&slf.units) {
            units.set_item(name, unit)?;
        }
        Ok(units)
    }

    #[doc = described!(Trajectory.ending)]
    #[getter]
    fn ending(&self) -> &'static str {
        self.ending
    }

    #[doc = described!(Trajectory.steps)]
    #[getter]
    fn steps(&self) -> u64 {
        self.steps
    }

    #[doc = described!(Trajectory.events)]
    #[getter]
    fn events<'py>(&self, py: Python<'py>) -> Vec<(String, f64, Bound<'py, PyArray1<f64>>)> {
        let event =
            |(name, time, state): &(String, f64, Vec<f64>)| (name.clone(), *time, state.to_pyarray(py));
        self.events.iter().map(event).collect()
    }

    #[doc = described!(Trajectory.plot)]
    #[pyo3(signature = (*names, x="t"))]
    fn plot(slf: PyRef<'_, Self>, names: Vec<String>, x: &str) -> PyResult<PyPlot> {
        let columns = slf.as_super();
        let state = || columns.names[1..=columns.entries].to_vec();
        let names = if names.is_empty() { state() } else { names };
        PyPlot::new(slf.py(), columns, &slf.units, (&names, x))
    }

    fn __repr__(slf: PyRef<'_, Self>) -> String {
        let (columns, ending) = (slf.as_super(), slf.ending);
        let times = columns.column(slf.py(), 0);
        let times = times.as_array();
        let end = times.last().copied().unwrap_or_default();
        format!(
            "<Trajectory of {} samples until t = {end}, {ending}: {}>",
            times.len(),
            columns.names.join(", ")
        )
    }
}
