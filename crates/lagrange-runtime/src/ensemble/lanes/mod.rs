//! Ensembles side by side: several motions in the lanes of vector instructions.
//!
//! A chunk of motions goes in lanes if its system hands out its equations for that, the method can, and no more than ends and samples was asked for. What is
//! out of the ordinary, lanes leave to a run of its own: motions that fail, with their cause, and those of systems that wait for a time at
//! which they jump.

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
use self::refill::{ArrivalOf, Beginning, EndsOf, Queue, Refill};
use super::asked::{Asked, SharedSystem, Unasked};
use super::builder::{Ensemble, Keep};
use super::engine::Engine;
use super::error::EnsembleError;
use super::motion::{Ran, caught, refuse_settings};
use super::progress::Counter;
use crate::integrate::{LanesMethod, LanesMethodVisitor, Method};
use crate::scalar::{Number, Scalar};
use crate::simulate::{Drive, Grid, Trajectory};
use crate::system::{LanesSystem, LanesVisitor, MechanicalSystem, ScalarOf};

/// Samples of motions that are computed together, at most: some megabytes of a small system. Beyond that
const MOST_SAMPLES: f64 = 1_048_576.0;
/// as many motions are, two for each lane,
const LEAST_TOGETHER: usize = 16;
/// and never more than these if there are samples of them.
const MOST_TOGETHER: usize = 256;

/// The outcome of a motion in lanes.
pub(super) enum Came<M: MechanicalSystem> {
    /// It was a run by itself.
    Ran(Ran<M>),
    /// It went in a lane to the end that was asked for.
    Arrived(ArrivalOf<M>),
}

