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
    /// # Errors
    /// If what is kept of so many motions cannot lie in memory, as far as the operating system
    /// tells beforehand.
    pub(super) fn refuse_too_many(&self, motions: usize) -> Result<(), EnsembleError> {
        self.refuse(
            motions,
            "save them to files with `.save_parquet(…)`, reduce them with `.reduce(…)`, or compute a shard of them",
        )
    }

    /// # Errors
    /// If the samples of so many motions, which lie in memory together while they are saved or
    /// summed up, cannot.
    pub(super) fn refuse_too_many_at_once(&self, motions: usize) -> Result<(), EnsembleError> {
        self.refuse(motions, "specify a longer interval, or split the run into shorter ones")
    }

    fn refuse(&self, motions: usize, instead: &str) -> Result<(), EnsembleError> {
        let bytes = self.least_bytes(motions);
        // More than a number of this type can say is more than there is.
        if has_room(bytes as usize) {
            return Ok(());
        }
        let what = if self.plan.settings.interval().is_some() { "samples" } else { "ends" };
        Err(EnsembleError::Setting(format!(
            "the {what} of {motions} motions need at least {:.1} GB of memory, which is not available: {instead}",
            bytes / 1e9
        )))
    }

    /// The size of times, states and parameters.
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

    /// The largest power of two that is not more than the samples of a motion, if nothing may stop
    /// it before its end.
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

/// True if as much memory could be had in one piece.
fn has_room(bytes: usize) -> bool {
    let mut room = Vec::<u8>::new();
    let has_room = room.try_reserve_exact(bytes).is_ok();
    // What nobody uses would not be asked for.
    black_box(&mut room);
    has_room
}
