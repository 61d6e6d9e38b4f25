//! The events in the declaration of a system.

use super::events::{Events, Found, Next, Origin, Replacement};
use super::margins::Margins;
use super::pending::Pending;
use crate::event::{Detector, Occurrence, end_of_instant, locate};
use crate::integrate::Stepper;
use crate::scalar::{Number, Scalar};
use crate::system::{
    Action, DeclaredEvent, Direction, OdeSystem, Reacted, Response, StepFailure, values_of_events,
};

/// The events in the declaration of the system M, at most C.
pub struct DeclaredEvents<M: OdeSystem, const C: usize> {
    pending: Pending<M::Scalar, M::State, C>,
    margins: Margins<M::Scalar, C>,
    /// Start time of the run.
    start: M::Scalar,
    /// The last change of a side.
    change: Option<Change<M::Scalar>>,
    /// True for each further side that changes with the last event.
    together: [bool; C],
}

/// A switch that changed its side.
#[derive(Clone, Copy)]
struct Change<S> {
    event: usize,
    time: S,
    /// Value of its event function right after the change.
    value: S,
    /// Number of changes without leaving its surface.
    returns: u32,
}

/// Number of returns without leaving the surface after which a switch counts as sliding.
const MAX_RETURNS: u32 = 5;
/// A switch has left its surface if its value exceeds this multiple of the value right after the
/// change.
const NEAR: f64 = 4.0;

impl<M: OdeSystem, const C: usize> DeclaredEvents<M, C> {
    /// Starts the search at a time and state, if there are any events that steppers of type T do
    /// not find themselves.
    pub fn new<T: Stepper<M>>(system: &M, t: M::Scalar, y: &M::State) -> Option<Self> {
        if !are_left(system.events(), T::FINDS_MODES) {
            return None;
        }
        let directions = directions(system.events());
        let margins = Margins::new(system, t, y, &[M::Scalar::ZERO; C]).without_modes(T::FINDS_MODES);
        let detector =
            Detector::new(directions, t, margins.values(system, t, y)).with_switches(system.events());
        let together = [false; C];
        Some(DeclaredEvents { pending: Pending::new(detector), margins, start: t, change: None, together })
    }

    /// Returns the event that was found last, with the switches that change their sides together
    /// with it.
    pub fn passed_with(&self, system: &M, event: usize) -> impl Iterator<Item = usize> {
        let is_side = system.events()[event].is_side;
        let others = (0..C).filter(move |side| is_side && self.together[*side]);
        core::iter::once(event).chain(others)
    }

    /// Counts the returns of a switch to its surface without leaving it.
    ///
    /// # Errors
    /// If there are so many that the state slides along the surface.
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
                let between =
                    self.margins.values(system, middle, &stepper.interpolate(system, middle))[event];
                let is_near = time == last.time || between <= M::Scalar::from_f64(NEAR) * last.value;
                if is_near { last.returns + 1 } else { 0 }
            }
            _ => 0,
        };
        if returns >= MAX_RETURNS {
            return Err(StepFailure::Slides { surface: system.events()[event].name });
        }
        self.change = Some(Change { event, time, value: M::Scalar::ZERO, returns });
        Ok(())
    }
}

/// True if any of these events must be searched for. Events of modes need not be if steps find
/// them.
fn are_left(events: &[DeclaredEvent], finds_modes: bool) -> bool {
    events.iter().any(|event| !finds_modes || !event.is_of_mode())
}

fn directions<const C: usize>(events: &[DeclaredEvent]) -> [Direction; C] {
    let mut directions = [Direction::Crossing; C];
    for (direction, event) in directions.iter_mut().zip(events) {
        *direction = event.direction;
    }
    directions
}

impl<M: OdeSystem, const C: usize> Events<M> for DeclaredEvents<M, C> {
    fn is_empty(&self) -> bool {
        false
    }

    fn look(&mut self, system: &M, stepper: &mut impl Stepper<M>, end: M::Scalar) -> Next<M> {
        let is_new = self.pending.next.is_none();
        if self.margins.time != stepper.time() {
            let ranges = self.pending.ranges();
            self.margins = self.margins.again(system, stepper.time(), stepper.state(), &ranges);
        }
        let margins = self.margins;
        let found = self.pending.look(system, stepper, end, |t, y| margins.values(system, t, y));
        found.map_err(|cause| cause.named(system.events()))?;
        if let Some(next) = self.pending.next
            && is_new
            && system.events()[next.event].is_side
        {
            let passage = Passage::new(system, stepper, &next);
            let next = passage.on_surface(system, stepper, next);
            self.check_sliding(system, stepper, &next)?;
            self.together = passage.others(next.event);
            if self.together.contains(&true) {
                let values = margins.values(system, next.time, &next.state);
                self.pending.fire_together(&values, &self.together);
            }
            self.pending.next = Some(next);
        }
        Ok(self.pending.time().map(|time| (Origin::Declared, time)))
    }

