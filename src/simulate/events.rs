//! Events of a run: any number of functions, each with a name and a reaction.

use std::boxed::Box;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::event::{Course, Declarations, Lookout, Occurrence, Watch, is_at_once};
use crate::integrate::Stepper;
use crate::scalar::Scalar;
use crate::simulate::control::ClosedLoop;
use crate::system::{
    Action, Direction, EventKind, EventSource, MechanicalSystem, OdeSystem, Reacted, Response, StepFailure,
};

/// Something that happened during a run.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub struct Event<S, Y> {
    /// What it is called.
    pub name: String,
    /// When it happened.
    pub time: S,
    /// The state then, before any reaction.
    pub state: Y,
    /// What it was: more than a zero if it is the event of a contact or of dry friction.
    pub kind: EventKind<S>,
}

/// A function of time and state.
type Value<'a, M> =
    Box<dyn FnMut(&M, <M as OdeSystem>::Scalar, &<M as OdeSystem>::State) -> <M as OdeSystem>::Scalar + 'a>;

/// An event with the state reached.
type Found<M> = Event<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>;

/// What to do at an event.
type React<'a, M> = Box<dyn FnMut(&M, &Found<M>) -> Action<<M as OdeSystem>::State> + 'a>;

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

/// A zero of a function, and what comes of it.
pub(super) struct Happened<C: MechanicalSystem> {
    /// The event that it is, unless it turned out to be none.
    pub(super) event: Option<Found<C>>,
    pub(super) time: C::Scalar,
    /// The state then, before any reaction.
    pub(super) state: C::State,
    pub(super) answer: Reacted<C>,
}

/// The next of them, if there is one.
type Next<C> = Result<Option<Happened<C>>, StepFailure<<C as OdeSystem>::Scalar>>;

/// A watcher with its memory.
struct Lookouts<'a, M: MechanicalSystem> {
    watcher: Watcher<'a, M>,
    lookout: Lookout<M::Scalar, M::State, 1>,
}

/// All events: those of the declaration, and those that watchers look for.
pub(super) struct Watchers<'a, M: MechanicalSystem, C: MechanicalSystem> {
    end: M::Scalar,
    declared: Declarations<C>,
    given: Vec<Lookouts<'a, M>>,
}

/// Whose event it is: that of the declaration, or of the watcher of this index.
#[derive(Clone, Copy)]
enum Whose {
    Declared,
    Given(usize),
}

/// Which event is ahead, and when.
type Ahead<M> = Result<Option<(Whose, <M as OdeSystem>::Scalar)>, StepFailure<<M as OdeSystem>::Scalar>>;

