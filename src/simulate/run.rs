//! The run itself: steps, and what happens in them.

use std::cmp::Ordering;
use std::ops::ControlFlow;
use std::string::String;
use std::vec::Vec;

use crate::event::{Course, is_forwards};
use crate::integrate::{Method, Restarts, Stepper, explained};
use crate::scalar::Scalar;
use crate::simulate::builder::Simulation;
use crate::simulate::control::{ClosedLoop, Controllers, Drive};
use crate::simulate::dense::Dense;
use crate::simulate::error::{SimulationError, repeated};
use crate::simulate::events::{Happened, Watchers};
use crate::simulate::progress::{Progress, Reporter};
use crate::simulate::record::Record;
use crate::simulate::table::TIME;
use crate::simulate::trajectory::{Ending, Trajectory};
use crate::system::{MechanicalSystem, OdeSystem, StepFailure};

/// Integrates from start to end.
pub(super) fn run<M, K, D>(simulation: Simulation<'_, M, K, D>) -> Result<Trajectory<M>, SimulationError<M>>
where
    M: MechanicalSystem,
    D: Drive<M>,
    K: Method<D::Closed>,
{
    let (system, drive) = (simulation.system, simulation.drive.clone());
    drive.close(system, |closed| run_closed(closed, simulation))
}

fn run_closed<M, K, D>(
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
    let begun = begin(system, &mut controllers, start, end);
    let (begun, fault) = begun.map_or_else(|cause| (None, Some(cause)), |begun| (begun, None));
    let mut record = Record::new((system, begun), simulation.observers, dense, start);
    let prepared = check_names(&record).and_then(|()| record.choose(simulation.sampling, end));
    let prepared = simulation.fault.or(fault).map_or(prepared, Err);
    let times = in_order(simulation.restarts, start.0, end);
    let given: Vec<String> = simulation.watchers.iter().map(|watcher| watcher.name.clone()).collect();
    let result = prepared.and(times).and_then(|times| {
        let method = method?;
        let max_steps = simulation.max_steps.unwrap_or(u64::MAX);
        let mut stepper = method.start(record.system(), start.0, &start.1, end)?;
        stepper.limit_steps(max_steps);
        let watchers = Watchers::new(simulation.watchers, record.system(), (start.0, &start.1), end);
        let restarts = Restarts::new(start.0, end, &times);
        let reporter = simulation.reporter;
        let mut run = Run { stepper, restarts, controllers, watchers, end, max_steps, reporter };
        let result = run.follow(&mut record);
        record.work = run.stepper.work();
        result
    });
    let ending = *result.as_ref().unwrap_or(&Ending::Failed);
    let (time, state) = record.last();
    let result = result.map_err(|cause| named(cause, &record, (time, &state), end));
    let trajectory = Trajectory { inputs: simulation.inputs, ..record.close(ending, name) };
    match result {
        Ok(_) => Ok(trajectory),
        Err(cause) => Err(SimulationError::new(cause, &given, trajectory)),
    }
}

/// The cause by name, of a run that stopped at this time and state.
fn named<M: MechanicalSystem>(
    cause: StepFailure<M::Scalar>,
    record: &Record<'_, '_, M, impl ClosedLoop<M>>,
    stopped: (M::Scalar, &M::State),
    end: M::Scalar,
) -> StepFailure<M::Scalar> {
    match explained(cause, record.system(), stopped, end) {
        StepFailure::Undefined(what) => StepFailure::Undefined(what.with_names(M::COORDINATES)),
        cause => cause,
    }
}

/// The system as the motion starts, if it is another one than that which was given: with the inputs that controllers set at the
/// start, and in the modes that fit.
fn begin<M: MechanicalSystem, C: ClosedLoop<M>>(
    system: &C,
    controllers: &mut Controllers<'_, M>,
    (t, y): (M::Scalar, M::State),
    end: M::Scalar,
) -> Result<Option<C>, StepFailure<M::Scalar>> {
    is_forwards::<C>(t, end)?;
    let acted = controllers.begin(system.plant(), (t, &y))?.map(|plant| system.with_plant(plant));
    let begun = acted.as_ref().unwrap_or(system).begin(t, &y)?;
    Ok(begun.or(acted))
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
    record: &Record<'_, '_, M, impl ClosedLoop<M>>,
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

/// A run in progress. The record knows the system as it is at present.
struct Run<'a, 'r, M: MechanicalSystem, C: MechanicalSystem, T> {
    stepper: T,
    restarts: Restarts<'r, M::Scalar>,
    controllers: Controllers<'a, M>,
    watchers: Watchers<'a, M, C>,
    end: M::Scalar,
    max_steps: u64,
    reporter: Option<Reporter<'a, M::Scalar>>,
}

impl<'a, M: MechanicalSystem, C: ClosedLoop<M>, T: Stepper<C>> Run<'a, '_, M, C, T> {
    /// Steps to the end, keeping what is asked for.
    fn follow(&mut self, record: &mut Record<'a, '_, M, C>) -> Result<Ending, StepFailure<M::Scalar>> {
        while self.stepper.time() != self.end {
            let work = self.stepper.work();
            if work.steps + work.rejections >= self.max_steps {
                return Err(StepFailure::TooManySteps { limit: self.max_steps });
            }
            self.control(record)?;
            let resumed = self.restarts.resume(record.system(), &mut self.stepper)?;
            record.switch(resumed);
            let has_watchers = !self.watchers.is_empty();
            let is_of_interest = |_, to| has_watchers || record.looks_before(to);
            let instant = self.controllers.next();
            self.restarts.step(record.system(), &mut self.stepper, instant, is_of_interest)?;
            if let ControlFlow::Break(ending) = self.react(record)? {
                return Ok(ending);
            }
            let is_cancelled = !self.report(record.first.0);
            if is_cancelled && self.stepper.time() != self.end {
                return Ok(Ending::Cancelled);
            }
        }
        Ok(Ending::Reached)
    }

    /// Lets controllers act whose instants have been reached.
    fn control(&mut self, record: &mut Record<'a, '_, M, C>) -> Result<(), StepFailure<M::Scalar>> {
        let (time, state) = (self.restarts.time(&self.stepper), *self.stepper.state());
        let beyond = self.restarts.beyond(&self.stepper);
        let acted = self.controllers.act(record.seen().plant(), beyond, (time, &state))?;
        let Some(system) = acted.map(|plant| record.system().with_plant(plant)) else { return Ok(()) };
        // Several surfaces may have been passed by the jump.
        let on_sides = system.on_sides(time, &state);
        record.switch(on_sides.or(Some(system)));
        record.act(time, &state);
        self.watchers.jump(record.system(), time, &state);
        match self.restarts.is_due(&self.stepper) {
            true => Ok(()),
            false => self.stepper.restart(record.system(), time, &state),
        }
    }

    /// Keeps the last step, up to the event that ends it if there is one; how the run ends, if it does thereby.
    fn react(
        &mut self,
        record: &mut Record<'a, '_, M, C>,
    ) -> Result<ControlFlow<Ending>, StepFailure<M::Scalar>> {
        loop {
            let next = self.watchers.next(record.system(), &mut self.stepper);
            let Some(first) = next? else { break };
            let (time, state, is_silent) = (first.time, first.state, first.event.is_none());
            let course = self.happen(record, first);
            if course.as_ref().is_ok_and(Course::goes_on) {
                continue;
            }
            if !self.keep(record, time, &state) {
                return Ok(ControlFlow::Break(Ending::Cancelled));
            }
            let Some(resumed) = course?.resume(record.system(), time) else {
                return Ok(ControlFlow::Break(Ending::Stopped));
            };
            let (state, switched) = resumed?;
            record.switch(switched);
            let restarted = self.stepper.restart(record.system(), time, &state);
            restarted.map_err(|cause| named(cause, record, (time, &state), self.end))?;
            self.watchers.restart(record.system(), time, &state);
            if !is_silent {
                record.jump(&state);
            }
            return Ok(ControlFlow::Continue(()));
        }
        let (time, state) = (self.restarts.time(&self.stepper), *self.stepper.state());
        match self.keep(record, time, &state) {
            true => Ok(ControlFlow::Continue(())),
            false => Ok(ControlFlow::Break(Ending::Cancelled)),
        }
    }

    /// Keeps what is asked for of the last step, and reports while that goes on; whether the run does.
    fn keep(&mut self, record: &mut Record<'a, '_, M, C>, time: M::Scalar, state: &M::State) -> bool {
        let (start, end, steps) = (record.first.0, self.end, self.stepper.work().steps);
        let reporter = &mut self.reporter;
        record.keep(&mut self.stepper, (time, state), |time| {
            let progress = Progress { start, time, end, steps };
            reporter.as_mut().is_none_or(|reporter| reporter.step(progress))
        })
    }

    /// What comes of an event and of the others at the same time, which follow each other, each from the state that the last one
    /// left.
    fn happen(
        &mut self,
        record: &mut Record<'a, '_, M, C>,
        first: Happened<C>,
    ) -> Result<Course<C>, StepFailure<M::Scalar>> {
        let time = first.time;
        let mut course = Course::new();
        let mut next = Some(first);
        while let Some(Happened { event, state, answer, .. }) = next {
            if let Some(event) = event {
                record.event(event);
            }
            course.add(answer?, state);
            if course.goes_on() {
                break;
            }
            next = self.watchers.next_at_once(record.system(), &course, &mut self.stepper, time)?;
        }
        Ok(course)
    }

    /// Reports progress; whether to go on.
    fn report(&mut self, start: M::Scalar) -> bool {
        let (time, steps) = (self.stepper.time(), self.stepper.work().steps);
        let progress = Progress { start, time, end: self.end, steps };
        self.reporter.as_mut().is_none_or(|reporter| reporter.step(progress))
    }
}
