//! Linear equations for symbols.

use super::minors::Minors;
use crate::calculus::{partial, substitute_all};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph, Node};

/// Reason why equations cannot be solved.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LinearFailure {
    /// The equation at this place is not linear in the symbols.
    Nonlinear(usize),
    /// The determinant vanishes.
    Singular,
}

/// Returns the values of symbols at which an equal number of expressions, linear in them, vanish.
///
/// Cramer's rule only divides by the determinant, so the values hold wherever the equations
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
        if is_branched(graph, residual, symbols) || reaches(graph, &row, symbols) {
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

fn reaches(graph: &Graph, roots: &[ExprId], symbols: &[ExprId]) -> bool {
    graph.reachable(roots).iter().any(|id| symbols.contains(id))
}

/// True if a condition or a function depends on symbols. Derivatives do not reveal jumps, such as
/// that of the sign of a symbol.
fn is_branched(graph: &Graph, root: ExprId, symbols: &[ExprId]) -> bool {
    graph.reachable(&[root]).into_iter().any(|id| match graph.node(id) {
        Node::Choose { left, right, .. } => reaches(graph, &[*left, *right], symbols),
        Node::Call(_, arguments) => reaches(graph, arguments, symbols),
        _ => false,
    })
}
