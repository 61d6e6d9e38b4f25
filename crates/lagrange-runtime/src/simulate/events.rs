//! Events of a run: any number of functions, each with a name and a reaction.

use std::boxed::Box;
use std::string::String;
use std::vec::Vec;

use crate::event::{Detector, Occurrence};
use crate::integrate::Stepper;
use crate::run::{Events, Found, Next, Origin, Pending, Replacement};
use crate::scalar::Number;
use crate::simulate::closed_loop::{ClosedLoop, GivenEvent};
use crate::system::{
    Action, Direction, EventKind, EventSource, MechanicalSystem, Reacted, Response, ScalarOf, State,
};

/// An event that occurred during a run.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub struct Event<S, Y> {
    /// Name of the event.
    pub name: String,
    /// Time of the event.
    pub time: S,
    /// State at the event, before any reaction.
    pub state: Y,
    /// Kind of the event, with details for contacts and dry friction.
    pub kind: EventKind<S>,
}

/// An event of the system M, as a reaction sees it.
pub(crate) type EventOf<M> = Event<ScalarOf<M>, State<M>>;

/// A function of time and state.
pub(crate) type Value<'a, M> = Box<dyn FnMut(&M, ScalarOf<M>, &State<M>) -> ScalarOf<M> + 'a>;

/// The response to an event.
pub(crate) type React<'a, M> = Box<dyn FnMut(&M, &EventOf<M>) -> Action<State<M>> + 'a>;

/// A function whose zeros are located, and the response to them.
pub(crate) type Watch<'a, M> = (Value<'a, M>, React<'a, M>);

/// An event of a run and its next occurrence.
struct Watcher<'a, M: MechanicalSystem, C: ClosedLoop<M>> {
    name: String,
    value: Value<'a, M>,
    react: React<'a, M>,
    pending: Pending<M::Scalar, C::State, 1>,
}

/// The events added to a run.
pub(super) struct Watchers<'a, M: MechanicalSystem, C: ClosedLoop<M>>(Vec<Watcher<'a, M, C>>);

impl<'a, M: MechanicalSystem, C: ClosedLoop<M>> Watchers<'a, M, C> {
    /// Starts watching, at a time and state, for events with these names and directions.
    pub(super) fn new(
        events: &[(String, Direction)],
        watches: Vec<Watch<'a, M>>,
        system: &C,
        (t, y): (M::Scalar, &C::State),
    ) -> Self {
        let mut watchers = Vec::new();
        for ((name, direction), (mut value, react)) in events.iter().zip(watches) {
            let detector = Detector::new([*direction], t, [ask(&mut value, system, t, y)]);
            watchers.push(Watcher { name: name.clone(), value, react, pending: Pending::new(detector) });
        }
        Watchers(watchers)
    }
}

/// Returns the value of a function for the system at this time and state.
fn ask<M: MechanicalSystem, C: ClosedLoop<M>>(
    value: &mut Value<'_, M>,
    system: &C,
    t: M::Scalar,
    y: &C::State,
) -> M::Scalar {
    let y = C::state_of_plant(y);
    system.ask(t, &y, |plant| value(plant, t, &y))
}

impl<M: MechanicalSystem, C: ClosedLoop<M>> Events<C> for Watchers<'_, M, C> {
    fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn look(&mut self, system: &C, stepper: &mut impl Stepper<C>, end: M::Scalar) -> Next<C> {
        let from = stepper.last_time();
        let since = |time: M::Scalar| (time - from).abs();
        let mut earliest: Option<(Origin, M::Scalar)> = None;
        for (index, Watcher { value, pending, .. }) in self.0.iter_mut().enumerate() {
            let found = pending.look(system, stepper, end, |t, y| [ask(value, system, t, y)]);
            let found = found.map_err(|cause| cause.of_event(|_| EventSource::Given(index)))?;
            let Some(time) = found else { continue };
            if earliest.is_none_or(|(_, other)| since(time) < since(other)) {
                earliest = Some((Origin::Given(index), time));
            }
        }
        Ok(earliest)
    }

    fn take(&mut self, origin: Origin) -> Option<Found<C>> {
        let Origin::Given(index) = origin else { return None };
        self.0[index].pending.take()
    }

    fn react(&mut self, system: &C, origin: Origin, found: &Found<C>) -> Reacted<C> {
        let Origin::Given(index) = origin else { return Ok(Response::new(Action::Continue)) };
        let Watcher { name, value, react, .. } = &mut self.0[index];
        let Occurrence { time, state: whole, .. } = *found;
        let state = C::state_of_plant(&whole);
        let mut event = Given { index, name, value, react };
        let action = match system.ask(time, &state, |plant| event.react(plant, time, &state)) {
            Action::Continue => Action::Continue,
            Action::Stop => Action::Stop,
            Action::Replace(after) => {
                Action::Replace(system.after_event((time, &whole), after, &mut event)?)
            }
        };
        Ok(Response::new(action))
    }

    fn restart(&mut self, system: &C, t: M::Scalar, y: &C::State, by: Replacement) {
        for Watcher { value, pending, .. } in &mut self.0 {
            pending.restart(t, [ask(value, system, t, y)], by);
        }
    }

    fn jump(&mut self, system: &C, t: M::Scalar, y: &C::State) {
        for Watcher { value, pending, .. } in &mut self.0 {
            pending.jump([ask(value, system, t, y)]);
        }
    }
}

/// An event of a run at one of its occurrences.
struct Given<'w, 'a, M: MechanicalSystem> {
    index: usize,
    name: &'w str,
    value: &'w mut Value<'a, M>,
    react: &'w mut React<'a, M>,
}

impl<M: MechanicalSystem> Given<'_, '_, M> {
    fn react(&mut self, plant: &M, time: M::Scalar, y: &M::State) -> Action<M::State> {
        let event = Event { name: self.name.into(), time, state: *y, kind: EventKind::Zero };
        (self.react)(plant, &event)
    }
}

impl<M: MechanicalSystem> GivenEvent<M> for Given<'_, '_, M> {
    fn value(&mut self, plant: &M, t: M::Scalar, y: &M::State) -> M::Scalar {
        (self.value)(plant, t, y)
    }

    fn outcome(&mut self, plant: &M, t: M::Scalar, y: &M::State) -> Option<M::State> {
        if let Action::Replace(state) = self.react(plant, t, y) { Some(state) } else { None }
    }

    fn index(&self) -> usize {
        self.index
    }
}
