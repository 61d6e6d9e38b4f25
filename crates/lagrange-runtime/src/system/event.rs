//! Events of a system: its declared events, and its responses to them.

use super::OdeSystem;
use crate::scalar::{Number, Scalar};

/// An event stated in the declaration of a system.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DeclaredEvent {
    /// Its name.
    pub name: &'static str,
    /// Direction of the zeros that count.
    pub direction: Direction,
    /// True if it belongs to a contact or to dry friction. Its function is then positive, except
    /// for rounding, while the present mode lasts, and falls through zero where the mode ends. A
    /// body that touches the ground at the start and is pushed below it counts as a hit.
    pub is_switch: bool,
    /// True if it belongs to a surface on which the equations are not smooth, identified by the
    /// name of the event. It is not reported to observers of a motion.
    pub is_side: bool,
}

impl DeclaredEvent {
    /// Creates an event whose zeros in this direction count.
    pub const fn new(name: &'static str, direction: Direction) -> Self {
        DeclaredEvent { name, direction, is_switch: false, is_side: false }
    }

    /// Creates the event that switches the mode of a contact or of dry friction.
    pub const fn switch(name: &'static str) -> Self {
        DeclaredEvent { name, direction: Direction::Falling, is_switch: true, is_side: false }
    }

    /// Creates the event by which a [switch](crate::event::Switches) changes its side.
    pub const fn side(name: &'static str) -> Self {
        DeclaredEvent { is_side: true, ..DeclaredEvent::switch(name) }
    }

    /// True if it changes the mode of a contact or of dry friction.
    pub const fn is_of_mode(&self) -> bool {
        self.is_switch && !self.is_side
    }
}

/// True if one of these events changes the mode of a contact or of dry friction.
pub(crate) fn have_modes(events: &[DeclaredEvent]) -> bool {
    events.iter().any(DeclaredEvent::is_of_mode)
}

/// Maximum number of events located by runs, including those by which
/// [switches](crate::event::Switches) change their sides.
pub const MAX_LOCATED: usize = 512;

/// Returns the values of all declared events, padded with ones.
pub(crate) fn values_of_events<M: OdeSystem, const C: usize>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
) -> [M::Scalar; C] {
    let mut values = [M::Scalar::ONE; C];
    let count = system.events().len().min(C);
    system.event_values(t, y, &mut values[..count]);
    values
}

/// The direction in which a function passes zero as the integration proceeds. If time runs
/// backwards, a function that rises with time is falling.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// Either.
    Crossing,
}

impl Direction {
    /// True if a change from the sign of `before` to the sign of `after`, both nonzero, counts.
    pub(crate) fn counts<S: Scalar>(self, before: S, after: S) -> bool {
        let (rises, falls) = (before < S::ZERO && after > S::ZERO, before > S::ZERO && after < S::ZERO);
        match self {
            Direction::Rising => rises,
            Direction::Falling => falls,
            Direction::Crossing => rises || falls,
        }
    }
}

/// The response to a declared event.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Response<M, S, Y> {
    /// Action.
    pub action: Action<Y>,
    /// The system that continues, if it differs: with other contacts closed, or other friction
    /// sticking.
    pub system: Option<M>,
    /// Kind of event.
    pub kind: EventKind<S>,
}

impl<M, S, Y> Response<M, S, Y> {
    /// Creates a response of this action alone.
    pub fn new(action: Action<Y>) -> Self {
        Response { action, system: None, kind: EventKind::Zero }
    }
}

/// The action at an event.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Action<Y> {
    /// The run continues.
    Continue,
    /// The run ends here.
    Stop,
    /// The run continues from this state instead.
    Replace(Y),
}

/// The effect of an impact.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Impact<S> {
    /// The impulse in the contact, in N s for SI units; never negative.
    pub impulse: S,
    /// The kinetic energy lost in all contacts that were hit at once and by friction. With moving
    /// surfaces, it is measured in their frame. Never negative except for rounding.
    pub energy_loss: S,
}

/// The kind of a declared event.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
#[non_exhaustive]
pub enum EventKind<S> {
    /// A zero of a function.
    #[default]
    Zero,
    /// An impact after which the contact opened again.
    Impact(Impact<S>),
    /// A contact closed: after a plastic impact, or after infinitely many impacts that accumulate
    /// at `at`.
    Closed {
        /// The time at which the contact comes to rest. It follows the event by the duration of the
        /// last bounces, so it may be after the end of the run.
        at: S,
        /// The impact at which it closed.
        impact: Impact<S>,
    },
    /// The force of a closed contact fell to zero, and it opened.
    Opened,
    /// Friction began to stick.
    Stuck,
    /// Friction began to slip.
    Slipped,
}
