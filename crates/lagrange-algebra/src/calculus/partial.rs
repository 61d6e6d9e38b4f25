//! Forward partial derivative.

use crate::calculus::partials;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Computes ∂root/∂symbol, memoised over the graph: the cost is proportional to the size of `root`.
pub fn partial(graph: &mut Graph, root: ExprId, symbol: ExprId) -> ExprId {
    let mut derivative: HashMap<ExprId, ExprId> = HashMap::default();
    let one = graph.number(1);
    for id in graph.reachable(&[root]) {
        if id == symbol {
            derivative.insert(id, one);
            continue;
        }
        let mut depends = false;
        graph.node(id).for_each_child(|child| depends |= derivative.contains(&child));
        if !depends {
            continue;
        }
        let mut terms = Vec::new();
        for (child, slope) in partials(graph, id) {
            if let Some(&inner) = derivative.get(&child) {
                terms.push((graph.multiply(slope, inner), Number::ONE));
            }
        }
        derivative.insert(id, graph.sum(Number::ZERO, terms));
    }
    derivative.get(&root).copied().unwrap_or_else(|| graph.number(0))
}
