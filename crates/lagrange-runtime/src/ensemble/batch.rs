//! The motions of an ensemble, independent of their method and their drive.

use core::ops::Range;
use std::boxed::Box;
use std::format;
use std::string::String;
use std::vec::Vec;

use super::error::EnsembleError;
use super::plan::{SharedPlan, SharedSystem};
use super::progress::BatchReporter;
use super::random::Random;
use super::shard::Shard;
use crate::scalar::Scalar;
use crate::simulate::{Plan, Sampling};
use crate::system::{MechanicalSystem, OdeSystem, StateVector};

/// Computes the start of a motion.
pub(super) type StartOf<'a, M> =
    Box<dyn Fn(usize, &mut Random) -> <M as OdeSystem>::State + Send + Sync + 'a>;

/// Computes the system of a motion.
pub(super) type Variation<'a, M> = Box<dyn Fn(usize, &M) -> M + Send + Sync + 'a>;

/// The motions of an ensemble: their starts, the plan that they share, and their distribution over
/// threads and shards.
pub(super) struct Batch<'a, M: MechanicalSystem> {
    pub(super) system: &'a M,
    pub(super) number: usize,
    pub(super) start: Option<StartOf<'a, M>>,
    pub(super) variation: Option<Variation<'a, M>>,
    pub(super) seed: u64,
    pub(super) plan: SharedPlan<'a, M>,
    /// True if every motion is computed as a separate run.
    pub(super) is_one_by_one: bool,
    /// Message about the first invalid setting.
    fault: Option<&'static str>,
    pub(super) threads: Option<usize>,
    pub(super) shard: Shard,
    pub(super) motions_per_part: usize,
    pub(super) reporter: Option<BatchReporter<'a>>,
}

/// Default part size: about ten seconds of double pendulums on one thread, or 3 MB in a file.
const MOTIONS_PER_PART: usize = 1 << 16;

impl<'a, M: SharedSystem> Batch<'a, M> {
    pub(super) fn new(system: &'a M, number: usize, start: Option<StartOf<'a, M>>) -> Self {
        Batch {
            system,
            number,
            start,
            variation: None,
            seed: 0,
            plan: Plan::new(Sampling::Ends),
            is_one_by_one: false,
            fault: None,
            threads: None,
            shard: Shard::WHOLE,
            motions_per_part: MOTIONS_PER_PART,
            reporter: None,
        }
    }

    /// Records an invalid setting, unless an earlier one was recorded.
    pub(super) fn refuse_setting(&mut self, what: &'static str) {
        self.fault = self.fault.or(Some(what));
    }

    /// True if the plan needs runs and excludes lanes.
    pub(super) fn needs_runs(&self) -> bool {
        let Plan { settings, watches, inputs, .. } = &self.plan;
        self.is_one_by_one || !watches.is_empty() || inputs.is_some() || !settings.restarts.is_empty()
    }

    /// Returns the times of start and end.
    pub(super) fn span(&self) -> [M::Scalar; 2] {
        self.plan.settings.span
    }

    /// Returns the system of a motion, if it has a separate one, and its initial state.
    pub(super) fn origin(&self, index: usize) -> (Option<M>, M::State) {
        let start = self.start.as_ref().map(|start| start(index, &mut Random::start(self.seed, index)));
        let varied = self.variation.as_ref().map(|variation| variation(index, self.system));
        (varied, start.unwrap_or(M::State::ZERO))
    }

    /// Returns the parameters of a motion that become columns: none if motions share parameters,
    /// otherwise all whose name is not among these columns.
    pub(super) fn parameters(&self, system: &M, columns: &[String]) -> Vec<(&'static str, M::Scalar)> {
        if self.variation.is_none() {
            return Vec::new();
        }
        let parameters = (0..).map_while(|index| system.parameter(index));
        parameters.filter(|(name, _)| !columns.iter().any(|column| column == name)).collect()
    }

    /// Returns the motions of this shard.
    pub(super) fn motions(&self) -> Range<usize> {
        let parts = self.parts();
        self.start_of(parts.start)..self.start_of(parts.end)
    }

    /// Returns the motions of a part.
    pub(super) fn part(&self, part: usize) -> Range<usize> {
        self.start_of(part)..self.start_of(part + 1)
    }

    /// Returns the first motion of a part, or the number of motions for parts after the last.
    fn start_of(&self, part: usize) -> usize {
        part.saturating_mul(self.motions_per_part).min(self.number)
    }

    /// Returns the parts of this shard.
    pub(super) fn parts(&self) -> Range<usize> {
        self.shard.share(self.number_of_parts())
    }

    /// Returns the number of parts of all shards.
    pub(super) fn number_of_parts(&self) -> usize {
        self.number.div_ceil(self.motions_per_part.max(1))
    }

    /// Checks the settings of the batch.
    ///
    /// # Errors
    /// If a setting is invalid.
    pub(super) fn check(&self) -> Result<(), EnsembleError> {
        let wrong = |what: &str| Err(EnsembleError::Setting(what.into()));
        if let Some(fault) = self.fault {
            return wrong(fault);
        }
        if self.number == 0 {
            return wrong("an ensemble needs at least one motion");
        }
        if self.start.is_none() {
            return wrong(
                "the motions have no start: add `.start(|index, random| …)`, or give a list of starts",
            );
        }
        let [from, end] = self.span();
        if !(from.is_finite() && end.is_finite()) {
            return Err(EnsembleError::Setting(format!(
                "motions go from the time {from:?} to {end:?}, which must both be finite"
            )));
        }
        if self.motions_per_part == 0 {
            return wrong("a part must contain at least one motion");
        }
        self.shard.check()?;
        let parts = self.number_of_parts();
        if self.shard.count() > parts as u64 {
            return Err(EnsembleError::Setting(format!(
                "{} shards are more than there are parts, {parts}: take fewer, or `.motions_per_part(…)` below {}",
                self.shard.count(),
                self.motions_per_part
            )));
        }
        Ok(())
    }
}
