//! Transitions at the end of a mode.

use super::choice::{Choice, Rule};
use super::forces::{Forces, reactions};
use super::guards::nothing;
use super::initial_modes::{Position, holds};
use super::padding::{joined, parts};
use super::project::{close, correct, halt, part};
use super::reaction_forces::Balance;
use super::resume::{Instant, SHORT};
use super::slip::{is_planar, length, present_direction};
use super::{Contact, ContactSystem, Friction, Heading, Mode, Terms};
use crate::linalg::vector::dot;
use crate::scalar::Number;
use crate::system::{Action, EventKind, Impact, Reacted, Response};
use crate::tolerance::HOP_TIME;

/// Friction without a limit.
const FREE: Mode = Mode::Friction(Friction::Slips);

/// Applies the declared event with this index to its state: an impact, a contact that opens, or
/// friction that starts to stick or slip. `None` if the event does not belong to a reaction.
///
/// Bounces are summed if their series would end within 10⁻⁹ of the time `elapsed` since the run
/// started. They are also summed if their height or duration is close to the rounding of the gap or
/// of time. The contact closes, and the time at which the series ends is reported.
///
/// # Errors
/// If there are no impulses, or no forces after them. Also if a coefficient of restitution is not
/// from 0 to 1, or a limit of friction is negative.
pub fn react<M, const N: usize, const K: usize>(
    system: &M,
    event: usize,
    t: M::Scalar,
    elapsed: M::Scalar,
    y: &M::State,
) -> Reacted<M>
where
    M: ContactSystem<N, K>,
{
    let modes = system.modes();
    let Some(k) = (0..K).find(|k| system.event_of(*k) == Some(event)) else {
        return Ok(Response::new(Action::Continue));
    };
    let mut held = *y;
    correct(system, t, &mut held)?;
    let (q, v) = parts::<M, N>(&held);
    let instant = Instant { system, t, elapsed, q, v };
    let terms = instant.terms(&v);
    terms.check_limits(system, &modes, &terms.rows)?;
    match modes[k] {
        Mode::Contact(Contact::Open) => instant.hit(k),
        Mode::Contact(Contact::Closed) => instant.end(k, Choice::Only(Rule::Absent)),
        Mode::Friction(Friction::Sticks) => instant.give_way(k),
        Mode::Friction(_) => instant.stop(k),
        Mode::Across(_) | Mode::Smooth => Ok(Response::new(Action::Continue)),
    }
}

