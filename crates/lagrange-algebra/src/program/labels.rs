//! Names that expressions should have in emitted code.

use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::ExprId;

/// Preferred names of expressions: those of the user's `let` statements, and those of the entries
/// of matrices and vectors in mechanics.
#[derive(Clone, Default, Debug)]
pub struct Labels {
    names: OrderedMap<ExprId, String>,
}

impl Labels {
    /// Names an expression unless it already has a name.
    pub fn insert(&mut self, expression: ExprId, name: impl Into<String>) {
        self.names.get_or_insert_with(expression, || name.into());
    }

    /// Returns expressions with their names, in the order of naming.
    pub fn iter(&self) -> impl Iterator<Item = (ExprId, &str)> {
        self.names.iter().map(|(expression, name)| (*expression, name.as_str()))
    }

    /// Returns the name of an expression.
    pub fn get(&self, expression: ExprId) -> Option<&str> {
        self.names.get(&expression).map(String::as_str)
    }
}
