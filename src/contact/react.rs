//! What happens where a mode ends.

use core::array;

use super::balance::{Balance, Rule, reactions};
use super::correct::{close, correct, halt, part};
use super::impact::Collision;
use super::start::{Position, holds};
use super::{Contact, ContactSystem, Friction, Happening, Impact, Mode, Terms};
use crate::event::{Answer, Reaction};
use crate::integrate::Cause;
use crate::scalar::Scalar;
use crate::system::{Reacted, join, split};

/// What the declared event of this index, which belongs to a reaction, does to the state at which it happened: an impact, a
/// contact that opens, friction that comes to hold or gives way. Nothing if it belongs to none.
///
/// Bounces whose series would end within 10⁻⁹ of the time that has passed, or whose height is near the rounding of the
/// gap, are taken together: the contact closes, and the time at which the series ends is told.
///
/// # Errors
/// If no impulses, or no forces after it, fit.
pub fn react<M, const N: usize, const K: usize>(
    system: &M,
    event: usize,
    t: M::Scalar,
    y: &M::State,
) -> Reacted<M>
where
    M: ContactSystem<N, K>,
{
    let modes = system.modes();
    let Some(k) = (0..K).find(|k| modes[*k] != Mode::Smooth && system.event_of(*k) == event) else {
        return Ok(Answer::new(Reaction::Continue));
    };
    let mut held = *y;
    correct(system, t, &mut held)?;
    let (q, v) = split::<M>(&held);
    let moment = Moment { system, t, q, v };
    match modes[k] {
        Mode::Contact(Contact::Open) => moment.hit(k),
        Mode::Contact(Contact::Closed) => moment.end(k, Rule::Absent),
        Mode::Friction(Friction::Sticks) => moment.give_way(k),
        Mode::Friction(_) => moment.stop(k),
        Mode::Smooth => Ok(Answer::new(Reaction::Continue)),
    }
}

/// A part of the time that has passed: what bounces take less than is not resolved.
const SHORT: f64 = 1e-9;
/// Hops are not resolved that are lower than this many roundings of the terms of the gap: how long they take would be rounding,
const ROUNDINGS: f64 = 256.0;
/// and times that are smaller than so many of the time.
const TIMES: f64 = 64.0;

/// A system at a state.
struct Moment<'a, M: ContactSystem<N, K>, const N: usize, const K: usize> {
    system: &'a M,
    t: M::Scalar,
    q: [M::Scalar; N],
    v: [M::Scalar; N],
}

