//! One motion of an ensemble.

use core::fmt::{Debug, Formatter};
use core::ops::{Deref, Range};
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::builder::Ensemble;
use super::error::{EnsembleError, panic_message};
use super::plan::SharedSystem;
use super::progress::Counter;
use crate::integrate::Method;
use crate::simulate::{
    ClosedLoop, Drive, Ending, RunSettings, Sampling, Simulation, SimulationError, Trajectory,
};
use crate::system::{MechanicalSystem, NamedSystem};

/// A motion of an ensemble, as those who reduce it see it.
pub struct Motion<'m, M: MechanicalSystem> {
    index: usize,
    system: &'m M,
    end: (M::Scalar, M::State),
    /// It may be computed on demand.
    trajectory: &'m dyn Deref<Target = Trajectory<M>>,
}

impl<'m, M: MechanicalSystem> Motion<'m, M> {
    pub(super) fn new(
        index: usize,
        system: &'m M,
        end: (M::Scalar, M::State),
        trajectory: &'m dyn Deref<Target = Trajectory<M>>,
    ) -> Self {
        Motion { index, system, end, trajectory }
    }

    /// Returns its place in the ensemble, counted from zero.
    pub fn index(&self) -> usize {
        self.index
    }

    /// Returns the system that moved, with the parameters of this motion.
    pub fn system(&self) -> &'m M {
        self.system
    }

    /// Returns the state where it ended, by the names of positions and velocities.
    pub fn end(&self) -> M::NamedState
    where
        M: NamedSystem,
    {
        self.end.1.into()
    }

    /// Returns the time at which it ended: the requested one unless an event stopped it.
    pub fn end_time(&self) -> M::Scalar {
        self.end.0
    }

    /// Returns all data kept of it: samples, if requested, events, and observed columns. For a
    /// motion that was computed [in lanes](super::Ensemble::is_in_lanes), the trajectory is built
    /// on request, with at least the start and the end as samples.
    pub fn trajectory(&self) -> &'m Trajectory<M> {
        self.trajectory
    }
}

impl<M: MechanicalSystem> Debug for Motion<'_, M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Motion").field("index", &self.index).field("end", &self.end).finish_non_exhaustive()
    }
}

/// The result of a motion that was a run.
pub(super) type RunResult<M> = Result<Trajectory<M>, SimulationError<M>>;

impl<M, K, D, P> Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
{
    /// Runs one motion of the ensemble again, or for the first time, as a single run, with every
    /// step kept unless samples were requested. It has the same bits, unless the ensemble runs [in
    /// lanes](Self::is_in_lanes): its end is then the same to within the tolerance.
    ///
    /// ```
    /// # lagrange::system! {
    /// #     struct Pendulum;
    /// #     param l = 1.0, g = 9.81;
    /// #     coord theta;
    /// #     kinetic = 1/2 * (l * dot(theta))^2;
    /// #     potential = -g * l * cos(theta);
    /// # }
    /// use lagrange::Ensembles;
    ///
    /// let pendulum = Pendulum::default();
    /// let ensemble = pendulum.ensemble(100).start(|i, _| [i as f64 / 100.0, 0.0]).until(2.0);
    /// let motion = ensemble.motion(41)?.expect("does not fail");
    /// assert_eq!(motion.first(), [0.41, 0.0]);
    /// assert_eq!(motion.len() as u64, motion.work().steps + 1);
    /// assert_eq!(ensemble.run()?.state(41), Some(motion.last()));
    /// # Ok::<(), lagrange::ensemble::EnsembleError>(())
    /// ```
    ///
    /// # Errors
    /// If there is no such motion, a setting makes no sense, or a closure panics.
    pub fn motion(&self, index: usize) -> Result<RunResult<M>, EnsembleError> {
        self.check()?;
        if index >= self.batch.number {
            let number = self.batch.number;
            return Err(EnsembleError::Setting(std::format!(
                "there is no motion {index} in an ensemble of {number}: the first has index 0"
            )));
        }
        self.run_then(index, Sampling::EveryStep, None, |_, result| result)
    }

