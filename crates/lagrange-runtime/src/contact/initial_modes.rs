//! Modes that fit a state.

use core::array;

use super::choice::{Choice, Rule};
use super::forces::Forces;
use super::forces::reactions;
use super::guards::nothing;
use super::pace::Pace;
use super::padding::{filled, parts};
use super::reaction_forces::Balance;
use super::slip::{is_planar, present_direction};
use super::{Contact, ContactSystem, Friction, Heading, Mode, Terms};
use crate::constraint::sizes;
use crate::linalg::vector::dot;
use crate::scalar::{Number, Scalar};
use crate::system::{SettingError, StateVector, StepFailure, Violation, reach};
use crate::tolerance::{INSTANT, TOUCHING};

/// Returns the system for a motion that starts from this state. Contacts that touch and press are
/// closed. Friction at rest sticks if it can, and otherwise slips in the direction of the load.
/// `None` if the system already has these modes.
///
/// A contact that touches and approaches stays open: its impact follows immediately.
///
/// # Errors
/// If any of these holds:
/// - the system [needs steps](ContactSystem::NEEDS_STEPS);
/// - a gap or a limit of friction is negative;
/// - a value is not finite;
/// - no modes fit.
pub fn begin<M, const N: usize, const K: usize>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
) -> Result<Option<M>, StepFailure<M::Scalar>>
where
    M: ContactSystem<N, K>,
{
    if let Some(reason) = system.needs_steps() {
        return Err(SettingError::Invalid(reason).into());
    }
    let (q, v) = parts::<M, N>(y);
    let (terms, modes) = (system.terms(t, &q, &v), system.modes());
    let is_finite = |values: &[M::Scalar; K]| values.iter().all(|value| value.is_finite());
    if !(is_finite(&terms.gaps) && is_finite(&terms.rates)) {
        return Err(terms.not_finite(system, t, &q));
    }
    terms.check_limits(system, &modes, &terms.rows)?;
    let mut position = Position::of(system, &terms, [t, M::Scalar::ZERO], (&q, &v));
    for k in (0..K).filter(|k| system.gradient_jumps(*k)) {
        if position.is_beyond[k] && terms.is_flat(system, k, t, &q) {
            (position.is_beyond[k], position.is_touching[k]) = (false, true);
        }
    }
    if let Some(k) = position.is_beyond.iter().position(|is_beyond| *is_beyond) {
        return Err(StepFailure::Violated(Violation::of_gap(system.reaction_name(k), terms.gaps[k])));
    }
    let settled = terms.settle(system, &modes, &position, None)?;
    Ok((settled != modes).then(|| system.in_modes(settled)))
}

/// The gaps and rates that are zero.
pub(super) struct Position<const K: usize> {
    pub(super) is_touching: [bool; K],
    /// True for each gap at which bodies overlap by more than rounding.
    is_beyond: [bool; K],
    pub(super) is_still: [bool; K],
    /// Speeds from which friction in a plane that gives way in this state has a direction.
    paces: [Pace; K],
}

impl<const K: usize> Position<K> {
    /// Judges the state by rounding, after the time `elapsed` in a run. For contacts and friction
    /// that already hold, half of the digits must agree.
    pub(super) fn of<M: ContactSystem<N, K>, const N: usize>(
        system: &M,
        terms: &Terms<M::Scalar, N, K>,
        [t, elapsed]: [M::Scalar; 2],
        (q, v): (&M::Coordinates, &[M::Scalar; N]),
    ) -> Self {
        let (modes, rounding) = (system.modes(), TOUCHING.part::<M::Scalar>());
        let share = |k: usize| if holds(modes[k]) { M::Scalar::epsilon().sqrt() } else { rounding };
        let [own, lengths] = [*q, lengths(q)].map(|by| filled::<M, N>(&reach(system, t, q, &by)));
        let (speeds, forces) = (sizes(v), reactions(terms, &modes));
        let delay = (rounding * elapsed).max(INSTANT.part::<M::Scalar>() * t.abs());
        let near: [M::Scalar; K] = array::from_fn(|k| {
            let size = rounding * terms.size_of(k, &lengths) + terms.speed_of(k, v) * delay;
            share(k) * terms.size_of(k, &own) + size
        });
        let slow: [M::Scalar; K] = array::from_fn(|k| {
            let size = rounding * terms.size_of(k, &speeds) + terms.acceleration_under(k, &forces) * delay;
            share(k) * terms.speed_of(k, v) + size
        });
        let is_contact = |k: usize| matches!(modes[k], Mode::Contact(_));
        let is_slow = |k: usize| terms.rates[k].abs() <= slow[k];
        let is_still = |k: usize| match modes[k] {
            Mode::Across(_) => is_slow(k) && is_slow(k - 1),
            _ => is_slow(k) && (!is_planar(&modes, k) || is_slow(k + 1)),
        };
        Position {
            is_touching: array::from_fn(|k| is_contact(k) && terms.gaps[k].abs() <= near[k]),
            is_beyond: array::from_fn(|k| is_contact(k) && terms.gaps[k] < -near[k]),
            is_still: array::from_fn(is_still),
            paces: array::from_fn(|k| match is_planar(&modes, k) {
                true => terms.pace(k, [t, elapsed], v),
                false => Pace::ZERO,
            }),
        }
    }
}

