//! The events that the declaration of a system states.

use super::events::{Events, Found, Next, Origin};
use super::pending::Pending;
use crate::event::{Detector, Occurrence, locate};
use crate::integrate::Stepper;
use crate::scalar::Number;
use crate::system::{Direction, MOST_LOCATED, OdeSystem, Reacted, StepFailure};
use crate::tolerance::SURFACE;

/// The events that the declaration of the system M states.
pub struct DeclaredEvents<M: OdeSystem> {
    pending: Pending<M::Scalar, M::State, MOST_LOCATED>,
    /// When the run started.
    start: M::Scalar,
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

impl<M: OdeSystem> DeclaredEvents<M> {
    /// Starts to look at a time and state.
    pub fn new(system: &M, t: M::Scalar, y: &M::State) -> Self {
        let mut directions = [Direction::Crossing; MOST_LOCATED];
        for (direction, event) in directions.iter_mut().zip(M::EVENTS) {
            *direction = event.direction;
        }
        let detector = Detector::new(directions, t, values(system, t, y)).with_switches(M::EVENTS);
        DeclaredEvents { pending: Pending::new(detector), start: t, change: None }
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
}

impl<M: OdeSystem> Events<M> for DeclaredEvents<M> {
    fn is_empty(&self) -> bool {
        M::EVENTS.is_empty()
    }

    fn look(&mut self, system: &M, stepper: &mut impl Stepper<M>, end: M::Scalar) -> Next<M> {
        if M::EVENTS.is_empty() {
            return Ok(None);
        }
        let is_new = self.pending.next.is_none();
        let found = self.pending.look(system, stepper, end, |t, y| values(system, t, y));
        found.map_err(|cause| cause.named(M::EVENTS))?;
        if let Some(next) = self.pending.next
            && is_new
            && M::EVENTS[next.event].is_side
        {
            let next = on_surface(system, stepper, next);
            self.check_sliding(system, stepper, &next)?;
            self.pending.next = Some(next);
        }
        Ok(self.pending.time().map(|time| (Origin::Declared, time)))
    }

    fn take(&mut self, _origin: Origin) -> Option<Found<M>> {
        self.pending.take()
    }

    fn react(&mut self, system: &M, _origin: Origin, event: &Found<M>) -> Reacted<M> {
        system.react(event.event, event.time, (event.time - self.start).abs(), &event.state)
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        if !M::EVENTS.is_empty() {
            let values = values(system, t, y);
            if let Some(change) = &mut self.change {
                change.value = values[change.event];
            }
            self.pending.restart(t, values);
        }
    }

    fn jump(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        if !M::EVENTS.is_empty() {
            self.pending.jump(values(system, t, y));
        }
    }
}

/// The values of all declared events, and of others that never happen. Those of switches are zero a little beyond their surfaces.
fn values<M: OdeSystem>(system: &M, t: M::Scalar, y: &M::State) -> [M::Scalar; MOST_LOCATED] {
    let mut values = exact_values(system, t, y);
    if M::EVENTS.iter().any(|event| event.is_side) {
        let size = y.as_ref().iter().fold(M::Scalar::ZERO, |size, entry| size.max(entry.abs()));
        let width = SURFACE.part::<M::Scalar>() * size;
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
