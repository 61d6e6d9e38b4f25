//! Length of expressions when written out.

use crate::collections::HashMap;
use crate::expr::{ExprId, Graph, Node};
use crate::number::Number;

/// The number of names, numbers and function signs of written-out expressions, each found once; it
/// saturates, because the text of a graph can be exponentially long.
#[derive(Default)]
pub(super) struct Sizes {
    known: HashMap<ExprId, u64>,
}

impl Sizes {
    pub(super) fn of(&mut self, graph: &Graph, root: ExprId) -> u64 {
        let mut pending = vec![root];
        while let Some(&id) = pending.last() {
            let before = pending.len();
            if !self.known.contains(&id) {
                graph.node(id).for_each_child(|child| {
                    if !self.known.contains(&child) {
                        pending.push(child);
                    }
                });
            }
            if pending.len() == before {
                pending.pop();
                let size = self.of_node(graph.node(id));
                self.known.insert(id, size);
            }
        }
        self.known.get(&root).copied().unwrap_or(u64::MAX)
    }

    fn of_node(&self, node: &Node) -> u64 {
        let own = match node {
            Node::Sum { constant, terms } => {
                u64::from(!constant.is_zero()) + count(terms, |c| !c.abs().is_one())
            }
            Node::Product(factors) => count(factors, |e| !e.is_one()),
            _ => 1,
        };
        let mut total = own;
        node.for_each_child(|child| {
            total = total.saturating_add(self.known.get(&child).copied().unwrap_or(1));
        });
        total
    }
}

fn count(weighted: &[(ExprId, Number)], shows: impl Fn(&Number) -> bool) -> u64 {
    weighted.iter().filter(|(_, weight)| shows(weight)).count() as u64
}
