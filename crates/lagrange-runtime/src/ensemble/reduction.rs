//! Ensembles reduced to a summary.

use core::cell::LazyCell;
use core::fmt::{Debug, Formatter};
use core::ops::{Deref, Range};
use std::vec::Vec;

use super::builder::{Ensemble, Keep};
use super::engine::BLOCK;
use super::error::EnsembleError;
use super::failure::Failure;
use super::lanes::MotionOutcome;
use super::motion::Motion;
use super::plan::SharedSystem;
use super::reduce::Reduce;
use crate::integrate::Method;
use crate::simulate::{ClosedLoop, Drive};
use crate::system::MechanicalSystem;

/// The reduction of an ensemble, and the motions that it omits because they failed. It dereferences
/// to its value.
pub struct Reduced<M: MechanicalSystem, R> {
    value: R,
    failed: u64,
    failures: Vec<Failure<M>>,
}

/// Maximum number of failures in the list, so that memory is bounded. Further ones are only
/// counted.
const MAX_FAILURES: usize = 1000;

impl<M: MechanicalSystem, R> Reduced<M, R> {
    /// Returns the reduction of no motions.
    fn new(value: R) -> Self {
        Reduced { value, failed: 0, failures: Vec::new() }
    }

    /// Returns the value reduced from the motions that succeeded.
    pub fn into_value(self) -> R {
        self.value
    }

    /// Returns the number of failed motions.
    pub fn failed(&self) -> u64 {
        self.failed
    }

    /// Returns the first thousand of the motions that failed.
    pub fn failures(&self) -> &[Failure<M>] {
        &self.failures
    }

    fn fail(&mut self, failed: u64, failures: impl IntoIterator<Item = Failure<M>>) {
        self.failed += failed;
        let room = MAX_FAILURES - self.failures.len();
        self.failures.extend(failures.into_iter().take(room));
    }

    /// Merges the reduction of the motions that follow.
    fn merge(&mut self, later: Self)
    where
        R: Reduce,
    {
        self.value.merge(later.value);
        self.fail(later.failed, later.failures);
    }
}

impl<M: MechanicalSystem, R> Deref for Reduced<M, R> {
    type Target = R;

    fn deref(&self) -> &R {
        &self.value
    }
}

impl<M: MechanicalSystem, R: Debug> Debug for Reduced<M, R> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Reduced")
            .field("value", &self.value)
            .field("failed", &self.failed)
            .finish_non_exhaustive()
    }
}

impl<M, K, D, P> Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
    P: Keep,
{
    /// Computes all motions and keeps only their reduction, so that memory does not depend on their
    /// number.
    ///
    /// `add` is called for every motion that did not fail. By the requirements of [`Reduce`], the
    /// result has the same bits for any number of threads.
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
    /// use lagrange::ensemble::Moments;
    ///
    /// let pendulum = Pendulum::default();
    /// let ensemble = pendulum.ensemble(1000).start(|_, random| [0.1 * random.normal(), 0.0]).until(1.0);
    /// let angles = ensemble.reduce(Moments::new(), |moments, motion| moments.add(motion.end().theta))?;
    /// assert_eq!((angles.count(), angles.failed()), (1000, 0));
    /// assert!(angles.mean().abs() < 0.01);
    /// # Ok::<(), lagrange::ensemble::EnsembleError>(())
    /// ```
    ///
    /// # Errors
    /// If a setting is invalid, a closure panics, or the progress callback cancels.
    pub fn reduce<R: Reduce>(
        self,
        identity: R,
        add: impl Fn(&mut R, &Motion<'_, M>) + Sync,
    ) -> Result<Reduced<M, R>, EnsembleError> {
        let (none, mut all) = (identity.clone(), Reduced::new(identity));
        self.reduce_parts(&none, add, |part| all.merge(part))?;
        Ok(all)
    }

    /// Computes all motions as [`reduce`](Self::reduce) does, and passes on the reductions of the
    /// parts, one by one. Use it for reductions over processes: if parts are merged in order, the
    /// bits do not depend on the number of processes.
    ///
    /// # Errors
    /// See [`reduce`](Self::reduce).
    pub fn reduce_parts<R: Reduce>(
        self,
        identity: &R,
        add: impl Fn(&mut R, &Motion<'_, M>) + Sync,
        mut then: impl FnMut(Reduced<M, R>),
    ) -> Result<(), EnsembleError> {
        let engine = self.engine()?;
        self.batch.refuse_too_many_at_once(1)?;
        let counter = self.counter(&self.batch.motions());
        let compute = |chunk: Range<usize>| {
            let blocks = chunk.len().div_ceil(BLOCK);
            let mut blocks: Vec<_> = (0..blocks).map(|_| Reduced::new(identity.clone())).collect();
            let first = chunk.start;
            self.each(chunk, &counter, |index, system, outcome| {
                let block = &mut blocks[(index - first) / BLOCK];
                match outcome {
                    MotionOutcome::Run(Err(error)) => block.fail(1, [Failure::new(index, error)]),
                    MotionOutcome::Run(Ok(trajectory)) => {
                        let end = (trajectory.end_time(), trajectory.last());
                        add(&mut block.value, &Motion::new(index, system, end, &&trajectory));
                    }
                    MotionOutcome::Arrival(start, arrival) => {
                        let trajectory =
                            LazyCell::new(|| self.trajectory_of(index, (system, start), &arrival));
                        let end = (self.batch.span()[1], D::Closed::state_of_plant(&arrival.state));
                        add(&mut block.value, &Motion::new(index, system, end, &trajectory));
                    }
                }
            })?;
            Ok(blocks)
        };
        for part in self.batch.parts() {
            let mut whole = Reduced::new(identity.clone());
            engine.chunks(self.batch.part(part), &counter, compute, |blocks| {
                blocks.into_iter().for_each(|block| whole.merge(block));
                Ok(())
            })?;
            then(whole);
        }
        counter.finish()
    }
}
