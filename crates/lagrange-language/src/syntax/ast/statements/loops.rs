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

impl Repetition {
    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let range = [&mut self.range.from, &mut self.range.to];
        range.into_iter().chain(within(&mut self.body)).collect()
    }
}

/// `if i > 0 { … } else if … { … } else { … }` around statements.
#[derive(Clone, Debug)]
pub struct Selection {
    /// Conditions, each with the statements that are meant where it holds and none before it does.
    pub branches: Vec<(IndexCondition, Vec<Statement>)>,
    /// Statements that apply if no condition holds.
    pub otherwise: Vec<Statement>,
}

impl Selection {
    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let branches = self.branches.iter_mut();
        let branches = branches
            .flat_map(|(condition, body)| condition.expressions_mut().into_iter().chain(within(body)));
        branches.chain(within(&mut self.otherwise)).collect()
    }
}

fn within(statements: &mut [Statement]) -> impl Iterator<Item = &mut AstId> {
    statements.iter_mut().flat_map(|statement| statement.kind.expressions_mut())
}
