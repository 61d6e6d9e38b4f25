//! The run itself: steps, and what is kept of them.

use std::boxed::Box;
use std::collections::BTreeSet;
use std::vec::Vec;

use crate::integrate::{Cause, Method, Stepper, Work};
use crate::simulate::SimulationError;
use crate::simulate::builder::{Observer, Simulation};
use crate::simulate::dense::Dense;
use crate::simulate::progress::{Progress, Reporter};
use crate::simulate::sampling::{Grid, Sampling};
use crate::simulate::table::Table;
use crate::simulate::trajectory::{Ending, Trajectory};
use crate::system::MechanicalSystem;

/// Integrates from start to end.
pub(super) fn run<M, K>(simulation: Simulation<'_, M, K>) -> Result<Trajectory<M>, SimulationError<M>>
where
    M: MechanicalSystem,
    K: Method<M>,
{
    let Simulation { system, start, end, method, sampling, is_dense, max_steps, observers, mut reporter } =
        simulation;
    let mut record = Record {
        system,
        table: Table::new(names(&observers)),
        observers,
        row: Vec::new(),
        dense: is_dense.then(|| Dense::new(method.order())),
        samples: Samples::EveryStep,
        first: start,
        last: start,
        work: Work::default(),
    };
    record.sample(start.0, &start.1);
    let result = record.check(sampling, end).and_then(|()| {
        let stepper = method.start(system, start.0, &start.1, end)?;
        record.follow(stepper, end, max_steps.unwrap_or(u64::MAX), reporter.as_mut())
    });
    record.close();
    match result {
        Ok(ending) => Ok(record.into_trajectory(ending, method.name())),
        Err(cause) => {
            let trajectory = Box::new(record.into_trajectory(Ending::Failed, method.name()));
            Err(SimulationError { cause, trajectory })
        }
    }
}

/// The names of all columns.
fn names<M: MechanicalSystem>(observers: &[Observer<'_, M>]) -> Vec<std::string::String> {
    let mut names = Observer::<M>::state_names();
    names.extend(observers.iter().flat_map(|observer| observer.names.iter().cloned()));
    names
}

/// What is kept of a run while it goes on.
struct Record<'a, M: MechanicalSystem> {
    system: &'a M,
    table: Table<M::Scalar>,
    observers: Vec<Observer<'a, M>>,
    /// Room for the columns of one sample.
    row: Vec<M::Scalar>,
    dense: Option<Dense<M::Scalar, M::State>>,
    samples: Samples<M::Scalar>,
    first: (M::Scalar, M::State),
    last: (M::Scalar, M::State),
    work: Work,
}

/// Which samples are still to come.
enum Samples<S> {
    EveryStep,
    Grid(Grid<S>),
    None,
}

impl<M: MechanicalSystem> Record<'_, M> {
    /// Whether what is asked for makes sense.
    fn check(&mut self, sampling: Sampling<M::Scalar>, end: M::Scalar) -> Result<(), Cause<M::Scalar>> {
        let names = self.table.names();
        if names.iter().collect::<BTreeSet<_>>().len() < names.len() {
            return Err(Cause::Setting("two columns have the same name"));
        }
        self.samples = match sampling {
            Sampling::EveryStep => Samples::EveryStep,
            Sampling::Every(interval) => Samples::Grid(Grid::new(self.first.0, end, interval)?),
            Sampling::Ends => Samples::None,
        };
        Ok(())
    }

    /// Steps to the end, keeping what is asked for.
    fn follow(
        &mut self,
        mut stepper: impl Stepper<M>,
        end: M::Scalar,
        max_steps: u64,
        mut reporter: Option<&mut Reporter<'_, M::Scalar>>,
    ) -> Result<Ending, Cause<M::Scalar>> {
        while stepper.time() != end {
            if stepper.work().steps >= max_steps {
                return Err(Cause::TooManySteps { limit: max_steps });
            }
            let stepped = stepper.step(self.system, end);
            self.work = stepper.work();
            stepped?;
            self.keep(&mut stepper);
            self.work = stepper.work();
            let progress =
                Progress { start: self.first.0, time: stepper.time(), end, steps: self.work.steps };
            if reporter.as_mut().is_some_and(|reporter| !reporter.step(progress)) {
                return Ok(if stepper.time() == end { Ending::Reached } else { Ending::Cancelled });
            }
        }
        Ok(Ending::Reached)
    }

    /// Keeps what is asked for of the last step.
    fn keep(&mut self, stepper: &mut impl Stepper<M>) {
        self.last = (stepper.time(), *stepper.state());
        match &mut self.samples {
            Samples::EveryStep => self.sample(stepper.time(), stepper.state()),
            Samples::Grid(grid) => {
                let mut grid = *grid;
                while let Some(time) = grid.up_to(stepper.time()) {
                    let state = stepper.interpolate(self.system, time);
                    self.sample(time, &state);
                }
                self.samples = Samples::Grid(grid);
            }
            Samples::None => {}
        }
        if let Some(dense) = &mut self.dense {
            let step = (stepper.last_time(), stepper.time());
            dense.push(step, |t| stepper.interpolate(self.system, t));
        }
    }

    /// Adds a sample.
    fn sample(&mut self, time: M::Scalar, state: &M::State) {
        self.row.clear();
        self.row.extend_from_slice(state.as_ref());
        for observer in &mut self.observers {
            (observer.extend)(self.system, time, state, &mut self.row);
        }
        self.table.push(time, &self.row);
    }

    /// Adds the last good state if it is not a sample yet.
    fn close(&mut self) {
        let (time, state) = self.last;
        if self.last.0 != self.first.0 && self.table.times().last() != Some(&time) {
            self.sample(time, &state);
        }
    }

    fn into_trajectory(self, ending: Ending, method: &'static str) -> Trajectory<M> {
        let Record { table, dense, first, last, work, .. } = self;
        Trajectory { table, dense, work, ending, first, last, method }
    }
}
