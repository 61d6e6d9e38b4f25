//! The builder of an ensemble: starts and ends of its motions, and their method.

use core::marker::PhantomData;
use std::boxed::Box;

use super::batch::Batch;
use super::plan::SharedSystem;
use super::progress::{BatchReporter, Done};
use super::random::Random;
use super::shard::Shard;
use super::starts::Starts;
use crate::integrate::{Method, Verner98};
use crate::scalar::Number;
use crate::simulate::{
    Drive, InitialState, Law, Sampling, Undriven, Variables, Verdict, WithHistory, columns_of,
    default_method, inputs, tolerance_setters, uncounted,
};
use crate::system::{
    ControlledSystem, DelayedSystem, EntryRange, MechanicalSystem, OdeSystem, ParametricSystem, ScalarOf,
    StateVector,
};

/// Motions of one system, which still require an end time.
#[must_use = "specify the end of the motions: `.until(time)`"]
pub struct Motions<'a, M: MechanicalSystem> {
    batch: Batch<'a, M>,
    has_starts: bool,
}

impl<'a, M: SharedSystem> Motions<'a, M> {
    pub(super) fn new(system: &'a M, starts: impl Starts<M>) -> Self {
        let (number, starts) = starts.into_starts();
        let has_starts = starts.is_some();
        let start = starts.map(|starts| Box::new(move |index: usize, _: &mut Random| starts[index]) as _);
        Motions { batch: Batch::new(system, number, start), has_starts }
    }

    /// Starts each motion from a state: a function of its index, counted from zero, and of separate
    /// [random numbers](Random). It may be called several times for a motion, and by several
    /// threads.
    pub fn start<Y: InitialState<M::State>>(
        mut self,
        start: impl Fn(usize, &mut Random) -> Y + Send + Sync + 'a,
    ) -> Self {
        if self.has_starts {
            let twice = "the motions have both a list of starts and `.start(…)`: specify a number of motions instead of the list";
            self.batch.refuse_setting(twice);
        }
        self.batch.start = Some(Box::new(move |index, random| start(index, random).into_state()));
        self
    }

    /// Starts each motion from a random state within the declared ranges. Entries whose range has
    /// two bounds are distributed uniformly between them, independently of each other; all others
    /// are those of the given state. Runs bring states onto the constraints, which may lead out of
    /// a range.
    pub fn start_within_ranges<Y: InitialState<M::State>>(mut self, others: Y) -> Self {
        let domain = self.batch.system.domain();
        if !domain.ranges.iter().any(EntryRange::is_bounded) {
            let unbounded = "`.start_within_ranges(…)` needs an entry of the state with a lower and an upper bound, as in `coord x in 0..=1;`";
            self.batch.refuse_setting(unbounded);
        }
        let others = others.into_state();
        self.start(move |_, random| {
            let mut state = others;
            domain.draw(state.as_mut(), |range| random.uniform(range));
            state
        })
    }

    /// Gives each motion a separate system: a copy of the common one, changed by its index.
    /// Parameters drawn at random take numbers from [`Random::parameters`], which differ from those
    /// of the starts, also under the same seed.
    ///
    /// Every parameter of the system, changed or not, then becomes a column of
    /// [`Ends`](super::Ends) and of files. It has its name, unless an [observer](Ensemble::observe)
    /// has that name. Other values of a motion, such as inputs, or fields of a handwritten system,
    /// are kept if they are observed.
    pub fn parameters(mut self, change: impl Fn(usize, &mut M) + Send + Sync + 'a) -> Self
    where
        M: Clone,
    {
        self.batch.variation = Some(Box::new(move |index, system: &M| {
            let mut system = system.clone();
            change(index, &mut system);
            system
        }));
        self
    }

    /// Starts at this time instead of 0.
    pub fn from(mut self, time: M::Scalar) -> Self {
        self.batch.plan.settings.span = [time; 2];
        self
    }

    /// Ends at this time, which may lie before the start.
    pub fn until(mut self, end: M::Scalar) -> Ensemble<'a, M, Verner98<M::Scalar>> {
        self.batch.plan.settings.span[1] = end;
        Ensemble { batch: self.batch, method: default_method(), drive: Undriven, kept: PhantomData }
    }
}

