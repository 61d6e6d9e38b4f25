//! Ensembles as Parquet files, part by part, so that memory is bounded and nothing that was finished is lost.

mod folder;
mod lock;
mod part;
mod settings;
#[cfg(test)]
mod tests;

use core::fmt::Debug;
use std::path::Path;
use std::vec::Vec;

use self::folder::Folder;
use super::asked::SharedSystem;
use super::builder::{Ensemble, KeepEnds};
use super::engine::Engine;
use super::error::EnsembleError;
use crate::integrate::Method;
use crate::simulate::Drive;

/// What was saved.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Saved {
    /// Files that were written.
    pub written: usize,
    /// Files of this shard that were there already.
    pub found: usize,
    /// Files that are not there yet: those of other shards that did not come so far.
    pub missing: usize,
    /// Motions that failed, in the files that were written.
    pub failed: u64,
}

impl<M, K, D> Ensemble<'_, M, K, D, KeepEnds>
where
    M: SharedSystem,
    M::Scalar: Into<f64>,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Debug + Sync,
{
    /// Computes all motions and saves their ends to Parquet files in a folder, `part-000000.parquet` and so on, in the order of motions.
    ///
    /// A file has a row for each motion and the columns `index`, `t`, the time at which it ended, those of [`Ends`](super::Ends), and
    /// `cause`, text where the motion failed and null elsewhere; the numbers of a motion that failed are NaN. Parameters become columns
    /// if they are [observed](Self::observe). A file is written under another name and renamed when it is whole. Files that are there are
    /// not computed again: an ensemble that was cancelled or killed goes on where it was, and the files in the end have the same bytes.
    ///
    /// Files say which ensemble they are of: the type of the system, what was asked for, the seed, and the bits of start and rates of the
    /// first, the middle and the last motion, by which other closures and parameters are told apart. While a shard is written a file
    /// `shard-0-of-1.lock` keeps other processes off; what a killed process left is taken over where Linux says that the process is gone.
    ///
    /// # Errors
    /// As of [`run`](Self::run); if a file cannot be written, as on a full disk; if the folder holds files that are none of these, or parts
    /// of another ensemble; if another process writes the same. What is finished is kept.
    pub fn save_parquet(self, folder: impl AsRef<Path>) -> Result<Saved, EnsembleError> {
        let parts = self.asked.parts()?;
        let settings = self.settings()?;
        let folder = Folder::open(folder.as_ref(), self.asked.shard)?;
        let number = self.asked.number_of_parts();
        let is_found = folder.parts(&parts, number, &settings)?;
        let engine = Engine::new(self.asked.threads)?;
        let counter = self.counter(&self.asked.motions()?);
        let missing: Vec<usize> = parts.clone().filter(|part| !is_found[*part]).collect();
        let found = parts.len() - missing.len();
        let mut saved = Saved { written: 0, found, missing: 0, failed: 0 };
        parts.filter(|part| is_found[*part]).for_each(|part| counter.count(self.asked.part(part).len()));
        for part in missing {
            let motions = self.asked.part(part);
            let rows = self.rows(&engine, &counter, motions.clone())?;
            folder.write(part, |file| part::write(file, motions.start, &rows, &settings))?;
            saved.written += 1;
            saved.failed += rows.failures.len() as u64;
        }
        counter.finish();
        saved.missing = number - folder.count()?;
        Ok(saved)
    }
}
