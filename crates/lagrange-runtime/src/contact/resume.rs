//! Velocities and modes with which a motion continues after a mode has ended.
//!
//! Impacts that follow each other ever faster end after a finite time. A contact that rises with
//! speed s under the downward acceleration a returns after τ = 2 s/a. If several contacts hit in
//! turn, such as the corners of a box that rocks to rest, another contact caused its rise. The
//! contacts of such a group approach with the energy E = ½ ṡᵀ G⁻¹ ṡ. The fraction r² of it remains
//! after the impact. The remaining hops therefore last about τ/(1 − r). This is
//! exact for one contact, where r is the coefficient of restitution. Once this time is too short to
//! be resolved, the rates of all contacts of the group become zero together. This is done by the
//! smallest change of the velocities in the measure of the mass matrix, which never adds energy.
//!
//! If friction is too strong for the direction in which a contact slips, no forces are consistent,
//! and the contact jams. A jam is an impact without approach, after which friction holds.
//!
//! Sources: Brogliato, *Nonsmooth Mechanics*, 3rd ed., §5, §7; Génot, Brogliato, "New results on
//! Painlevé paradoxes", *European Journal of Mechanics A* 18 (1999) 653–677; Champneys, Várkonyi,
//! "The Painlevé paradox in contact mechanics", *IMA Journal of Applied Mathematics* 81 (2016)
//! 538–588.

use core::array;

use super::choice::{Choice, Rule};
use super::forces::reactions;
use super::initial_modes::{Position, holds};
use super::padding::filled;
use super::project::{energy, halt};
use super::reaction_forces::Balance;
use super::{ContactSystem, Mode, Terms};
use crate::scalar::{Number, Scalar};
use crate::system::{StepFailure, reach};
use crate::tolerance::{HOP, HOP_TIME};

/// Shortest duration of bounces that is resolved, relative to the time since the run started.
pub(super) const SHORT: f64 = 1e-9;

/// A system at a state.
pub(super) struct Instant<'a, M: ContactSystem<N, K>, const N: usize, const K: usize> {
    pub(super) system: &'a M,
    pub(super) t: M::Scalar,
    /// Time since the run started.
    pub(super) elapsed: M::Scalar,
    pub(super) q: M::Coordinates,
    pub(super) v: [M::Scalar; N],
}

/// The continuation of a motion.
pub(super) struct Resumed<S, const N: usize, const K: usize> {
    pub(super) velocities: [S; N],
    pub(super) modes: [Mode; K],
    /// Duration of the bounces that were summed.
    pub(super) rest: [S; K],
}

