//! Events of a run: any number of functions, each with a name and a reaction.

use std::boxed::Box;
use std::string::String;
use std::vec::Vec;

use crate::event::{Detector, Occurrence};
use crate::integrate::Stepper;
use crate::run::{Events, Found, Next, Origin, Pending};
use crate::scalar::Number;
use crate::simulate::control::ClosedLoop;
use crate::system::{
    Action, Direction, EventKind, EventSource, MechanicalSystem, OdeSystem, Reacted, Response,
};

/// Something that happened during a run.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub struct Event<S, Y> {
    /// Name.
    pub name: String,
    /// When it happened.
    pub time: S,
    /// The state then, before any reaction.
    pub state: Y,
    /// Kind: more than a zero for the event of a contact or of dry friction.
    pub kind: EventKind<S>,
}

/// A function of time and state.
type Value<'a, M> =
    Box<dyn FnMut(&M, <M as OdeSystem>::Scalar, &<M as OdeSystem>::State) -> <M as OdeSystem>::Scalar + 'a>;

/// An event as those are told who asked for it.
type Told<M> = Event<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>;

/// The response to an event.
type React<'a, M> = Box<dyn FnMut(&M, &Told<M>) -> Action<<M as OdeSystem>::State> + 'a>;

/// A function whose zeros are looked for.
pub(super) struct Watcher<'a, M: MechanicalSystem> {
    pub(super) name: String,
    pub(super) direction: Direction,
    pub(super) value: Value<'a, M>,
    pub(super) react: React<'a, M>,
}

impl<M: MechanicalSystem> Watcher<'_, M> {
    fn value(&mut self, system: &impl ClosedLoop<M>, t: M::Scalar, y: &M::State) -> M::Scalar {
        system.ask(t, y, |plant| (self.value)(plant, t, y))
    }
}

/// A watcher with what its function has ahead.
struct Ahead<'a, M: MechanicalSystem> {
    watcher: Watcher<'a, M>,
    pending: Pending<M::Scalar, M::State, 1>,
}

/// The events that watchers look for.
pub(super) struct Watchers<'a, M: MechanicalSystem>(Vec<Ahead<'a, M>>);

impl<'a, M: MechanicalSystem> Watchers<'a, M> {
    /// Starts to watch at a time and state.
    pub(super) fn new(
        watchers: Vec<Watcher<'a, M>>,
        system: &impl ClosedLoop<M>,
        (t, y): (M::Scalar, &M::State),
    ) -> Self {
        let start = |mut watcher: Watcher<'a, M>| {
            let detector = Detector::new([watcher.direction], t, [watcher.value(system, t, y)]);
            Ahead { watcher, pending: Pending::new(detector) }
        };
        Watchers(watchers.into_iter().map(start).collect())
    }
}

impl<M: MechanicalSystem, C: ClosedLoop<M>> Events<C> for Watchers<'_, M> {
    fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn look(&mut self, system: &C, stepper: &mut impl Stepper<C>, end: M::Scalar) -> Next<C> {
        let from = stepper.last_time();
        let since = |time: M::Scalar| (time - from).abs();
        let mut earliest: Option<(Origin, M::Scalar)> = None;
        for (index, Ahead { watcher, pending }) in self.0.iter_mut().enumerate() {
            let found = pending.look(system, stepper, end, |t, y| [watcher.value(system, t, y)]);
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
        let watcher = &mut self.0[index].watcher;
        let Occurrence { time, state, .. } = *found;
        let event = Event { name: watcher.name.clone(), time, state, kind: EventKind::Zero };
        let action = system.ask(time, &state, |plant| (watcher.react)(plant, &event));
        Ok(Response::new(action))
    }

    fn restart(&mut self, system: &C, t: M::Scalar, y: &M::State) {
        for Ahead { watcher, pending } in &mut self.0 {
            pending.restart(t, [watcher.value(system, t, y)]);
        }
    }

    fn jump(&mut self, system: &C, t: M::Scalar, y: &M::State) {
        for Ahead { watcher, pending } in &mut self.0 {
            pending.jump([watcher.value(system, t, y)]);
        }
    }
}
