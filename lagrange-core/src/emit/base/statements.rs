//! The plain statements of a declaration.

use crate::model::Product;
use lagrange_language::syntax::ast::{Declaration, StatementKind};
use lagrange_language::syntax::print;

/// Writes the statements, one on each line, without requests that only systems with bodies can
/// satisfy, and without the request for these statements.
pub fn statements(declaration: &Declaration) -> String {
    let mut declaration = declaration.clone();
    let is_left_out = |product: Product| product.is_of_bodies() || product == Product::Statements;
    let is_left_out = |name: &str| Product::ALL.iter().any(|p| is_left_out(*p) && p.name() == name);
    for statement in &mut declaration.statements {
        if let StatementKind::Emit(items) = &mut statement.kind {
            items.retain(|item| !is_left_out(&item.product.text));
        }
    }
    let is_empty = |kind: &StatementKind| matches!(kind, StatementKind::Emit(items) if items.is_empty());
    declaration.statements.retain(|statement| !is_empty(&statement.kind));
    print::statements(&declaration)
}
