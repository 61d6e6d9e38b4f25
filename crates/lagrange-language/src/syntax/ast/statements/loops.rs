//! Loops, choices and parts: statements in braces, as written.

use super::parts::{PartDefinition, Placement};
use super::{Statement, StatementKind};
use crate::syntax::ast::conditions::CombinedCondition;
use crate::syntax::ast::{AstId, Name, Range};

/// `for i in 0..n { … }`
#[derive(Clone, Debug)]
pub struct Repetition {
    /// The variable.
    pub variable: Name,
    /// Its values.
    pub range: Range,
    /// The statements to be repeated for each of them.
    pub body: Vec<Statement>,
}

/// `if i > 0 { … } else if … { … } else { … }` around statements.
#[derive(Clone, Debug)]
pub struct Selection {
    /// Conditions, each with the statements that apply if it holds and no previous one does.
    pub branches: Vec<(CombinedCondition, Vec<Statement>)>,
    /// Statements that apply if no condition holds.
    pub otherwise: Vec<Statement>,
}

/// A statement with its context.
#[derive(Clone, Copy)]
pub struct Nested<'d> {
    /// The statement.
    pub statement: &'d Statement,
    /// True within a loop.
    pub is_in_loop: bool,
}

impl<'d> Nested<'d> {
    /// Returns the names that the statement declares for everything that follows; those of one
    /// iteration are excluded.
    pub fn lasting_names(self) -> impl Iterator<Item = (&'d Name, String)> {
        let kind = &self.statement.kind;
        let are_local = self.is_in_loop && kind.is_local_in_loops();
        kind.written_names().into_iter().filter(move |(name, _)| !(are_local && name.indices.is_empty()))
    }
}

/// Returns all statements, including those in loops and choices after the enclosing one, but not
/// those of parts.
pub fn nested(statements: &[Statement]) -> Vec<Nested<'_>> {
    let with = |is_in_loop| move |statement| Nested { statement, is_in_loop };
    let mut pending = statements.iter().rev().map(with(false)).collect::<Vec<_>>();
    let mut all = Vec::new();
    while let Some(next) = pending.pop() {
        all.push(next);
        if let StatementKind::Block(block) = &next.statement.kind {
            let is_in_loop = next.is_in_loop || matches!(block, Block::Repeat(_));
            let within = block.bodies().into_iter().flatten().collect::<Vec<_>>();
            pending.extend(within.into_iter().rev().map(with(is_in_loop)));
        }
    }
    all
}

/// Statements that expand to others: loops, choices and parts.
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

    /// Returns the expressions before the braces or in a placement, and the statements between each
    /// pair of braces.
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
