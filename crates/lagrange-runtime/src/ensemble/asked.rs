//! The request for an ensemble, independent of its method and its drive.

use core::marker::PhantomData;
use core::ops::Range;
use std::boxed::Box;
use std::format;
use std::string::String;
use std::vec::Vec;

use super::error::EnsembleError;
use super::progress::Reporter;
use super::random::Random;
use super::shard::Shard;
use crate::integrate::Verner98;
use crate::scalar::Scalar;
use crate::simulate::{Simulation, Start};
use crate::system::{MechanicalSystem, OdeSystem, ScalarOf, StateVector};

/// A system that threads may share. Every system whose fields, numbers and states they may is one.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be shared by threads",
    note = "an ensemble needs a system, numbers and states that are `Send` and `Sync`: no `Rc`, `Cell` or pointer in them"
)]
pub trait SharedSystem: MechanicalSystem<Scalar: Send + Sync, State: Send + Sync> + Send + Sync {}

impl<M: MechanicalSystem<Scalar: Send + Sync, State: Send + Sync> + Send + Sync> SharedSystem for M {}

/// A run before its method and drive are chosen.
pub(super) type Plain<'s, M> = Simulation<'s, M, Verner98<ScalarOf<M>>>;

/// Says that 'a outlives 's, the time of one run.
pub(super) struct Within<'s, 'a: 's>(PhantomData<&'s &'a ()>);

/// Something that is asked of every run.
pub(super) type Request<'a, M> =
    Box<dyn for<'s> Fn(Within<'s, 'a>, usize, Plain<'s, M>) -> Plain<'s, M> + Send + Sync + 'a>;

/// The start of a motion.
pub(super) type StartOf<'a, M> =
    Box<dyn Fn(usize, &mut Random) -> <M as OdeSystem>::State + Send + Sync + 'a>;

/// The system of a motion.
pub(super) type Variation<'a, M> = Box<dyn Fn(usize, &M) -> M + Send + Sync + 'a>;

/// The samples of a run without a sampling request.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Unasked {
    EveryStep,
    EndsOnly,
}

/// The request for an ensemble, independent of its method and its drive.
pub(super) struct Asked<'a, M: MechanicalSystem> {
    pub(super) system: &'a M,
    pub(super) number: usize,
    pub(super) start: Option<StartOf<'a, M>>,
    pub(super) variation: Option<Variation<'a, M>>,
    pub(super) from: M::Scalar,
    pub(super) end: M::Scalar,
    pub(super) seed: u64,
    requests: Vec<Request<'a, M>>,
    /// True if every motion is to be a run by itself.
    pub(super) is_one_by_one: bool,
    /// Interval between samples, if samples are kept.
    pub(super) interval: Option<M::Scalar>,
    /// True if columns beside the state were asked for.
    pub(super) has_columns: bool,
    pub(super) most_steps: Option<u64>,
    pub(super) longest_step: Option<M::Scalar>,
    /// The requests in words, by which ensembles are told apart.
    pub(super) words: Vec<String>,
    /// A setting that makes no sense.
    pub(super) fault: Option<&'static str>,
    pub(super) threads: Option<usize>,
    pub(super) shard: Shard,
    pub(super) motions_per_part: usize,
    pub(super) reporter: Option<Reporter<'a>>,
}

/// Some ten seconds of double pendulums on one thread; 3 MB in a file.
const MOTIONS_PER_PART: usize = 1 << 16;

impl<'a, M: SharedSystem> Asked<'a, M> {
    pub(super) fn new(system: &'a M, number: usize, start: Option<StartOf<'a, M>>, from: M::Scalar) -> Self {
        Asked {
            system,
            number,
            start,
            variation: None,
            from,
            end: from,
            seed: 0,
            requests: Vec::new(),
            is_one_by_one: false,
            interval: None,
            has_columns: false,
            most_steps: None,
            longest_step: None,
            words: Vec::new(),
            fault: None,
            threads: None,
            shard: Shard::WHOLE,
            motions_per_part: MOTIONS_PER_PART,
            reporter: None,
        }
    }

