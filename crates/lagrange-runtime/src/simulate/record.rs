//! The record of a run in progress.

use std::string::{String, ToString};
use std::sync::Arc;
use std::vec::Vec;

use crate::integrate::{Stepper, Work};
use crate::run::{Current, Found, Origin, Sink};
use crate::scalar::{Number, Scalar};
use crate::simulate::closed_loop::ClosedLoop;
use crate::simulate::dense::Dense;
use crate::simulate::events::Event;
use crate::simulate::observer::Extend;
use crate::simulate::plan::RunSettings;
use crate::simulate::progress::{Callbacks, Progress};
use crate::simulate::sampling::{Grid, Sampling};
use crate::simulate::table::Table;
use crate::simulate::trajectory::{Ending, Trajectory};
use crate::system::{DeclaredEvent, EventKind, MechanicalSystem};
use crate::tolerance::SAME_INSTANT;

/// The record of a run in progress.
pub(super) struct Record<'a, M: MechanicalSystem, C: ClosedLoop<M>> {
    /// The system as it is at present with its switches free, if it has any.
    freed: Option<C>,
    table: Table<M::Scalar>,
    columns: Vec<Extend<'a, M>>,
    /// Room for the columns of one sample.
    row: Vec<M::Scalar>,
    dense: Option<Dense<M::Scalar, M::State>>,
    samples: Samples<M::Scalar>,
    /// Events of the system.
    declared: &'static [DeclaredEvent],
    /// Names of the events that the run was given.
    given: Vec<String>,
    events: Vec<Event<M::Scalar, M::State>>,
    callbacks: Callbacks<'a, M::Scalar>,
    first: (M::Scalar, C::State),
    last: (M::Scalar, C::State),
    end: M::Scalar,
    pub(super) work: Work,
}

/// The samples that are still to come.
#[derive(Clone)]
enum Samples<S> {
    EveryStep,
    Grid(Grid<S>),
    /// Given times, the next one last, and the end of the run.
    Times(Vec<S>, S),
    None,
}

impl<S: Scalar> Samples<S> {
    /// Returns the samples of a run after its start.
    fn new(settings: &RunSettings<S>) -> Self {
        match (settings.sampling, settings.grid()) {
            (Sampling::EveryStep, _) => Samples::EveryStep,
            (Sampling::Every(_), Ok(Some(grid))) => Samples::Grid(grid),
            (Sampling::Times, _) => {
                let [start, end] = settings.span;
                let later = settings.times.iter().rev().copied().filter(|time| *time != start);
                Samples::Times(later.collect(), end)
            }
            _ => Samples::None,
        }
    }

    /// Returns the next time of a sample if it is not after `to` and before the end.
    fn ahead(&self, to: S) -> Option<S> {
        match self {
            Samples::Grid(grid) => { *grid }.up_to(to),
            Samples::Times(times, end) => {
                let is_reached = |time: &S| if *end < to { *time >= to } else { *time <= to };
                times.last().copied().filter(|time| time != end && is_reached(time))
            }
            Samples::EveryStep | Samples::None => None,
        }
    }

    /// Takes that time.
    fn take(&mut self, to: S) -> Option<S> {
        let next = self.ahead(to)?;
        match self {
            Samples::Grid(grid) => grid.up_to(to),
            Samples::Times(times, _) => times.pop(),
            Samples::EveryStep | Samples::None => Some(next),
        }
    }
}

