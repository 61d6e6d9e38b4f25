//! Functions of the user's crate: the places of their names, and derivatives that are called but
//! not declared.

use lagrange_expr::diagnostics::Report;
use lagrange_expr::opaque::Opaque;
use lagrange_language::syntax::ast::{AstId, Declaration, Expression, ExternalFunction, Name, StatementKind};

use super::messages;

/// A derivative that is called but not listed in the declaration.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(in crate::emit) struct MissingDerivative {
    pub(in crate::emit) derivative: Opaque,
    /// Description of the caller; `product` is its name if it can be omitted.
    pub(in crate::emit) needed_by: String,
    pub(in crate::emit) product: Option<&'static str>,
}

/// Returns the names of functions without a formula, at the places where the user wrote them.
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

/// Reports missing derivatives at the declaration of each function, with the reason why they are
/// needed.
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
