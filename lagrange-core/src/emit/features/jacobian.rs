//! Jacobians of the right-hand side ẏ = [v, a], as methods.

use crate::expr::{ExprId, Graph};

/// ∂ẏ/∂y from the rows of the `n` accelerations.
pub(in crate::emit) fn by_state(graph: &mut Graph, n: usize, accelerations: &[ExprId]) -> Vec<ExprId> {
    let mut entries = Vec::with_capacity(4 * n * n);
    for i in 0..n {
        // A coordinate changes with its velocity and nothing else.
        entries.extend((0..2 * n).map(|j| graph.number(i64::from(j == n + i))));
    }
    entries.extend(accelerations);
    entries
}

/// The derivatives of ẏ by fields from the rows of the accelerations; those of the velocities are `zeros` zeros.
pub(in crate::emit) fn by_fields(graph: &mut Graph, zeros: usize, accelerations: &[ExprId]) -> Vec<ExprId> {
    let mut entries = vec![graph.number(0); zeros];
    entries.extend(accelerations);
    entries
}
