//! When modes switch.

use core::array;

use super::reaction_forces::{Balance, Rule};
use super::{Contact, ContactSystem, Friction, Mode, Terms};
use crate::constraint::sizes;
use crate::scalar::{Number, Scalar};
use crate::system::split;
use crate::tolerance::BOUND;

/// Friction whose limit is smaller than this does not act.
pub(super) fn nothing<S: Scalar>() -> S {
    S::epsilon() * S::epsilon()
}

/// Computes a function for each reaction that is positive while its mode may last and falls through
/// zero where it ends:
/// - the gap of an open contact;
/// - the force of a closed contact;
/// - the slip velocity of slipping friction, in the direction of slipping;
/// - the margin of sticking friction to the static limit.
///
/// Functions of forces fall through zero a few roundings later than the forces do.
pub fn switch_values<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    modes: &[Mode; K],
) -> [S; K] {
    let rules = terms.rules(modes);
    let balance = Balance::of_active(terms, &rules.unwrap_or([Rule::Absent; K]));
    let reactions = rules.map_or([S::NAN; K], |rules| balance.reactions(&rules));
    let rounding = |k: usize| match balance.response(k) {
        response if response > S::ZERO => BOUND.part::<S>() * balance.size(k, &reactions) / response,
        _ => S::ZERO,
    };
    let value = |k: usize| match modes[k] {
        Mode::Contact(Contact::Open) => terms.gaps[k],
        Mode::Contact(Contact::Closed) => reactions[k] + rounding(k),
        Mode::Friction(Friction::SlipsForwards) => terms.rates[k],
        Mode::Friction(Friction::SlipsBackwards) => -terms.rates[k],
        Mode::Friction(Friction::Sticks) => balance.fixed(k, &reactions) + rounding(k) - reactions[k].abs(),
        Mode::Friction(Friction::Slips) => nothing::<S>() - balance.fixed(k, &reactions),
        Mode::Smooth => S::ONE,
    };
    array::from_fn(value)
}

/// Writes [`switch_values`] of the state to the places of the declared events that belong to
/// reactions.
///
/// Slip velocities count as positive down to their rounding error. Friction may be at its limit
/// where other contacts hold its slip velocity, as that of a block pushed against a wall. It would
/// otherwise end in every step.
///
/// # Panics
/// If `values` has no position for one of them.
pub fn event_values<M, const N: usize, const K: usize>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
    values: &mut [M::Scalar],
) where
    M: ContactSystem<N, K>,
{
    let (q, v) = split::<M>(y);
    let modes = system.modes();
    let terms = system.terms(t, &q, &v);
    let found = switch_values(&terms, &modes);
    for k in (0..K).filter(|k| modes[*k] != Mode::Smooth) {
        let is_slipping =
            matches!(modes[k], Mode::Friction(Friction::SlipsForwards | Friction::SlipsBackwards));
        let noise = if is_slipping { terms.slip_noise(k, t, &v) } else { M::Scalar::ZERO };
        values[system.event_of(k)] = found[k] + noise;
    }
}

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Bounds the rounding error of slip velocity k where it is held at zero: from the velocities,
    /// and from accelerations in the elapsed time.
    fn slip_noise(&self, k: usize, t: S, v: &[S; N]) -> S {
        let size = self.size_of(k, &sizes(v)) + self.acceleration_of(k) * t.abs();
        BOUND.part::<S>() * size
    }

    /// Returns the size of the terms in the rate of rate k without reactions.
    pub(super) fn acceleration_of(&self, k: usize) -> S {
        self.size_of(k, &self.free) + self.drifts[k].abs()
    }

    /// Returns the size of the terms in the rate of rate k under these reactions; reactions that
    /// are not finite are ignored.
    pub(super) fn acceleration_under(&self, k: usize, reactions: &[S; K]) -> S {
        let parts = self.responses.iter().zip(reactions).filter(|(_, reaction)| reaction.is_finite());
        parts.fold(self.acceleration_of(k), |sum, (response, reaction)| {
            sum + (self.size_of(k, response) * *reaction).abs()
        })
    }
}
