//! Loops, conditions and local names around lines of events, clocks and reductions.

use super::Statement;
use crate::syntax::ast::conditions::CombinedCondition;
use crate::syntax::ast::{AstId, Name, Range};

/// A loop, a condition or a local name around a line of an event, a clock or a reduction.
#[derive(Clone, Debug)]
pub enum Enclosure {
    /// `let dv = e;` before it, with the expression e
    Local(Box<Statement>, AstId),
    /// `for i in 0..n { … }`
    Loop(Name, Range),
    /// `if i > 0 { … }`, or the negated conditions before `else`
    Condition(CombinedCondition),
}

impl Enclosure {
    /// True if its expressions must be evaluated during expansion.
    pub fn is_counted(&self) -> bool {
        !matches!(self, Enclosure::Local(..))
    }

    /// True if both are the same enclosure in the text.
    pub fn is_same(&self, other: &Enclosure) -> bool {
        match (self, other) {
            (Enclosure::Local(_, one), Enclosure::Local(_, other)) => one == other,
            (Enclosure::Loop(_, one), Enclosure::Loop(_, other)) => one.from == other.from,
            (Enclosure::Condition(one), Enclosure::Condition(other)) => one == other,
            _ => false,
        }
    }

    /// Returns its expressions for reading or modification.
    pub fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        match self {
            Enclosure::Local(statement, value) => {
                [value].into_iter().chain(statement.kind.expressions_mut()).collect()
            }
            Enclosure::Loop(_, range) => vec![&mut range.from, &mut range.to],
            Enclosure::Condition(condition) => condition.expressions_mut(),
        }
    }
}

/// A line between braces that loops and conditions may enclose.
pub trait Enclosed {
    /// Returns its enclosures, from the outside inwards, before expansion.
    fn enclosures_mut(&mut self) -> &mut Vec<Enclosure>;
}
