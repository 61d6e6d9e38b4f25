//! Memory checks for the recorded data of all motions.

use core::hint::black_box;
use std::format;
use std::vec::Vec;

use super::batch::Batch;
use super::error::EnsembleError;
use super::plan::SharedSystem;
use crate::scalar::Number;
use crate::simulate::state_names;

impl<M: SharedSystem> Batch<'_, M> {
    /// Checks the room for recorded data.
    ///
    /// # Errors
    /// If the recorded data of this many motions do not fit in memory, as far as the operating
    /// system can predict.
    pub(super) fn refuse_too_many(&self, motions: usize) -> Result<(), EnsembleError> {
        self.refuse(
            motions,
            "save them to files with `.save_parquet(…)`, reduce them with `.reduce(…)`, or compute a shard of them",
        )
    }

    /// Checks the room for samples that are in memory together.
    ///
    /// # Errors
    /// If the samples of this many motions, held in memory together while they are saved or
    /// reduced, do not fit.
    pub(super) fn refuse_too_many_at_once(&self, motions: usize) -> Result<(), EnsembleError> {
        self.refuse(motions, "specify a longer interval, or split the run into shorter ones")
    }

    fn refuse(&self, motions: usize, instead: &str) -> Result<(), EnsembleError> {
        let bytes = self.least_bytes(motions);
        // The conversion saturates, and no machine has that much memory.
        if has_room(bytes as usize) {
            return Ok(());
        }
        let what = if self.plan.settings.interval().is_some() { "samples" } else { "ends" };
        Err(EnsembleError::Setting(format!(
            "the {what} of {motions} motions need at least {:.1} GB of memory, which is not available: {instead}",
            bytes / 1e9
        )))
    }

    /// Returns a lower bound on the size of times, states and parameters in bytes.
    fn least_bytes(&self, motions: usize) -> f64 {
        let parameters = match self.variation {
            Some(_) if self.plan.settings.interval().is_none() => {
                (0..).map_while(|index| self.system.parameter(index)).count()
            }
            _ => 0,
        };
        let numbers = 1 + state_names(self.system.description()).count() + parameters;
        motions as f64 * self.least_samples() * (numbers * size_of::<M::Scalar>()) as f64
    }

    /// Returns the largest power of two not above the number of samples of a motion, or 1 if it may
    /// stop early.
    fn least_samples(&self) -> f64 {
        let settings = &self.plan.settings;
        let may_stop = self.needs_runs() || settings.max_steps.is_some() || !self.system.events().is_empty();
        let Some(interval) = settings.interval().filter(|_| !may_stop) else { return 1.0 };
        let [from, end] = self.span();
        let mut samples = 1.0;
        while M::Scalar::from_f64(2.0 * samples) * interval <= (end - from).abs() {
            samples *= 2.0;
        }
        samples
    }
}

/// True if this much contiguous memory can be reserved.
fn has_room(bytes: usize) -> bool {
    let mut room = Vec::<u8>::new();
    let has_room = room.try_reserve_exact(bytes).is_ok();
    // The compiler would remove an unused allocation.
    black_box(&mut room);
    has_room
}
