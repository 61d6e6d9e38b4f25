//! Forward-mode Jacobian: all derivatives of several expressions with respect to several symbols.

use crate::calculus::partials;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Derivatives of nodes with respect to their operands, each computed once.
type Slopes = HashMap<ExprId, Vec<(ExprId, ExprId)>>;

/// Returns ∂root/∂x in rows, one for each of `roots` with an entry for each of `variables`, which
/// are symbols.
///
/// One sweep for each variable visits the nodes that depend on it. The sweeps share the derivatives
/// of nodes with respect to their operands. A choice is differentiated branch by branch, so
/// undefined values of the other branch do no harm.
pub fn jacobian(graph: &mut Graph, roots: &[ExprId], variables: &[ExprId]) -> Vec<Vec<ExprId>> {
    let nodes = graph.reachable(roots);
    let mut slopes = Slopes::default();
    let mut rows = vec![Vec::with_capacity(variables.len()); roots.len()];
    for &variable in variables {
        let rates = sweep(graph, &nodes, variable, &mut slopes);
        for (row, root) in rows.iter_mut().zip(roots) {
            row.push(rates.get(root).copied().unwrap_or_else(|| graph.number(0)));
        }
    }
    rows
}

/// Returns the derivatives with respect to a variable of all `nodes` that depend on it. Operands
/// must come first in `nodes`.
fn sweep(
    graph: &mut Graph,
    nodes: &[ExprId],
    variable: ExprId,
    slopes: &mut Slopes,
) -> HashMap<ExprId, ExprId> {
    let mut rates: HashMap<ExprId, ExprId> = HashMap::default();
    for &id in nodes {
        if id == variable {
            rates.insert(id, graph.number(1));
            continue;
        }
        let mut depends = false;
        graph.node(id).for_each_child(|child| depends |= rates.contains(&child));
        if depends {
            let rate = chain_rule(graph, id, &rates, slopes);
            rates.insert(id, rate);
        }
    }
    rates
}

fn chain_rule(graph: &mut Graph, id: ExprId, rates: &HashMap<ExprId, ExprId>, slopes: &mut Slopes) -> ExprId {
    if let Node::Choose { relation, left, right, then, otherwise } = *graph.node(id) {
        let zero = graph.number(0);
        let [then, otherwise] = [then, otherwise].map(|branch| rates.get(&branch).copied().unwrap_or(zero));
        return graph.choose(relation, left, right, then, otherwise);
    }
    if !slopes.contains(&id) {
        let found = partials(graph, id);
        slopes.insert(id, found);
    }
    let mut terms = Vec::new();
    for (operand, slope) in slopes.get(&id).into_iter().flatten() {
        if let Some(&rate) = rates.get(operand) {
            terms.push((graph.multiply(*slope, rate), Number::ONE));
        }
    }
    graph.sum(Number::ZERO, terms)
}
