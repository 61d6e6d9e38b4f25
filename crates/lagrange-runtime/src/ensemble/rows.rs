//! Motions as rows of a table.

use std::vec::Vec;

use super::batch::Batch;
use super::failure::Failure;
use super::motion::RunResult;
use super::plan::SharedSystem;
use crate::scalar::Number;
use crate::simulate::{Table, state_names};
use crate::system::MechanicalSystem;

/// The rows of consecutive motions: state, observed columns, and parameters if motions have
/// separate ones.
pub(super) struct Rows<M: MechanicalSystem> {
    /// `None` before the first row.
    pub(super) table: Option<Table<M::Scalar>>,
    /// Number of parameter columns, which come last.
    pub(super) parameters: usize,
    pub(super) failures: Vec<Failure<M>>,
}

impl<M: SharedSystem> Rows<M> {
    pub(super) fn new() -> Self {
        Rows { table: None, parameters: 0, failures: Vec::new() }
    }

    /// Adds the end of a motion, or NaN if it failed.
    pub(super) fn push_end(&mut self, batch: &Batch<'_, M>, index: usize, system: &M, result: RunResult<M>) {
        let (samples, is_good) = samples(&result);
        let parameters = batch.parameters(system, samples.names());
        let end = |values: &[M::Scalar]| if is_good { values.last().copied() } else { Some(M::Scalar::NAN) };
        let time = end(samples.times()).unwrap_or(M::Scalar::NAN);
        let row = samples.columns().filter_map(end).chain(parameters.iter().map(|(_, value)| *value));
        let row: Vec<_> = row.collect();
        self.table(samples, &parameters).push(time, &row);
        self.fail(index, result);
    }

    /// Adds the end of a motion computed in a lane, without columns beyond the state.
    pub(super) fn push_arrival(
        &mut self,
        batch: &Batch<'_, M>,
        system: &M,
        (time, state): (M::Scalar, &M::State),
    ) {
        let samples = Table::new(state_names(system.description()).collect());
        let parameters = batch.parameters(system, samples.names());
        let mut row = state.as_ref().to_vec();
        row.extend(parameters.iter().map(|(_, value)| *value));
        self.table(&samples, &parameters).push(time, &row);
    }

    /// Adds all samples of a motion; for a failed one, those up to the failure.
    #[cfg(feature = "parquet")]
    pub(super) fn push_samples(
        &mut self,
        batch: &Batch<'_, M>,
        index: usize,
        system: &M,
        result: RunResult<M>,
    ) {
        let (samples, _) = samples(&result);
        let parameters = batch.parameters(system, samples.names());
        self.table(samples, &parameters).extend(samples, parameters.iter().map(|(_, value)| *value));
        self.fail(index, result);
    }

    /// Appends the rows of the motions that follow.
    pub(super) fn merge(&mut self, later: Self) {
        match (&mut self.table, later.table) {
            (Some(table), Some(later)) => table.append(later),
            (table, later) => *table = table.take().or(later),
        }
        self.parameters = self.parameters.max(later.parameters);
        self.failures.extend(later.failures);
    }

    /// Returns the table, created on first use with the columns of these samples and parameters.
    fn table(
        &mut self,
        samples: &Table<M::Scalar>,
        parameters: &[(&'static str, M::Scalar)],
    ) -> &mut Table<M::Scalar> {
        self.parameters = parameters.len();
        self.table.get_or_insert_with(|| {
            let parameters = parameters.iter().map(|(name, _)| (*name).into());
            Table::new(samples.names().iter().cloned().chain(parameters).collect())
        })
    }

    /// Records the failure of a motion, if it failed.
    fn fail(&mut self, index: usize, result: RunResult<M>) {
        self.failures.extend(result.err().map(|error| Failure::new(index, error)));
    }
}

/// Returns the samples of a motion, and true if it reached its end.
pub(super) fn samples<M: MechanicalSystem>(result: &RunResult<M>) -> (&Table<M::Scalar>, bool) {
    match result {
        Ok(trajectory) => (trajectory.table(), true),
        Err(error) => (error.trajectory.table(), false),
    }
}
