//! The events of a run: declared by its system, passed to the run, or none.

use crate::event::Occurrence;
use crate::integrate::Stepper;
use crate::scalar::Number;
use crate::system::{Action, OdeSystem, Reacted, Response, StepFailure};

/// The owner of an event.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Origin {
    /// The declaration.
    Declared,
    /// The function given under this index.
    Given(usize),
}

/// The cause that replaced a state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Replacement {
    /// An event, or several at the same time.
    Event,
    /// A clock.
    Clock,
}

/// The owner of the next event, and its time.
pub type Next<M> = Result<Option<(Origin, <M as OdeSystem>::Scalar)>, StepFailure<<M as OdeSystem>::Scalar>>;

/// An event with the state reached.
pub type Found<M> = Occurrence<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>;

/// Functions of time and state that are searched for zeros, with the responses to the zeros.
pub trait Events<M: OdeSystem> {
    /// True if there are no events.
    fn is_empty(&self) -> bool;

    /// Finds the next event in the last step of a run to `end`. Among simultaneous events, the one
    /// specified first comes first.
    ///
    /// # Errors
    /// As [`Detector::next`](crate::event::Detector::next).
    fn look(&mut self, system: &M, stepper: &mut impl Stepper<M>, end: M::Scalar) -> Next<M>;

    /// Removes and returns the event found; the next search finds the one after it.
    fn take(&mut self, origin: Origin) -> Option<Found<M>>;

    /// Returns the response to an event.
    ///
    /// # Errors
    /// If the motion cannot continue.
    fn react(&mut self, system: &M, origin: Origin, event: &Found<M>) -> Reacted<M>;

    /// Continues from another state.
    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State, by: Replacement);

    /// Continues with another system, such as one with other inputs.
    fn jump(&mut self, system: &M, t: M::Scalar, y: &M::State);
}

/// The events of a declaration together with those passed to a run.
pub struct AllEvents<D, G> {
    /// Declared events, which precede other events at the same time.
    pub declared: D,
    /// Events passed to the run.
    pub given: G,
}

impl<M: OdeSystem, D: Events<M>, G: Events<M>> Events<M> for AllEvents<D, G> {
    fn is_empty(&self) -> bool {
        self.declared.is_empty() && self.given.is_empty()
    }

    fn look(&mut self, system: &M, stepper: &mut impl Stepper<M>, end: M::Scalar) -> Next<M> {
        let from = stepper.last_time();
        let first = self.declared.look(system, stepper, end)?;
        let second = self.given.look(system, stepper, end)?;
        Ok(match (first, second) {
            (Some((_, one)), Some((_, other))) if (other - from).abs() < (one - from).abs() => second,
            (Some(_), _) => first,
            (None, second) => second,
        })
    }

    fn take(&mut self, origin: Origin) -> Option<Found<M>> {
        match origin {
            Origin::Declared => self.declared.take(origin),
            Origin::Given(_) => self.given.take(origin),
        }
    }

    fn react(&mut self, system: &M, origin: Origin, event: &Found<M>) -> Reacted<M> {
        match origin {
            Origin::Declared => self.declared.react(system, origin, event),
            Origin::Given(_) => self.given.react(system, origin, event),
        }
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State, by: Replacement) {
        self.declared.restart(system, t, y, by);
        self.given.restart(system, t, y, by);
    }

    fn jump(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        self.declared.jump(system, t, y);
        self.given.jump(system, t, y);
    }
}

/// Events of a kind that a run may lack.
impl<M: OdeSystem, E: Events<M>> Events<M> for Option<E> {
    fn is_empty(&self) -> bool {
        self.as_ref().is_none_or(E::is_empty)
    }

    fn look(&mut self, system: &M, stepper: &mut impl Stepper<M>, end: M::Scalar) -> Next<M> {
        self.as_mut().map_or(Ok(None), |events| events.look(system, stepper, end))
    }

    fn take(&mut self, origin: Origin) -> Option<Found<M>> {
        self.as_mut()?.take(origin)
    }

    fn react(&mut self, system: &M, origin: Origin, event: &Found<M>) -> Reacted<M> {
        let nothing = || Ok(Response::new(Action::Continue));
        self.as_mut().map_or_else(nothing, |events| events.react(system, origin, event))
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State, by: Replacement) {
        self.iter_mut().for_each(|events| events.restart(system, t, y, by));
    }

    fn jump(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        self.iter_mut().for_each(|events| events.jump(system, t, y));
    }
}

/// No events, and no memory for them.
pub struct NoEvents;

impl<M: OdeSystem> Events<M> for NoEvents {
    fn is_empty(&self) -> bool {
        true
    }

    fn look(&mut self, _system: &M, _stepper: &mut impl Stepper<M>, _end: M::Scalar) -> Next<M> {
        Ok(None)
    }

    fn take(&mut self, _origin: Origin) -> Option<Found<M>> {
        None
    }

    fn react(&mut self, _system: &M, _origin: Origin, _event: &Found<M>) -> Reacted<M> {
        Ok(Response::new(Action::Continue))
    }

    fn restart(&mut self, _system: &M, _t: M::Scalar, _y: &M::State, _by: Replacement) {}

    fn jump(&mut self, _system: &M, _t: M::Scalar, _y: &M::State) {}
}
