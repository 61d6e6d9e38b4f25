//! Runs with settings specified at run time.

use std::cell::Cell;

use lagrange_runtime::integrate::Verner98;
use lagrange_runtime::simulate::{Simulate, Simulation, SimulationError, Trajectory};
use lagrange_runtime::system::OdeSystem;

use crate::method::MethodChoice;
use crate::system::DynamicSystem;
use crate::watch::Watch;

/// The settings of a run.
#[derive(Clone, PartialEq, Debug)]
pub struct RunSettings {
    /// Initial state: positions, then velocities.
    pub start: Vec<f64>,
    /// Initial time.
    pub from: f64,
    /// Final time.
    pub until: f64,
    /// Interval of the samples; one sample per step if it is `None`.
    pub every: Option<f64>,
    /// Method, with which [`MethodChoice::run`] runs the simulation.
    pub method: MethodChoice,
    /// True if the energy is a column. The system must provide it.
    pub has_energy: bool,
}

impl RunSettings {
    /// Runs a system. Its delayed signals are those of its past.
    ///
    /// # Errors
    /// If the run fails, as in [`Simulation::run`].
    pub fn run<const CAPACITY: usize>(
        &self,
        system: &DynamicSystem<CAPACITY>,
    ) -> Result<Trajectory<DynamicSystem<CAPACITY>>, SimulationError<DynamicSystem<CAPACITY>>> {
        self.run_watched(system, &|_| false)
    }

    /// Runs a system as [`run`](Self::run) does, until it ends or is cancelled.
    ///
    /// # Errors
    /// If the run fails, as in [`Simulation::run`].
    pub fn run_watched<const CAPACITY: usize>(
        &self,
        system: &DynamicSystem<CAPACITY>,
        watch: Watch<'_>,
    ) -> Result<Trajectory<DynamicSystem<CAPACITY>>, SimulationError<DynamicSystem<CAPACITY>>> {
        let done = Cell::new(0.0);
        let simulation = self.simulation(system).progress(|progress| done.set(progress.fraction()));
        let simulation = simulation.cancel_when(|| watch(done.get()));
        let has_series = self.method.product().is_some();
        match system.has_delays() && !has_series {
            true => self.method.run(simulation.with_history()),
            false => self.method.run_freely(simulation, system),
        }
    }

    /// Returns the simulation of a system with these settings except the method. Declared outputs
    /// are columns.
    pub fn simulation<'a, const CAPACITY: usize>(
        &self,
        system: &'a DynamicSystem<CAPACITY>,
    ) -> Simulation<'a, DynamicSystem<CAPACITY>, Verner98<f64>> {
        let mut simulation = system.simulate(system.state(&self.start)).from(self.from).until(self.until);
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
