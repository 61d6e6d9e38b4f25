//! Motions with samples.

use core::ops::Range;
use std::vec::Vec;

use super::builder::{Ensemble, KeepSamples};
use super::engine::Engine;
use super::error::EnsembleError;
use super::motion::RunResult;
use super::plan::SharedSystem;
use crate::integrate::Method;
use crate::simulate::{Drive, SimulationError, Table, Trajectory};
use crate::system::MechanicalSystem;

/// The trajectory of each motion of an ensemble, or the error of a failed one, with its trajectory
/// up to the failure.
#[derive(Debug)]
pub struct Samples<M: MechanicalSystem> {
    motions: Range<usize>,
    results: Vec<RunResult<M>>,
}

impl<M: MechanicalSystem> Samples<M> {
    /// Returns the number of motions, including failed ones; at least one.
    #[expect(clippy::len_without_is_empty, reason = "there is at least one motion")]
    pub fn len(&self) -> usize {
        self.results.len()
    }

    /// Returns the range of motions: all motions, or the motions of a shard.
    pub fn motions(&self) -> Range<usize> {
        self.motions.clone()
    }

    /// Returns the motion with this index; `None` if it is outside the range.
    pub fn motion(&self, index: usize) -> Option<Result<&Trajectory<M>, &SimulationError<M>>> {
        self.results.get(index.checked_sub(self.motions.start)?).map(Result::as_ref)
    }

    /// Returns the motions that did not fail, by their index.
    pub fn iter(&self) -> impl Iterator<Item = (usize, &Trajectory<M>)> {
        self.motions().zip(&self.results).filter_map(|(index, result)| Some((index, result.as_ref().ok()?)))
    }

    /// Returns the motions that failed, by their index.
    pub fn failures(&self) -> impl Iterator<Item = (usize, &SimulationError<M>)> {
        self.motions().zip(&self.results).filter_map(|(index, result)| Some((index, result.as_ref().err()?)))
    }
}

impl<M, K, D> Ensemble<'_, M, K, D, KeepSamples>
where
    M: SharedSystem,
    M::Columns<Table<M::Scalar>>: Send,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
{
    /// Computes all motions and keeps their samples.
    ///
    /// # Errors
    /// If a setting is invalid, a closure panics, or the progress callback cancels. A motion that
    /// fails is among the [`failures`](Samples::failures), and the others continue.
    pub fn run(self) -> Result<Samples<M>, EnsembleError> {
        self.run_in(&self.engine()?)
    }

    pub(super) fn run_in(&self, engine: &Engine) -> Result<Samples<M>, EnsembleError> {
        let motions = self.batch.motions();
        self.batch.refuse_too_many(motions.len())?;
        let counter = self.counter(&motions);
        let mut all = Vec::new();
        let compute = |chunk: Range<usize>| {
            let mut results = Vec::with_capacity(chunk.len());
            self.each(chunk, &counter, |index, system, outcome| {
                results.push(self.samples_of(index, system, outcome));
            })?;
            Ok(results)
        };
        engine.chunks(motions.clone(), &counter, compute, |chunk| {
            all.extend(chunk);
            Ok(())
        })?;
        counter.finish()?;
        Ok(Samples { motions, results: all })
    }
}
