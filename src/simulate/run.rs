//! The run itself: steps, and what happens in them.

use std::boxed::Box;
use std::collections::BTreeSet;
use std::ops::ControlFlow;

use crate::event::Reaction;
use crate::integrate::{Cause, Method, Stepper};
use crate::simulate::builder::Simulation;
use crate::simulate::dense::Dense;
use crate::simulate::error::SimulationError;
use crate::simulate::events::Watchers;
use crate::simulate::progress::{Progress, Reporter};
use crate::simulate::record::Record;
use crate::simulate::table::TIME;
use crate::simulate::trajectory::{Ending, Trajectory};
use crate::system::MechanicalSystem;

/// Integrates from start to end.
pub(super) fn run<M, K>(simulation: Simulation<'_, M, K>) -> Result<Trajectory<M>, SimulationError<M>>
where
    M: MechanicalSystem,
    K: Method<M>,
{
    let Simulation { system, start, end, method, .. } = simulation;
    let dense = simulation.is_dense.then(|| Dense::new(method.order()));
    let mut record = Record::new(system, simulation.observers, dense, start);
    let prepared = check_names(&record).and_then(|()| record.choose(simulation.sampling, end));
    let result = prepared.and_then(|()| {
        let stepper = method.start(system, start.0, &start.1, end)?;
        let watchers = Watchers::new(simulation.watchers, system, (start.0, &start.1));
        let max_steps = simulation.max_steps.unwrap_or(u64::MAX);
        let mut run = Run { system, stepper, watchers, end, max_steps, reporter: simulation.reporter };
        let result = run.follow(&mut record);
        record.work = run.stepper.work();
        result
    });
    let ending = *result.as_ref().unwrap_or(&Ending::Failed);
    let trajectory = record.close(ending, method.name());
    match result {
        Ok(_) => Ok(trajectory),
        Err(cause) => Err(SimulationError { cause, trajectory: Box::new(trajectory) }),
    }
}

fn check_names<M: MechanicalSystem>(record: &Record<'_, M>) -> Result<(), Cause<M::Scalar>> {
    let names = record.names();
    if names.iter().collect::<BTreeSet<_>>().len() < names.len() {
        return Err(Cause::Setting("two columns have the same name"));
    }
    if names.iter().any(|name| name == TIME) {
        return Err(Cause::Setting("a column has the name of the time, `t`"));
    }
    Ok(())
}

/// A run in progress.
struct Run<'a, M: MechanicalSystem, T> {
    system: &'a M,
    stepper: T,
    watchers: Watchers<'a, M>,
    end: M::Scalar,
    max_steps: u64,
    reporter: Option<Reporter<'a, M::Scalar>>,
}

impl<'a, M: MechanicalSystem, T: Stepper<M>> Run<'a, M, T> {
    /// Steps to the end, keeping what is asked for.
    fn follow(&mut self, record: &mut Record<'a, M>) -> Result<Ending, Cause<M::Scalar>> {
        while self.stepper.time() != self.end {
            let work = self.stepper.work();
            if work.steps + work.rejections >= self.max_steps {
                return Err(Cause::TooManySteps { limit: self.max_steps });
            }
            self.stepper.step(self.system, self.end)?;
            if self.react(record)?.is_break() {
                return Ok(Ending::Stopped);
            }
            let is_cancelled = !self.report(record.first.0);
            if is_cancelled && self.stepper.time() != self.end {
                return Ok(Ending::Cancelled);
            }
        }
        Ok(Ending::Reached)
    }

    /// Keeps the last step, up to the event that ends it if there is one; whether that ends the run.
    fn react(&mut self, record: &mut Record<'a, M>) -> Result<ControlFlow<()>, Cause<M::Scalar>> {
        while let Some((event, reaction)) = self.watchers.next(self.system, &mut self.stepper)? {
            let (time, state) = (event.time, event.state);
            record.event(event);
            if let Reaction::Continue = reaction {
                continue;
            }
            let reaction = self.react_at_once(record, time, reaction)?;
            record.keep(&mut self.stepper, time, &state);
            let Reaction::Replace(state) = reaction else { return Ok(ControlFlow::Break(())) };
            self.stepper.restart(self.system, time, &state)?;
            self.watchers.restart(self.system, time, &state);
            record.jump(&state);
            return Ok(ControlFlow::Continue(()));
        }
        let (time, state) = (self.stepper.time(), *self.stepper.state());
        record.keep(&mut self.stepper, time, &state);
        Ok(ControlFlow::Continue(()))
    }

    /// Lets the other events at the same time follow, each from the state that the last one left. To stop prevails.
    fn react_at_once(
        &mut self,
        record: &mut Record<'a, M>,
        time: M::Scalar,
        first: Reaction<M::State>,
    ) -> Result<Reaction<M::State>, Cause<M::Scalar>> {
        let mut answer = first;
        loop {
            let state = if let Reaction::Replace(state) = answer { Some(state) } else { None };
            let next = self.watchers.next_at_once(self.system, &mut self.stepper, time, state)?;
            let Some((event, reaction)) = next else { return Ok(answer) };
            record.event(event);
            answer = match (reaction, answer) {
                (Reaction::Continue, earlier) | (_, earlier @ Reaction::Stop) => earlier,
                (later, _) => later,
            };
        }
    }

    /// Reports progress; whether to go on.
    fn report(&mut self, start: M::Scalar) -> bool {
        let (time, steps) = (self.stepper.time(), self.stepper.work().steps);
        let progress = Progress { start, time, end: self.end, steps };
        self.reporter.as_mut().is_none_or(|reporter| reporter.step(progress))
    }
}
