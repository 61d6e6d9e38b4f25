//! The run itself: steps, and what happens in them.

use std::cmp::Ordering;
use std::string::{String, ToString};
use std::vec::Vec;

#[cfg(feature = "ensemble")]
use crate::integrate::Work;
use crate::integrate::{Method, Stepper, explained};
use crate::run::{AllEvents, Current, DeclaredEvents, Events, Found, Origin, Run, Sink, Turn};
use crate::scalar::Scalar;
use crate::simulate::builder::Simulation;
use crate::simulate::control::{ClosedLoop, Controllers, Drive};
use crate::simulate::dense::Dense;
use crate::simulate::error::{SimulationError, repeated};
use crate::simulate::events::{Event, Watchers};
use crate::simulate::progress::{Progress, Reporter};
use crate::simulate::record::Record;
use crate::simulate::table::TIME;
use crate::simulate::trajectory::{Ending, Trajectory};
use crate::system::{EventKind, MechanicalSystem, OdeSystem, StepFailure};

impl<M: MechanicalSystem, K, D: Drive<M>> Simulation<'_, M, K, D> {
    /// Integrates.
    ///
    /// # Errors
    /// What the method met, or a setting that makes no sense, with the trajectory so far.
    pub fn run(self) -> Result<Trajectory<M>, SimulationError<M>>
    where
        K: Method<D::Closed>,
    {
        let (system, drive) = (self.system, self.drive.clone());
        drive.close(system, |closed| run(closed, self))
    }
}

/// A trajectory assembled from samples that were computed elsewhere, in lanes.
#[cfg(feature = "ensemble")]
impl<M: MechanicalSystem, K, D: Drive<M>> Simulation<'_, M, K, D> {
    /// The trajectory of this run, given the samples after its start, the last of which is its end.
    pub(crate) fn told(
        self,
        samples: impl IntoIterator<Item = (M::Scalar, M::State)>,
        work: Work,
    ) -> Trajectory<M>
    where
        K: Method<D::Closed>,
    {
        let Simulation { system, start, observers, method, drive, .. } = self;
        drive.close(system, |closed| {
            let current = Current::new(closed);
            let mut record = Record::new(&current, observers, None, start);
            samples.into_iter().for_each(|sample| record.reach(closed, sample));
            record.work = work;
            record.close(current, Ending::Reached, method.name())
        })
    }
}

/// Integrates from start to end.
fn run<M, K, D>(
    system: &D::Closed,
    simulation: Simulation<'_, M, K, D>,
) -> Result<Trajectory<M>, SimulationError<M>>
where
    M: MechanicalSystem,
    D: Drive<M>,
    K: Method<D::Closed>,
{
    let Simulation { end, method, .. } = simulation;
    let (order, name) = (method.order(), method.name());
    let method = match simulation.longest_step {
        Some(longest) => method.with_longest_step(longest),
        None => Ok(method),
    };
    let start = admitted(system, simulation.start);
    let dense = simulation.is_dense.then(|| Dense::new(order));
    let mut controllers = Controllers::new(simulation.controllers, end);
    let mut current = Current::new(system);
    let begun = current.begin((start.0, &start.1), end, |system| {
        let acted = controllers.begin(system.plant(), (start.0, &start.1))?;
        Ok(acted.map(|plant| system.with_plant(plant)))
    });
    let mut record = Record::new(&current, simulation.observers, dense, start);
    let prepared = check_names(&record).and_then(|()| record.choose(simulation.sampling, end));
    let prepared = simulation.fault.or(begun.err()).map_or(prepared, Err);
    let times = in_order(simulation.restarts, start.0, end);
    let given: Vec<String> = simulation.watchers.iter().map(|watcher| watcher.name.clone()).collect();
    let result = prepared.and(times).and_then(|times| {
        let method = method?;
        let max_steps = simulation.max_steps.unwrap_or(u64::MAX);
        let mut stepper = method.start(current.system(), start.0, &start.1, end)?;
        stepper.limit_steps(max_steps);
        let events = AllEvents {
            declared: DeclaredEvents::new(current.system(), start.0, &start.1),
            given: Watchers::new(simulation.watchers, current.system(), (start.0, &start.1)),
        };
        let run = Run::new(&mut current, stepper, events, (start.0, end), &times);
        let recorder = Recorder { record: &mut record, given: &given, reporter: simulation.reporter, end };
        recorder.follow(run, &mut controllers, max_steps)
    });
    let ending = *result.as_ref().unwrap_or(&Ending::Failed);
    let (time, state) = record.last();
    let result = result.map_err(|cause| named::<M, _>(cause, current.system(), (time, &state), end));
    let trajectory = Trajectory { inputs: simulation.inputs, ..record.close(current, ending, name) };
    match result {
        Ok(_) => Ok(trajectory),
        Err(cause) => Err(SimulationError::new(cause, &given, trajectory)),
    }
}

/// The cause by name, of a run that stopped at this time and state.
fn named<M: MechanicalSystem, C: ClosedLoop<M>>(
    cause: StepFailure<M::Scalar>,
    system: &C,
    stopped: (M::Scalar, &M::State),
    end: M::Scalar,
) -> StepFailure<M::Scalar> {
    match explained(cause, system, stopped, end) {
        StepFailure::Undefined(what) => StepFailure::Undefined(what.with_names_of::<M>()),
        cause => cause,
    }
}

/// The start as methods take it: on the constraints if it nearly satisfies them. What is wrong with it methods say.
fn admitted<M: OdeSystem>(system: &M, (t, y): (M::Scalar, M::State)) -> (M::Scalar, M::State) {
    let mut admitted = y;
    match system.admit(t, &mut admitted) {
        Ok(()) => (t, admitted),
        Err(_) => (t, y),
    }
}

