//! Events of a run: any number of functions, each with a name and a reaction.

use std::boxed::Box;
use std::string::String;
use std::vec::Vec;

use crate::event::{Direction, Occurrence, Reaction, Watch, is_at_once};
use crate::integrate::{Cause, Stepper};
use crate::scalar::Scalar;
use crate::system::{MechanicalSystem, OdeSystem};

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
}

/// A function of time and state.
type Value<'a, M> =
    Box<dyn FnMut(&M, <M as OdeSystem>::Scalar, &<M as OdeSystem>::State) -> <M as OdeSystem>::Scalar + 'a>;

/// An event with the state reached.
type Found<M> = Event<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>;

/// What to do at an event.
type React<'a, M> = Box<dyn FnMut(&M, &Found<M>) -> Reaction<<M as OdeSystem>::State> + 'a>;

/// A function whose zeros are looked for.
pub(super) struct Watcher<'a, M: MechanicalSystem> {
    pub(super) name: String,
    pub(super) direction: Direction,
    pub(super) value: Value<'a, M>,
    pub(super) react: React<'a, M>,
}

/// An event, and what is to be done about it.
type Answered<M> = (Found<M>, Reaction<<M as OdeSystem>::State>);

/// The next of them, if there is one.
type Next<M> = Result<Option<Answered<M>>, Cause<<M as OdeSystem>::Scalar>>;

impl<M: MechanicalSystem> Watcher<'_, M> {
    fn answer(&mut self, system: &M, time: M::Scalar, state: M::State) -> Answered<M> {
        let event = Event { name: self.name.clone(), time, state };
        let reaction = (self.react)(system, &event);
        (event, reaction)
    }
}

/// All watchers, each with its memory and the event that it found next.
pub(super) struct Watchers<'a, M: MechanicalSystem> {
    watchers: Vec<Watcher<'a, M>>,
    watches: Vec<Watch<M::Scalar, 1>>,
    pending: Vec<Option<Occurrence<M::Scalar, M::State>>>,
}

impl<'a, M: MechanicalSystem> Watchers<'a, M> {
    /// Starts to watch at a time and state.
    pub(super) fn new(mut watchers: Vec<Watcher<'a, M>>, system: &M, (t, y): (M::Scalar, &M::State)) -> Self {
        let start = |watcher: &mut Watcher<'a, M>| {
            Watch::new([watcher.direction], t, [(watcher.value)(system, t, y)])
        };
        let watches: Vec<_> = watchers.iter_mut().map(start).collect();
        let pending = watches.iter().map(|_| None).collect();
        Watchers { watchers, watches, pending }
    }

    /// The next event in the last step, with what to do; of those at the same time the one given first.
    pub(super) fn next(&mut self, system: &M, stepper: &mut impl Stepper<M>) -> Next<M> {
        self.look(system, stepper)?;
        let Some((index, _)) = self.earliest(stepper.last_time()) else { return Ok(None) };
        let Some(Occurrence { time, state, .. }) = self.pending[index].take() else { return Ok(None) };
        Ok(Some(self.watchers[index].answer(system, time, state)))
    }

    /// The next event that cannot be told from `time`, taken to find the state as it was replaced by then, if it was.
    pub(super) fn next_at_once(
        &mut self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        time: M::Scalar,
        replaced: Option<M::State>,
    ) -> Next<M> {
        let (from, to) = (stepper.last_time(), stepper.time());
        let earliest = self.earliest(from).filter(|(_, other)| is_at_once(time, *other, from, to));
        let Some((index, _)) = earliest else { return Ok(None) };
        let Some(Occurrence { state, .. }) = self.pending[index].take() else { return Ok(None) };
        Ok(Some(self.watchers[index].answer(system, time, replaced.unwrap_or(state))))
    }

    /// The earliest of the pending events and its time.
    fn earliest(&self, from: M::Scalar) -> Option<(usize, M::Scalar)> {
        let since = |time: M::Scalar| (time - from).abs();
        let mut earliest: Option<(usize, M::Scalar)> = None;
        for (index, pending) in self.pending.iter().enumerate() {
            let Some(pending) = pending else { continue };
            if earliest.is_none_or(|(_, time)| since(pending.time) < since(time)) {
                earliest = Some((index, pending.time));
            }
        }
        earliest
    }

    /// Looks for the next event of each watcher that has none pending.
    fn look(&mut self, system: &M, stepper: &mut impl Stepper<M>) -> Result<(), Cause<M::Scalar>> {
        let memory = self.watches.iter_mut().zip(&mut self.pending);
        for (index, (watcher, (watch, pending))) in self.watchers.iter_mut().zip(memory).enumerate() {
            if pending.is_none() {
                let found = watch.next(system, stepper, |t, y| [(watcher.value)(system, t, y)]);
                *pending = found.map_err(|cause| with_index(cause, index))?;
            }
        }
        Ok(())
    }

    /// Goes on from another state.
    pub(super) fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        self.pending.fill(None);
        for (watcher, watch) in self.watchers.iter_mut().zip(&mut self.watches) {
            watch.restart(t, [(watcher.value)(system, t, y)]);
        }
    }
}

/// The cause, about the event of this index.
fn with_index<S: Scalar>(cause: Cause<S>, event: usize) -> Cause<S> {
    match cause {
        Cause::EventNotFinite { .. } => Cause::EventNotFinite { event },
        Cause::EventNotLocated { bisections, .. } => Cause::EventNotLocated { event, bisections },
        other => other,
    }
}
