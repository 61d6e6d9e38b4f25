//! Loops and conditions around lines of events, clocks and reductions.

use super::conditions::CombinedCondition;
use super::{AstId, Name, Range};

/// A loop or a condition around a line of an event, a clock or a reduction.
#[derive(Clone, Debug)]
pub enum Enclosure {
    /// `for i in 0..n { … }`
    Loop(Name, Range),
    /// `if i > 0 { … }`, or the negation of what stands before `else`
    Condition(CombinedCondition),
}

impl Enclosure {
    /// Returns its expressions, to be read or replaced.
    pub fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        match self {
            Enclosure::Loop(_, range) => vec![&mut range.from, &mut range.to],
            Enclosure::Condition(condition) => condition.expressions_mut(),
        }
    }
}

/// A line between braces that loops and conditions may enclose.
pub trait Enclosed {
    /// Returns what encloses it, from the outside inwards, until that is written out.
    fn enclosures_mut(&mut self) -> &mut Vec<Enclosure>;
}
