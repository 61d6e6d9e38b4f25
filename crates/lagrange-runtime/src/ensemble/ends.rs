//! Final states of motions.

use core::fmt::{Debug, Formatter};
use core::ops::{Deref, Range};
use std::string::String;
use std::vec::Vec;

use super::builder::{Ensemble, Keep, KeepEnds};
use super::engine::Engine;
use super::error::EnsembleError;
use super::failure::Failure;
use super::lanes::{Arrival, MotionOutcome};
use super::plan::SharedSystem;
use super::progress::Counter;
use super::rows::Rows;
use crate::integrate::Method;
use crate::simulate::{ClosedLoop, Drive, Table};
use crate::system::{MechanicalSystem, StateVector};

/// The final states of an ensemble's motions: one row each, in named columns.
///
/// Columns are the coordinates and velocities, then the observed quantities, and then all
/// parameters, if motions were given separate [parameters](crate::ensemble::Motions::parameters).
/// For an emitted system the state columns are also methods, such as `ends.theta()`. The row of a
/// failed motion holds NaN except for its parameters; [`failures`](Ends::failures) describes it.
pub struct Ends<M: MechanicalSystem> {
    columns: M::Columns<Table<M::Scalar>>,
    failures: Vec<Failure<M>>,
    motions: Range<usize>,
}

impl<M: MechanicalSystem> Ends<M> {
    /// Returns the number of rows, including those of failed motions; at least one.
    #[expect(clippy::len_without_is_empty, reason = "there is at least one motion")]
    pub fn len(&self) -> usize {
        self.table().len()
    }

    /// Returns the range of motions: all motions, or the motions of a shard. The first row belongs
    /// to the first motion of the range.
    pub fn motions(&self) -> Range<usize> {
        self.motions.clone()
    }

    /// Returns the times at which motions ended: the requested one, unless an event stopped them.
    pub fn times(&self) -> &[M::Scalar] {
        self.table().times()
    }

    /// Returns the names of the columns, in order; time has no name.
    pub fn names(&self) -> &[String] {
        self.table().names()
    }

    /// Returns the column of this name: a coordinate, a velocity such as `theta_dot`, an observed
    /// quantity, or a parameter.
    pub fn column(&self, name: &str) -> Option<&[M::Scalar]> {
        self.table().column(name)
    }

    /// Returns all columns.
    pub fn table(&self) -> &Table<M::Scalar> {
        self.columns.as_ref()
    }

    /// Returns the state at which the motion with this index ended; `None` if it failed or is not
    /// included.
    pub fn state(&self, index: usize) -> Option<M::State> {
        let row = index.checked_sub(self.motions.start).filter(|row| *row < self.len())?;
        if self.failures.binary_search_by_key(&index, |failure| failure.index).is_ok() {
            return None;
        }
        let mut state = M::State::ZERO;
        for (component, column) in state.as_mut().iter_mut().zip(self.table().columns()) {
            *component = column[row];
        }
        Some(state)
    }

    /// Returns the motions that failed, in order of their indices.
    pub fn failures(&self) -> &[Failure<M>] {
        &self.failures
    }
}

impl<M: MechanicalSystem> Deref for Ends<M> {
    type Target = M::Columns<Table<M::Scalar>>;

    fn deref(&self) -> &Self::Target {
        &self.columns
    }
}

/// Omits the rows, of which there may be millions.
impl<M: MechanicalSystem> Debug for Ends<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Ends")
            .field("motions", &self.motions)
            .field("columns", &self.names())
            .field("failures", &self.failures.len())
            .finish_non_exhaustive()
    }
}

impl<'a, M, K, D, P> Ensemble<'a, M, K, D, P>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
    P: Keep,
{
    /// Computes the rows of these motions.
    fn rows(
        &self,
        engine: &Engine,
        counter: &Counter<'_, '_>,
        motions: Range<usize>,
    ) -> Result<Rows<M>, EnsembleError> {
        let mut rows = Rows::new();
        let compute = |chunk: Range<usize>| {
            let mut rows = Rows::new();
            self.each(chunk, counter, |index, system, outcome| {
                self.push_end(&mut rows, index, system, outcome);
            })?;
            Ok(rows)
        };
        engine.chunks(motions, counter, compute, |chunk| {
            rows.merge(chunk);
            Ok(())
        })?;
        Ok(rows)
    }

    /// Adds the end of a motion, whether computed in a lane or as a single run.
    pub(super) fn push_end(
        &self,
        rows: &mut Rows<M>,
        index: usize,
        system: &M,
        outcome: MotionOutcome<M, D::Closed>,
    ) {
        let is_plain = self.batch.plan.columns.is_empty() && D::Closed::IS_PLANT;
        match outcome {
            MotionOutcome::Run(result) => rows.push_end(&self.batch, index, system, result),
            MotionOutcome::Arrival(_, arrival) if is_plain => {
                let end = (self.batch.span()[1], &D::Closed::state_of_plant(&arrival.state));
                rows.push_arrival(&self.batch, system, end);
            }
            MotionOutcome::Arrival(start, Arrival { state, work, .. }) => {
                let last = Arrival { state, samples: Vec::new(), work };
                let trajectory = self.trajectory_of(index, (system, start), &last);
                rows.push_end(&self.batch, index, system, Ok(trajectory));
            }
        }
    }

    pub(super) fn counter(&self, motions: &Range<usize>) -> Counter<'_, 'a> {
        Counter::new(self.batch.reporter.as_ref(), motions.len())
    }
}

impl<M, K, D> Ensemble<'_, M, K, D, KeepEnds>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
{
    /// Computes all motions and keeps their ends.
    ///
    /// # Errors
    /// If a setting is invalid, a closure panics, or the progress callback cancels. A motion that
    /// fails is among the [`failures`](Ends::failures), and the others continue.
    pub fn run(self) -> Result<Ends<M>, EnsembleError> {
        self.run_in(&self.engine()?)
    }

    pub(super) fn run_in(&self, engine: &Engine) -> Result<Ends<M>, EnsembleError> {
        let motions = self.batch.motions();
        self.batch.refuse_too_many(motions.len())?;
        let counter = self.counter(&motions);
        let Rows { table, failures, .. } = self.rows(engine, &counter, motions.clone())?;
        counter.finish()?;
        let columns = table.unwrap_or_else(|| Table::new(Vec::new())).into();
        Ok(Ends { columns, failures, motions })
    }
}