    fn take(&mut self, _origin: Origin) -> Option<Found<M>> {
        self.pending.take()
    }

    fn react(&mut self, system: &M, _origin: Origin, event: &Found<M>) -> Reacted<M> {
        let elapsed = (event.time - self.start).abs();
        let mut response = system.react(event.event, event.time, elapsed, &event.state)?;
        for side in self.passed_with(system, event.event).skip(1) {
            let before = response.system.as_ref().unwrap_or(system);
            let state = if let Action::Replace(state) = response.action { state } else { event.state };
            let Response { action, system, .. } = before.react(side, event.time, elapsed, &state)?;
            response.system = system.or(response.system);
            if let Action::Replace(_) = action {
                response.action = action;
            }
        }
        Ok(response)
    }

    fn restart(&mut self, system: &M, t: M::Scalar, y: &M::State, by: Replacement) {
        self.margins = self.margins.again(system, t, y, &self.pending.ranges());
        let values = self.margins.values(system, t, y);
        if let Some(change) = &mut self.change {
            change.value = values[change.event];
        }
        self.pending.restart(t, values, by);
    }

    fn jump(&mut self, system: &M, t: M::Scalar, y: &M::State) {
        self.margins = self.margins.again(system, t, y, &self.pending.ranges());
        self.pending.jump(self.margins.values(system, t, y));
    }
}

/// Sides passed at the same time, within the accuracy of located times.
struct Passage<S, const C: usize> {
    is_passed: [bool; C],
    /// A time at which all of them are passed.
    end: S,
}

impl<S: Scalar, const C: usize> Passage<S, C> {
    /// Finds the sides that are passed together with this event.
    fn new<M>(system: &M, stepper: &mut impl Stepper<M>, first: &Occurrence<S, M::State>) -> Self
    where
        M: OdeSystem<Scalar = S>,
    {
        let end = end_of_instant(first.time, stepper.last_time(), stepper.time());
        let at_end = values_of_events(system, end, &stepper.interpolate(system, end));
        Passage::of((first.event, first.time), system.events(), (end, &at_end))
    }

    /// Returns the sides that are passed with this event, given the values at the end of its
    /// instant.
    fn of((event, time): (usize, S), events: &[DeclaredEvent], (end, at_end): (S, &[S; C])) -> Self {
        let is_side = |k: usize| events.get(k).is_some_and(|event| event.is_side);
        let is_passed = core::array::from_fn(|k| k == event || is_side(k) && at_end[k] < S::ZERO);
        let is_alone = is_passed.iter().filter(|is_passed| **is_passed).count() == 1;
        Passage { is_passed, end: if is_alone { time } else { end } }
    }

    /// Returns the largest of these values among the sides that are passed; it is negative once all
    /// are passed.
    fn last(&self, values: &[S; C]) -> S {
        let passed = values.iter().zip(self.is_passed).filter(|(_, is_passed)| *is_passed);
        passed.fold(-S::ONE / S::ZERO, |last, (value, _)| last.max(*value))
    }

    /// Returns the passed sides other than that of this event.
    fn others(&self, event: usize) -> [bool; C] {
        core::array::from_fn(|k| self.is_passed[k] && k != event)
    }

    /// Moves the event to the time at which the last side passes its surface, within the spacing of
    /// times. Even tiny delays would accumulate: a body that bounces in a valley with a kink would
    /// gain energy.
    fn on_surface<M>(
        &self,
        system: &M,
        stepper: &mut impl Stepper<M>,
        beyond: Occurrence<S, M::State>,
    ) -> Occurrence<S, M::State>
    where
        M: OdeSystem<Scalar = S>,
    {
        let from = stepper.last_time();
        let mut value = |t: S| self.last(&values_of_events(system, t, &stepper.interpolate(system, t)));
        let (before, after) = ((from, value(from)), (self.end, value(self.end)));
        let is_bracket = before.1 > S::ZERO && after.1 < S::ZERO;
        let located = if is_bracket { locate(before, after, S::ZERO, &mut value) } else { None };
        let time = located.unwrap_or(self.end);
        Occurrence { time, state: stepper.interpolate(system, time), ..beyond }
    }
}