/// Returns the length scales of coordinates for judging gaps. If all coordinates are zero, the unit
/// length is the only scale, as in the tolerances of methods.
pub(super) fn lengths<S: Scalar, Q: StateVector<S>>(q: &Q) -> Q {
    if q.as_ref().iter().any(|entry| *entry != S::ZERO) {
        return sizes(q);
    }
    let mut ones = *q;
    ones.as_mut().fill(S::ONE);
    ones
}

/// True if this mode keeps a rate at zero.
pub(super) fn holds(mode: Mode) -> bool {
    matches!(
        mode,
        Mode::Contact(Contact::Closed) | Mode::Friction(Friction::Sticks) | Mode::Across(Friction::Sticks)
    )
}

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Returns the size of the terms of rate k, including those from a motion of the surroundings.
    pub(super) fn speed_of(&self, k: usize, v: &[S; N]) -> S {
        let own = dot(&self.rows[k], v);
        self.size_of(k, v) + (self.rates[k] - own).abs()
    }

    /// Finds modes that fit together if the gaps and rates that are zero are known. The mode of
    /// reaction `ended` has just ended, which leaves these choices for it.
    ///
    /// # Errors
    /// If there are none, or if something is not finite.
    pub(super) fn settle<M>(
        &self,
        system: &M,
        modes: &[Mode; K],
        position: &Position<K>,
        ended: Option<(usize, Choice<S>)>,
    ) -> Result<[Mode; K], StepFailure<S>>
    where
        M: ContactSystem<N, K, Scalar = S>,
    {
        let mut choices = [Choice::Only(Rule::Smooth); K];
        let giving_way =
            ended.filter(|(_, choice)| *choice == Choice::GiveWay).map(|_| Forces::under(self, modes));
        for k in 0..K {
            choices[k] = match modes[k] {
                Mode::Smooth => Choice::Only(Rule::Smooth),
                Mode::Across(_) => continue,
                _ if ended.is_some_and(|(ended, _)| ended == k) => {
                    ended.map_or(Choice::Only(Rule::Absent), |(_, choice)| choice)
                }
                Mode::Contact(_) if position.is_touching[k] && position.is_still[k] => Choice::Touch,
                Mode::Contact(_) => Choice::Only(Rule::Absent),
                Mode::Friction(_) if giving_way.as_ref().is_some_and(|forces| forces.gives_way(modes, k)) => {
                    Choice::GiveWay
                }
                Mode::Friction(_) if position.is_still[k] => Choice::Rest,
                Mode::Friction(_) => {
                    let slip = self.slip(k, is_planar(modes, k));
                    let rules = Rule::slipping(present_direction(slip)).map(Choice::Only);
                    if is_planar(modes, k) {
                        choices[k + 1] = rules[1];
                    }
                    rules[0]
                }
            };
            if is_planar(modes, k) && !matches!(choices[k], Choice::Only(_)) {
                choices[k + 1] = Choice::Across;
            }
        }
        let balance = Balance::of_forces(self);
        if !balance.is_finite() {
            return Err(StepFailure::NotFinite);
        }
        let Some(settled) = balance.settle(&choices) else {
            return Err(self.inconsistent(system, modes, [&position.is_touching, &position.is_still]));
        };
        let mut result = *modes;
        for k in 0..K {
            let is_limited = balance.fixed(k, &settled.reactions) > nothing();
            let is_at_rest = choices.get(k + 1) == Some(&Choice::Across);
            result[k] = match (modes[k], settled.rules[k]) {
                (Mode::Across(_), _) => across(result.get(k - 1)),
                (Mode::Friction(_), Rule::Slips(_)) if is_limited && is_at_rest => {
                    Mode::Friction(Friction::GivesWay(position.paces[k]))
                }
                (Mode::Friction(_), Rule::Slips(along)) if is_limited && is_planar(modes, k) => {
                    let across =
                        if let Rule::Slips(across) = settled.rules[k + 1] { across } else { S::ZERO };
                    let heading = Heading::new([along, across]);
                    Mode::Friction(Friction::SlipsTowards(heading, position.paces[k]))
                }
                (kind, rule) => mode(kind, rule, is_limited),
            };
        }
        Ok(result)
    }
}

/// Returns the mode of a second component.
fn across(first: Option<&Mode>) -> Mode {
    match first {
        Some(Mode::Friction(first)) => Mode::Across(*first),
        _ => Mode::Across(Friction::Slips),
    }
}

/// Returns the mode with this rule. Friction without a limit slips.
fn mode<S: Scalar>(kind: Mode, rule: Rule<S>, is_limited: bool) -> Mode {
    match (kind, rule) {
        (Mode::Smooth | Mode::Across(_), _) => kind,
        (Mode::Contact(_), Rule::Holds) => Mode::Contact(Contact::Closed),
        (Mode::Contact(_), _) => Mode::Contact(Contact::Open),
        (Mode::Friction(_), Rule::Holds) if is_limited => Mode::Friction(Friction::Sticks),
        (Mode::Friction(_), Rule::Slips(along)) if is_limited && along > S::ZERO => {
            Mode::Friction(Friction::SlipsForwards)
        }
        (Mode::Friction(_), Rule::Slips(_)) if is_limited => Mode::Friction(Friction::SlipsBackwards),
        (Mode::Friction(_), _) => Mode::Friction(Friction::Slips),
    }
}
