//! Ensembles in lanes: several motions in the lanes of vector instructions.
//!
//! A chunk of motions runs in lanes if the system and the method support it, and only ends and
//! samples were requested. Motions that fail or leave their domain are repeated alone, which
//! reports the cause. Motions with a jump at a known time are run alone from the start.

mod dispatch;
mod refill;
mod sampler;
#[cfg(test)]
mod tests;

use core::ops::Range;
use std::vec::Vec;

#[cfg(any(feature = "parquet", test))]
pub(super) use self::dispatch::is_fused;
pub(super) use self::refill::Arrival;
use self::refill::{ArrivalOf, EndsOf, MotionStart, Queue, Refill};
use super::builder::{Ensemble, Keep};
use super::engine::Engine;
use super::error::EnsembleError;
use super::motion::{RunResult, caught};
use super::plan::SharedSystem;
use super::progress::Counter;
use crate::integrate::{LanesMethod, LanesMethodVisitor, Method};
use crate::scalar::{Number, Scalar};
use crate::simulate::{ClosedLoop, Drive, Grid, Sampling, Trajectory};
use crate::system::{LanesSystem, LanesVisitor, MechanicalSystem, OdeSystem, ScalarOf};

/// Maximum number of samples of motions that are computed together: a few megabytes for a small
/// system.
const MAX_SAMPLES: f64 = 1_048_576.0;
/// Minimum number of motions computed together, whatever their samples: two per lane.
const LEAST_TOGETHER: usize = 16;
/// Maximum number of motions computed together if they have samples.
const MAX_TOGETHER: usize = 256;

/// Size of the stacks of threads for derivatives in lanes, in bytes. Unoptimised code takes some
/// 50 kB for each entry of a state with its derivatives.
const STACK_FOR_DERIVATIVES: usize = 16 << 20;

/// The outcome of a motion.
pub(super) enum MotionOutcome<M: MechanicalSystem, C: OdeSystem> {
    /// It was a separate run.
    Run(RunResult<M>),
    /// It reached its end in a lane, from this initial state, with the state of a closed loop C.
    Arrival(M::State, ArrivalOf<C>),
}

