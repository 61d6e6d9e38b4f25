//! Ensembles side by side: several motions in the lanes of vector instructions.
//!
//! A chunk of motions goes in lanes if its system hands out its equations for that, the method can, and nothing was asked for but ends. What is
//! out of the ordinary, lanes leave to a run of its own: motions that fail, with their cause, and those of systems that wait for a time at
//! which they jump.

mod dispatch;
mod refill;
#[cfg(test)]
mod tests;

use core::ops::Range;
use std::vec::Vec;

#[cfg(feature = "parquet")]
pub(super) use self::dispatch::is_fused;
pub(super) use self::refill::Arrival;
use self::refill::{Beginning, EndsOf, Queue, Refill};
use super::asked::SharedSystem;
use super::builder::Ensemble;
use super::engine::Engine;
use super::error::EnsembleError;
use super::motion::{Ran, caught, refuse_settings};
use super::progress::Counter;
use crate::integrate::{LanesMethod, LanesMethodVisitor, Method};
use crate::scalar::Scalar;
use crate::simulate::{Drive, Trajectory};
use crate::system::{LanesSystem, LanesVisitor, MechanicalSystem, ScalarOf};

/// What came of a motion.
pub(super) enum Came<M: MechanicalSystem> {
    /// It was a run by itself.
    Ran(Ran<M>),
    /// It went in a lane to the end that was asked for.
    Arrived(Arrival<M::State>),
}

impl<M, K, D, P> Ensemble<'_, M, K, D, P>
where
    M: SharedSystem,
    D: Drive<M> + Sync,
    K: Method<D::Closed> + Clone + Sync,
{
    /// Whether motions are computed side by side, several at a time with each instruction of the processor.
    ///
    /// They are if the declaration says `emit { lanes }` and has neither constraints nor events, contacts or friction, if the method is
    /// [`Verner98`](crate::integrate::Verner98) or [`RungeKutta4`](crate::integrate::RungeKutta4), and if nothing is asked for but ends and columns:
    /// no samples, laws, controllers, events or restarts. A motion that fails, or jumps at a time known beforehand, is a run by itself in
    /// any case.
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
        let engine = Engine::new(self.asked.threads)?;
        Ok(if self.is_in_lanes() { engine.with_wide_chunks(self.asked.motions()?.len()) } else { engine })
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
        let beginnings: Vec<_> =
            motions.clone().map(|index| self.beginning(index)).collect::<Result<_, _>>()?;
        if let Some(first) = beginnings.first() {
            let start = (self.asked.from, first.state);
            refuse_settings(
                motions.start,
                &self.instant(motions.start, first.system(self.asked.system), start),
            )?;
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

    /// Where a motion begins.
    ///
    /// # Errors
    /// If a closure panics, or what was asked for makes no sense.
    fn beginning(&self, index: usize) -> Result<Beginning<M>, EnsembleError> {
        caught(index, || {
            let (system, state) = self.asked.origin(index);
            Beginning { system, state }
        })
    }

    /// Where motions end that start there.
    fn in_lanes(&self, beginnings: &[Beginning<M>], counter: &Counter<'_, '_>) -> EndsOf<M> {
        let asked = &self.asked;
        let is_plain = |motion: &usize| {
            let (system, state) = (beginnings[*motion].system(asked.system), &beginnings[*motion].state);
            let is_smooth = system.next_restart(asked.from, asked.end).is_none();
            is_smooth && matches!(system.begin(asked.from, state), Ok(None))
        };
        let has_length = (asked.end - asked.from).is_finite() && asked.end != asked.from;
        let motions: Vec<_> = (0..beginnings.len()).filter(|motion| has_length && is_plain(motion)).collect();
        let queue = Queue {
            system: asked.system,
            beginnings,
            motions: &motions,
            from: asked.from,
            end: asked.end,
            most_steps: asked.most_steps,
            counter,
        };
        let method = match asked.longest_step {
            Some(longest) => self.method.clone().with_longest_step(longest).ok(),
            None => Some(self.method.clone()),
        };
        let ends = method.and_then(|method| method.in_lanes(queue).ok().flatten());
        ends.unwrap_or_else(|| beginnings.iter().map(|_| None).collect())
    }

    /// The trajectory of a motion of which only the ends are known.
    pub(super) fn ends_of(&self, index: usize, system: &M, end: &Arrival<M::State>) -> Trajectory<M> {
        let kept = |instant| match self.instant(index, system, instant) {
            Ok(trajectory) => trajectory,
            Err(error) => *error.trajectory,
        };
        let (_, start) = self.asked.origin(index);
        let (start, end_trajectory) = (kept((self.asked.from, start)), kept((self.asked.end, end.state)));
        Trajectory::of_ends(&start, &end_trajectory, end.work)
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

impl<M: MechanicalSystem> LanesMethodVisitor<M::Scalar> for Queue<'_, '_, M> {
    type Output = Option<EndsOf<M>>;

    fn visit(self, method: impl LanesMethod<M::Scalar>) -> Self::Output {
        M::with_lanes(Refill { queue: self, method }).ok()
    }
}

impl<M: MechanicalSystem, L: LanesMethod<ScalarOf<M>>> LanesVisitor<M> for Refill<'_, '_, M, L> {
    type Output = EndsOf<M>;

    fn visit(self) -> EndsOf<M>
    where
        M: LanesSystem,
    {
        dispatch::compute(self)
    }
}
