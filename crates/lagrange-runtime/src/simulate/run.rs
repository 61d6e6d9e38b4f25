//! The run itself: its steps and their events.

#[cfg(feature = "ensemble")]
use crate::integrate::Work;
use crate::integrate::{Method, Stepper, explained};
use crate::run::room::with_room;
use crate::run::{AllEvents, Current, DeclaredEvents, Events, Run, Turn};
use crate::scalar::Number;
use crate::simulate::builder::{KnowsItsEnd, Simulation};
use crate::simulate::closed_loop::ClosedLoop;
use crate::simulate::control::Drive;
use crate::simulate::controllers::Controllers;
use crate::simulate::error::SimulationError;
use crate::simulate::events::Watchers;
use crate::simulate::plan::Plan;
#[cfg(feature = "ensemble")]
use crate::simulate::progress::Callbacks;
use crate::simulate::record::Record;
use crate::simulate::trajectory::{Ending, Trajectory};
use crate::system::{MechanicalSystem, OdeSystem, StepFailure};

impl<M: MechanicalSystem, K, D, E> Simulation<'_, M, K, D, E> {
    /// Integrates the motion.
    ///
    /// # Errors
    /// If the method fails or a setting is invalid, with the trajectory so far.
    pub fn run(self) -> Result<Trajectory<M>, SimulationError<M>>
    where
        D: Drive<M>,
        K: Method<D::Closed>,
        E: KnowsItsEnd,
    {
        let (system, drive) = (self.system, self.drive.clone());
        drive.close(system, |closed| run(closed, self))
    }

    /// Returns the trajectory of this run from samples of its loop computed in lanes. They follow
    /// the start, and the last one is the end.
    #[cfg(feature = "ensemble")]
    pub(crate) fn assemble(
        self,
        samples: impl IntoIterator<Item = (M::Scalar, <D::Closed as OdeSystem>::State)>,
        work: Work,
    ) -> Trajectory<M>
    where
        D: Drive<M>,
        K: Method<D::Closed>,
    {
        let Simulation { system, state, plan: Plan { settings, columns, .. }, method, drive, .. } = self;
        drive.close(system, |closed| {
            let current = Current::new(closed);
            let start = (settings.span[0], closed.extended(settings.span[0], &state));
            let mut names = settings.names(system.description());
            names.extend(closed.further_columns());
            let mut record = Record::new(&current, &settings, (names, columns), Callbacks::none(), start);
            samples.into_iter().for_each(|sample| record.push(closed, sample));
            record.work = work;
            record.close(current, Ending::Reached, method.name()).1
        })
    }
}

/// Integrates from start to end.
fn run<M, K, D, E>(
    system: &D::Closed,
    simulation: Simulation<'_, M, K, D, E>,
) -> Result<Trajectory<M>, SimulationError<M>>
where
    M: MechanicalSystem,
    D: Drive<M>,
    K: Method<D::Closed>,
{
    let Simulation { state, plan, callbacks, method, .. } = simulation;
    let Plan { settings, columns, watches, controllers, inputs } = plan;
    let (order, name, [t, end]) = (method.order(), method.name(), settings.span);
    let start = admitted(system, (t, system.extended(t, &state)));
    let restarts = settings.restarts_in_order();
    system.start_history((t, &start.1), order, &restarts);
    let mut current = Current::new(system);
    let description = system.plant().description();
    let mut names = settings.names(description);
    names.extend(system.further_columns());
    let checked = settings.check::<D::Closed, K>(system, &names, method);
    let checked =
        system.check(settings.span, !controllers.is_empty()).and(checked).map_err(StepFailure::Setting);
    let begun = checked.and_then(|method| {
        let ends_early = !watches.is_empty() || system.plant().events().iter().any(|event| !event.is_switch);
        system.check_parameters(settings.span, ends_early || settings.max_steps.is_some())?;
        let mut controllers = Controllers::new(settings.span, &settings.periods, controllers)?;
        current.begin::<K::Stepper>((t, &start.1), end, |system| {
            let state = D::Closed::state_of_plant(&start.1);
            let acted = system.ask(t, &state, |plant| controllers.begin(plant, (t, &state)))?;
            Ok(acted.map(|plant| system.with_plant(plant)))
        })?;
        Ok((method, controllers))
    });
    let mut record = Record::new(&current, &settings, (names, columns), callbacks, start);
    let result = begun.and_then(|(method, mut controllers)| {
        if settings.is_dense {
            record.keep_steps(order);
        }
        let max_steps = settings.max_steps.unwrap_or(u64::MAX);
        let mut stepper = method.start(current.system(), t, &start.1, end)?;
        stepper.limit_steps(max_steps);
        let given = Watchers::new(&settings.events, watches, current.system(), (t, &start.1));
        with_room!(system, D::Closed, ROOM => {
            let declared = DeclaredEvents::<_, ROOM>::new::<K::Stepper>(current.system(), t, &start.1);
            let run = Run::new(&mut current, stepper, AllEvents { declared, given }, (t, end), &restarts);
            follow(run, &mut record, &mut controllers, max_steps)
        })
    });
    let ending = *result.as_ref().unwrap_or(&Ending::Failed);
    let (time, state) = record.last();
    let result = result.map_err(|cause| named(cause, current.system(), (time, &state), end));
    let (given, trajectory) = record.close(current, ending, name);
    let trajectory = Trajectory { inputs, ..trajectory };
    match result {
        Ok(_) => Ok(trajectory),
        Err(cause) => Err(SimulationError::new(cause, &given, trajectory)),
    }
}

