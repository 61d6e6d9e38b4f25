//! Substitution of expressions for expressions.

use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::functions::apply;

/// Replaces every expression in `root` that `replacements` contains, all at once.
pub fn substitute(graph: &mut Graph, root: ExprId, replacements: &HashMap<ExprId, ExprId>) -> ExprId {
    substitute_all(graph, &[root], replacements)[0]
}

/// Replaces expressions in several roots, each shared part once.
pub fn substitute_all(
    graph: &mut Graph,
    roots: &[ExprId],
    replacements: &HashMap<ExprId, ExprId>,
) -> Vec<ExprId> {
    let mut image: HashMap<ExprId, ExprId> = HashMap::default();
    for id in graph.reachable_until(roots, |id| replacements.contains(&id)) {
        let new = match replacements.get(&id) {
            Some(&replacement) => replacement,
            None => rebuild(graph, id, |child| image.get(&child).copied().unwrap_or(child)),
        };
        image.insert(id, new);
    }
    roots.iter().map(|root| image.get(root).copied().unwrap_or(*root)).collect()
}

/// Rebuilds a node from mapped operands, using the constructors.
pub fn rebuild(graph: &mut Graph, id: ExprId, map: impl Fn(ExprId) -> ExprId) -> ExprId {
    let node = graph.node(id).clone();
    if matches!(node, Node::Number(_) | Node::Pi) {
        return id;
    }
    construct(graph, node, id, map)
}

/// Reconstructs a node with its operands mapped by `map`; a symbol becomes `id`.
pub(super) fn construct(graph: &mut Graph, node: Node, id: ExprId, map: impl Fn(ExprId) -> ExprId) -> ExprId {
    match node {
        Node::Symbol(_) => id,
        Node::Number(value) => graph.number(value),
        Node::Pi => graph.pi(),
        Node::Sum { constant, terms } => graph.sum(constant, terms.iter().map(|(t, c)| (map(*t), c.clone()))),
        Node::Product(factors) => graph.product(factors.iter().map(|(b, e)| (map(*b), e.clone()))),
        Node::Call(function, arguments) => {
            let arguments = arguments.iter().map(|argument| map(*argument)).collect::<Vec<_>>();
            apply(graph, function, &arguments)
        }
        Node::Opaque(function, arguments) => {
            let arguments = arguments.iter().map(|argument| map(*argument)).collect::<Vec<_>>();
            graph.opaque(function, &arguments)
        }
        Node::Choose { relation, left, right, then, otherwise } => {
            graph.choose(relation, map(left), map(right), map(then), map(otherwise))
        }
    }
}
