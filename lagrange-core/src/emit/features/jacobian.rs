//! Jacobians of the right-hand side ẏ = [v, a], as methods.

use crate::emit::base::method::Returns;
use crate::expr::{ExprId, Graph};

pub(in crate::emit) const JACOBIAN: [&str; 2] = [
    "Jacobian of `rhs`, in rows: entry `[i][j]` is the derivative of its entry `i` by entry `j`",
    "of the state.",
];
pub(in crate::emit) const PARAMETER_JACOBIAN: [&str; 2] = [
    "Derivatives of `rhs` by the fields in the order of `PARAMETERS`, in rows: entry `[i][j]`",
    "is that of its entry `i` by field `j`.",
];

/// ∂ẏ/∂y from the rows of the accelerations.
pub(in crate::emit) fn by_state(graph: &mut Graph, accelerations: &[Vec<ExprId>]) -> (Returns, Vec<ExprId>) {
    let n = accelerations.len();
    let mut entries = Vec::with_capacity(4 * n * n);
    for i in 0..n {
        // A coordinate changes with its velocity and nothing else.
        entries.extend((0..2 * n).map(|j| graph.number(i64::from(j == n + i))));
    }
    entries.extend(accelerations.iter().flatten());
    (Returns::Matrix(2 * n, 2 * n), entries)
}

/// The derivatives of ẏ by `count` fields from the rows of the accelerations.
pub(in crate::emit) fn by_fields(
    graph: &mut Graph,
    accelerations: &[Vec<ExprId>],
    count: usize,
) -> (Returns, Vec<ExprId>) {
    let n = accelerations.len();
    let mut entries = vec![graph.number(0); n * count];
    entries.extend(accelerations.iter().flatten());
    (Returns::Matrix(2 * n, count), entries)
}
