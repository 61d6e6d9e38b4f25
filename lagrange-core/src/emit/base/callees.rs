//! Functions of the user's crate: where they are named, and derivatives that are called and not
//! named.

use lagrange_expr::diagnostics::Report;
use lagrange_expr::opaque::Opaque;
use lagrange_language::syntax::ast::{AstId, Declaration, Expression, ExternalFunction, Name, StatementKind};

use super::messages;

/// A derivative that is called, and not among those that the declaration lists.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(in crate::emit) struct MissingDerivative {
    pub(in crate::emit) derivative: Opaque,
    /// The caller, in words, and whether it can be omitted.
    pub(in crate::emit) needed_by: String,
    pub(in crate::emit) product: Option<&'static str>,
}

/// The names of functions without a formula, where the user says them.
pub(in crate::emit) fn callees(declaration: &Declaration) -> Vec<Name> {
    let functions = externals(declaration);
    let names = functions.flat_map(|function| {
        let derivatives = function.derivatives.iter().flatten().map(|derivative| &derivative.name);
        derivatives.chain([&function.name])
    });
    let tables = declaration.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Table(table) => Some(&table.name),
        _ => None,
    });
    names.chain(tables).cloned().collect()
}

fn externals(declaration: &Declaration) -> impl Iterator<Item = &ExternalFunction> {
    declaration.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::External(function) => Some(&**function),
        _ => None,
    })
}

/// Reports at the declaration of each function which of its derivatives is missing, and where that
/// comes from.
pub(in crate::emit) fn report_missing(
    declaration: &Declaration,
    missing: &[MissingDerivative],
    report: &mut Report,
) {
    for MissingDerivative { derivative, needed_by, product } in missing {
        let function = derivative.function();
        let declared = externals(declaration).find(|declared| declared.name.text == function.name);
        let place = declared.map_or(declaration.name.span, |declared| declared.name.span);
        let error = report.error(place, messages::missing_derivative(&derivative.describe(), needed_by));
        if let Some(call) = first_call(declaration, &function.name) {
            error.related(declaration.expressions.origin(call), messages::CALLED_HERE);
        }
        error.help(messages::missing_derivative_help(&derivative.label(), *product));
    }
}

/// Returns the first call of a function.
fn first_call(declaration: &Declaration, name: &str) -> Option<AstId> {
    let mut expressions = declaration.expressions.iter();
    let is_call =
        |expression: &Expression| matches!(expression, Expression::Call(called, _) if called.text == name);
    expressions.find(|(_, expression)| is_call(expression)).map(|(id, _)| id)
}