impl<'a, M: MechanicalSystem, C: ClosedLoop<M>> Record<'a, M, C> {
    /// Starts with the initial state as the first sample, and with functions of the columns after
    /// those of the state. The system may differ there from the original one.
    pub(super) fn new(
        current: &Current<'_, C>,
        settings: &RunSettings<M::Scalar>,
        (names, columns): (Vec<String>, Vec<Extend<'a, M>>),
        callbacks: Callbacks<'a, M::Scalar>,
        start: (M::Scalar, C::State),
    ) -> Self {
        let samples = Samples::new(settings);
        let mut record = Record {
            freed: current.switched().and_then(C::freed),
            table: Table::new(names),
            columns,
            row: Vec::new(),
            dense: None,
            samples,
            declared: current.system().events(),
            given: settings.event_names(),
            events: Vec::new(),
            callbacks,
            first: start,
            last: start,
            end: settings.span[1],
            work: Work::default(),
        };
        record.sample(current.system(), start);
        record
    }

    /// Keeps all steps of a method of this order.
    pub(super) fn keep_steps(&mut self, order: u32) {
        self.dense = Some(Dense::new(order));
    }

    /// Returns the last good state, with its time.
    pub(super) fn last(&self) -> (M::Scalar, C::State) {
        self.last
    }

    /// Returns the system that observers see.
    pub(super) fn seen<'s>(&'s self, system: &'s C) -> &'s C {
        self.freed.as_ref().unwrap_or(system)
    }

    /// Adds a sample that was computed elsewhere.
    #[cfg(feature = "ensemble")]
    pub(super) fn push(&mut self, system: &C, reached: (M::Scalar, C::State)) {
        self.sample(system, reached);
        self.last = reached;
    }

    /// Reports progress and asks for cancellation; true to continue.
    pub(super) fn report(&mut self, time: M::Scalar, steps: u64) -> bool {
        let progress = Progress { start: self.first.0, time, end: self.end, steps };
        self.callbacks.turn(progress)
    }

    /// Adds a sample at this time and state.
    fn sample(&mut self, system: &C, (time, whole): (M::Scalar, C::State)) {
        let state = C::state_of_plant(&whole);
        self.row.clear();
        self.row.extend_from_slice(state.as_ref());
        let system = self.freed.as_ref().unwrap_or(system);
        let (columns, row) = (&mut self.columns, &mut self.row);
        system.ask(time, &state, |plant| {
            columns.iter_mut().for_each(|extend| extend(plant, time, &state, row));
        });
        system.extend_row(&whole, row);
        self.table.push(time, &self.row);
    }

    /// Returns the names of the given events, and the trajectory with the last good state as its
    /// last sample.
    pub(super) fn close(
        mut self,
        current: Current<'_, C>,
        ending: Ending,
        method: &'static str,
    ) -> (Vec<String>, Trajectory<M>) {
        if self.last.0 != self.first.0 && self.table.times().last() != Some(&self.last.0) {
            self.sample(current.system(), self.last);
        }
        let plant = current.system().plant();
        let description = plant.description();
        #[cfg(feature = "plot")]
        let domain = plant.domain();
        let variables = current.system().variables();
        let Record { table, dense, given, events, first, last, work, freed, .. } = self;
        let system = freed.or(current.into_switched()).map(|closed| Arc::new(closed.into_plant()));
        let of_plant = |(time, state): (M::Scalar, C::State)| (time, C::state_of_plant(&state));
        let (first, last) = (of_plant(first), of_plant(last));
        let (columns, inputs) = (table.into(), None);
        (
            given,
            Trajectory {
                columns,
                dense,
                events,
                work,
                ending,
                first,
                last,
                method,
                inputs,
                variables,
                system,
                description,
                #[cfg(feature = "plot")]
                domain,
            },
        )
    }
}

impl<M: MechanicalSystem, C: ClosedLoop<M>> Sink<C> for Record<'_, M, C> {
    fn looks_before(&self, to: M::Scalar) -> bool {
        self.samples.ahead(to).is_some_and(|time| time != to) || self.dense.is_some() || C::HAS_HISTORY
    }

    fn happen(&mut self, origin: Origin, event: &Found<C>, kind: EventKind<M::Scalar>) {
        let name = match origin {
            Origin::Declared => self.declared[event.event].name.to_string(),
            Origin::Given(index) => self.given[index].clone(),
        };
        let state = C::state_of_plant(&event.state);
        self.events.push(Event { name, time: event.time, state, kind });
    }

    fn reach_end(&mut self, system: &C, stepper: &mut impl Stepper<C>, time: M::Scalar) -> bool {
        let state = *stepper.state();
        self.reach(system, stepper, (time, &state))
    }

    /// Keeps what is wanted of the last step, and reports after each sample within it. If the run
    /// is cancelled there, it ends at that sample.
    fn reach(&mut self, system: &C, stepper: &mut impl Stepper<C>, reached: (M::Scalar, &C::State)) -> bool {
        let (to, state) = reached;
        let steps = stepper.work().steps;
        let mut reached = (to, *state);
        if let Samples::EveryStep = self.samples {
            self.sample(system, reached);
        }
        while let Some(time) = self.samples.take(to) {
            let state = if time == to { *state } else { stepper.interpolate(system, time) };
            self.sample(system, (time, state));
            if time != to && !self.report(time, steps) {
                reached = (time, state);
                break;
            }
        }
        if let Some(dense) = &mut self.dense {
            let from = stepper.last_time();
            dense.push((from, reached.0), &mut |t| C::state_of_plant(&stepper.interpolate(system, t)));
        }
        system.keep(stepper, reached.0);
        self.last = reached;
        reached.0 == to
    }

    fn switch(&mut self, system: &C) {
        self.freed = system.freed();
    }

    fn replace(&mut self, system: &C, (time, state): (M::Scalar, &C::State), is_silent: bool) {
        system.jump(time);
        if is_silent {
            return;
        }
        self.last.1 = *state;
        if let Samples::EveryStep = self.samples {
            self.sample(system, self.last);
        }
    }

    /// Replaces a sample that was kept at this time: it has the new inputs.
    fn exchange(&mut self, system: &C, (time, state): (M::Scalar, &C::State)) {
        system.jump(time);
        let rounding = SAME_INSTANT.part::<M::Scalar>() * time.abs();
        if let Some(&last) = self.table.times().last()
            && (time - last).abs() <= rounding
        {
            self.table.pop();
            self.sample(system, (last, *state));
        }
    }
}