impl<M, K, D, P> Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
    P: Keep,
{
    /// True if motions are computed in lanes, several at a time with each instruction of the
    /// processor.
    ///
    /// This requires all of the following:
    /// - the declaration has `emit { lanes }`, and neither constraints nor events, contacts or
    ///   friction;
    /// - the method is [`Verner98`](crate::integrate::Verner98),
    ///   [`RungeKutta4`](crate::integrate::RungeKutta4),
    ///   [`StormerVerlet`](crate::integrate::StormerVerlet),
    ///   [`SymplecticEuler`](crate::integrate::SymplecticEuler),
    ///   [`BlanesMoan4`](crate::integrate::BlanesMoan4) or, for
    ///   [series in lanes](crate::system::TaylorSystem::IN_LANES),
    ///   [`Taylor`](crate::integrate::Taylor);
    /// - only ends, samples, columns and sensitivities are requested: no laws, controllers, events
    ///   or restarts. Sensitivities need `emit { jacobian }`, no series and at most 96 numbers per
    ///   state, derivatives included.
    ///
    /// A motion that fails, leaves a declared range, or jumps at a time known in advance, is always
    /// a single run.
    ///
    /// The bits of a motion in a lane do not depend on other motions, threads or shards. They
    /// depend on whether the processor has fused multiply-add. They agree with the bits of a single
    /// run only within the tolerance. [`one_by_one`](Self::one_by_one) gives the bits of single
    /// runs.
    pub fn is_in_lanes(&self) -> bool {
        let is_plain = !self.batch.needs_runs()
            && !self.batch.system.is_constrained()
            && self.batch.system.events().is_empty();
        is_plain && self.method.in_lanes(Ask).is_ok() && D::Closed::with_lanes(Ask).is_ok()
    }

    /// Checks the settings, and returns an engine with suitable threads and chunks.
    ///
    /// # Errors
    /// If a setting is invalid, or threads cannot be started.
    pub(super) fn engine(&self) -> Result<Engine, EnsembleError> {
        self.check()?;
        let (is_in_lanes, motions) = (self.is_in_lanes(), self.batch.motions().len());
        let stack = (is_in_lanes && !D::Closed::IS_PLANT).then_some(STACK_FOR_DERIVATIVES);
        let engine = Engine::new(self.batch.threads, stack)?;
        Ok(match (is_in_lanes, P::SAMPLES) {
            (false, _) => engine,
            (true, false) => engine.with_wide_chunks(motions),
            (true, true) => engine.with_chunks_of_samples(motions),
        })
    }

    /// Computes motions and passes on their outcomes in order, until the ensemble is cancelled.
    pub(super) fn each(
        &self,
        motions: Range<usize>,
        counter: &Counter<'_, '_>,
        mut then: impl FnMut(usize, &M, MotionOutcome<M, D::Closed>),
    ) -> Result<(), EnsembleError> {
        if !self.is_in_lanes() {
            return self.each_alone(motions, counter, |index, system, result| {
                then(index, system, MotionOutcome::Run(result));
            });
        }
        let together = self.together();
        for first in motions.clone().step_by(together) {
            self.each_in_lanes(first..motions.end.min(first.saturating_add(together)), counter, &mut then)?;
        }
        Ok(())
    }

    /// Returns the number of motions computed together: all of them, or fewer if their samples
    /// would be too many.
    fn together(&self) -> usize {
        let Some(interval) = self.batch.plan.settings.interval() else { return usize::MAX };
        let [from, end] = self.batch.span();
        let samples = ((end - from) / interval).abs();
        let is_too_many =
            |motions: usize| M::Scalar::from_f64(MAX_SAMPLES) < M::Scalar::from_f64(motions as f64) * samples;
        let mut together = MAX_TOGETHER;
        while together > LEAST_TOGETHER && is_too_many(together) {
            together /= 2;
        }
        together
    }

    fn each_in_lanes(
        &self,
        motions: Range<usize>,
        counter: &Counter<'_, '_>,
        then: &mut impl FnMut(usize, &M, MotionOutcome<M, D::Closed>),
    ) -> Result<(), EnsembleError> {
        self.drive.close(self.batch.system, |all| {
            let start = |index| caught(index, || self.start_of(index, all));
            let starts: Vec<_> = motions.clone().map(start).collect::<Result<_, _>>()?;
            let ends = caught(motions.start, || self.in_lanes(all, &starts, counter))?;
            for ((index, start), end) in motions.zip(starts).zip(ends) {
                if counter.is_cancelled() {
                    break;
                }
                let Some(end) = end else {
                    let then = |system: &M, result| then(index, system, MotionOutcome::Run(result));
                    self.run_alone(index, counter, then)?;
                    continue;
                };
                let (system, from) = (start.system(all).plant(), D::Closed::state_of_plant(&start.state));
                caught(index, || then(index, system, MotionOutcome::Arrival(from, end)))?;
            }
            Ok(())
        })
    }

    /// Returns the start of a motion, given the common loop.
    fn start_of(&self, index: usize, all: &D::Closed) -> MotionStart<D::Closed> {
        let (varied, state) = self.batch.origin(index);
        let plant = varied.as_ref().unwrap_or(self.batch.system);
        let drive = self.drive.for_motion(plant, &state);
        let (detached, state) =
            drive.close(plant, |closed| (closed.detached(), closed.extended(self.batch.span()[0], &state)));
        MotionStart { system: detached.or_else(|| varied.map(|plant| all.with_plant(plant))), state }
    }

    /// Computes the final states of motions with these starts.
    fn in_lanes(
        &self,
        all: &D::Closed,
        starts: &[MotionStart<D::Closed>],
        counter: &Counter<'_, '_>,
    ) -> EndsOf<D::Closed> {
        let ([from, end], domain) = (self.batch.span(), self.batch.system.domain());
        let is_plain = |motion: &usize| {
            let (system, state) = (starts[*motion].system(all), &starts[*motion].state);
            let is_inside = system.domain() == domain && domain.check(state.as_ref()).is_ok();
            let is_free = is_inside && system.next_restart(from, end).is_none();
            is_free && matches!(system.begin(from, state), Ok(None))
        };
        let has_length = (end - from).is_finite() && end != from;
        let motions: Vec<_> = (0..starts.len()).filter(|motion| has_length && is_plain(motion)).collect();
        if P::SAMPLES {
            let grid = self.batch.plan.settings.grid().ok().flatten();
            self.arrivals::<true>(all, (starts, &motions), grid, counter)
        } else {
            self.arrivals::<false>(all, (starts, &motions), None, counter)
        }
    }

    /// Computes the final states of these motions, given by their indices in the list of starts.
    fn arrivals<const SAMPLED: bool>(
        &self,
        system: &D::Closed,
        (starts, motions): (&[MotionStart<D::Closed>], &[usize]),
        grid: Option<Grid<M::Scalar>>,
        counter: &Counter<'_, '_>,
    ) -> EndsOf<D::Closed> {
        let (settings, [from, end]) = (&self.batch.plan.settings, self.batch.span());
        let max_steps = settings.max_steps;
        let queue = Queue::<_, SAMPLED> { system, starts, motions, from, end, grid, max_steps, counter };
        let method = match settings.longest_step {
            Some(longest) => self.method.clone().with_longest_step(longest).ok(),
            None => Some(self.method.clone()),
        };
        let ends = method.and_then(|method| method.in_lanes(queue).ok().flatten());
        ends.unwrap_or_else(|| starts.iter().map(|_| None).collect())
    }

    /// Returns the trajectory of a motion computed in a lane: its start, its samples and its end,
    /// with all columns.
    pub(super) fn trajectory_of(
        &self,
        index: usize,
        (system, start): (&M, M::State),
        arrival: &ArrivalOf<D::Closed>,
    ) -> Trajectory<M> {
        let Arrival { state, samples, work } = arrival;
        let end = (self.batch.span()[1], *state);
        let run = self.run_of(index, (system, start), Sampling::Ends);
        run.assemble(samples.iter().copied().chain([end]), *work)
    }

    /// Returns the samples of a motion, whether computed in a lane or as a single run.
    pub(super) fn samples_of(
        &self,
        index: usize,
        system: &M,
        outcome: MotionOutcome<M, D::Closed>,
    ) -> RunResult<M> {
        match outcome {
            MotionOutcome::Run(result) => result,
            MotionOutcome::Arrival(start, arrival) => {
                Ok(self.trajectory_of(index, (system, start), &arrival))
            }
        }
    }
}

/// A visitor that only checks for support of lanes.
struct Ask;

impl<T: Scalar> LanesMethodVisitor<T> for Ask {
    type Output = ();

    fn visit(self, _method: impl LanesMethod<T>) {}
}

impl<M> LanesVisitor<M> for Ask {
    type Output = ();

    fn visit(self) {}
}

impl<M, const SAMPLED: bool> LanesMethodVisitor<M::Scalar> for Queue<'_, '_, M, SAMPLED>
where
    M: OdeSystem,
{
    type Output = Option<EndsOf<M>>;

    fn visit(self, method: impl LanesMethod<M::Scalar>) -> Self::Output {
        M::with_lanes(Refill { queue: self, method }).ok()
    }
}

impl<M, L, const SAMPLED: bool> LanesVisitor<M> for Refill<'_, '_, M, L, SAMPLED>
where
    M: OdeSystem,
    L: LanesMethod<ScalarOf<M>>,
{
    type Output = EndsOf<M>;

    fn visit(self) -> EndsOf<M>
    where
        M: LanesSystem,
    {
        dispatch::compute(self)
    }
}
