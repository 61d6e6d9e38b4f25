//! Times at which a step ends and a new one starts.
//!
//! A right-hand side that jumps at a known time, or whose derivatives do, is integrated up to that
//! time and from there on. The methods themselves know nothing of it: each step is limited, and the
//! method restarted from the state that it reached. A system with fixed sides continues from that
//! very time, on another side. Otherwise steps end two roundings of time before the jump and start
//! two after it. Every evaluation then lies on one side of it, wherever its definition puts the
//! instant itself.

use crate::integrate::Stepper;
use crate::scalar::Scalar;
use crate::system::{OdeSystem, StepFailure};
use crate::tolerance::{RESTART, Roundings};

/// Restarts of a run: at the times that were given, and at those that the system names.
#[derive(Clone, Copy, Debug)]
pub struct Restarts<'a, S> {
    end: S,
    is_backwards: bool,
    /// In the order in which the run meets them.
    given: &'a [S],
    /// The one that the last step ended at, if it did.
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
    /// Returns the restarts of a run between these times, with the `given` times in the order in
    /// which it meets them.
    pub fn new(start: S, end: S, given: &'a [S]) -> Self {
        Restarts { end, is_backwards: end < start, given, due: None }
    }

    /// Restarts the method where that is due, before a step. Returns the system for the
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

    /// Takes one step towards the end, to the next restart at most; `instant` is one more.
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

    /// Returns the time that was reached: that of the restart if the last step ended there.
    pub fn time<M>(&self, stepper: &impl Stepper<M>) -> S
    where
        M: OdeSystem<Scalar = S>,
    {
        self.due_at(stepper.time()).map_or(stepper.time(), |restart| restart.at)
    }

    /// Returns the time from which the motion continues: after the restart if the last step ended
    /// there.
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

    /// The restart that is due where this time was reached.
    fn due_at(&self, t: S) -> Option<Restart<S>> {
        self.due.filter(|restart| restart.before == t)
    }

    /// The first restart after `t`.
    fn next<M: OdeSystem<Scalar = S>>(&self, system: &M, t: S, instant: Option<S>) -> Option<Restart<S>> {
        let mut named = None;
        if let Some(time) = system.next_restart(t, self.end) {
            let is_exact = system.beyond(time, self.end).is_some() || system.is_tick(time);
            named = Some((time, if is_exact { Roundings::NONE } else { RESTART }));
        }
        self.first(t, named, instant)
    }

    /// The first restart after `t`: a given one, the one that the system names, or an instant.
    fn first(&self, t: S, named: Option<(S, Roundings)>, instant: Option<S>) -> Option<Restart<S>> {
        let past = self.given.partition_point(|time| !self.is_ahead(t, *time));
        let given = self.given[past..].iter().find_map(|time| self.between(t, *time, RESTART));
        let named = named.and_then(|(time, roundings)| self.between(t, time, roundings));
        let instant = instant.and_then(|time| self.between(t, time, Roundings::NONE));
        let known = match (given, named) {
            (Some(given), Some(named)) if self.is_ahead(given.at, named.at) => Some(given),
            (given, None) => given,
            (_, named) => named,
        };
        match (known, instant) {
            (Some(known), Some(instant)) if self.is_ahead(instant.at, known.before) => Some(instant),
            (None, instant) => instant,
            (known, _) => known,
        }
    }

    /// Returns a restart at `at` on the way from `t`, with this many roundings of time on both
    /// sides. `None` without room for steps, too.
    fn between(&self, t: S, at: S, roundings: Roundings) -> Option<Restart<S>> {
        let rounding = roundings.part::<S>() * t.abs().max(at.abs());
        let gap = if self.is_backwards { -rounding } else { rounding };
        let restart = Restart { before: at - gap, at, after: at + gap };
        let has_room = self.is_ahead(t, restart.before) && self.is_ahead(restart.after, self.end);
        has_room.then_some(restart)
    }

    /// True if the run meets `later` after `time`; not so if one of them is NaN.
    fn is_ahead(&self, time: S, later: S) -> bool {
        if self.is_backwards { later < time } else { time < later }
    }
}

#[cfg(test)]
mod tests;
