//! Names that expressions should have in emitted code.

use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::ExprId;

/// Preferred names of expressions: those of the user's `let` statements, and those of the entries
/// of the matrices and vectors that mechanics knows.
#[derive(Clone, Default, Debug)]
pub struct Labels {
    names: OrderedMap<ExprId, String>,
}

impl Labels {
    /// Gives an expression a name, unless it has one already.
    pub fn insert(&mut self, expression: ExprId, name: impl Into<String>) {
        self.names.get_or_insert_with(expression, || name.into());
    }

    /// Expressions with their names, in the order in which they were named.
    pub fn iter(&self) -> impl Iterator<Item = (ExprId, &str)> {
        self.names.iter().map(|(expression, name)| (*expression, name.as_str()))
    }

    /// Returns the name of an expression.
    pub fn get(&self, expression: ExprId) -> Option<&str> {
        self.names.get(&expression).map(String::as_str)
    }
}
