//! Ensembles as Parquet files, written part by part, so that memory is bounded and finished parts
//! are never lost.

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
    /// Files of this shard that already existed.
    pub found: usize,
    /// Files that do not exist yet, because other shards have not written them.
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
    /// A file has a row for each motion, or for each of its samples. The columns are
    ///
    /// - `index`, the index of the motion, counted from zero;
    /// - all parameters, if motions have separate [parameters](super::Motions::parameters);
    /// - `t`, the time of the sample, or the time at which the motion ended;
    /// - positions, velocities and [observed](Self::observe) columns;
    /// - `cause`, a text if the motion failed and null otherwise. The end of a failed motion is NaN
    ///   except for its parameters. Its samples are those up to the failure, and the last one has
    ///   the cause.
    ///
    /// If the unit of a column is known, the key–value metadata have it under `lagrange.unit.` and
    /// the name of the column, as [trajectories](crate::simulate::Trajectory::write_parquet) do.
    ///
    /// Rows are written in groups of at least 131 072. Memory holds one group and the motions that
    /// threads have computed ahead, at most one part. A file is written under another name and
    /// renamed when it is complete. Existing files are not recomputed: an ensemble that was
    /// cancelled or killed resumes, and the final files have the same bytes.
    ///
    /// Files identify their ensemble:
    /// - the declaration of the system by its
    ///   [fingerprint](crate::system::MechanicalSystem::FINGERPRINT), the requested results, the
    ///   method and its settings, and the seed;
    /// - the bits of start, rates, parameters and first steps of the first, the middle and the last
    ///   motion. They reveal changes in closures and functions of your crate.
    ///
    /// Files also identify their part, and contain a checksum of all their bytes. All of this is
    /// checked for existing parts; [`verify`](fn@verify) does so without computing anything.
    ///
    /// While a shard is written, a file such as `shard-0-of-1.lock` keeps other processes out. A
    /// lock left by a process of this machine that no longer exists is taken over. A complete
    /// folder is only read. Files with other names are ignored.
    ///
    /// # Errors
    /// See [`run`](Self::run). An error is also returned in these cases, in which finished parts
    /// are kept:
    /// - a file cannot be written, as on a full disk;
    /// - the folder contains a damaged or foreign part, or a file that is named like a part and is
    ///   not one;
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
        // A folder with all parts of this shard is only read.
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

    /// Computes motions and passes on their rows, chunk by chunk, in order.
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
