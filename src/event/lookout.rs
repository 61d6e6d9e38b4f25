//! Events ahead: the next one of several functions, kept until its turn comes.

use super::declared::MOST_DECLARED;
use super::direction::Direction;
use super::watch::{Occurrence, Watch};
use crate::integrate::{Cause, Stepper};
use crate::scalar::Scalar;
use crate::system::OdeSystem;

/// A watch, and the event that it found next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lookout<S, Y, const K: usize> {
    watch: Watch<S, K>,
    next: Option<Occurrence<S, Y>>,
}

impl<S: Scalar, Y: Copy, const K: usize> Lookout<S, Y, K> {
    pub(crate) fn new(watch: Watch<S, K>) -> Self {
        Lookout { watch, next: None }
    }

    /// When the next event in the last step of a run to `end` happens.
    ///
    /// # Errors
    /// As [`Watch::next`].
    pub(crate) fn look<M>(
        &mut self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        end: S,
        values: impl FnMut(S, &Y) -> [S; K],
    ) -> Result<Option<S>, Cause<S>>
    where
        M: OdeSystem<Scalar = S, State = Y>,
    {
        if self.next.is_none() {
            self.next = self.watch.next(system, stepper, values)?;
        }
        if self.next.is_none() && stepper.time() == end {
            self.next = self.watch.next_at_end(end, stepper.state());
        }
        Ok(self.time())
    }

    /// When the event that was found happens.
    pub(crate) fn time(&self) -> Option<S> {
        self.next.as_ref().map(|next| next.time)
    }

    /// The event that was found.
    pub(crate) fn take(&mut self) -> Option<Occurrence<S, Y>> {
        self.next.take()
    }

    /// Goes on from another state, in which the functions have these values.
    pub(crate) fn restart(&mut self, t: S, values: [S; K]) {
        self.next = None;
        self.watch.restart(t, values);
    }
}

/// The events that the declaration of the system M states.
pub(crate) struct Declarations<M: OdeSystem> {
    lookout: Lookout<M::Scalar, M::State, MOST_DECLARED>,
}

impl<M: OdeSystem> Declarations<M> {
    pub(crate) fn new(system: &M, t: M::Scalar, y: &M::State) -> Self {
        let mut directions = [Direction::Crossing; MOST_DECLARED];
        for (direction, event) in directions.iter_mut().zip(M::EVENTS) {
            *direction = event.direction;
        }
        let watch = Watch::new(directions, t, values(system, t, y)).with_switches(M::EVENTS);
        Declarations { lookout: Lookout::new(watch) }
    }

    /// When the next of them in the last step of a run to `end` happens.
    ///
    /// # Errors
    /// As [`Watch::next`].
    pub(crate) fn look(
        &mut self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        end: M::Scalar,
    ) -> Result<Option<M::Scalar>, Cause<M::Scalar>> {
        if M::EVENTS.is_empty() {
            return Ok(None);
        }
        self.lookout.look(system, stepper, end, |t, y| values(system, t, y))
    }

    pub(crate) fn take(&mut self) -> Option<Occurrence<M::Scalar, M::State>> {
        self.lookout.take()
    }

    /// Forgets the event that was found if it switches a mode: the modes are others now.
    pub(crate) fn drop_switch(&mut self) {
        self.lookout.next = self.lookout.next.filter(|next| !M::EVENTS[next.event].is_switch);
    }

    pub(crate) fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        if !M::EVENTS.is_empty() {
            self.lookout.restart(t, values(system, t, y));
        }
    }
}

/// The values of all declared events, and of others that never happen.
fn values<M: OdeSystem>(system: &M, t: M::Scalar, y: &M::State) -> [M::Scalar; MOST_DECLARED] {
    let mut values = [M::Scalar::ONE; MOST_DECLARED];
    let count = M::EVENTS.len().min(MOST_DECLARED);
    system.event_values(t, y, &mut values[..count]);
    values
}

/// Whether a run may go this way: not backwards through impacts and friction, whose past does not follow from the present.
///
/// # Errors
/// If it may not, or if there are more events than can be looked for.
pub(crate) fn is_forwards<M: OdeSystem>(t: M::Scalar, end: M::Scalar) -> Result<(), Cause<M::Scalar>> {
    if M::EVENTS.len() > MOST_DECLARED {
        return Err(Cause::Setting("the system declares more events than can be looked for"));
    }
    if end < t && M::EVENTS.iter().any(|event| event.is_switch) {
        return Err(Cause::Setting("contacts and dry friction run forwards in time only"));
    }
    Ok(())
}
