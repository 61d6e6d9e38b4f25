//! Loops and choices between statements, as written.

use super::Statement;
use crate::syntax::ast::conditions::IndexCondition;
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
    pub branches: Vec<(IndexCondition, Vec<Statement>)>,
    /// Statements that apply if no condition holds.
    pub otherwise: Vec<Statement>,
}

/// Statements in braces, behind a loop or a choice.
#[derive(Clone, Debug)]
pub enum Block {
    /// A loop.
    Repeat(Box<Repetition>),
    /// A choice.
    Select(Selection),
}

impl Block {
    /// Returns the statements between each pair of braces.
    pub fn bodies(&self) -> Vec<&[Statement]> {
        match self {
            Block::Repeat(repetition) => vec![&repetition.body],
            Block::Select(Selection { branches, otherwise }) => {
                branches.iter().map(|(_, body)| &body[..]).chain([&otherwise[..]]).collect()
            }
        }
    }

    /// Returns the expressions in front of the braces, and the statements between each pair of
    /// them.
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
        }
    }

    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let (mut expressions, bodies) = self.parts_mut();
        let within = bodies.into_iter().flatten().flat_map(|statement| statement.kind.expressions_mut());
        expressions.extend(within);
        expressions
    }
}