/// Keeps the final state of every motion.
#[derive(Clone, Copy, Debug)]
pub struct KeepEnds;

/// Keeps samples of every motion.
#[derive(Clone, Copy, Debug)]
pub struct KeepSamples;

/// The recorded data of every motion: [`KeepEnds`] or [`KeepSamples`].
pub trait Keep {
    /// True if it is samples.
    const SAMPLES: bool;
}

impl Keep for KeepEnds {
    const SAMPLES: bool = false;
}

impl Keep for KeepSamples {
    const SAMPLES: bool = true;
}

/// An ensemble that can be computed: which motions, by which method, and what to keep of them.
///
/// Every motion is a [separate run](crate::simulate::Simulation), with the same bits. Methods,
/// inputs, events, contacts, constraints and settings are those of runs. K is the method, D drives
/// the inputs, and P, [`KeepEnds`] or [`KeepSamples`], selects the results to keep. `.tolerance(…)`
/// exists for the default method only.
#[must_use = "nothing happens before `.run()`, `.reduce(…)` or `.save_parquet(…)`"]
pub struct Ensemble<'a, M: MechanicalSystem, K, D = Undriven, P = KeepEnds> {
    pub(super) batch: Batch<'a, M>,
    pub(super) method: K,
    pub(super) drive: D,
    kept: PhantomData<fn() -> P>,
}

impl<M: SharedSystem, D, P> Ensemble<'_, M, Verner98<M::Scalar>, D, P> {
    tolerance_setters!();
}

impl<'a, M: SharedSystem, K, P> Ensemble<'a, M, K, Undriven, P> {
    /// Sets the inputs at every instant by a law, as [in a single
    /// run](crate::simulate::Simulation::drive). Every input becomes a column.
    pub fn drive<F>(mut self, law: F) -> Ensemble<'a, M, K, Law<F>, P>
    where
        M: ControlledSystem,
        F: Fn(&M, M::Scalar, M::NamedState) -> M::Inputs + Send + Sync,
    {
        self.batch.plan.record_inputs(self.batch.system, Box::new(columns_of(inputs::<M>)));
        let Ensemble { batch, method, kept, .. } = self;
        Ensemble { batch, method, drive: Law::new(law), kept }
    }

    /// Keeps the past of every motion, as the delays of the declaration ask for, as [in a single
    /// run](crate::simulate::Simulation::with_history).
    pub fn with_history(mut self) -> Ensemble<'a, M, K, WithHistory, P>
    where
        M: DelayedSystem,
    {
        self.batch.plan.record_inputs(self.batch.system, Box::new(columns_of(inputs::<M>)));
        let Ensemble { batch, method, kept, .. } = self;
        Ensemble { batch, method, drive: WithHistory, kept }
    }
}

impl<'a, M: SharedSystem + ParametricSystem, K, D, P> Ensemble<'a, M, K, D, P> {
    /// Adds derivatives of every motion with respect to parameters, inputs and initial values, as
    /// [in a single run](crate::simulate::Simulation::sensitivities). Each pair has a column, such
    /// as `d(theta)/d(m)`. Motions are computed [in lanes](Self::is_in_lanes) with
    /// `emit { jacobian, lanes }`.
    pub fn sensitivities<V, const N: usize>(self, names: V) -> Ensemble<'a, M, K, V::Sensitive<M, D, N>, P>
    where
        V: Variables,
        M: OdeSystem<State = [ScalarOf<M>; N]>,
    {
        self.differentiated::<V, N>(names, M::Scalar::ONE)
    }

