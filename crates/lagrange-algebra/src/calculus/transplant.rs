//! Copies of expressions in a separate graph.

use crate::calculus::substitute::construct;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{AlgebraicUnknowns, ExprId, Graph, Node};
use lagrange_expr::symbol::Role;

/// Creates a new graph with the parts of `roots`, and returns the place of each expression there.
/// No rates of positions are set in the new graph. Symbols keep their names and receive their roles
/// from `role`, which must preserve the number of roles.
pub fn transplant(
    source: &Graph,
    roots: &[ExprId],
    role: impl Fn(Role) -> Role,
) -> (Graph, HashMap<ExprId, ExprId>) {
    let mut graph = Graph::new();
    let mut image: HashMap<ExprId, ExprId> = HashMap::default();
    let equations = source.unknowns().iter().flat_map(AlgebraicUnknowns::expressions);
    let roots = roots.iter().copied().chain(equations).collect::<Vec<_>>();
    for id in source.reachable(&roots) {
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
    for unknowns in source.unknowns() {
        graph.add_unknowns(unknowns.map(|id| image.get(&id).copied().unwrap_or(id)));
    }
    (graph, image)
}