impl<M: ContactSystem<N, K>, const N: usize, const K: usize> Moment<'_, M, N, K> {
    fn terms(&self, v: &[M::Scalar; N]) -> Terms<M::Scalar, N, K> {
        self.system.terms(self.t, &self.q, v)
    }

    /// The contact of this index touches.
    fn hit(mut self, k: usize) -> Reacted<M> {
        let modes = self.system.modes();
        let mut is_closed = modes.map(|mode| mode == Mode::Contact(Contact::Closed));
        is_closed[k] = true;
        close(self.system, self.t, &mut self.q, &self.v, is_closed)?;
        let mut terms = self.terms(&self.v);
        let mut position = Position::of(&terms, &modes, (self.t, &self.q, &self.v));
        for j in 0..K {
            position.is_touching[j] |= is_closed[j];
            if holds(modes[j]) {
                (position.is_still[j], terms.rates[j]) = (true, M::Scalar::ZERO);
            }
        }
        if position.is_still[k] || terms.rates[k] >= M::Scalar::ZERO {
            return self.graze(k, &terms, &position);
        }
        let (collision, rest, settled) = self.collide(&terms, position)?;
        let impact = Impact { impulse: collision.impulses[k], energy_loss: collision.energy_loss };
        let happening = match settled[k] {
            Mode::Contact(Contact::Closed) => Happening::Closed { at: self.t + rest[k], impact },
            _ => Happening::Impact(impact),
        };
        Ok(self.answer(settled, &collision.velocities, happening))
    }

    /// A contact that touches and does not approach: it closes if it is pressed. Else nothing happens, but that the body is put
    /// onto the side on which it was.
    fn graze(&self, k: usize, terms: &Terms<M::Scalar, N, K>, position: &Position<K>) -> Reacted<M> {
        let modes = self.system.modes();
        let settled = terms.settle(&modes, position, None)?;
        if settled == modes {
            let mut q = self.q;
            part(terms, &mut q, k);
            return Ok(Answer::new(Reaction::Replace(join::<M>(&q, &self.v))));
        }
        let none = Impact { impulse: M::Scalar::ZERO, energy_loss: M::Scalar::ZERO };
        let mut v = self.v;
        halt(terms, &mut v, settled.map(holds));
        Ok(self.answer(settled, &v, Happening::Closed { at: self.t, impact: none }))
    }

    /// The impact, with bounces that end soon taken together, how long they take, and the modes after it.
    fn collide(
        &self,
        terms: &Terms<M::Scalar, N, K>,
        Position { is_touching: touching, .. }: Position<K>,
    ) -> Result<Collided<M::Scalar, N, K>, Cause<M::Scalar>> {
        let modes = self.system.modes();
        let mut restitutions = restitutions(terms, &modes)?;
        let mut rest = [M::Scalar::ZERO; K];
        loop {
            let mut collision = terms.impact(&self.v, &modes, &touching, &restitutions)?;
            let after = self.terms(&collision.velocities);
            let mut position = Position::of(&after, &modes, (self.t, &self.q, &collision.velocities));
            position.is_touching = touching;
            for (is_still, stays) in position.is_still.iter_mut().zip(collision.is_still) {
                *is_still |= stays;
            }
            let settled = after.settle(&modes, &position, None)?;
            let soon = self.first_at_rest(terms, &restitutions, &after, &settled);
            let Some((j, time)) = soon.filter(|(j, _)| touching[*j]) else {
                let is_held = array::from_fn(|j| holds(settled[j]) || collision.is_still[j]);
                halt(&after, &mut collision.velocities, is_held);
                return Ok((collision, rest, settled));
            };
            (rest[j], restitutions[j]) = (time, M::Scalar::ZERO);
        }
    }

    /// The first of the contacts that were thrown back but will soon have come to rest, and when.
    fn first_at_rest(
        &self,
        before: &Terms<M::Scalar, N, K>,
        restitutions: &[M::Scalar; K],
        after: &Terms<M::Scalar, N, K>,
        settled: &[Mode; K],
    ) -> Option<(usize, M::Scalar)> {
        let zero = M::Scalar::ZERO;
        let forces = reactions(after, settled);
        let balance = Balance::of_forces(after);
        (0..K).find_map(|k| {
            let is_thrown_back = before.rates[k] * restitutions[k] < zero && after.rates[k] > zero;
            let pull = -balance.rate(k, &forces);
            let size = after.size_of(k, &self.q);
            let hops = Hops { speed: after.rates[k], pull, restitution: restitutions[k] };
            hops.rest(self.t, size).filter(|_| is_thrown_back).map(|time| (k, time))
        })
    }

    /// The force of a closed contact has fallen to zero.
    fn end(&self, k: usize, rule: Rule) -> Reacted<M> {
        let modes = self.system.modes();
        let terms = self.terms(&self.v);
        let settled = terms.settle(&modes, &self.held(&terms), Some((k, rule)))?;
        let happening = if rule == Rule::Absent { Happening::Opened } else { Happening::Slipped };
        Ok(self.answer(settled, &self.v, happening))
    }

    /// Friction that held has reached its limit: it slips against its force.
    fn give_way(&self, k: usize) -> Reacted<M> {
        let terms = self.terms(&self.v);
        let force = reactions(&terms, &self.system.modes())[k];
        self.end(k, if force < M::Scalar::ZERO { Rule::Forwards } else { Rule::Backwards })
    }

    /// Slipping has come to its end, or friction has got a limit.
    fn stop(mut self, k: usize) -> Reacted<M> {
        let modes = self.system.modes();
        let terms = self.terms(&self.v);
        let mut position = self.held(&terms);
        if modes[k] != Mode::Friction(Friction::Slips) {
            position.is_still[k] = true;
        }
        let mut is_held = modes.map(holds);
        is_held[k] = position.is_still[k];
        halt(&terms, &mut self.v, is_held);
        let terms = self.terms(&self.v);
        let settled = terms.settle(&modes, &position, None)?;
        let happening = match (modes[k], settled[k]) {
            (_, Mode::Friction(Friction::Sticks)) => Happening::Stuck,
            // What slips without friction and what slips with it pass into each other smoothly.
            (Mode::Friction(Friction::Slips), _) | (_, Mode::Friction(Friction::Slips)) => Happening::Zero,
            _ => Happening::Slipped,
        };
        Ok(self.answer(settled, &self.v, happening))
    }

    /// Which gaps and rates are zero, those that are held at zero among them.
    fn held(&self, terms: &Terms<M::Scalar, N, K>) -> Position<K> {
        let modes = self.system.modes();
        let mut position = Position::of(terms, &modes, (self.t, &self.q, &self.v));
        for k in (0..K).filter(|k| holds(modes[*k])) {
            (position.is_touching[k], position.is_still[k]) = (true, true);
        }
        position
    }

    fn answer(
        &self,
        modes: [Mode; K],
        v: &[M::Scalar; N],
        happening: Happening<M::Scalar>,
    ) -> Answer<M, M::Scalar, M::State> {
        let reaction = Reaction::Replace(join::<M>(&self.q, v));
        Answer { reaction, system: Some(self.system.in_modes(modes)), happening }
    }
}

/// Coefficients of restitution of contacts; zero for friction.
fn restitutions<S: Scalar, const N: usize, const K: usize>(
    terms: &Terms<S, N, K>,
    modes: &[Mode; K],
) -> Result<[S; K], Cause<S>> {
    let mut restitutions = [S::ZERO; K];
    for k in (0..K).filter(|k| matches!(modes[*k], Mode::Contact(_))) {
        restitutions[k] = terms.restitutions[k];
        if !(restitutions[k] >= S::ZERO && restitutions[k].is_finite()) {
            return Err(Cause::Setting(
                "a coefficient of restitution must not be negative and must be finite",
            ));
        }
    }
    Ok(restitutions)
}

/// An impact, how long bounces that were taken together last, and modes.
type Collided<S, const N: usize, const K: usize> = (Collision<S, N, K>, [S; K], [Mode; K]);

/// Hops of a body that is pulled back evenly: each lasts 2 v/a, and e times as long as the one before.
struct Hops<S> {
    speed: S,
    pull: S,
    restitution: S,
}

impl<S: Scalar> Hops<S> {
    /// When they have ended, if that is soon.
    fn rest(&self, t: S, size: S) -> Option<S> {
        let Hops { speed, pull, restitution } = *self;
        let is_pulled = pull > S::ZERO && restitution < S::ONE;
        let time = (speed + speed) / (pull * (S::ONE - restitution));
        let height = speed * speed / (pull + pull);
        let is_short = time <= t.abs() * S::from_f64(SHORT).max(S::from_f64(TIMES) * S::epsilon());
        let is_low = height <= S::from_f64(ROUNDINGS) * S::epsilon() * size;
        (is_pulled && (is_short || is_low)).then_some(time)
    }
}
