//! Events, clocks, contacts and friction.

use lagrange_expr::expr::ExprId;
use lagrange_language::syntax::ast::Direction;

/// A zero to be found during a motion, and the action at it.
#[derive(Clone, Debug)]
pub struct Event {
    /// Name of the event.
    pub name: String,
    /// Function of t, q and v, accelerations and multipliers, whose zeros are the event.
    pub value: ExprId,
    /// Direction of relevant zeros.
    pub direction: Direction,
    /// Action at the event.
    pub action: Action,
}

/// Assignments at the multiples of a period.
#[derive(Clone, Debug)]
pub struct Clock {
    /// Period, a function of parameters.
    pub period: ExprId,
    /// Simultaneous assignments at each tick.
    pub assignments: Vec<Assignment>,
}

/// Action at an event.
#[derive(Clone, Debug)]
pub enum Action {
    /// The motion ends.
    Stop,
    /// The run continues.
    Record,
    /// Bodies touch: the contact with this index among the reactions.
    Impact(u32),
    /// Entries of the state are assigned new values simultaneously.
    Assign(Vec<Assignment>),
}

/// An entry of the state and its value after an event.
#[derive(Clone, Copy, Debug)]
pub struct Assignment {
    /// Index in [q…, v…], where q has one entry for each position.
    pub index: usize,
    /// New value, a function of t, q and v before the event.
    pub value: ExprId,
}

/// A contact or dry friction, with a force along the gradient of a velocity.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// Name of the reaction.
    pub name: String,
    /// Symbol of the force.
    pub symbol: ExprId,
    /// Rate of the gap, or the slip velocity, affine in q̇.
    pub velocity: ExprId,
    /// Law of the force.
    pub kind: ReactionKind,
}

/// Law of the force of a contact or of friction.
#[derive(Clone, Copy, Debug)]
pub enum ReactionKind {
    /// A unilateral contact.
    Contact {
        /// Function of t and q, positive if bodies are apart.
        gap: ExprId,
        /// Coefficient of restitution, a function of t, q and v.
        restitution: ExprId,
    },
    /// Dry friction that sticks and slips. Limits are functions of t, q and v, affine in
    /// multipliers and in the forces of previously declared reactions.
    Friction {
        /// Magnitude of the force while slipping.
        kinetic: ExprId,
        /// Maximum magnitude of the force while sticking.
        fixed: ExprId,
    },
    /// The second component of friction in a plane, with the limits of the previous reaction. They
    /// bound the magnitude of the vector.
    Across {
        /// Magnitude while slipping.
        kinetic: ExprId,
        /// Maximum magnitude while sticking.
        fixed: ExprId,
    },
    /// Friction that only slips: the force is −limit · tanh(velocity / width).
    Smooth {
        /// Magnitude of the force far from velocity zero, a limit like those above.
        limit: ExprId,
        /// Velocity, constant in motion.
        width: ExprId,
    },
}

impl ReactionKind {
    /// True if the reaction has its own mode, switched by events.
    pub fn has_mode(self) -> bool {
        !matches!(self, ReactionKind::Smooth { .. } | ReactionKind::Across { .. })
    }
}
