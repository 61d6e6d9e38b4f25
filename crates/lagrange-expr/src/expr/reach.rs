//! The operands that expressions depend on.

use super::{ExprId, Graph};
use crate::collections::HashSet;

impl Graph {
    /// Returns all parts of the roots, including themselves, children before parents.
    pub fn reachable(&self, roots: &[ExprId]) -> Vec<ExprId> {
        self.reachable_until(roots, |_| false)
    }

    /// Returns expressions like [`reachable`](Graph::reachable), except those that are only reached
    /// through expressions for which `stop` is true. The latter are included.
    pub fn reachable_until(&self, roots: &[ExprId], stop: impl Fn(ExprId) -> bool) -> Vec<ExprId> {
        let mut seen = vec![false; roots.iter().map(|root| root.index() + 1).max().unwrap_or(0)];
        let mut pending = roots.to_vec();
        let mut found = Vec::new();
        while let Some(id) = pending.pop() {
            if !std::mem::replace(&mut seen[id.index()], true) {
                found.push(id);
                if !stop(id) {
                    self.node(id).for_each_child(|child| pending.push(child));
                }
            }
        }
        found.sort_unstable();
        found
    }

    /// True if an expression has more than `limit` parts, including itself. Visits at most this
    /// many, even in a large expression.
    pub fn is_larger_than(&self, root: ExprId, limit: usize) -> bool {
        let mut seen = HashSet::from_iter([root]);
        let mut pending = vec![root];
        while let Some(id) = pending.pop() {
            if seen.len() > limit {
                return true;
            }
            self.node(id).for_each_child(|child| {
                if seen.insert(child) {
                    pending.push(child);
                }
            });
        }
        seen.len() > limit
    }
}
