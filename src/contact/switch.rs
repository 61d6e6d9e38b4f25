//! When modes switch.

use super::balance::{Balance, reactions};
use super::{Contact, ContactSystem, Friction, Mode, Terms};
use crate::scalar::Scalar;
use crate::system::split;

/// Friction whose limit is smaller than this is none.
pub(super) fn nothing<S: Scalar>() -> S {
    S::epsilon() * S::epsilon()
}

/// A function for each reaction that is positive while its mode may last and falls through zero where it ends: the gap of an open
/// contact, the force of a closed one, the slip velocity in the direction of slipping, and what is left to the static
/// limit while friction sticks.
pub fn switch_values<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    modes: &[Mode; K],
) -> [S; K] {
    let reactions = reactions(terms, modes);
    let balance = Balance::of_forces(terms);
    let mut values = [S::ONE; K];
    for k in 0..K {
        values[k] = match modes[k] {
            Mode::Contact(Contact::Open) => terms.gaps[k],
            Mode::Contact(Contact::Closed) => reactions[k],
            Mode::Friction(Friction::SlipsForwards) => terms.rates[k],
            Mode::Friction(Friction::SlipsBackwards) => -terms.rates[k],
            Mode::Friction(Friction::Sticks) => balance.fixed(k, &reactions) - reactions[k].abs(),
            Mode::Friction(Friction::Slips) => nothing::<S>() - balance.fixed(k, &reactions),
            Mode::Smooth => S::ONE,
        };
    }
    values
}

/// Writes [`switch_values`] of the state to the places of the declared events that belong to reactions.
///
/// # Panics
/// If `values` has no place for one of them.
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
    let found = switch_values(&system.terms(t, &q, &v), &modes);
    for k in (0..K).filter(|k| modes[*k] != Mode::Smooth) {
        values[system.event_of(k)] = found[k];
    }
}
