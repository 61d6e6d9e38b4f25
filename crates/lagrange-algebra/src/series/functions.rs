//! Rates of elementary functions.

use crate::calculus::{AccelerationTerms, Rates};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{Dependencies, ExprId, Function, Graph, Node};

/// Returns the values of changing elementary functions within `roots` or the rates of such
/// functions, each with its rate.
pub fn function_rates(graph: &mut Graph, roots: &[ExprId]) -> Vec<(ExprId, ExprId)> {
    let mut rates = Rates::new(AccelerationTerms::Kept);
    let mut found: OrderedMap<ExprId, ExprId> = OrderedMap::default();
    let mut roots = roots.to_vec();
    while !roots.is_empty() {
        let reachable = graph.reachable(&roots);
        roots.clear();
        for id in reachable {
            if is_expanded(graph, id) && !found.contains(&id) {
                let rate = rates.of(graph, id);
                found.insert(id, rate);
                roots.push(rate);
            }
        }
    }
    found.iter().map(|(value, rate)| (*value, *rate)).collect()
}

/// True for values of functions that change smoothly.
fn is_expanded(graph: &Graph, id: ExprId) -> bool {
    let moving = Dependencies::TIME | Dependencies::COORDINATE | Dependencies::STATE | Dependencies::VELOCITY;
    match graph.node(id) {
        Node::Call(Function::Sign | Function::MagnitudeSlope | Function::Power, _) => false,
        Node::Call(..) => graph.dependencies(id).intersects(moving),
        _ => false,
    }
}
