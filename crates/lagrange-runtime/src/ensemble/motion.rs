//! One motion of an ensemble.

use core::cell::OnceCell;
use core::fmt::{Debug, Formatter};
use core::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::asked::{SharedSystem, Unasked};
use super::builder::Ensemble;
use super::error::{EnsembleError, panic_message};
use super::progress::Counter;
use crate::integrate::Method;
use crate::simulate::{Drive, SimulationError, Trajectory};
use crate::system::{MechanicalSystem, NamedSystem, StepFailure};

/// A motion of an ensemble, as those who reduce it see it.
pub struct Motion<'m, M: MechanicalSystem> {
    index: usize,
    system: &'m M,
    end: (M::Scalar, M::State),
    kept: Memory<'m, M>,
}

/// The recorded data of a motion.
#[derive(Clone, Copy)]
pub(super) enum Memory<'m, M: MechanicalSystem> {
    Trajectory(&'m Trajectory<M>),
    /// A place for a trajectory, which is made when it is asked for.
    Unmade(&'m OnceCell<Trajectory<M>>, &'m dyn Fn() -> Trajectory<M>),
}

impl<'m, M: MechanicalSystem> Motion<'m, M> {
    pub(super) fn new(index: usize, system: &'m M, end: (M::Scalar, M::State), kept: Memory<'m, M>) -> Self {
        Motion { index, system, end, kept }
    }

    /// Its place in the ensemble, counted from zero.
    pub fn index(&self) -> usize {
        self.index
    }

    /// The system that moved, with the parameters of this motion.
    pub fn system(&self) -> &'m M {
        self.system
    }

    /// The state where it ended, by the names of positions and velocities.
    pub fn end(&self) -> M::NamedState
    where
        M: NamedSystem,
    {
        self.end.1.into()
    }

    /// The time at which it ended: that which was asked for unless an event stopped it.
    pub fn end_time(&self) -> M::Scalar {
        self.end.0
    }

    /// All that was kept of it: samples if they were asked for, events, columns that were observed. Of a motion that was computed
    /// [in lanes](super::Ensemble::is_in_lanes) it is made when it is asked for, with the start and the end as samples at least.
    pub fn trajectory(&self) -> &'m Trajectory<M> {
        match self.kept {
            Memory::Trajectory(trajectory) => trajectory,
            Memory::Unmade(place, make) => place.get_or_init(make),
        }
    }
}

impl<M: MechanicalSystem> Debug for Motion<'_, M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Motion").field("index", &self.index).field("end", &self.end).finish_non_exhaustive()
    }
}

/// The outcome of a motion.
pub(super) type Ran<M> = Result<Trajectory<M>, SimulationError<M>>;

impl<M, K, D, P> Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
{
    /// Runs one motion of the ensemble again, or for the first time, by itself, with every step kept if samples were not asked for. It has the
    /// same bits, unless the ensemble goes [in lanes](Self::is_in_lanes): its end then is the same to within what the tolerance leaves open.
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
    /// If there is no such motion, what was asked for makes no sense, or a closure panics.
    pub fn motion(&self, index: usize) -> Result<Ran<M>, EnsembleError> {
        self.asked.parts()?;
        if index >= self.asked.number {
            let number = self.asked.number;
            return Err(EnsembleError::Setting(std::format!(
                "there is no motion {index} in an ensemble of {number}: they are counted from zero"
            )));
        }
        self.ran_with(index, Unasked::EveryStep, |_, ran| ran)
    }

    /// Runs a motion of which no samples are kept unless they were asked for, and makes something of what came of it.
    ///
    /// # Errors
    /// If a closure that was given panics, or a setting makes no sense.
    pub(super) fn ran<R>(
        &self,
        index: usize,
        then: impl FnOnce(&M, Ran<M>) -> R,
    ) -> Result<R, EnsembleError> {
        self.ran_with(index, Unasked::EndsOnly, then)
    }

    fn ran_with<R>(
        &self,
        index: usize,
        unasked: Unasked,
        then: impl FnOnce(&M, Ran<M>) -> R,
    ) -> Result<R, EnsembleError> {
        caught(index, || {
            let (varied, state) = self.asked.origin(index);
            let system = varied.as_ref().unwrap_or(self.asked.system);
            let ran = self.run_over(index, (system, state), [self.asked.from, self.asked.end], unasked);
            refuse_settings(index, &ran)?;
            Ok(then(system, ran))
        })?
    }

    /// Runs motions one after the other, until the ensemble is cancelled.
    pub(super) fn each_alone(
        &self,
        motions: Range<usize>,
        counter: &Counter<'_, '_>,
        mut then: impl FnMut(usize, &M, Ran<M>),
    ) -> Result<(), EnsembleError> {
        for index in motions {
            if counter.is_cancelled() {
                break;
            }
            self.ran(index, |system, ran| then(index, system, ran))?;
            counter.count(1);
        }
        Ok(())
    }

    /// Returns the record of a single instant of a motion.
    pub(super) fn instant(&self, index: usize, system: &M, (time, state): (M::Scalar, M::State)) -> Ran<M> {
        self.run_over(index, (system, state), [time, time], Unasked::EndsOnly)
    }

    /// Returns the record of a motion that ends after a number of steps.
    #[cfg(feature = "parquet")]
    pub(super) fn first_steps(&self, index: usize, origin: (&M, M::State), steps: u64) -> Ran<M> {
        let span = [self.asked.from, self.asked.end];
        let run = self.asked.plain(index, origin, span, Unasked::EveryStep).max_steps(steps);
        run.exchange(|_, _| (self.method.clone(), self.drive.clone())).run()
    }

    fn run_over(
        &self,
        index: usize,
        origin: (&M, M::State),
        span: [M::Scalar; 2],
        unasked: Unasked,
    ) -> Ran<M> {
        let run = self.asked.plain(index, origin, span, unasked);
        run.exchange(|_, _| (self.method.clone(), self.drive.clone())).run()
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

/// # Errors
/// If what failed was not the motion but what was asked of all.
pub(super) fn refuse_settings<M: MechanicalSystem>(index: usize, ran: &Ran<M>) -> Result<(), EnsembleError> {
    match ran {
        Err(error) if is_setting(error.cause) => {
            Err(EnsembleError::Setting(std::format!("motion {index}: {error}")))
        }
        _ => Ok(()),
    }
}

/// True if what failed was not the motion but what was asked of all.
fn is_setting<S: Copy>(cause: StepFailure<S>) -> bool {
    matches!(
        cause,
        StepFailure::Setting(_)
            | StepFailure::RepeatedColumn
            | StepFailure::UnknownOutput { .. }
            | StepFailure::TooManySamples { .. }
    )
}
