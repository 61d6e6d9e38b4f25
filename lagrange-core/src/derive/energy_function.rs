//! The energy that is conserved if the Lagrangian does not depend on time.

use crate::model::{Energies, Model};
use lagrange_algebra::calculus::{gradient, homogeneity};
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Returns the energy function h = v·∂L/∂v − L (Goldstein, Poole and Safko, *Classical Mechanics*,
/// 3rd ed., §2.7). A term of L that is homogeneous of degree k in the velocities contributes k − 1
/// times itself (Euler).
pub(super) fn energy_function(model: &mut Model) -> ExprId {
    let graph = &mut model.graph;
    if let Energies::Separate { kinetic, potential } = model.energies
        && homogeneity(graph, kinetic) == Some(2)
    {
        return graph.add(kinetic, potential);
    }
    if let Some(terms) = weighted_by_degree(graph, model.lagrangian) {
        return graph.sum(Number::ZERO, terms);
    }
    let velocities = model.velocities();
    let graph = &mut model.graph;
    let momenta = gradient(graph, model.lagrangian, &velocities);
    let mut terms = vec![(model.lagrangian, Number::MINUS_ONE)];
    for (&velocity, momentum) in velocities.iter().zip(momenta) {
        terms.push((graph.multiply(velocity, momentum), Number::ONE));
    }
    graph.sum(Number::ZERO, terms)
}

/// Returns the terms of a sum, with each coefficient multiplied by the degree of its term less one.
fn weighted_by_degree(graph: &mut Graph, sum: ExprId) -> Option<Vec<(ExprId, Number)>> {
    let Node::Sum { constant, terms } = graph.node(sum).clone() else { return None };
    let mut weighted = vec![(graph.number(constant), Number::MINUS_ONE)];
    for (term, coefficient) in &terms {
        let weight = Number::from(homogeneity(graph, *term)?.checked_sub(1)?);
        weighted.push((*term, coefficient * &weight));
    }
    Some(weighted)
}
