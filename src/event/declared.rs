//! Events that belong to a system.

use super::direction::Direction;
use super::run::Reaction;
use crate::contact::Happening;

/// An event that the declaration of a system states.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DeclaredEvent {
    /// Its name.
    pub name: &'static str,
    /// Which zeros count.
    pub direction: Direction,
    /// Whether it belongs to a contact or to dry friction. Its function then is positive, but for rounding, while the present
    /// mode lasts, and falling through zero is what ends the mode: a body that touches at the start and is pushed below the
    /// ground has hit it.
    pub is_switch: bool,
    /// Whether it belongs to a surface on which the equations are not smooth, and then its name says to which. It is no event for
    /// those who watch a motion.
    pub is_side: bool,
}

impl DeclaredEvent {
    /// An event whose zeros in this direction count.
    pub const fn new(name: &'static str, direction: Direction) -> Self {
        DeclaredEvent { name, direction, is_switch: false, is_side: false }
    }

    /// The event by which a contact or dry friction switches its mode.
    pub const fn switch(name: &'static str) -> Self {
        DeclaredEvent { name, direction: Direction::Falling, is_switch: true, is_side: false }
    }

    /// The event by which a [switch](super::Switches) changes its side.
    pub const fn side(name: &'static str) -> Self {
        DeclaredEvent { is_side: true, ..DeclaredEvent::switch(name) }
    }
}

/// The largest number of events that a system can declare.
pub const MOST_DECLARED: usize = 32;

/// The largest number of events that runs look for, those by which [switches](super::Switches) change their sides among them.
pub(crate) const MOST_LOCATED: usize = 64;

/// What a declared event does.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Answer<M, S, Y> {
    /// How to go on.
    pub reaction: Reaction<Y>,
    /// The system that goes on, if it is not the same: with other contacts closed, other friction sticking.
    pub system: Option<M>,
    /// What happened.
    pub happening: Happening<S>,
}

impl<M, S, Y> Answer<M, S, Y> {
    /// Nothing but this reaction.
    pub fn new(reaction: Reaction<Y>) -> Self {
        Answer { reaction, system: None, happening: Happening::Zero }
    }
}
