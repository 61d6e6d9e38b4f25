//! Events and dry friction, as written.

use proc_macro2::Span;

use super::enclosures::{Enclosed, Enclosure};
use crate::syntax::ast::{AstId, Name};

/// A zero to be located during a motion, and the action there.
#[derive(Clone, Debug)]
pub struct Event {
    /// Its name.
    pub name: Name,
    /// Function whose zeros are the event.
    pub value: AstId,
    /// Direction of the relevant zeros.
    pub direction: Direction,
    /// Place of the direction.
    pub direction_span: Span,
    /// Action at the event.
    pub action: Action,
}

impl Event {
    /// Returns its expressions.
    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let mut expressions = vec![&mut self.value];
        match &mut self.action {
            Action::Stop | Action::Record => {}
            Action::Impact(restitution) => expressions.push(restitution),
            Action::Assign(assignments) => {
                expressions.extend(assignments.iter_mut().flat_map(Assignment::parts));
            }
        }
        expressions
    }
}

/// Assignments at equal time intervals.
#[derive(Clone, Debug)]
pub struct Clock {
    /// The interval.
    pub period: AstId,
    /// Assignments at each tick.
    pub assignments: Vec<Assignment>,
}

impl Clock {
    /// Returns its expressions.
    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let assigned = self.assignments.iter_mut().flat_map(Assignment::parts);
        [&mut self.period].into_iter().chain(assigned).collect()
    }
}

/// Direction in which a function crosses zero over time.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// Upwards, from negative to positive.
    Rising,
    /// Downwards, from positive to negative.
    Falling,
    /// Either direction.
    Crossing,
}

/// Action at an event.
#[derive(Clone, Debug)]
pub enum Action {
    /// `stop`: the motion ends.
    Stop,
    /// `record`: the run continues.
    Record,
    /// `impact(e)`: bodies touch; the coefficient of restitution.
    Impact(AstId),
    /// `{ dot(x) = e; y = e; }`: the state changes.
    Assign(Vec<Assignment>),
}

/// One `target = value` of an event, of a clock or of the start.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// Quantity that changes: it should be `x` or `dot(x)` of a coordinate.
    pub target: AstId,
    /// The new value.
    pub value: AstId,
    /// Loops and conditions around it, before expansion.
    pub enclosures: Vec<Enclosure>,
}

impl Assignment {
    /// Creates an assignment without enclosures.
    pub fn new(target: AstId, value: AstId) -> Assignment {
        Assignment { target, value, enclosures: Vec::new() }
    }

    pub(super) fn parts(&mut self) -> impl Iterator<Item = &mut AstId> {
        let around = self.enclosures.iter_mut().flat_map(Enclosure::expressions_mut);
        [&mut self.value, &mut self.target].into_iter().chain(around)
    }
}

impl Enclosed for Assignment {
    fn enclosures_mut(&mut self) -> &mut Vec<Enclosure> {
        &mut self.enclosures
    }
}

/// Dry friction.
#[derive(Clone, Debug)]
pub struct Friction {
    /// Its name.
    pub name: Name,
    /// The slip velocity.
    pub slip: AstId,
    /// The magnitude of the force while it slips.
    pub kinetic: AstId,
    /// The maximum magnitude of the force while it sticks, if different.
    pub fixed: Option<AstId>,
    /// The range of slip velocities over which the force changes its sign, if it is smooth.
    pub width: Option<AstId>,
    /// True if it is a moment of a contact against rolling or spinning.
    pub is_moment: bool,
}

impl Friction {
    /// Returns its expressions.
    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let limits = [Some(&mut self.kinetic), self.fixed.as_mut(), self.width.as_mut()];
        [&mut self.slip].into_iter().chain(limits.into_iter().flatten()).collect()
    }
}
