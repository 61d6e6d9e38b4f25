//! Linear equations for symbols.

use super::minors::Minors;
use crate::calculus::{partial, substitute_all};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};

/// Why equations are not solved.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LinearFailure {
    /// The equation at this place is not linear in the symbols.
    Nonlinear(usize),
    /// The determinant vanishes.
    Singular,
}

/// Returns the values of symbols at which as many expressions, linear in them, vanish.
///
/// Cramer's rule divides by the determinant only, so the values hold wherever the equations
/// determine them. The effort grows as 2ⁿ with the number of symbols.
///
/// # Errors
/// If an expression is not linear in the symbols, or the determinant is zero everywhere.
pub fn linear_solution(
    graph: &mut Graph,
    residuals: &[ExprId],
    symbols: &[ExprId],
) -> Result<Vec<ExprId>, LinearFailure> {
    let mut rows = Vec::new();
    for (place, &residual) in residuals.iter().enumerate() {
        let row = symbols.iter().map(|&symbol| partial(graph, residual, symbol)).collect::<Vec<_>>();
        let reachable = graph.reachable(&row);
        if symbols.iter().any(|symbol| reachable.contains(symbol)) {
            return Err(LinearFailure::Nonlinear(place));
        }
        rows.push(row);
    }
    let zero = graph.number(0);
    let at_zero = symbols.iter().map(|&symbol| (symbol, zero)).collect::<HashMap<_, _>>();
    let constants = substitute_all(graph, residuals, &at_zero);
    let mut minors = Minors::new(&rows);
    let determinant = minors.determinant(graph);
    if graph.is_zero(determinant) {
        return Err(LinearFailure::Singular);
    }
    Ok((0..symbols.len()).map(|place| minors.root(graph, &constants, place)).collect())
}
