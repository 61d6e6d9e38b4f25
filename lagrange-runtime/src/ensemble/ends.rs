//! Where motions ended.

use core::fmt::{Debug, Display, Formatter};
use core::ops::{Deref, Range};
use std::string::String;
use std::vec::Vec;

use super::asked::SharedSystem;
use super::builder::{Ensemble, KeepEnds};
use super::engine::Engine;
use super::error::EnsembleError;
use super::motion::Ran;
use super::progress::Counter;
use crate::integrate::Method;
use crate::scalar::Number;
use crate::simulate::{Drive, SimulationError, Table, explain_run};
use crate::system::{MechanicalSystem, StateVector, StepFailure};

/// Where the motions of an ensemble ended: a row for each, in named columns.
///
/// Columns are the coordinates and velocities and then what was observed. Of an emitted system those of the state are also methods, such as
/// `ends.theta()`. The row of a motion that failed holds NaN: what is known of it is in [`failures`](Ends::failures).
pub struct Ends<M: MechanicalSystem> {
    columns: M::Columns<Table<M::Scalar>>,
    failures: Vec<Failure<M>>,
    motions: Range<usize>,
}

impl<M: MechanicalSystem> Ends<M> {
    /// How many rows there are, those of failed motions among them; at least one.
    #[expect(clippy::len_without_is_empty, reason = "there is at least one motion")]
    pub fn len(&self) -> usize {
        self.table().len()
    }

    /// The motions whose ends these are: all, or those of a shard. The first row is that of the first of them.
    pub fn motions(&self) -> Range<usize> {
        self.motions.clone()
    }

    /// The times at which motions ended: that which was asked for, unless an event stopped them.
    pub fn times(&self) -> &[M::Scalar] {
        self.table().times()
    }

    /// The names of the columns, in their order; time has none.
    pub fn names(&self) -> &[String] {
        self.table().names()
    }

    /// The column of this name: a coordinate, a velocity such as `theta_dot`, or what was observed.
    pub fn column(&self, name: &str) -> Option<&[M::Scalar]> {
        self.table().column(name)
    }

    /// All columns.
    pub fn table(&self) -> &Table<M::Scalar> {
        self.columns.as_ref()
    }

    /// The state at which the motion with this index ended; `None` if it failed or is not among these.
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

    /// The motions that failed, in their order.
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

/// Not the rows, which may be millions.
impl<M: MechanicalSystem> Debug for Ends<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Ends")
            .field("motions", &self.motions)
            .field("columns", &self.names())
            .field("failures", &self.failures.len())
            .finish_non_exhaustive()
    }
}

/// A motion that failed: how far it came, and why no further.
#[non_exhaustive]
pub struct Failure<M: MechanicalSystem> {
    /// Which motion.
    pub index: usize,
    /// The time of the last good state.
    pub time: M::Scalar,
    /// The last good state; finite, unless the start was not.
    pub state: M::State,
    /// Why it came no further.
    pub cause: StepFailure<M::Scalar>,
    /// What the event is called that the cause is about, if it is about one.
    pub name: Option<String>,
}

impl<M: MechanicalSystem> Failure<M> {
    pub(super) fn new(index: usize, error: SimulationError<M>) -> Self {
        let (time, state) = (error.time(), error.state());
        Failure { index, time, state, cause: error.cause, name: error.name }
    }

    /// Why and when, in words.
    #[cfg(feature = "parquet")]
    pub(super) fn why(&self) -> impl Display + '_ {
        Why(self)
    }
}

impl<M: MechanicalSystem> Clone for Failure<M> {
    fn clone(&self) -> Self {
        Failure { name: self.name.clone(), ..*self }
    }
}

impl<M: MechanicalSystem> Debug for Failure<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Failure")
            .field("index", &self.index)
            .field("time", &self.time)
            .field("state", &self.state)
            .field("cause", &self.cause)
            .finish_non_exhaustive()
    }
}

impl<M: MechanicalSystem> Display for Failure<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        write!(f, "motion {}: {}", self.index, Why(self))
    }
}

/// A failure without its motion.
struct Why<'f, M: MechanicalSystem>(&'f Failure<M>);

impl<M: MechanicalSystem> Display for Why<'_, M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        explain_run(&self.0.cause, self.0.name.as_deref(), self.0.time, f)
    }
}

/// The rows of motions that follow each other.
pub(super) struct Rows<M: MechanicalSystem> {
    /// None before the first.
    pub(super) table: Option<Table<M::Scalar>>,
    pub(super) failures: Vec<Failure<M>>,
}

impl<M: MechanicalSystem> Rows<M> {
    pub(super) fn new() -> Self {
        Rows { table: None, failures: Vec::new() }
    }

    /// Adds a motion.
    fn push(&mut self, index: usize, ran: Ran<M>) {
        match ran {
            Ok(trajectory) => self.push_row(trajectory.table(), |value| value, trajectory.end_time()),
            Err(error) => {
                self.push_row(error.trajectory.table(), |_| M::Scalar::NAN, M::Scalar::NAN);
                self.failures.push(Failure::new(index, error));
            }
        }
    }

    /// Adds what is made of the last sample of a table.
    fn push_row(
        &mut self,
        samples: &Table<M::Scalar>,
        made: impl Fn(M::Scalar) -> M::Scalar,
        time: M::Scalar,
    ) {
        let table = self.table.get_or_insert_with(|| Table::new(samples.names().to_vec()));
        let row: Vec<_> = samples.columns().filter_map(|column| column.last().copied().map(&made)).collect();
        table.push(time, &row);
    }

    /// Adds the motions that follow.
    pub(super) fn merge(&mut self, later: Self) {
        match (&mut self.table, later.table) {
            (Some(table), Some(later)) => table.append(later),
            (table, later) => *table = table.take().or(later),
        }
        self.failures.extend(later.failures);
    }
}

impl<'a, M, K, D, P> Ensemble<'a, M, K, D, P>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
{
    /// The rows of these motions.
    pub(super) fn rows(
        &self,
        engine: &Engine,
        counter: &Counter<'_, '_>,
        motions: Range<usize>,
    ) -> Result<Rows<M>, EnsembleError> {
        let mut rows = Rows::new();
        let compute = |chunk: Range<usize>| {
            let mut rows = Rows::new();
            self.each(chunk, counter, |index, _, ran| rows.push(index, ran))?;
            Ok(rows)
        };
        engine.chunks(motions, counter, compute, |chunk| rows.merge(chunk))?;
        Ok(rows)
    }

    /// Runs motions one after the other, until the ensemble is cancelled.
    pub(super) fn each(
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

    pub(super) fn counter(&self, motions: &Range<usize>) -> Counter<'_, 'a> {
        Counter::new(self.asked.reporter.as_ref(), motions.len())
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
    /// If what was asked for makes no sense, a closure that was given panics, or the progress callback cancels. A motion that fails is
    /// among the [`failures`](Ends::failures), and the others go on.
    pub fn run(self) -> Result<Ends<M>, EnsembleError> {
        self.run_in(&Engine::new(self.asked.threads)?)
    }

    pub(super) fn run_in(&self, engine: &Engine) -> Result<Ends<M>, EnsembleError> {
        let motions = self.asked.motions()?;
        let counter = self.counter(&motions);
        let Rows { table, failures } = self.rows(engine, &counter, motions.clone())?;
        counter.finish();
        let columns = table.unwrap_or_else(|| Table::new(Vec::new())).into();
        Ok(Ends { columns, failures, motions })
    }
}