    /// Checks the settings of the ensemble and of its runs.
    ///
    /// # Errors
    /// If one makes no sense.
    pub(super) fn check(&self) -> Result<(), EnsembleError> {
        self.batch.check()?;
        let plan = &self.batch.plan;
        let (settings, system) = (&plan.settings, self.batch.system);
        self.drive.close(system, |closed| {
            let mut names = settings.names(system.description());
            names.extend(closed.further_columns());
            let checked = settings.check::<D::Closed, K>(system, &names, self.method.clone());
            let checked = closed.check(settings.span, !plan.controllers.is_empty()).and(checked);
            checked.map(drop).map_err(|error| EnsembleError::Setting(RunSettings::explain(&names, error)))
        })
    }

    /// Runs a motion of which no samples are kept unless an interval gives them, counts it, and
    /// hands over the result. A motion that ends because the ensemble is cancelled has no result.
    ///
    /// # Errors
    /// If a closure that was given panics.
    pub(super) fn run_alone(
        &self,
        index: usize,
        counter: &Counter<'_, '_>,
        then: impl FnOnce(&M, RunResult<M>),
    ) -> Result<(), EnsembleError> {
        let is_complete = self.run_then(index, Sampling::Ends, Some(counter), |system, result| {
            let is_cancelled = result.as_ref().is_ok_and(|motion| motion.ending() == Ending::Cancelled);
            if !is_cancelled {
                then(system, result);
            }
            !is_cancelled
        })?;
        if is_complete {
            counter.count(1);
        }
        Ok(())
    }

    fn run_then<R>(
        &self,
        index: usize,
        sampling: Sampling<M::Scalar>,
        counter: Option<&Counter<'_, '_>>,
        then: impl FnOnce(&M, RunResult<M>) -> R,
    ) -> Result<R, EnsembleError> {
        caught(index, || {
            let (varied, state) = self.batch.origin(index);
            let system = varied.as_ref().unwrap_or(self.batch.system);
            let run = self.run_of(index, (system, state), sampling);
            let run = match counter.filter(|counter| counter.has_reporter()) {
                Some(counter) => run.cancel_when(|| counter.asks()),
                None => run,
            };
            then(system, run.run())
        })
    }

    /// Runs motions one after the other, until the ensemble is cancelled.
    pub(super) fn each_alone(
        &self,
        motions: Range<usize>,
        counter: &Counter<'_, '_>,
        mut then: impl FnMut(usize, &M, RunResult<M>),
    ) -> Result<(), EnsembleError> {
        for index in motions {
            if counter.is_cancelled() {
                break;
            }
            self.run_alone(index, counter, |system, result| then(index, system, result))?;
        }
        Ok(())
    }

    /// Returns the run of a motion, with these samples unless an interval gives others.
    pub(super) fn run_of<'s>(
        &'s self,
        index: usize,
        (system, state): (&'s M, M::State),
        sampling: Sampling<M::Scalar>,
    ) -> Simulation<'s, M, K, D> {
        let mut plan = self.batch.plan.of_motion(index);
        if plan.settings.interval().is_none() {
            plan.settings.sampling = sampling;
        }
        let method = self.method.clone().of_motion(index);
        Simulation::new(system, state, plan, (method, self.drive.for_motion(system, &state)))
    }
}

/// Runs a closure for this motion and catches panics.
///
/// # Errors
/// If it panics.
pub(super) fn caught<R>(motion: usize, compute: impl FnOnce() -> R) -> Result<R, EnsembleError> {
    // What a panic leaves behind is not looked at again: the ensemble ends with it.
    catch_unwind(AssertUnwindSafe(compute))
        .map_err(|panic| EnsembleError::Panicked { motion, message: panic_message(&*panic) })
}
