//! Reverse-mode gradient: all partial derivatives of a scalar for a small multiple of its own cost
//! (Griewank and Walther, *Evaluating Derivatives*, 2nd ed., §3.2).

use crate::calculus::partials;
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Returns ∂root/∂x for every x of `variables`.
pub fn gradient(graph: &mut Graph, root: ExprId, variables: &[ExprId]) -> Vec<ExprId> {
    let one = graph.number(1);
    adjoint(graph, &[(root, one)], variables)
}

/// Returns Σ weight · ∂root/∂x over the `(root, weight)` pairs of `seeds`, for every x of
/// `variables`. The weights are not differentiated.
pub fn adjoint(graph: &mut Graph, seeds: &[(ExprId, ExprId)], variables: &[ExprId]) -> Vec<ExprId> {
    sweep(graph, seeds, variables, |_, _, _| {})
}

/// Computes adjoints; `visit` receives every expression between the variables and the roots, roots
/// first, with the derivative with respect to it.
pub(super) fn sweep(
    graph: &mut Graph,
    seeds: &[(ExprId, ExprId)],
    variables: &[ExprId],
    mut visit: impl FnMut(&mut Graph, ExprId, ExprId),
) -> Vec<ExprId> {
    let roots = seeds.iter().map(|(root, _)| *root).collect::<Vec<_>>();
    let is_variable = variables.iter().map(|&x| (x, ())).collect::<HashMap<_, _>>();
    let mut active: OrderedMap<ExprId, ()> = OrderedMap::default();
    for id in graph.reachable_until(&roots, |id| is_variable.contains(&id)) {
        let mut depends = is_variable.contains(&id);
        graph.node(id).for_each_child(|child| depends |= active.contains(&child));
        if depends {
            active.insert(id, ());
        }
    }
    let mut contributions: HashMap<ExprId, Vec<ExprId>> = HashMap::default();
    for &(root, weight) in seeds {
        contributions.get_or_insert_with(root, Vec::new).push(weight);
    }
    for (&id, ()) in active.iter().rev() {
        if is_variable.contains(&id) {
            continue;
        }
        let Some(terms) = contributions.remove(&id) else { continue };
        let bar = graph.sum(Number::ZERO, terms.into_iter().map(|term| (term, Number::ONE)));
        visit(graph, id, bar);
        for (child, slope) in partials(graph, id) {
            if active.contains(&child) {
                let term = graph.multiply(bar, slope);
                contributions.get_or_insert_with(child, Vec::new).push(term);
            }
        }
    }
    variables
        .iter()
        .map(|x| {
            let terms = contributions.get(x).cloned().unwrap_or_default();
            graph.total(terms)
        })
        .collect()
}
