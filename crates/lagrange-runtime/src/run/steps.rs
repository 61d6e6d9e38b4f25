//! A run in progress, turn by turn.
//!
//! One turn is a step of the method with its restarts at known times and its events, one by one in
//! order of time. An event may replace the state or the system, from which the motion continues. A
//! [`Sink`] receives everything visible. The same loop therefore serves runs that keep nothing and
//! simulations, which keep the requested data.

use super::current::{Current, check_ranges};
use super::events::{Events, Found, Origin, Replacement};
use super::outcome::EventOutcome;
use super::restarts::Restarts;
use crate::event::{Occurrence, is_at_once};
use crate::integrate::{IntegrationError, Outcome, Stepper, Work, explained};
use crate::system::{EventKind, OdeSystem, StepFailure};

/// An observer of a run.
pub trait Sink<M: OdeSystem> {
    /// True if states before the end of a step to `to` will be requested.
    fn looks_before(&self, _to: M::Scalar) -> bool {
        false
    }

    /// Receives an event.
    fn happen(&mut self, _origin: Origin, _event: &Found<M>, _kind: EventKind<M::Scalar>) {}

    /// Receives the end of the last step, which counts as this time. True if the motion continues.
    fn reach_end(&mut self, system: &M, stepper: &mut impl Stepper<M>, time: M::Scalar) -> bool;

    /// Receives an event at this time and state in the last step. True if the motion continues.
    fn reach(&mut self, system: &M, stepper: &mut impl Stepper<M>, reached: (M::Scalar, &M::State)) -> bool;

    /// Receives another system, valid from here on.
    fn switch(&mut self, _system: &M) {}

    /// Receives the state from which the motion continues at the time reached. The event before it
    /// was reported unless it `is_silent`.
    fn replace(&mut self, system: &M, from: (M::Scalar, &M::State), is_silent: bool);

    /// Receives other inputs or the state after a tick, from this time and state on.
    fn exchange(&mut self, _system: &M, _from: (M::Scalar, &M::State)) {}
}

/// The result of a turn.
#[derive(Clone, Copy, Debug)]
pub enum Turn<S, Y> {
    /// The motion continues, unless it has reached its end.
    GoesOn,
    /// An event stopped it at this time and state.
    Stopped(S, Y),
    /// The sink stopped it.
    Cancelled,
}

/// The result of one turn of a run of the system M.
type Turned<M> = Outcome<M, Turn<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>>;

/// The next event of the system M with its origin, if there is one, or the error E.
type NextEvent<M, E> = Result<Option<(Origin, Found<M>)>, E>;

/// The outcome of events, and true if the first of them was not reported.
type Reaction<M> = Result<(EventOutcome<M>, bool), StepFailure<<M as OdeSystem>::Scalar>>;

/// A run of a system by a stepper of type T, with events of type E.
pub struct Run<'r, 's, M: OdeSystem, T, E> {
    current: &'r mut Current<'s, M>,
    stepper: T,
    events: E,
    restarts: Restarts<'r, M::Scalar>,
    /// The last time at which clocks ticked.
    ticked: Option<M::Scalar>,
    end: M::Scalar,
}

impl<'r, 's, M: OdeSystem, T: Stepper<M>, E: Events<M>> Run<'r, 's, M, T, E> {
    /// Starts a run, with `restarts` in the order of the run.
    pub fn new(
        current: &'r mut Current<'s, M>,
        stepper: T,
        events: E,
        (start, end): (M::Scalar, M::Scalar),
        restarts: &'r [M::Scalar],
    ) -> Self {
        let restarts = Restarts::new(start, end, restarts);
        Run { current, stepper, events, restarts, ticked: None, end }
    }

    /// True if the end is reached.
    pub fn is_over(&self) -> bool {
        self.stepper.time() == self.end
    }

    /// Returns the present system.
    pub fn system(&self) -> &M {
        self.current.system()
    }

    /// Returns the time at which the last step ended.
    pub fn step_end(&self) -> M::Scalar {
        self.stepper.time()
    }

    /// Returns the time reached: the time of the restart if the last step ended at one.
    pub fn time(&self) -> M::Scalar {
        self.restarts.time(&self.stepper)
    }

    /// Returns the time from which the motion continues: just after the restart if the last step
    /// ended at one.
    pub fn beyond(&self) -> M::Scalar {
        self.restarts.beyond(&self.stepper)
    }

    /// Returns the state reached.
    pub fn state(&self) -> &M::State {
        self.stepper.state()
    }

    /// Returns the work so far.
    pub fn work(&self) -> Work {
        self.stepper.work()
    }