/// Returns the cause with names, for a run that stopped at this time and state.
fn named<M: MechanicalSystem, C: ClosedLoop<M>>(
    cause: StepFailure<M::Scalar>,
    system: &C,
    stopped: (M::Scalar, &C::State),
    end: M::Scalar,
) -> StepFailure<M::Scalar> {
    match explained(cause, system, stopped, end) {
        StepFailure::Undefined(what) => {
            StepFailure::Undefined(what.with_names_of(system.plant().description()))
        }
        cause => cause,
    }
}

/// Returns the start, moved onto the constraints if it nearly satisfies them. Errors in it are
/// reported by methods.
fn admitted<M: OdeSystem>(system: &M, (t, y): (M::Scalar, M::State)) -> (M::Scalar, M::State) {
    let mut admitted = y;
    match system.admit(t, &mut admitted) {
        Ok(()) => (t, admitted),
        Err(_) => (t, y),
    }
}

/// Follows a run to its end. Controllers act between its turns, when their instants are reached.
fn follow<M, C, T, E>(
    mut run: Run<'_, '_, C, T, E>,
    record: &mut Record<'_, M, C>,
    controllers: &mut Controllers<'_, M>,
    max_steps: u64,
) -> Result<Ending, StepFailure<M::Scalar>>
where
    M: MechanicalSystem,
    C: ClosedLoop<M>,
    T: Stepper<C>,
    E: Events<C>,
{
    let mut turns = || {
        while !run.is_over() {
            let work = run.work();
            if work.steps + work.rejections >= max_steps {
                return Err(StepFailure::TooManySteps { limit: max_steps });
            }
            let (t, state) = (run.time(), C::state_of_plant(run.state()));
            let acted = record
                .seen(run.system())
                .ask(t, &state, |plant| controllers.act(plant, run.beyond(), (t, &state)))?;
            if let Some(plant) = acted {
                run.exchange(record, run.system().with_plant(plant))?;
            }
            let instant = match (controllers.next(), run.system().limit()) {
                (Some(next), Some(limit)) => Some(next.min(limit)),
                (next, limit) => next.or(limit),
            };
            match run.next(record, instant).map_err(|error| error.cause)? {
                Turn::Stopped(..) => return Ok(Ending::Stopped),
                Turn::Cancelled => return Ok(Ending::Cancelled),
                Turn::GoesOn => {}
            }
            if !record.report(run.step_end(), run.work().steps) && !run.is_over() {
                return Ok(Ending::Cancelled);
            }
        }
        Ok(Ending::Reached)
    };
    let ending = turns();
    record.work = run.work();
    ending
}
