//! An estimate of the number of velocities that a system couples, before anything is derived.

use crate::model::Model;
use lagrange_algebra::calculus::{Degree, Degrees};
use lagrange_expr::collections::HashSet;
use lagrange_expr::expr::Node;
use lagrange_expr::number::Number;

/// Maximum number of expressions that the search visits.
const LONGEST_LOOK: usize = 200_000;

/// Finds the largest number of velocities in one square of the Lagrangian that the mass matrix
/// couples with each other. The search ends when it has found `enough` of them, or when it takes
/// too long.
pub fn most_coupled(model: &Model, enough: usize) -> usize {
    let graph = &model.graph;
    let mut degrees = Degrees::default();
    degrees.classify(graph, &[model.lagrangian]);
    let is_velocity = model.velocities().into_iter().collect::<HashSet<_>>();
    let (mut most, mut looked_at) = (0, 0);
    for id in graph.reachable(&[model.lagrangian]).into_iter().rev() {
        let Node::Product(factors) = graph.node(id) else { continue };
        let squares = factors.iter().filter(|(_, exponent)| *exponent == Number::TWO).map(|(base, _)| *base);
        for base in squares.filter(|base| degrees.of(graph, *base) == Degree::Affine) {
            let parts = graph.reachable_until(&[base], |part| is_velocity.contains(&part));
            most = most.max(parts.iter().filter(|part| is_velocity.contains(part)).count());
            looked_at += parts.len();
        }
        if looked_at > LONGEST_LOOK || most >= enough {
            break;
        }
    }
    most
}
