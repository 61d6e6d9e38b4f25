//! Values of expressions without symbols.

use lagrange_expr::collections::HashMap;
use lagrange_expr::elementary;
use lagrange_expr::expr::node_value;
use lagrange_expr::expr::{ExprId, Graph, Node};

/// Values of expressions without symbols.
#[derive(Default)]
pub(super) struct Constants {
    pub(super) values: HashMap<ExprId, f64>,
}

impl Constants {
    /// Evaluates an expression without symbols. Returns the first part that is not real although
    /// all its operands are finite.
    pub(super) fn first_unreal(&mut self, graph: &Graph, root: ExprId) -> Option<ExprId> {
        if self.values.contains(&root) {
            return None;
        }
        let new = graph.reachable_until(&[root], |id| self.values.contains(&id));
        let unreal = new.into_iter().filter(|&id| self.add(graph, id));
        unreal.min()
    }

    /// Evaluates one node after its operands; true if its value is the first that is not real.
    pub(super) fn add(&mut self, graph: &Graph, id: ExprId) -> bool {
        if self.values.contains(&id) {
            return false;
        }
        let at = |child: &ExprId| self.values.get(child).copied().unwrap_or(f64::NAN);
        let value = node_value(graph, id, at, |_| f64::NAN);
        let mut from_finite = true;
        graph.node(id).for_each_child(|child| from_finite &= at(&child).is_finite());
        self.values.insert(id, value);
        from_finite && (value.is_nan() || value.is_infinite() && has_poles(graph.node(id)))
    }
}

/// True if this is a function that is undefined for some arguments.
fn has_poles(node: &Node) -> bool {
    matches!(node, Node::Call(function, _) if !elementary::row(*function).is_total())
}
