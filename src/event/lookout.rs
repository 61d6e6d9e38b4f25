//! Events ahead: the next one of several functions, kept until its turn comes.

use super::locate::locate;
use super::watch::{Occurrence, Watch};
use crate::integrate::Stepper;
use crate::scalar::Scalar;
use crate::system::{Direction, MOST_LOCATED, OdeSystem, StepFailure};

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
    ) -> Result<Option<S>, StepFailure<S>>
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

    /// Goes on where the functions jumped to these values.
    pub(crate) fn jump(&mut self, values: [S; K]) {
        self.watch.jump(values);
    }
}

/// The events that the declaration of the system M states.
pub(crate) struct Declarations<M: OdeSystem> {
    lookout: Lookout<M::Scalar, M::State, MOST_LOCATED>,
    /// The last change of a side.
    change: Option<Change<M::Scalar>>,
}

/// A switch that changed its side.
#[derive(Clone, Copy)]
struct Change<S> {
    event: usize,
    time: S,
    /// The value of its event right after.
    value: S,
    /// How often it had changed by then without having left its surface.
    returns: u32,
}

/// A switch that returns so often without having left its surface stays there,
const MOST_RETURNS: u32 = 5;
/// which it has not if it was never farther from it than this many times as far as right after the change.
const NEAR: f64 = 4.0;

impl<M: OdeSystem> Declarations<M> {
    pub(crate) fn new(system: &M, t: M::Scalar, y: &M::State) -> Self {
        let mut directions = [Direction::Crossing; MOST_LOCATED];
        for (direction, event) in directions.iter_mut().zip(M::EVENTS) {
            *direction = event.direction;
        }
        let watch = Watch::new(directions, t, values(system, t, y)).with_switches(M::EVENTS);
        Declarations { lookout: Lookout::new(watch), change: None }
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
    ) -> Result<Option<M::Scalar>, StepFailure<M::Scalar>> {
        if M::EVENTS.is_empty() {
            return Ok(None);
        }
        let is_new = self.lookout.next.is_none();
        let found = self.lookout.look(system, stepper, end, |t, y| values(system, t, y));
        found.map_err(|cause| cause.named(M::EVENTS))?;
        if let Some(next) = self.lookout.next
            && is_new
            && M::EVENTS[next.event].is_side
        {
            let next = on_surface(system, stepper, next);
            self.check_sliding(system, stepper, &next)?;
            self.lookout.next = Some(next);
        }
        Ok(self.lookout.time())
    }

    /// Counts how often a switch returns to its surface without having left it.
    ///
    /// # Errors
    /// If that is so often that the state slides along it.
    fn check_sliding(
        &mut self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        next: &Occurrence<M::Scalar, M::State>,
    ) -> Result<(), StepFailure<M::Scalar>> {
        let Occurrence { event, time, .. } = *next;
        let returns = match self.change {
            Some(last) if last.event == event && last.time == stepper.last_time() => {
                let middle = M::Scalar::from_f64(0.5) * (last.time + time);
                let between = values(system, middle, &stepper.interpolate(system, middle))[event];
                let is_near = time == last.time || between <= M::Scalar::from_f64(NEAR) * last.value;
                if is_near { last.returns + 1 } else { 0 }
            }
            _ => 0,
        };
        if returns >= MOST_RETURNS {
            return Err(StepFailure::Slides { surface: M::EVENTS[event].name });
        }
        self.change = Some(Change { event, time, value: M::Scalar::ZERO, returns });
        Ok(())
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
            let values = values(system, t, y);
            if let Some(change) = &mut self.change {
                change.value = values[change.event];
            }
            self.lookout.restart(t, values);
        }
    }

    /// Goes on where the system is another one, with other inputs.
    pub(crate) fn jump(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        if !M::EVENTS.is_empty() {
            self.lookout.jump(values(system, t, y));
        }
    }
}

/// A switch is looked for this many roundings of the state's largest component beyond its surface, lest rounding on the surface
/// pass it again and again.
const ROUNDINGS: f64 = 32.0;

/// The values of all declared events, and of others that never happen. Those of switches are zero a little beyond their surfaces.
fn values<M: OdeSystem>(system: &M, t: M::Scalar, y: &M::State) -> [M::Scalar; MOST_LOCATED] {
    let mut values = exact_values(system, t, y);
    if M::EVENTS.iter().any(|event| event.is_side) {
        let size = y.as_ref().iter().fold(M::Scalar::ZERO, |size, entry| size.max(entry.abs()));
        let width = M::Scalar::from_f64(ROUNDINGS) * M::Scalar::epsilon() * size;
        let sides = values.iter_mut().zip(M::EVENTS).filter(|(_, event)| event.is_side);
        sides.for_each(|(value, _)| *value = *value + width);
    }
    values
}

fn exact_values<M: OdeSystem>(system: &M, t: M::Scalar, y: &M::State) -> [M::Scalar; MOST_LOCATED] {
    let mut values = [M::Scalar::ONE; MOST_LOCATED];
    let count = M::EVENTS.len().min(MOST_LOCATED);
    system.event_values(t, y, &mut values[..count]);
    values
}

/// The event of a switch where it passes its surface, as well as times are spaced. What is passed late, however little, adds up: a
/// body that bounces in a valley with a kink would gain energy.
fn on_surface<M: OdeSystem>(
    system: &M,
    stepper: &mut impl Stepper<M>,
    beyond: Occurrence<M::Scalar, M::State>,
) -> Occurrence<M::Scalar, M::State> {
    let from = stepper.last_time();
    let mut value = |t: M::Scalar| exact_values(system, t, &stepper.interpolate(system, t))[beyond.event];
    let (before, after) = ((from, value(from)), (beyond.time, value(beyond.time)));
    let is_bracket = before.1 > M::Scalar::ZERO && after.1 < M::Scalar::ZERO;
    let located = if is_bracket { locate(before, after, M::Scalar::ZERO, value) } else { None };
    let time = located.unwrap_or(beyond.time);
    Occurrence { time, state: stepper.interpolate(system, time), ..beyond }
}

/// Whether a run may go this way: not backwards through impacts and friction, whose past does not follow from the present.
///
/// # Errors
/// If it may not, or if there are more events than can be looked for.
pub(crate) fn is_forwards<M: OdeSystem>(t: M::Scalar, end: M::Scalar) -> Result<(), StepFailure<M::Scalar>> {
    if M::EVENTS.len() > MOST_LOCATED {
        return Err(StepFailure::Setting("the system declares more events than can be looked for"));
    }
    if end < t && M::EVENTS.iter().any(|event| event.is_switch && !event.is_side) {
        return Err(StepFailure::Setting("contacts and dry friction run forwards in time only"));
    }
    Ok(())
}