impl<'a, M: MechanicalSystem, C: ClosedLoop<M>> Watchers<'a, M, C> {
    /// Starts to watch a run to `end` at a time and state.
    pub(super) fn new(
        watchers: Vec<Watcher<'a, M>>,
        system: &C,
        (t, y): (M::Scalar, &M::State),
        end: M::Scalar,
    ) -> Self {
        let start = |mut watcher: Watcher<'a, M>| {
            let watch = Watch::new([watcher.direction], t, [watcher.value(system, t, y)]);
            Lookouts { watcher, lookout: Lookout::new(watch) }
        };
        Watchers {
            end,
            declared: Declarations::new(system, t, y),
            given: watchers.into_iter().map(start).collect(),
        }
    }

    /// Whether there is nothing to look for.
    pub(super) fn is_empty(&self) -> bool {
        C::EVENTS.is_empty() && self.given.is_empty()
    }

    /// The next event in the last step, with what comes of it; of those at the same time the one given first, and declared ones
    /// before all others.
    pub(super) fn next(&mut self, system: &C, stepper: &mut impl Stepper<C>) -> Next<C> {
        let Some((whose, _)) = self.look(system, stepper)? else { return Ok(None) };
        let Some(event) = self.take(whose) else { return Ok(None) };
        Ok(Some(self.answer(system, whose, event)))
    }

    /// The next event that cannot be told from `time`, taken to find the state as it was replaced by then, if it was. What
    /// contacts and friction do is not among them: they have been settled, or are once the motion goes on.
    pub(super) fn next_at_once(
        &mut self,
        system: &C,
        course: &Course<C>,
        stepper: &mut impl Stepper<C>,
        time: M::Scalar,
    ) -> Next<C> {
        let (from, to) = (stepper.last_time(), stepper.time());
        loop {
            let next = self.look(system, stepper)?;
            let next = next.filter(|(_, other)| is_at_once(time, *other, from, to));
            let Some((whose, _)) = next else { return Ok(None) };
            let Some(event) = self.take(whose) else { return Ok(None) };
            if matches!(whose, Whose::Declared) && C::EVENTS[event.event].is_switch {
                continue;
            }
            let state = course.state().unwrap_or(event.state);
            let event = Occurrence { time, state, ..event };
            return Ok(Some(self.answer(course.system.as_ref().unwrap_or(system), whose, event)));
        }
    }

    fn answer(
        &mut self,
        system: &C,
        whose: Whose,
        Occurrence { event, time, state }: Occurrence<M::Scalar, M::State>,
    ) -> Happened<C> {
        let found = |name, kind| Event { name, time, state, kind };
        match whose {
            Whose::Declared => {
                let (answer, declared) = (system.react(event, time, &state), &C::EVENTS[event]);
                let kind = answer.as_ref().map_or(EventKind::Zero, |answer| answer.kind);
                // A contact may touch without an impact and without closing.
                let is_none = declared.is_switch && kind == EventKind::Zero;
                let event = (!is_none).then(|| found(declared.name.to_string(), kind));
                Happened { event, time, state, answer }
            }
            Whose::Given(index) => {
                let watcher = &mut self.given[index].watcher;
                let event = found(watcher.name.clone(), EventKind::Zero);
                let action = system.ask(time, &state, |plant| (watcher.react)(plant, &event));
                let answer = Ok(Response::new(action));
                Happened { event: Some(event), time, state, answer }
            }
        }
    }

    /// The earliest of the next events, and its time.
    fn look(&mut self, system: &C, stepper: &mut impl Stepper<C>) -> Ahead<M> {
        let from = stepper.last_time();
        let since = |time: M::Scalar| (time - from).abs();
        let mut earliest = self.declared.look(system, stepper, self.end)?.map(|time| (Whose::Declared, time));
        for (index, Lookouts { watcher, lookout }) in self.given.iter_mut().enumerate() {
            let found = lookout.look(system, stepper, self.end, |t, y| [watcher.value(system, t, y)]);
            let found = found.map_err(|cause| cause.of_event(|_| EventSource::Given(index)))?;
            let Some(time) = found else { continue };
            if earliest.is_none_or(|(_, other)| since(time) < since(other)) {
                earliest = Some((Whose::Given(index), time));
            }
        }
        Ok(earliest)
    }

    fn take(&mut self, whose: Whose) -> Option<Occurrence<M::Scalar, M::State>> {
        match whose {
            Whose::Declared => self.declared.take(),
            Whose::Given(index) => self.given[index].lookout.take(),
        }
    }

    /// Goes on from another state.
    pub(super) fn restart(&mut self, system: &C, t: M::Scalar, y: &M::State) {
        self.declared.restart(system, t, y);
        for Lookouts { watcher, lookout } in &mut self.given {
            lookout.restart(t, [watcher.value(system, t, y)]);
        }
    }

    /// Goes on with other inputs.
    pub(super) fn jump(&mut self, system: &C, t: M::Scalar, y: &M::State) {
        self.declared.jump(system, t, y);
        for Lookouts { watcher, lookout } in &mut self.given {
            lookout.jump([watcher.value(system, t, y)]);
        }
    }
}
