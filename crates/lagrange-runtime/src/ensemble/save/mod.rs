//! Ensembles as Parquet files, part by part, so that memory is bounded and nothing that was
//! finished is lost.

mod folder;
mod lock;
mod part;
mod seal;
mod settings;
mod sheet;
#[cfg(test)]
mod tests;
mod verify;

use core::fmt::Debug;
use core::ops::Range;
use std::collections::BTreeSet;
use std::path::Path;

use self::folder::Folder;
use self::part::{Label, PartFile};
use self::sheet::Sheet;
pub use self::verify::{Verified, verify};
use super::builder::{Ensemble, Keep};
use super::engine::{BLOCK, Engine};
use super::error::EnsembleError;
use super::plan::SharedSystem;
use super::progress::Counter;
use crate::integrate::Method;
use crate::simulate::Drive;

/// The result of saving an ensemble.
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

impl<M, K, D, P> Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    M::Scalar: Into<f64>,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Debug + Sync,
    P: Keep,
{
    /// Computes all motions and saves their ends, or their samples after [`every`](Self::every), to
    /// Parquet files in a folder. The files are `part-000000.parquet` and so on, in the order of
    /// motions.
    ///
    /// A file has a row for each motion, or for each of its samples. Columns are
    ///
    /// - `index`, the place of the motion, counted from zero;
    /// - all parameters, if motions have separate [parameters](super::Motions::parameters);
    /// - `t`, the time, of an end that at which the motion ended;
    /// - positions, velocities and what was [observed](Self::observe);
    /// - `cause`, text where the motion failed and null elsewhere. The end of a failed motion is
    ///   NaN except for its parameters. Its samples are those until it failed, the last of which
    ///   has the cause.
    ///
    /// Columns whose unit is known have it under `lagrange.unit.` and their name among the
    /// key–value metadata, as [trajectories](crate::simulate::Trajectory::write_parquet) do.
    ///
    /// Rows are written in groups of at least 131 072. Memory holds one group and the motions that
    /// threads have computed ahead, at most a part. A file is written under another name and
    /// renamed when it is complete. Existing files are not computed again: an ensemble that was
    /// cancelled or killed continues where it was, and the final files have the same bytes.
    ///
    /// Files identify their ensemble:
    /// - the declaration of the system by its
    ///   [fingerprint](crate::system::MechanicalSystem::FINGERPRINT), the requested results, the
    ///   method and its settings, and the seed;
    /// - the bits of start, rates, parameters and first steps of the first, the middle and the last
    ///   motion. They distinguish closures and functions of your crate.
    ///
    /// They also identify their part, and have a checksum of all their bytes. Existing parts are
    /// checked for all of this; [`verify`](fn@verify) does so without computing anything.
    ///
    /// While a shard is written a file `shard-0-of-1.lock` keeps other processes off; what a
    /// process of this machine left that is gone is taken over. A folder in which nothing is
    /// missing is only read. Files with other names are passed over.
    ///
    /// # Errors
    /// As for [`run`](Self::run). Also in these cases, in which finished parts are kept:
    /// - a file cannot be written, as on a full disk;
    /// - the folder holds a damaged or foreign part, or a file that is no part;
    /// - another process writes the same parts.
    pub fn save_parquet(self, folder: impl AsRef<Path>) -> Result<Saved, EnsembleError> {
        self.check()?;
        let parts = self.batch.parts();
        self.batch.refuse_too_many_at_once(self.batch.motions().len().min(BLOCK))?;
        let settings = self.settings()?;
        let mut folder = Folder::open(folder.as_ref());
        let label = Label { settings, part: parts.start, number: self.batch.number_of_parts() };
        let mut found = folder.find(&parts, &label)?;
        let is_whole = found.range(parts.clone()).count() == parts.len();
        // A folder of which nothing is missing is only read.
        let lock = if is_whole { None } else { Some(folder.lock(self.batch.shard, &parts)?) };
        if lock.is_some() {
            found = folder.find(&parts, &label)?;
        }
        let mut saved = self.save_missing(&folder, &found, &parts, &label)?;
        saved.missing = label.number.saturating_sub(folder.parts()?.len());
        Ok(saved)
    }

    /// Computes and saves the parts that were not found.
    fn save_missing(
        &self,
        folder: &Folder,
        found: &BTreeSet<usize>,
        parts: &Range<usize>,
        label: &Label,
    ) -> Result<Saved, EnsembleError> {
        let (engine, counter) = (self.engine()?, self.counter(&self.batch.motions()));
        let of_shard = found.range(parts.clone());
        let mut saved = Saved { written: 0, found: of_shard.clone().count(), missing: 0, failed: 0 };
        of_shard.for_each(|part| counter.count(self.batch.part(*part).len()));
        for part in parts.clone().filter(|part| !found.contains(part)) {
            let (motions, label) = (self.batch.part(part), Label { part, ..label.clone() });
            let failed = folder.write(part, |file, wrong| {
                let mut part = PartFile::new(file, &label);
                self.sheets(&engine, &counter, motions, |sheet| part.add(sheet).map_err(wrong))?;
                part.finish().map_err(wrong)
            })?;
            saved.written += 1;
            saved.failed += failed as u64;
        }
        counter.finish()?;
        Ok(saved)
    }

    /// Computes motions and hands their rows over, chunk by chunk in their order.
    fn sheets(
        &self,
        engine: &Engine,
        counter: &Counter<'_, '_>,
        motions: Range<usize>,
        then: impl FnMut(Sheet<M>) -> Result<(), EnsembleError>,
    ) -> Result<(), EnsembleError> {
        let compute = |chunk: Range<usize>| {
            let mut sheet = Sheet::new();
            self.each(chunk, counter, |index, system, outcome| {
                sheet.push(index, |rows| {
                    if P::SAMPLES {
                        rows.push_samples(
                            &self.batch,
                            index,
                            system,
                            self.samples_of(index, system, outcome),
                        );
                    } else {
                        self.push_end(rows, index, system, outcome);
                    }
                });
            })?;
            Ok(sheet)
        };
        engine.chunks(motions, counter, compute, then)
    }
}