    /// Takes a step, at most to `instant`, and handles its events up to one that changes or ends
    /// the motion.
    ///
    /// # Errors
    /// If the method, the search for events or an event fails, with the last good state.
    #[inline]
    pub fn next(&mut self, sink: &mut impl Sink<M>, instant: Option<M::Scalar>) -> Turned<M> {
        if let Err(cause) = self.tick(sink).and_then(|()| self.step(sink, instant)) {
            return Err(IntegrationError { cause, time: self.stepper.time(), state: *self.stepper.state() });
        }
        if let Some(system) = self.stepper.in_modes(self.current.system()) {
            self.current.switch(Some(system));
            sink.switch(self.current.system());
        }
        while let Some((origin, event)) = self.next_event()? {
            let (time, state) = (event.time, event.state);
            self.check_reached(&state)?;
            let reaction = self.react(sink, origin, event);
            if !reaction.as_ref().is_ok_and(|(outcome, _)| outcome.goes_on()) {
                return self.resume(sink, (time, state), reaction);
            }
        }
        let reached = *self.stepper.state();
        self.check_reached(&reached)?;
        let time = self.time();
        let goes_on = sink.reach_end(self.current.system(), &mut self.stepper, time);
        Ok(if goes_on { Turn::GoesOn } else { Turn::Cancelled })
    }

    /// Continues with this system, such as one with other inputs, from the time and state reached.
    ///
    /// # Errors
    /// If the method cannot continue from there.
    pub fn exchange(&mut self, sink: &mut impl Sink<M>, system: M) -> Result<(), StepFailure<M::Scalar>> {
        let (time, state) = (self.time(), *self.stepper.state());
        // The jump may have crossed several surfaces.
        let on_sides = system.on_sides(time, &state);
        self.current.switch(on_sides.or(Some(system)));
        let system = self.current.system();
        sink.switch(system);
        sink.exchange(system, (time, &state));
        self.events.jump(system, time, &state);
        if self.restarts.is_due(&self.stepper) {
            return Ok(());
        }
        self.stepper.restart(system, time, &state)
    }

    /// Ticks the clocks that are due at the time reached, once.
    #[inline]
    fn tick(&mut self, sink: &mut impl Sink<M>) -> Result<(), StepFailure<M::Scalar>> {
        let (time, system) = (self.time(), self.current.system());
        let Some(state) = system.tick(time, self.stepper.state()) else { return Ok(()) };
        if self.ticked.replace(time) == Some(time) {
            return Ok(());
        }
        check_ranges::<M, T>(system, &state)?;
        self.stepper.restart(system, self.beyond(), &state)?;
        // The stepper may have brought the state nearer to the constraints.
        let admitted = *self.stepper.state();
        self.events.restart(system, time, &admitted, Replacement::Clock);
        sink.exchange(system, (time, &admitted));
        Ok(())
    }

    /// Takes one step, after a restart if one is due.
    #[inline]
    fn step(
        &mut self,
        sink: &mut impl Sink<M>,
        instant: Option<M::Scalar>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        if let Some(beyond) = self.restarts.resume(self.current.system(), &mut self.stepper)? {
            self.current.switch(Some(beyond));
            sink.switch(self.current.system());
        }
        let has_events = !self.events.is_empty();
        let is_of_interest = |_, to| has_events || sink.looks_before(to);
        self.restarts.step(self.current.system(), &mut self.stepper, instant, is_of_interest)
    }

    /// Returns the end of the run, or of the last step if clocks tick there. A function that is
    /// zero there has an event, whatever follows.
    fn last_instant(&self) -> M::Scalar {
        let (time, state) = (self.stepper.time(), self.stepper.state());
        let ticks = self.ticked != Some(time) && self.current.system().tick(time, state).is_some();
        if ticks { time } else { self.end }
    }

    /// Returns the next event of the last step.
    #[inline]
    fn next_event(&mut self) -> NextEvent<M, IntegrationError<M::Scalar, M::State>> {
        let (end, system) = (self.last_instant(), self.current.system());
        match self.events.look(system, &mut self.stepper, end) {
            Ok(next) => Ok(next.and_then(|(origin, _)| Some((origin, self.events.take(origin)?)))),
            Err(cause) => Err(self.before_step(cause)),
        }
    }

    /// Checks the ranges at a state of the last step.
    fn check_reached(&mut self, state: &M::State) -> Result<(), IntegrationError<M::Scalar, M::State>> {
        check_ranges::<M, T>(self.current.system(), state).map_err(|cause| self.before_step(cause))
    }

