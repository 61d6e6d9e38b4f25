//! What rounding leaves of an equation where it is solved.

use crate::calculus::partials;
use crate::collections::OrderedMap;
use crate::expr::{AlgebraicUnknown, ExprId, Function, Graph};
use crate::functions;

/// Bound of what rounding leaves of an equation where it is solved, in units of the rounding of one operation: Σ |n ∂r/∂n| over the value
/// and all that is computed of it on the way to r (Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., §3.3 and chapter 25).
pub fn rounding(graph: &mut Graph, unknown: &AlgebraicUnknown) -> ExprId {
    let mut adjoints: OrderedMap<ExprId, ExprId> = OrderedMap::default();
    for id in graph.reachable(&[unknown.residual]) {
        let mut depends = id == unknown.value;
        graph.node(id).for_each_child(|child| depends |= adjoints.contains(&child));
        if depends {
            let none = graph.number(0);
            adjoints.insert(id, none);
        }
    }
    let one = graph.number(1);
    adjoints.insert(unknown.residual, one);
    let nodes = adjoints.iter().rev().map(|(id, _)| *id).collect::<Vec<_>>();
    let mut shares = Vec::new();
    for id in nodes {
        let adjoint = adjoints.get(&id).copied().unwrap_or(id);
        if id != unknown.residual {
            let share = graph.multiply(adjoint, id);
            shares.push(functions::apply(graph, Function::Abs, &[share]));
        }
        for (child, slope) in partials(graph, id) {
            if let Some(&known) = adjoints.get(&child) {
                let through = graph.multiply(adjoint, slope);
                let total = graph.add(known, through);
                adjoints.insert(child, total);
            }
        }
    }
    graph.total(shares)
}
