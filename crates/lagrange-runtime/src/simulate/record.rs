//! The record of a run in progress.

use std::string::String;
use std::sync::Arc;
use std::vec::Vec;

use crate::integrate::{Stepper, Work};
use crate::run::Current;
use crate::scalar::Number;
use crate::simulate::control::ClosedLoop;
use crate::simulate::dense::Dense;
use crate::simulate::events::Event;
use crate::simulate::observer::{Observer, state_names};
use crate::simulate::sampling::{Grid, Sampling};
use crate::simulate::table::Table;
use crate::simulate::trajectory::{Ending, Trajectory};
use crate::system::{MechanicalSystem, StepFailure};
use crate::tolerance::SAME_INSTANT;

/// The record of a run in progress.
pub(super) struct Record<'a, M: MechanicalSystem, C> {
    /// The system as it is at present with its switches free, if it has any.
    freed: Option<C>,
    table: Table<M::Scalar>,
    observers: Vec<Observer<'a, M>>,
    /// Room for the columns of one sample.
    row: Vec<M::Scalar>,
    dense: Option<Dense<M::Scalar, M::State>>,
    samples: Samples<M::Scalar>,
    events: Vec<Event<M::Scalar, M::State>>,
    pub(super) first: (M::Scalar, M::State),
    last: (M::Scalar, M::State),
    pub(super) work: Work,
}

/// The samples that are still to come.
enum Samples<S> {
    EveryStep,
    Grid(Grid<S>),
    None,
}

impl<'a, M: MechanicalSystem, C: ClosedLoop<M>> Record<'a, M, C> {
    /// Starts with the initial state as the first sample; the system may be another one there than that which was given.
    pub(super) fn new(
        current: &Current<'_, C>,
        observers: Vec<Observer<'a, M>>,
        dense: Option<Dense<M::Scalar, M::State>>,
        start: (M::Scalar, M::State),
    ) -> Self {
        let mut record = Record {
            freed: current.switched().and_then(C::freed),
            table: Table::new(names(&observers)),
            observers,
            row: Vec::new(),
            dense,
            samples: Samples::None,
            events: Vec::new(),
            first: start,
            last: start,
            work: Work::default(),
        };
        record.sample(current.system(), start.0, &start.1);
        record
    }

    /// The last good state, with its time.
    pub(super) fn last(&self) -> (M::Scalar, M::State) {
        self.last
    }

    /// The system as it is for whoever looks at it.
    pub(super) fn seen<'s>(&'s self, system: &'s C) -> &'s C {
        self.freed.as_ref().unwrap_or(system)
    }

    /// Goes on with this system.
    pub(super) fn switch(&mut self, system: &C) {
        self.freed = system.freed();
    }

    /// The names of the columns.
    pub(super) fn names(&self) -> &[String] {
        self.table.names()
    }

    /// Chooses the samples up to this end.
    pub(super) fn choose(
        &mut self,
        sampling: Sampling<M::Scalar>,
        end: M::Scalar,
    ) -> Result<(), StepFailure<M::Scalar>> {
        self.samples = match sampling {
            Sampling::EveryStep => Samples::EveryStep,
            Sampling::Every(interval) => {
                Samples::Grid(Grid::new(self.first.0, end, interval)?.that_can_be_kept()?)
            }
            Sampling::Ends => Samples::None,
        };
        Ok(())
    }

    /// True if states before `to` that lie within the step to it will be kept.
    pub(super) fn looks_before(&self, to: M::Scalar) -> bool {
        let is_sampled = match self.samples {
            Samples::Grid(mut grid) => grid.up_to(to).is_some_and(|time| time != to),
            Samples::EveryStep | Samples::None => false,
        };
        is_sampled || self.dense.is_some()
    }

    /// Keeps what is asked for of the last step up to `to`, where this is the state.
    ///
    /// After each sample within the step `goes_on` is asked. The result is whether the run does: otherwise it ends at the last sample.
    pub(super) fn keep(
        &mut self,
        system: &C,
        stepper: &mut impl Stepper<C>,
        (to, state): (M::Scalar, &M::State),
        mut goes_on: impl FnMut(M::Scalar) -> bool,
    ) -> bool {
        let mut reached = (to, *state);
        match self.samples {
            Samples::EveryStep => self.sample(system, to, state),
            Samples::Grid(mut grid) => {
                while let Some(time) = grid.up_to(to) {
                    let state = if time == to { *state } else { stepper.interpolate(system, time) };
                    self.sample(system, time, &state);
                    if time != to && !goes_on(time) {
                        reached = (time, state);
                        break;
                    }
                }
                self.samples = Samples::Grid(grid);
            }
            Samples::None => {}
        }
        let has_gone_on = reached.0 == to;
        let to = reached.0;
        if let Some(dense) = &mut self.dense {
            dense.push((stepper.last_time(), to), |t| stepper.interpolate(system, t));
        }
        self.last = reached;
        has_gone_on
    }

    /// Goes on from another state at the time that was reached.
    pub(super) fn jump(&mut self, system: &C, state: &M::State) {
        self.last.1 = *state;
        if let Samples::EveryStep = self.samples {
            self.sample(system, self.last.0, state);
        }
    }

    /// Goes on from this time and state with other inputs: a sample that was kept there has these.
    pub(super) fn act(&mut self, system: &C, time: M::Scalar, state: &M::State) {
        let rounding = SAME_INSTANT.part::<M::Scalar>() * time.abs();
        if let Some(&last) = self.table.times().last()
            && (time - last).abs() <= rounding
        {
            self.table.pop();
            self.sample(system, last, state);
        }
    }

    pub(super) fn event(&mut self, event: Event<M::Scalar, M::State>) {
        self.events.push(event);
    }

    /// Adds a sample that was reached.
    #[cfg(feature = "ensemble")]
    pub(super) fn reach(&mut self, system: &C, (time, state): (M::Scalar, M::State)) {
        self.sample(system, time, &state);
        self.last = (time, state);
    }

    /// Adds a sample.
    fn sample(&mut self, system: &C, time: M::Scalar, state: &M::State) {
        self.row.clear();
        self.row.extend_from_slice(state.as_ref());
        let system = self.freed.as_ref().unwrap_or(system);
        let (observers, row) = (&mut self.observers, &mut self.row);
        system.ask(time, state, |plant| {
            observers.iter_mut().for_each(|observer| (observer.extend)(plant, time, state, row));
        });
        self.table.push(time, &self.row);
    }

    /// Returns the trajectory, with the last good state as its last sample.
    pub(super) fn close(
        mut self,
        current: Current<'_, C>,
        ending: Ending,
        method: &'static str,
    ) -> Trajectory<M> {
        let (time, state) = self.last;
        if time != self.first.0 && self.table.times().last() != Some(&time) {
            self.sample(current.system(), time, &state);
        }
        let Record { table, dense, events, first, last, work, freed, .. } = self;
        let system = freed.or(current.into_switched()).map(|closed| Arc::new(closed.into_plant()));
        let columns = table.into();
        Trajectory { columns, dense, events, work, ending, first, last, method, inputs: None, system }
    }
}

/// The names of all columns: coordinates, velocities, and what observers add.
fn names<M: MechanicalSystem>(observers: &[Observer<'_, M>]) -> Vec<String> {
    let mut names = state_names::<M>();
    names.extend(observers.iter().flat_map(|observer| observer.names.iter().cloned()));
    names
}