impl<M: ContactSystem<N, K>, const N: usize, const K: usize> Instant<'_, M, N, K> {
    /// Handles the contact of this index, which touches.
    fn hit(mut self, k: usize) -> Reacted<M> {
        let modes = self.system.modes();
        let mut is_closed = modes.map(|mode| mode == Mode::Contact(Contact::Closed));
        is_closed[k] = true;
        close(self.system, self.t, &mut self.q, &self.v, is_closed)?;
        let mut terms = self.terms(&self.v);
        let mut position = self.position(&terms, &self.v);
        for j in 0..K {
            position.is_touching[j] |= is_closed[j];
            if holds(modes[j]) {
                (position.is_still[j], terms.rates[j]) = (true, M::Scalar::ZERO);
            }
        }
        if position.is_still[k] || terms.rates[k] >= M::Scalar::ZERO {
            return self.graze(k, &terms, &position);
        }
        let restitutions = terms.restitutions(self.system, &modes, |j| position.is_touching[j])?;
        let collision = terms.impact(&self.v, &modes, &position.is_touching, &restitutions)?;
        let resumed = self.resume(&terms, collision.velocities, position.is_touching, collision.is_still)?;
        let impact = Impact { impulse: collision.impulses[k], energy_loss: collision.energy_loss };
        let kind = match resumed.modes[k] {
            Mode::Contact(Contact::Closed) => EventKind::Closed { at: self.t + resumed.rest[k], impact },
            _ => EventKind::Impact(impact),
        };
        Ok(self.answer(resumed.modes, &resumed.velocities, kind))
    }

    /// Handles a contact that touches and does not approach. It closes if it is pressed. Otherwise
    /// the body is only moved to the side on which it was.
    fn graze(&self, k: usize, terms: &Terms<M::Scalar, N, K>, position: &Position<K>) -> Reacted<M> {
        let modes = self.system.modes();
        let is_still = core::array::from_fn(|j| position.is_still[j] && (j == k || holds(modes[j])));
        let resumed = self.resume(terms, self.v, position.is_touching, is_still)?;
        // Directions of other friction may be new, but this is no event.
        if resumed.modes[k] == modes[k] {
            let mut q = self.q;
            let is_open = |j: usize| resumed.modes[j] == Mode::Contact(Contact::Open);
            let are_touching = core::array::from_fn(|j| is_open(j) && position.is_touching[j]);
            let are_closed = resumed.modes.map(|mode| mode == Mode::Contact(Contact::Closed));
            part(self.system, self.t, terms, &mut q, (are_touching, are_closed));
            let action = Action::Replace(joined(self.system, &q, &resumed.velocities));
            let system = (resumed.modes != modes).then(|| self.system.in_modes(resumed.modes));
            return Ok(Response { system, ..Response::new(action) });
        }
        let none = Impact { impulse: M::Scalar::ZERO, energy_loss: M::Scalar::ZERO };
        let at = self.t + resumed.rest[k];
        Ok(self.answer(resumed.modes, &resumed.velocities, EventKind::Closed { at, impact: none }))
    }

    /// Handles a force of a closed contact that has become zero, or friction that gives way.
    fn end(&self, k: usize, choice: Choice<M::Scalar>) -> Reacted<M> {
        let (mut v, terms) = (self.v, self.terms(&self.v));
        let settled = self.settle(&mut v, &mut self.held(&terms), Some((k, choice)))?;
        let kind = if choice == Choice::Only(Rule::Absent) { EventKind::Opened } else { EventKind::Slipped };
        Ok(self.answer(settled, &v, kind))
    }

    /// Handles sticking friction at its limit: it slips opposite to its force.
    fn give_way(&self, k: usize) -> Reacted<M> {
        let (terms, modes, one) = (self.terms(&self.v), self.system.modes(), M::Scalar::ONE);
        if is_planar(&modes, k) {
            return self.end(k, Choice::GiveWay);
        }
        let is_forwards = reactions(&terms, &modes)[k] < M::Scalar::ZERO;
        self.end(k, Choice::Only(Rule::Slips(if is_forwards { one } else { -one })))
    }

    /// Handles slipping that has ended, or friction that has obtained a limit.
    fn stop(mut self, k: usize) -> Reacted<M> {
        let modes = self.system.modes();
        let terms = self.terms(&self.v);
        if let Some(turned) = self.turn(k, &terms) {
            let system = Some(self.system.in_modes(turned));
            return Ok(Response { system, ..Response::new(Action::Continue) });
        }
        let mut is_held = modes.map(holds);
        is_held[k] =
            modes[k] != FREE || self.position(&terms, &self.v).is_still[k] && self.would_stick(k, &terms);
        for j in (0..K).filter(|&j| is_planar(&modes, j)) {
            is_held[j] |= is_held[k] && modes[j] != FREE && self.is_stopping(j, &terms);
            is_held[j + 1] |= is_held[j];
        }
        halt(&terms, &mut self.v, is_held);
        // The held rates may determine all velocities, and may not be zero yet. If rates are nearly
        // dependent, no small change of the velocities makes them zero.
        let halted = self.terms(&self.v);
        let mut position = self.held(&halted);
        for j in (0..K).filter(|&j| is_held[j] && !matches!(modes[j], Mode::Contact(_))) {
            position.is_still[j] |= !self.moves(j, &halted);
        }
        let mut v = self.v;
        let settled = self.settle(&mut v, &mut position, None)?;
        let kind = match (modes[k], settled[k]) {
            (_, Mode::Friction(Friction::Sticks)) => EventKind::Stuck,
            // Slipping without and with friction pass smoothly into each other.
            (Mode::Friction(Friction::Slips), _) | (_, Mode::Friction(Friction::Slips)) => EventKind::Zero,
            _ => EventKind::Slipped,
        };
        Ok(self.answer(settled, &v, kind))
    }

    /// True if friction k, which had no limit so far, has one where its slip velocity is zero.
    /// Otherwise it would be stopped again and again.
    fn would_stick(&self, k: usize, terms: &Terms<M::Scalar, N, K>) -> bool {
        let (mut v, modes) = (self.v, self.system.modes());
        halt(terms, &mut v, core::array::from_fn(|j| j == k || j == k + 1 && is_planar(&modes, k)));
        let halted = self.terms(&v);
        Balance::of_forces(&halted).fixed(k, &reactions(&halted, &modes)) > nothing()
    }

    /// Returns the modes with friction k in its present direction, if it acts in a plane and is not
    /// about to stop. Friction that gives way with it gets its direction at half of the required
    /// speed.
    fn turn(&self, k: usize, terms: &Terms<M::Scalar, N, K>) -> Option<[Mode; K]> {
        let modes = self.system.modes();
        if !is_planar(&modes, k) || modes[k] == FREE || self.is_stopping(k, terms) {
            return None;
        }
        let is_starting = matches!(modes[k], Mode::Friction(Friction::GivesWay(_)));
        let half = M::Scalar::from_f64(0.5);
        let mut turned = modes;
        for j in 0..K {
            let is_fast = match modes[j] {
                Mode::Friction(Friction::GivesWay(pace)) => {
                    is_starting && length(&terms.slip(j, true)) >= half * pace.value::<M::Scalar>()
                }
                _ => false,
            };
            if j == k || is_fast {
                let heading = Heading::new(present_direction(terms.slip(j, true))?);
                let pace = terms.pace(j, [self.t, self.elapsed], &self.v);
                turned[j] = Mode::Friction(Friction::SlipsTowards(heading, pace));
            }
        }
        Some(turned)
    }

    /// True if friction k, which acts in a plane, would stop within a time that is not resolved.
    fn is_stopping(&self, k: usize, terms: &Terms<M::Scalar, N, K>) -> bool {
        let modes = self.system.modes();
        let found = Forces::under(terms, &modes);
        let forces = found.reactions;
        let (slip, noise) = (terms.slip(k, true), terms.slip_noise(k, self.t, &self.v));
        match modes[k] {
            Mode::Friction(Friction::GivesWay(_)) => {
                let advance = -dot(&slip, &[forces[k], forces[k + 1]]);
                return advance <= noise * length(&[forces[k], forces[k + 1]]);
            }
            Mode::Friction(Friction::SlipsTowards(_, pace))
                if length(&slip) <= M::Scalar::from_f64(0.5) * pace.value::<M::Scalar>() + noise
                    && found.lingers(terms, k) =>
            {
                return true;
            }
            _ => {}
        }
        let instant = HOP_TIME.part::<M::Scalar>() * self.t.abs();
        let time = (M::Scalar::from_f64(SHORT) * self.elapsed).max(instant);
        let slowing = [k, k + 1].map(|row| terms.acceleration_under(row, &forces));
        length(&slip) <= length(&slowing) * time + noise
    }

    /// True if the slip velocity of friction j, or of its other component, is more than rounding.
    fn moves(&self, j: usize, terms: &Terms<M::Scalar, N, K>) -> bool {
        let modes = self.system.modes();
        let first = if matches!(modes[j], Mode::Across(_)) { j - 1 } else { j };
        let noise = terms.slip_noise(j, self.t, &self.v);
        length(&terms.slip(first, is_planar(&modes, first))) > noise
    }

    /// Returns the gaps and rates that are zero, including those that are held at zero.
    fn held(&self, terms: &Terms<M::Scalar, N, K>) -> Position<K> {
        let modes = self.system.modes();
        let mut position = self.position(terms, &self.v);
        for k in (0..K).filter(|k| holds(modes[*k])) {
            (position.is_touching[k], position.is_still[k]) = (true, true);
        }
        position
    }

    fn answer(
        &self,
        modes: [Mode; K],
        v: &[M::Scalar; N],
        kind: EventKind<M::Scalar>,
    ) -> Response<M, M::Scalar, M::State> {
        let action = Action::Replace(joined(self.system, &self.q, v));
        Response { action, system: Some(self.system.in_modes(modes)), kind }
    }
}
