//! Symmetric linear equations M x = r between expressions.
//!
//! Elimination takes the simplest pivot first. For a top, that is the inertia I₃ of the spin, and
//! I₁ sin² θ is left. The other order would leave a difference. On the way rᵀM⁻¹r becomes a sum of
//! squares.

use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// The solution of M x = r.
pub(super) struct Solution {
    /// x
    pub(super) values: Vec<ExprId>,
    /// rᵀM⁻¹r
    pub(super) square: ExprId,
}

/// An unknown that is eliminated, and those that are left then.
type Step = (usize, Vec<usize>);

/// Solves M x = r; the error is the index of a pivot that is zero.
pub(super) fn solve(
    graph: &mut Graph,
    mut matrix: Vec<Vec<ExprId>>,
    mut rests: Vec<ExprId>,
) -> Result<Solution, usize> {
    let mut left = (0..rests.len()).collect::<Vec<_>>();
    let (mut steps, mut squares) = (Vec::new(), Vec::new());
    while let Some(i) = left.iter().copied().min_by_key(|&i| graph.reachable(&[matrix[i][i]]).len()) {
        left.retain(|&other| other != i);
        if graph.is_zero(matrix[i][i]) {
            return Err(i);
        }
        let square = graph.square(rests[i]);
        squares.push((graph.divide(square, matrix[i][i]), Number::ONE));
        for &j in &left {
            let factor = graph.divide(matrix[i][j], matrix[i][i]);
            for &k in &left {
                let product = graph.multiply(factor, matrix[i][k]);
                matrix[j][k] = graph.subtract(matrix[j][k], product);
            }
            let product = graph.multiply(factor, rests[i]);
            rests[j] = graph.subtract(rests[j], product);
        }
        steps.push((i, left.clone()));
    }
    let values = substituted_back(graph, &matrix, rests, steps);
    Ok(Solution { values, square: graph.sum(Number::ZERO, squares) })
}

fn substituted_back(
    graph: &mut Graph,
    matrix: &[Vec<ExprId>],
    mut values: Vec<ExprId>,
    steps: Vec<Step>,
) -> Vec<ExprId> {
    for (i, left) in steps.into_iter().rev() {
        for j in left {
            let product = graph.multiply(matrix[i][j], values[j]);
            values[i] = graph.subtract(values[i], product);
        }
        values[i] = graph.divide(values[i], matrix[i][i]);
    }
    values
}