    /// Returns an error for the last step, with the state before it.
    #[cold]
    fn before_step(&mut self, cause: StepFailure<M::Scalar>) -> IntegrationError<M::Scalar, M::State> {
        let time = self.stepper.last_time();
        IntegrationError { cause, time, state: self.stepper.interpolate(self.current.system(), time) }
    }

    /// Returns the outcome of simultaneous events, each starting from the state that the previous
    /// one left.
    fn react(&mut self, sink: &mut impl Sink<M>, origin: Origin, first: Found<M>) -> Reaction<M> {
        let time = first.time;
        let mut outcome = EventOutcome::new();
        let is_told = self.answer(sink, &mut outcome, origin, &first)?;
        if !outcome.goes_on() {
            while let Some((origin, event)) = self.next_at_once(&outcome, time)? {
                self.answer(sink, &mut outcome, origin, &event)?;
            }
        }
        Ok((outcome, !is_told))
    }

    /// Adds the outcome of an event; true if the event was reported. A contact that touches without
    /// impact and without closing is not an event.
    fn answer(
        &mut self,
        sink: &mut impl Sink<M>,
        outcome: &mut EventOutcome<M>,
        origin: Origin,
        event: &Found<M>,
    ) -> Result<bool, StepFailure<M::Scalar>> {
        let system = outcome.system.as_ref().unwrap_or(self.current.system());
        let response = self.events.react(system, origin, event);
        let kind = response.as_ref().map_or(EventKind::Zero, |response| response.kind);
        let is_told = !(is_switch(self.current.system(), origin, event) && kind == EventKind::Zero);
        if is_told {
            sink.happen(origin, event, kind);
        }
        outcome.add(response?, event.state);
        Ok(is_told)
    }

    /// Returns the next event that cannot be distinguished from `time`, at the state left by
    /// earlier ones. Events of contacts and friction are excluded: they are already settled, or
    /// will be when the motion continues.
    fn next_at_once(
        &mut self,
        outcome: &EventOutcome<M>,
        time: M::Scalar,
    ) -> NextEvent<M, StepFailure<M::Scalar>> {
        let (from, to, end) = (self.stepper.last_time(), self.stepper.time(), self.last_instant());
        loop {
            // After the event the step is not part of the motion: functions may have any values
            // there.
            let next = match self.events.look(self.current.system(), &mut self.stepper, end) {
                Ok(next) => next,
                Err(cause @ StepFailure::Slides { .. }) => return Err(cause),
                Err(_) => return Ok(None),
            };
            let next = next.filter(|(_, other)| is_at_once(time, *other, from, to));
            let Some((origin, _)) = next else { return Ok(None) };
            let Some(event) = self.events.take(origin) else { return Ok(None) };
            if !is_switch(self.current.system(), origin, &event) {
                let state = outcome.state().unwrap_or(event.state);
                return Ok(Some((origin, Occurrence { time, state, ..event })));
            }
        }
    }

    /// Continues after events at this time and state, unless they stop the motion.
    fn resume(
        &mut self,
        sink: &mut impl Sink<M>,
        (time, state): (M::Scalar, M::State),
        reaction: Reaction<M>,
    ) -> Turned<M> {
        if !sink.reach(self.current.system(), &mut self.stepper, (time, &state)) {
            return Ok(Turn::Cancelled);
        }
        let failed = |cause| IntegrationError { cause, time, state };
        let (outcome, is_silent) = reaction.map_err(failed)?;
        let Some(resumed) = outcome.resume::<T>(self.current.system(), time) else {
            return Ok(Turn::Stopped(time, state));
        };
        let (other, switched) = resumed.map_err(failed)?;
        if switched.is_some() {
            self.current.switch(switched);
            sink.switch(self.current.system());
        }
        let system = self.current.system();
        check_ranges::<M, T>(system, &other).map_err(failed)?;
        let restarted = self.stepper.restart(system, time, &other);
        restarted.map_err(|cause| failed(explained(cause, system, (time, &other), self.end)))?;
        // The stepper may have brought the state nearer to the constraints.
        let admitted = *self.stepper.state();
        self.events.restart(system, time, &admitted, Replacement::Event);
        sink.replace(system, (time, &admitted), is_silent);
        Ok(Turn::GoesOn)
    }
}

/// True for an event of a contact, friction or a switch, which ends a mode.
fn is_switch<M: OdeSystem>(system: &M, origin: Origin, event: &Found<M>) -> bool {
    origin == Origin::Declared && system.events()[event.event].is_switch
}