    /// Adds derivatives along steps that are chosen for the state alone, as [in a single
    /// run](crate::simulate::Simulation::sensitivities_alongside).
    pub fn sensitivities_alongside<V, const N: usize>(
        self,
        names: V,
    ) -> Ensemble<'a, M, K, V::Sensitive<M, D, N>, P>
    where
        V: Variables,
        M: OdeSystem<State = [ScalarOf<M>; N]>,
    {
        self.differentiated::<V, N>(names, uncounted())
    }

    fn differentiated<V, const N: usize>(
        mut self,
        names: V,
        weight: M::Scalar,
    ) -> Ensemble<'a, M, K, V::Sensitive<M, D, N>, P>
    where
        V: Variables,
        M: OdeSystem<State = [ScalarOf<M>; N]>,
    {
        let (settings, system) = (&mut self.batch.plan.settings, self.batch.system);
        // Each motion scales them by its values.
        let variables = settings.find_variables(system, &M::State::ZERO, names.into(), weight);
        let Ensemble { batch, method, drive, kept } = self;
        Ensemble { batch, method, drive: V::around(drive, variables), kept }
    }
}

impl<'a, M: SharedSystem, K, D, P> Ensemble<'a, M, K, D, P> {
    /// Integrates by this method instead of the adaptive one.
    pub fn method<N>(self, method: N) -> Ensemble<'a, M, N, D, P>
    where
        D: Drive<M>,
        N: Method<D::Closed>,
    {
        let Ensemble { batch, drive, kept, .. } = self;
        Ensemble { batch, method, drive, kept }
    }

    /// Keeps samples of every motion, at its start, at its end and at this interval between them.
    /// `.run()` then returns a trajectory for each motion, `.reduce(…)` receives it, and
    /// `.save_parquet(…)` writes a row for each sample. After `.run()` all samples of all motions
    /// are in memory.
    pub fn every(mut self, interval: M::Scalar) -> Ensemble<'a, M, K, D, KeepSamples> {
        self.batch.plan.settings.sampling = Sampling::Every(interval);
        let Ensemble { batch, method, drive, .. } = self;
        Ensemble { batch, method, drive, kept: PhantomData }
    }

    /// Sets the seed of the [random numbers](Random) of all motions; 0 by default.
    pub fn seed(mut self, seed: u64) -> Self {
        self.batch.seed = seed;
        self
    }

    /// Computes every motion as a separate run, with the bits of a [single
    /// run](crate::simulate::Simulation), instead of several [in lanes](Self::is_in_lanes).
    pub fn one_by_one(mut self) -> Self {
        self.batch.is_one_by_one = true;
        self
    }

    /// Computes on this many threads, 4096 at most, instead of those of rayon's pool, one for each
    /// processor. Results do not depend on it.
    pub fn threads(mut self, threads: usize) -> Self {
        match threads {
            0 => self.batch.refuse_setting("an ensemble needs at least one thread"),
            1..=4096 => self.batch.threads = Some(threads),
            _ => self.batch.refuse_setting("an ensemble can use at most 4096 threads"),
        }
        self
    }

    /// Calls back about twenty times a second, from whichever thread, and once at the end, as for a
    /// progress bar.
    ///
    /// The callback returns nothing, or `ControlFlow::Break(())` to cancel the ensemble. Motions
    /// that have begun then end as well, within a few dozen steps, and
    /// [`Cancelled`](super::EnsembleError::Cancelled) is returned. Saved parts are kept.
    pub fn progress<V: Verdict>(mut self, callback: impl FnMut(Done) -> V + Send + 'a) -> Self {
        self.batch.reporter = Some(BatchReporter::new(callback));
        self
    }

    /// Computes this share of the motions only, for one of several processes.
    pub fn shard(mut self, shard: Shard) -> Self {
        self.batch.shard = shard;
        self
    }

    /// Sets the minimum number of motions in a [shard](Shard) and in a saved file; 65 536 by
    /// default. A killed process loses at most this many motions, and this many are in memory while
    /// a file is saved.
    pub fn motions_per_part(mut self, motions: usize) -> Self {
        self.batch.motions_per_part = motions;
        self
    }
}
