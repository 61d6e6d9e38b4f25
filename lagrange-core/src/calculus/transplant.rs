//! Copies of expressions in a graph of their own.

use crate::calculus::substitute::construct;
use crate::collections::HashMap;
use crate::expr::{ExprId, Graph, Node};
use crate::symbol::Role;

/// A new graph with everything that `roots` are made of, and where each expression is there. No rates of positions are set in it. Symbols
/// keep their names and get the roles that `role` gives them, which must be as many as before.
pub fn transplant(
    source: &Graph,
    roots: &[ExprId],
    role: impl Fn(Role) -> Role,
) -> (Graph, HashMap<ExprId, ExprId>) {
    let mut graph = Graph::new();
    let mut image: HashMap<ExprId, ExprId> = HashMap::default();
    for id in source.reachable(roots) {
        let node = source.node(id);
        let new = match node {
            Node::Symbol(symbol) => {
                let symbol = source.symbols().get(*symbol);
                graph.dotted_symbol(&symbol.name, role(symbol.role), symbol.dots)
            }
            _ => construct(&mut graph, node.clone(), id, |child| image.get(&child).copied().unwrap_or(child)),
        };
        image.insert(id, new);
    }
    (graph, image)
}