/// Times of restart in the order in which a run from `start` to `end` meets them.
fn in_order<S: Scalar>(mut times: Vec<S>, start: S, end: S) -> Result<Vec<S>, StepFailure<S>> {
    if !times.iter().all(|time| time.is_finite()) {
        return Err(StepFailure::Setting("times of restart must be finite"));
    }
    times.sort_by(|one, other| one.partial_cmp(other).unwrap_or(Ordering::Equal));
    if end < start {
        times.reverse();
    }
    Ok(times)
}

fn check_names<M: MechanicalSystem>(
    record: &Record<'_, M, impl ClosedLoop<M>>,
) -> Result<(), StepFailure<M::Scalar>> {
    let names = record.names();
    if repeated(names).is_some() {
        return Err(StepFailure::RepeatedColumn);
    }
    if names.iter().any(String::is_empty) {
        return Err(StepFailure::Setting("a column has an empty name"));
    }
    if names.iter().any(|name| name == TIME) {
        return Err(StepFailure::Setting("a column has the name of the time, `t`"));
    }
    Ok(())
}

/// The recorder of a run, notified every turn.
struct Recorder<'a, 'r, M: MechanicalSystem, C> {
    record: &'r mut Record<'a, M, C>,
    /// The names of the events that the run was given.
    given: &'r [String],
    reporter: Option<Reporter<'a, M::Scalar>>,
    end: M::Scalar,
}

impl<M: MechanicalSystem, C: ClosedLoop<M>> Recorder<'_, '_, M, C> {
    /// Follows a run to its end.
    fn follow<T: Stepper<C>, E: Events<C>>(
        mut self,
        mut run: Run<'_, '_, C, T, E>,
        controllers: &mut Controllers<'_, M>,
        max_steps: u64,
    ) -> Result<Ending, StepFailure<M::Scalar>> {
        let mut ending = Ok(None);
        while let Ok(None) = ending
            && !run.is_over()
        {
            ending = self.turn(&mut run, controllers, max_steps);
        }
        self.record.work = run.work();
        Ok(ending?.unwrap_or(Ending::Reached))
    }

    /// One turn: controllers act, and the run goes on; how it ends, if it does before its end.
    fn turn<T: Stepper<C>, E: Events<C>>(
        &mut self,
        run: &mut Run<'_, '_, C, T, E>,
        controllers: &mut Controllers<'_, M>,
        max_steps: u64,
    ) -> Result<Option<Ending>, StepFailure<M::Scalar>> {
        let work = run.work();
        if work.steps + work.rejections >= max_steps {
            return Err(StepFailure::TooManySteps { limit: max_steps });
        }
        self.control(run, controllers)?;
        match run.next(self, controllers.next()).map_err(|error| error.cause)? {
            Turn::Stopped(..) => return Ok(Some(Ending::Stopped)),
            Turn::Cancelled => return Ok(Some(Ending::Cancelled)),
            Turn::GoesOn => {}
        }
        let is_cancelled = !self.report(run.step_end(), run.work().steps);
        Ok((is_cancelled && !run.is_over()).then_some(Ending::Cancelled))
    }

    /// Lets controllers act whose instants have been reached.
    fn control<T: Stepper<C>, E: Events<C>>(
        &mut self,
        run: &mut Run<'_, '_, C, T, E>,
        controllers: &mut Controllers<'_, M>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let plant = self.record.seen(run.system()).plant();
        let acted = controllers.act(plant, run.beyond(), (run.time(), run.state()))?;
        let Some(system) = acted.map(|plant| run.system().with_plant(plant)) else { return Ok(()) };
        run.exchange(self, system)
    }

    /// Reports progress; whether to go on.
    fn report(&mut self, time: M::Scalar, steps: u64) -> bool {
        let progress = Progress { start: self.record.first.0, time, end: self.end, steps };
        self.reporter.as_mut().is_none_or(|reporter| reporter.step(progress))
    }
}

impl<M: MechanicalSystem, C: ClosedLoop<M>> Sink<C> for Recorder<'_, '_, M, C> {
    fn looks_before(&self, to: M::Scalar) -> bool {
        self.record.looks_before(to)
    }

    fn happen(&mut self, origin: Origin, event: &Found<C>, kind: EventKind<M::Scalar>) {
        let name = match origin {
            Origin::Declared => C::EVENTS[event.event].name.to_string(),
            Origin::Given(index) => self.given[index].clone(),
        };
        self.record.event(Event { name, time: event.time, state: event.state, kind });
    }

    fn reach_end(&mut self, system: &C, stepper: &mut impl Stepper<C>, time: M::Scalar) -> bool {
        let state = *stepper.state();
        self.reach(system, stepper, (time, &state))
    }

    /// Keeps what is asked for of the last step, and reports while that goes on; whether the run does.
    fn reach(&mut self, system: &C, stepper: &mut impl Stepper<C>, reached: (M::Scalar, &M::State)) -> bool {
        let (start, end, steps) = (self.record.first.0, self.end, stepper.work().steps);
        let reporter = &mut self.reporter;
        self.record.keep(system, stepper, reached, |time| {
            let progress = Progress { start, time, end, steps };
            reporter.as_mut().is_none_or(|reporter| reporter.step(progress))
        })
    }

    fn switch(&mut self, system: &C) {
        self.record.switch(system);
    }

    fn replace(&mut self, system: &C, (_, state): (M::Scalar, &M::State), is_silent: bool) {
        if !is_silent {
            self.record.jump(system, state);
        }
    }

    fn exchange(&mut self, system: &C, (time, state): (M::Scalar, &M::State)) {
        self.record.act(system, time, state);
    }
}
