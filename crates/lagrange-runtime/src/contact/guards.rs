//! Functions whose zeros end the modes of contacts and friction.

use core::array;

use super::forces::Forces;
use super::pace::Pace;
use super::padding::parts;
use super::slip::{is_planar, length, present_direction};
use super::{Contact, ContactSystem, Friction, Mode, Terms};
use crate::constraint::sizes;
use crate::linalg::vector::dot;
use crate::scalar::{Number, Scalar};
use crate::tolerance::BOUND;

/// Fraction of the pace (the speed from which slipping has a direction) by which friction that
/// gives way may move backwards. On redundant supports, forces at their limits are less accurate
/// than rounding.
const SLACK: f64 = 1e-3;

/// Returns the limit below which friction is ignored.
pub(super) fn nothing<S: Scalar>() -> S {
    S::epsilon() * S::epsilon()
}

/// Computes a function for each reaction that is positive while its mode lasts and falls through
/// zero where it ends:
/// - the gap of an open contact;
/// - the force of a closed contact;
/// - the slip velocity of slipping friction, in the direction of slipping;
/// - the margin of sticking friction to the static limit.
///
/// Slipping in a plane also ends where its direction has turned by 60°, and restarts in its current
/// direction. It also ends if it remains slow: the slower it is, the faster its direction would
/// turn. Functions of forces fall through zero a few rounding errors later than the forces do.
pub fn switch_values<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    modes: &[Mode; K],
) -> [S; K] {
    let forces = Forces::under(terms, modes);
    let reactions = &forces.reactions;
    let value = |k: usize| match modes[k] {
        // A separating contact does not close: right after it has opened, its gap within a step may
        // be negative by the error of the method.
        Mode::Contact(Contact::Open) if terms.rates[k] > S::ZERO => terms.gaps[k].abs(),
        Mode::Contact(Contact::Open) => terms.gaps[k],
        Mode::Contact(Contact::Closed) | Mode::Friction(Friction::Sticks) => forces.margin(modes, k),
        Mode::Friction(Friction::Slips) => nothing::<S>() - forces.balance.fixed(k, reactions),
        Mode::Friction(Friction::GivesWay(_)) => match present_direction([reactions[k], reactions[k + 1]]) {
            Some(direction) => -dot(&terms.slip(k, true), &direction),
            None => S::ZERO,
        },
        Mode::Friction(Friction::SlipsTowards(heading, pace)) if forces.lingers(terms, k) => {
            let advance = terms.advance(k, true, Friction::SlipsTowards(heading, pace));
            advance.min(length(&terms.slip(k, true)) - S::from_f64(0.5) * pace.value::<S>())
        }
        Mode::Friction(friction) => terms.advance(k, is_planar(modes, k), friction),
        Mode::Across(_) | Mode::Smooth => S::ONE,
    };
    array::from_fn(value)
}

/// Writes [`switch_values`] of the state to the entries of the declared events that belong to
/// reactions.
///
/// Slip velocities count as positive down to their rounding error. Friction may be at its limit
/// while other contacts keep its slip velocity at zero, as for a block pushed against a wall. It
/// would otherwise end in every step.
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
    let (q, v) = parts::<M, N>(y);
    let modes = system.modes();
    let terms = system.terms(t, &q, &v);
    let found = switch_values(&terms, &modes);
    for k in 0..K {
        let Some(event) = system.event_of(k) else { continue };
        let has_direction = |friction| !matches!(friction, Friction::Slips | Friction::Sticks);
        let is_slipping = matches!(modes[k], Mode::Friction(friction) if has_direction(friction));
        let noise = if is_slipping { terms.slip_noise(k, t, &v) } else { M::Scalar::ZERO };
        let value = found[k] + noise;
        values[event] = match modes[k] {
            Mode::Friction(Friction::GivesWay(pace)) => {
                let slack = M::Scalar::from_f64(SLACK) * pace.value::<M::Scalar>();
                (value + slack).min(terms.pace_margin(k, pace))
            }
            _ => value,
        };
    }
}

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Bounds the rounding error of slip velocity k while it is kept at zero.
    pub(super) fn slip_noise(&self, k: usize, t: S, v: &[S; N]) -> S {
        BOUND.part::<S>() * self.slip_terms(k, t, v)
    }

    /// Returns the size of the terms of slip velocity k: those of the velocities, and those of the
    /// accelerations times `time`.
    fn slip_terms(&self, k: usize, time: S, v: &[S; N]) -> S {
        self.size_of(k, &sizes(v)) + self.acceleration_of(k) * time.abs()
    }

    /// Returns the speed from which friction k in a plane has a direction. It gives way at time
    /// `t`, which is `elapsed` after the start of the run.
    pub(super) fn pace(&self, k: usize, [t, elapsed]: [S; 2], v: &[S; N]) -> Pace {
        let of = |size: &dyn Fn(usize) -> S| length(&[size(k), size(k + 1)]);
        Pace::of_slip(of(&|row| self.slip_terms(row, elapsed, v)), of(&|row| self.slip_noise(row, t, v)))
    }

    /// Returns the pace minus the current slip speed.
    fn pace_margin(&self, k: usize, pace: Pace) -> S {
        pace.value::<S>() - length(&self.slip(k, true))
    }

    /// Returns the slip velocity in the direction of slipping, minus half of its magnitude in a
    /// plane, where it may turn.
    fn advance(&self, k: usize, is_planar: bool, friction: Friction) -> S {
        let [x, y] = self.slip(k, is_planar);
        let along = match friction {
            Friction::SlipsBackwards => -x,
            Friction::SlipsTowards(heading, _) => {
                let [cos, sin] = heading.components::<S>();
                x * cos + y * sin
            }
            Friction::Slips | Friction::SlipsForwards | Friction::GivesWay(_) | Friction::Sticks => x,
        };
        if is_planar { along - S::from_f64(0.5) * length(&[x, y]) } else { along }
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