impl<M: ContactSystem<N, K>, const N: usize, const K: usize> Instant<'_, M, N, K> {
    pub(super) fn terms(&self, v: &[M::Scalar; N]) -> M::Terms {
        self.system.terms(self.t, &self.q, v)
    }

    /// Returns the gaps and rates that are zero at these velocities.
    pub(super) fn position(&self, terms: &Terms<M::Scalar, N, K>, v: &[M::Scalar; N]) -> Position<K> {
        Position::of(self.system, terms, [self.t, self.elapsed], (&self.q, v))
    }

    /// Returns the continuation from these velocities after an impact that made the rates
    /// `is_still` zero. `before` describes the velocities before the impact.
    pub(super) fn resume(
        &self,
        before: &Terms<M::Scalar, N, K>,
        mut velocities: [M::Scalar; N],
        is_touching: [bool; K],
        mut is_still: [bool; K],
    ) -> Result<Resumed<M::Scalar, N, K>, StepFailure<M::Scalar>> {
        let mut rest = [M::Scalar::ZERO; K];
        loop {
            let after = self.terms(&velocities);
            let mut position = self.position(&after, &velocities);
            position.is_touching = is_touching;
            for (is_slow, is_still) in position.is_still.iter_mut().zip(is_still) {
                *is_slow |= is_still;
            }
            let modes = self.settle(&mut velocities, &mut position, None)?;
            let after = self.terms(&velocities);
            let ending = self.ending(before, &after, &modes, &position);
            let is_held = array::from_fn(|k| holds(modes[k]) || is_still[k] || ending[k].is_some());
            halt(&after, &mut velocities, is_held);
            if ending.iter().all(Option::is_none) {
                return Ok(Resumed { velocities, modes, rest });
            }
            for (k, time) in ending.into_iter().enumerate() {
                is_still[k] |= holds(modes[k]) || time.is_some();
                rest[k] = time.unwrap_or(rest[k]);
            }
        }
    }

    /// Finds the contacts that leave but will soon be at rest, and the time until then.
    fn ending(
        &self,
        before: &Terms<M::Scalar, N, K>,
        after: &Terms<M::Scalar, N, K>,
        modes: &[Mode; K],
        position: &Position<K>,
    ) -> [Option<M::Scalar>; K] {
        let one = M::Scalar::ONE;
        let forces = reactions(after, modes);
        let balance = Balance::of_forces(after);
        let hops: [Option<Hop<M::Scalar>>; K] = array::from_fn(|k| {
            let is_elastic = before.rates[k] < M::Scalar::ZERO && before.restitutions[k] >= one;
            let leaves = position.is_touching[k] && !position.is_still[k] && !is_elastic;
            let hop = Hop { speed: after.rates[k], pull: -balance.rate(k, &forces) };
            (leaves && hop.returns()).then_some(hop)
        });
        let unresolved = HOP_TIME.part::<M::Scalar>();
        let limit = self.elapsed * M::Scalar::from_f64(SHORT).max(unresolved);
        let instant = unresolved * self.t.abs();
        let is_short = |k: usize| hops[k].as_ref().is_some_and(|hop| hop.time() <= limit.max(instant));
        let size = filled::<M, N>(&reach(self.system, self.t, &self.q, &self.q));
        let approached = |k: usize| position.is_touching[k] && before.rates[k] < M::Scalar::ZERO;
        let left = part_left(before, after, array::from_fn(|k| is_short(k) || approached(k)));
        array::from_fn(|k| {
            let hop = hops[k].as_ref()?;
            let time = if left < one { hop.time() / (one - left) } else { hop.time() };
            let is_resolved = !(left < one && (time <= limit || hop.time() <= instant));
            let is_low = hop.height() <= HOP.part::<M::Scalar>() * after.size_of(k, &size);
            (!is_resolved || is_low).then_some(time)
        })
    }

    /// Finds modes that fit together, after a jam if there are none. The mode of reaction `ended`
    /// has just ended.
    pub(super) fn settle(
        &self,
        v: &mut [M::Scalar; N],
        position: &mut Position<K>,
        ended: Option<(usize, Choice<M::Scalar>)>,
    ) -> Result<[Mode; K], StepFailure<M::Scalar>> {
        let (terms, modes) = (self.terms(v), self.system.modes());
        let settled = terms.settle(self.system, &modes, position, ended);
        let fits = match &settled {
            Ok(settled) => !ended.is_some_and(|(k, choice)| {
                choice == Choice::Only(Rule::Absent) && is_drawn_in(&terms, settled, k)
            }),
            Err(cause) => !matches!(cause, StepFailure::Stuck(_) | StepFailure::Painleve { .. }),
        };
        let is_pressed = array::from_fn(|k| position.is_touching[k] && position.is_still[k]);
        let Some(jam) = (!fits).then(|| terms.jam(v, &modes, &is_pressed)).flatten() else { return settled };
        *v = jam.velocities;
        for (is_still, stays) in position.is_still.iter_mut().zip(jam.is_still) {
            *is_still |= stays;
        }
        halt(&self.terms(v), v, jam.is_still);
        self.terms(v).settle(self.system, &modes, position, None)
    }
}

/// True if a contact that has opened would immediately close again.
fn is_drawn_in<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    modes: &[Mode; K],
    k: usize,
) -> bool {
    let (balance, forces) = (Balance::of_forces(terms), reactions(terms, modes));
    balance.rate(k, &forces) < -S::epsilon().sqrt() * balance.size(k, &forces)
}

/// Returns the square root of the fraction of the energy of approach in these contacts that remains
/// after an impact.
fn part_left<S: Scalar, const N: usize, const K: usize>(
    before: &Terms<S, N, K>,
    after: &Terms<S, N, K>,
    group: [bool; K],
) -> S {
    let (left, all) = (energy(after, group), energy(before, group));
    if all > S::ZERO { (left / all).sqrt() } else { S::ONE }
}

/// A hop of a body under a constant downward acceleration.
struct Hop<S> {
    speed: S,
    pull: S,
}

impl<S: Scalar> Hop<S> {
    fn returns(&self) -> bool {
        self.speed > S::ZERO && self.pull > S::ZERO
    }

    fn time(&self) -> S {
        (self.speed + self.speed) / self.pull
    }

    fn height(&self) -> S {
        self.speed * self.speed / (self.pull + self.pull)
    }
}