impl<M, K, D, P> Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
    P: Keep,
{
    /// True if motions are computed side by side, several at a time with each instruction of the
    /// processor.
    ///
    /// They are if the declaration says `emit { lanes }` and has neither constraints nor events, contacts or friction, if the method is
    /// [`Verner98`](crate::integrate::Verner98), [`RungeKutta4`](crate::integrate::RungeKutta4),
    /// [`StormerVerlet`](crate::integrate::StormerVerlet), [`SymplecticEuler`](crate::integrate::SymplecticEuler) or
    /// [`BlanesMoan4`](crate::integrate::BlanesMoan4), and if nothing is asked for but ends, samples and columns: no laws, controllers, events
    /// or restarts. A motion that fails, or jumps at a time known beforehand, is a run by itself in any case.
    ///
    /// What comes of a motion then depends neither on the others nor on threads or shards, but on whether the processor fuses products and
    /// sums; and it is that of a single run only to within what the tolerance leaves open. [`one_by_one`](Self::one_by_one) gives the bits of
    /// single runs.
    pub fn is_in_lanes(&self) -> bool {
        let asked = &self.asked;
        let is_plain = !asked.is_one_by_one && !M::IS_CONSTRAINED && M::EVENTS.is_empty();
        is_plain && self.method.in_lanes(Ask).is_ok() && M::with_lanes(Ask).is_ok()
    }

    /// Threads, and chunks for them.
    pub(super) fn engine(&self) -> Result<Engine, EnsembleError> {
        let (engine, motions) = (Engine::new(self.asked.threads)?, self.asked.motions()?.len());
        Ok(match (self.is_in_lanes(), P::SAMPLES) {
            (false, _) => engine,
            (true, false) => engine.with_wide_chunks(motions),
            (true, true) => engine.with_chunks_of_samples(motions),
        })
    }

    /// Computes motions and hands over in their order what came of them, until the ensemble is cancelled.
    pub(super) fn each(
        &self,
        motions: Range<usize>,
        counter: &Counter<'_, '_>,
        mut then: impl FnMut(usize, &M, Came<M>),
    ) -> Result<(), EnsembleError> {
        if !self.is_in_lanes() {
            return self
                .each_alone(motions, counter, |index, system, ran| then(index, system, Came::Ran(ran)));
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
        let Some(interval) = self.asked.interval else { return usize::MAX };
        let samples = ((self.asked.end - self.asked.from) / interval).abs();
        let is_too_many = |motions: usize| {
            M::Scalar::from_f64(MOST_SAMPLES) < M::Scalar::from_f64(motions as f64) * samples
        };
        let mut together = MOST_TOGETHER;
        while together > LEAST_TOGETHER && is_too_many(together) {
            together /= 2;
        }
        together
    }

    fn each_in_lanes(
        &self,
        motions: Range<usize>,
        counter: &Counter<'_, '_>,
        then: &mut impl FnMut(usize, &M, Came<M>),
    ) -> Result<(), EnsembleError> {
        let beginnings: Vec<_> =
            motions.clone().map(|index| self.beginning(index)).collect::<Result<_, _>>()?;
        if let Some(first) = beginnings.first() {
            let (index, system) = (motions.start, first.system(self.asked.system));
            let instant = caught(index, || self.instant(index, system, (self.asked.from, first.state)))?;
            refuse_settings(index, &instant)?;
        }
        let ends = caught(motions.start, || self.in_lanes(&beginnings, counter))?;
        for ((index, beginning), end) in motions.zip(beginnings).zip(ends) {
            if counter.is_cancelled() {
                break;
            }
            let Some(end) = end else {
                self.ran(index, |system, ran| then(index, system, Came::Ran(ran)))?;
                counter.count(1);
                continue;
            };
            let system = beginning.system(self.asked.system);
            caught(index, || then(index, system, Came::Arrived(end)))?;
        }
        Ok(())
    }

    /// Returns the start of a motion.
    ///
    /// # Errors
    /// If a closure panics, or what was asked for makes no sense.
    fn beginning(&self, index: usize) -> Result<Beginning<M>, EnsembleError> {
        caught(index, || {
            let (system, state) = self.asked.origin(index);
            Beginning { system, state }
        })
    }

    /// Computes the final states of motions with these starts.
    fn in_lanes(&self, beginnings: &[Beginning<M>], counter: &Counter<'_, '_>) -> EndsOf<M> {
        let asked = &self.asked;
        let is_plain = |motion: &usize| {
            let (system, state) = (beginnings[*motion].system(asked.system), &beginnings[*motion].state);
            let is_smooth = system.next_restart(asked.from, asked.end).is_none();
            is_smooth && matches!(system.begin(asked.from, state), Ok(None))
        };
        let has_length = (asked.end - asked.from).is_finite() && asked.end != asked.from;
        let grid =
            asked.interval.map(|interval| Grid::new(asked.from, asked.end, interval)?.that_can_be_kept());
        // What is wrong with the times of samples a run tells.
        let Ok(grid) = grid.transpose() else { return beginnings.iter().map(|_| None).collect() };
        let motions: Vec<_> = (0..beginnings.len()).filter(|motion| has_length && is_plain(motion)).collect();
        if P::SAMPLES {
            self.arrivals::<true>(beginnings, &motions, grid, counter)
        } else {
            self.arrivals::<false>(beginnings, &motions, None, counter)
        }
    }

    /// Computes the final states of these motions, given by their indices in the list of starts.
    fn arrivals<const SAMPLED: bool>(
        &self,
        beginnings: &[Beginning<M>],
        motions: &[usize],
        grid: Option<Grid<M::Scalar>>,
        counter: &Counter<'_, '_>,
    ) -> EndsOf<M> {
        let &Asked { system, from, end, most_steps, longest_step, .. } = &self.asked;
        let queue = Queue::<M, SAMPLED> { system, beginnings, motions, from, end, grid, most_steps, counter };
        let method = match longest_step {
            Some(longest) => self.method.clone().with_longest_step(longest).ok(),
            None => Some(self.method.clone()),
        };
        let ends = method.and_then(|method| method.in_lanes(queue).ok().flatten());
        ends.unwrap_or_else(|| beginnings.iter().map(|_| None).collect())
    }

    /// The trajectory of a motion that went in a lane: its start, its samples and its end, with all columns.
    pub(super) fn trajectory_of(&self, index: usize, system: &M, arrival: &ArrivalOf<M>) -> Trajectory<M> {
        let (asked, Arrival { state, samples, work }) = (&self.asked, arrival);
        let (_, start) = asked.origin(index);
        let run = asked.plain(index, (system, start), [asked.from, asked.end], Unasked::EndsOnly);
        let run = run.exchange(|_, _| (self.method.clone(), self.drive.clone()));
        run.told(samples.iter().copied().chain([(asked.end, *state)]), *work)
    }

    /// The samples of a motion, however it was computed.
    pub(super) fn samples_of(&self, index: usize, system: &M, came: Came<M>) -> Ran<M> {
        match came {
            Came::Ran(ran) => ran,
            Came::Arrived(arrival) => Ok(self.trajectory_of(index, system, &arrival)),
        }
    }
}

/// Asks whether something can be done in lanes.
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
    M: MechanicalSystem,
{
    type Output = Option<EndsOf<M>>;

    fn visit(self, method: impl LanesMethod<M::Scalar>) -> Self::Output {
        M::with_lanes(Refill { queue: self, method }).ok()
    }
}

impl<M, L, const SAMPLED: bool> LanesVisitor<M> for Refill<'_, '_, M, L, SAMPLED>
where
    M: MechanicalSystem,
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
