//! Loops, choices and parts: statements in braces, as written.

use super::Statement;
use super::parts::{PartDefinition, Placement};
use crate::syntax::ast::conditions::CombinedCondition;
use crate::syntax::ast::{AstId, Name, Range};

/// `for i in 0..n { … }`
#[derive(Clone, Debug)]
pub struct Repetition {
    /// The variable.
    pub variable: Name,
    /// Its values.
    pub range: Range,
    /// The statements that are meant for each of them.
    pub body: Vec<Statement>,
}

/// `if i > 0 { … } else if … { … } else { … }` around statements.
#[derive(Clone, Debug)]
pub struct Selection {
    /// Conditions, each with the statements that are meant where it holds and none before it does.
    pub branches: Vec<(CombinedCondition, Vec<Statement>)>,
    /// Statements that apply if no condition holds.
    pub otherwise: Vec<Statement>,
}

/// Statements that stand for others: those of loops, choices and parts.
#[derive(Clone, Debug)]
pub enum Block {
    /// A loop.
    Repeat(Box<Repetition>),
    /// A choice.
    Select(Selection),
    /// A part.
    Part(Box<PartDefinition>),
    /// A placement of a part.
    Place(Box<Placement>),
    /// `include "parts/leg.lag";`, the path of a file of parts.
    Include(Name),
}

impl Block {
    /// Returns the statements between each pair of braces, without those of parts.
    pub fn bodies(&self) -> Vec<&[Statement]> {
        match self {
            Block::Repeat(repetition) => vec![&repetition.body],
            Block::Select(Selection { branches, otherwise }) => {
                branches.iter().map(|(_, body)| &body[..]).chain([&otherwise[..]]).collect()
            }
            Block::Part(_) | Block::Place(_) | Block::Include(_) => Vec::new(),
        }
    }

    /// Returns the expressions in front of the braces or in a placement, and the statements between
    /// each pair of braces.
    pub fn parts_mut(&mut self) -> (Vec<&mut AstId>, Vec<&mut Vec<Statement>>) {
        match self {
            Block::Repeat(repetition) => {
                let Repetition { range, body, .. } = &mut **repetition;
                (vec![&mut range.from, &mut range.to], vec![body])
            }
            Block::Select(Selection { branches, otherwise }) => {
                let parts = branches.iter_mut().map(|(condition, body)| (condition.expressions_mut(), body));
                let (conditions, mut bodies): (Vec<_>, Vec<_>) = parts.unzip();
                bodies.push(otherwise);
                (conditions.into_iter().flatten().collect(), bodies)
            }
            Block::Part(part) => {
                let defaults = part.arguments.iter_mut().filter_map(|argument| argument.default.as_mut());
                (defaults.collect(), vec![&mut part.body])
            }
            Block::Place(placement) => (placement.expressions_mut(), Vec::new()),
            Block::Include(_) => (Vec::new(), Vec::new()),
        }
    }

    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let (mut expressions, bodies) = self.parts_mut();
        let within = bodies.into_iter().flatten().flat_map(|statement| statement.kind.expressions_mut());
        expressions.extend(within);
        expressions
    }
}