    /// Asks every run for something, which these words tell from others, and which only runs can do.
    pub(super) fn request(
        &mut self,
        words: impl Into<String>,
        request: impl for<'s> Fn(Within<'s, 'a>, usize, Plain<'s, M>) -> Plain<'s, M> + Send + Sync + 'a,
    ) {
        self.is_one_by_one = true;
        self.request_anyhow(words, request);
    }

    /// Asks for columns, which can be computed of an end however it was found.
    pub(super) fn request_columns(
        &mut self,
        words: impl Into<String>,
        request: impl for<'s> Fn(Within<'s, 'a>, usize, Plain<'s, M>) -> Plain<'s, M> + Send + Sync + 'a,
    ) {
        self.has_columns = true;
        self.request_anyhow(words, request);
    }

    /// Asks for something that lanes can do as well as runs.
    pub(super) fn request_anyhow(
        &mut self,
        words: impl Into<String>,
        request: impl for<'s> Fn(Within<'s, 'a>, usize, Plain<'s, M>) -> Plain<'s, M> + Send + Sync + 'a,
    ) {
        self.words.push(words.into());
        self.requests.push(Box::new(request));
    }

    /// The run of a motion over this time, with everything that was asked for, and the samples that are kept unless others were.
    pub(super) fn plain<'s>(
        &'s self,
        index: usize,
        (system, state): (&'s M, M::State),
        [from, until]: [M::Scalar; 2],
        unasked: Unasked,
    ) -> Plain<'s, M>
    where
        'a: 's,
    {
        let plain = Start::of(system, from, state).until(until);
        let plain = match unasked {
            Unasked::EveryStep => plain.every_step(),
            Unasked::EndsOnly => plain.ends_only(),
        };
        self.requests.iter().fold(plain, |plain, request| request(Within(PhantomData), index, plain))
    }

    /// The system of a motion, if it is not that of all, and where it starts.
    pub(super) fn origin(&self, index: usize) -> (Option<M>, M::State) {
        let start = self.start.as_ref().map(|start| start(index, &mut Random::start(self.seed, index)));
        let varied = self.variation.as_ref().map(|variation| variation(index, self.system));
        (varied, start.unwrap_or(M::State::ZERO))
    }

    /// The parameters of a motion that become columns: all but those that one of these columns is called like, if motions have their own.
    pub(super) fn parameters(&self, system: &M, columns: &[String]) -> Vec<(&'static str, M::Scalar)> {
        if self.variation.is_none() {
            return Vec::new();
        }
        let parameters = (0..).map_while(|index| system.parameter(index));
        parameters.filter(|(name, _)| !columns.iter().any(|column| column == name)).collect()
    }

    /// The motions of this shard.
    ///
    /// # Errors
    /// If what was asked for makes no sense.
    pub(super) fn motions(&self) -> Result<Range<usize>, EnsembleError> {
        self.parts().map(|parts| self.start_of(parts.start)..self.start_of(parts.end))
    }

    /// The motions of a part.
    pub(super) fn part(&self, part: usize) -> Range<usize> {
        self.start_of(part)..self.start_of(part + 1)
    }

    /// The first motion of a part, or the number of all behind the last.
    fn start_of(&self, part: usize) -> usize {
        part.saturating_mul(self.motions_per_part).min(self.number)
    }

    /// The parts of this shard.
    ///
    /// # Errors
    /// If what was asked for makes no sense.
    pub(super) fn parts(&self) -> Result<Range<usize>, EnsembleError> {
        let wrong = |what: &str| Err(EnsembleError::Setting(what.into()));
        if let Some(fault) = self.fault {
            return wrong(fault);
        }
        if self.number == 0 {
            return wrong("an ensemble of no motions was asked for");
        }
        if self.start.is_none() {
            return wrong(
                "motions do not know where they start: say `.start(|index, random| …)`, or give a list of starts",
            );
        }
        if !(self.from.is_finite() && self.end.is_finite()) {
            return Err(EnsembleError::Setting(format!(
                "motions go from the time {:?} to {:?}, which must both be finite",
                self.from, self.end
            )));
        }
        if self.motions_per_part == 0 {
            return wrong("a part must hold a motion at least");
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
        Ok(self.shard.share(parts))
    }

    /// Returns the number of parts of all shards.
    pub(super) fn number_of_parts(&self) -> usize {
        self.number.div_ceil(self.motions_per_part.max(1))
    }
}
