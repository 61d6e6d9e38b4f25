//! Times at which a step ends and a new one starts.
//!
//! If a right-hand side or its derivatives jump at a known time, it is integrated up to that time
//! and then from there. The methods are not involved: each step is limited, and the method
//! restarted from the state reached. A system with fixed sides continues from exactly that time, on
//! another side. Otherwise steps end two roundings of time before the jump and start two after it.
//! Every evaluation then lies on one side of the jump, whichever side its definition assigns the
//! instant to.

use crate::integrate::Stepper;
use crate::scalar::Scalar;
use crate::system::{OdeSystem, StepFailure};
use crate::tolerance::{RESTART, Roundings};

/// Restarts of a run: at specified times, and at those provided by the system.
#[derive(Clone, Copy, Debug)]
pub struct Restarts<'a, S> {
    end: S,
    is_backwards: bool,
    /// Specified times, in the order of the run.
    given: &'a [S],
    /// The restart at which the last step ended, if any.
    due: Option<Restart<S>>,
}

/// A time of restart with the end of the step before it and the start of the step after it.
#[derive(Clone, Copy, Debug)]
struct Restart<S> {
    before: S,
    at: S,
    after: S,
}

impl<'a, S: Scalar> Restarts<'a, S> {
    /// Returns the restarts of a run between these times, with the `given` times in the order of
    /// the run.
    pub fn new(start: S, end: S, given: &'a [S]) -> Self {
        Restarts { end, is_backwards: end < start, given, due: None }
    }

    /// Restarts the method before a step, if a restart is due. Returns the system for the
    /// continuation, if it differs.
    ///
    /// # Errors
    /// As [`Stepper::restart`].
    pub fn resume<M>(&self, system: &M, stepper: &mut impl Stepper<M>) -> Result<Option<M>, StepFailure<S>>
    where
        M: OdeSystem<Scalar = S>,
    {
        let Some(restart) = self.due_at(stepper.time()) else { return Ok(None) };
        let (other, state) = (system.beyond(restart.at, self.end), *stepper.state());
        stepper.restart(other.as_ref().unwrap_or(system), restart.after, &state)?;
        Ok(other)
    }

    /// Takes one step towards the end, at most to the next restart; `instant` is an additional one.
    ///
    /// States within the last step are available until the next one is taken. `is_of_interest` is
    /// true if states between two times will be requested. Such a step is repeated, shorter, until
    /// these states are as accurate as its end.
    ///
    /// # Errors
    /// As [`Stepper::step`].
    pub fn step<M>(
        &mut self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        instant: Option<S>,
        is_of_interest: impl Fn(S, S) -> bool,
    ) -> Result<(), StepFailure<S>>
    where
        M: OdeSystem<Scalar = S>,
    {
        self.due = self.next(system, stepper.time(), instant);
        let limit = self.due.map_or(self.end, |restart| restart.before);
        loop {
            stepper.step(system, limit)?;
            let is_asked = is_of_interest(stepper.last_time(), stepper.time());
            if !is_asked || stepper.confirm(system) {
                return Ok(());
            }
        }
    }

    /// Returns the time reached: the time of the restart if the last step ended at one.
    pub fn time<M>(&self, stepper: &impl Stepper<M>) -> S
    where
        M: OdeSystem<Scalar = S>,
    {
        self.due_at(stepper.time()).map_or(stepper.time(), |restart| restart.at)
    }

    /// Returns the time from which the motion continues: just after the restart if the last step
    /// ended at one.
    pub fn beyond<M>(&self, stepper: &impl Stepper<M>) -> S
    where
        M: OdeSystem<Scalar = S>,
    {
        self.due_at(stepper.time()).map_or(stepper.time(), |restart| restart.after)
    }

    /// True if the last step ended at a restart, so that [`resume`](Self::resume) restarts the
    /// method.
    pub fn is_due<M>(&self, stepper: &impl Stepper<M>) -> bool
    where
        M: OdeSystem<Scalar = S>,
    {
        self.due_at(stepper.time()).is_some()
    }

    /// Returns the restart that is due at this time.
    fn due_at(&self, t: S) -> Option<Restart<S>> {
        self.due.filter(|restart| restart.before == t)
    }

    /// Returns the first restart after `t`: a given time, one that the system provides, or an
    /// instant.
    fn next<M: OdeSystem<Scalar = S>>(&self, system: &M, t: S, instant: Option<S>) -> Option<Restart<S>> {
        let past = self.given.partition_point(|time| !self.is_ahead(t, *time));
        let given = self.given[past..].iter().find_map(|time| self.between(t, *time, RESTART));
        let instant = instant.and_then(|time| self.between(t, time, Roundings::NONE));
        let known = self.first(given, self.provided(system, t));
        match (known, instant) {
            (Some(known), Some(instant)) if self.is_ahead(instant.at, known.before) => Some(instant),
            (None, instant) => instant,
            (known, _) => known,
        }
    }

    /// Returns the first restart after `t` that the system provides.
    fn provided<M: OdeSystem<Scalar = S>>(&self, system: &M, t: S) -> Option<Restart<S>> {
        let after = |from: S| {
            let time = system.next_restart(from, self.end)?;
            let is_exact = system.beyond(time, self.end).is_some() || system.is_tick(time);
            self.between(t, time, if is_exact { Roundings::NONE } else { RESTART })
        };
        let first = after(t)?;
        self.first(Some(first), after(first.at))
    }

    /// Returns the first of two restarts, or both as one if only rounding separates them. A clock
    /// then ticks within it, as at 3 · 0.1 for a restart at 0.3.
    fn first(&self, one: Option<Restart<S>>, other: Option<Restart<S>>) -> Option<Restart<S>> {
        let (Some(one), Some(other)) = (one, other) else { return one.or(other) };
        let (first, second) = if self.is_ahead(other.at, one.at) { (other, one) } else { (one, other) };
        if self.is_ahead(first.after, second.before) {
            return Some(first);
        }
        let exact = if second.before == second.after { second } else { first };
        let before = if self.is_ahead(second.before, first.before) { second.before } else { first.before };
        let after = if self.is_ahead(first.after, second.after) { second.after } else { first.after };
        Some(Restart { before, at: exact.at, after })
    }

    /// Returns a restart at `at` on the way from `t`, with this many roundings of time on both
    /// sides. `None` also if there is no room for steps.
    fn between(&self, t: S, at: S, roundings: Roundings) -> Option<Restart<S>> {
        let rounding = roundings.part::<S>() * t.abs().max(at.abs());
        let gap = if self.is_backwards { -rounding } else { rounding };
        let restart = Restart { before: at - gap, at, after: at + gap };
        let has_room = self.is_ahead(t, restart.before) && self.is_ahead(restart.after, self.end);
        has_room.then_some(restart)
    }

    /// True if `later` comes after `time` in the run; false if either is NaN.
    fn is_ahead(&self, time: S, later: S) -> bool {
        if self.is_backwards { later < time } else { time < later }
    }
}

#[cfg(test)]
mod tests;
