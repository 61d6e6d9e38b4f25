//! Symmetric linear equations M x = r between expressions.
//!
//! Elimination uses the simplest pivot first. For a top, this is the inertia I₃ of the spin, and I₁
//! sin² θ is left. The other order would leave a difference. In the process rᵀM⁻¹r becomes a sum of
//! squares.
//!
//! If the whole diagonal is zero, row j and column j are added to those of i. This gives the pivot
//! 2 Mᵢⱼ, and xⱼ becomes xⱼ + xᵢ.

use super::ignored::vanish;
use crate::model::Model;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// The solution of M x = r.
pub(super) struct Solution {
    /// x
    pub(super) values: Vec<ExprId>,
    /// rᵀM⁻¹r
    pub(super) square: ExprId,
}

/// M and r
type Equations<'e> = (&'e mut [Vec<ExprId>], &'e mut [ExprId]);

/// A step of back substitution from reduced equations to the given ones.
enum Step {
    /// An eliminated unknown, and the unknowns that remain.
    Eliminated(usize, Vec<usize>),
    /// An unknown that was added to a second one.
    Added(usize, usize),
}

/// Solves M x = r; the error is the index of an undetermined unknown.
pub(super) fn solve(
    model: &mut Model,
    mut matrix: Vec<Vec<ExprId>>,
    mut rests: Vec<ExprId>,
) -> Result<Solution, usize> {
    let mut left = (0..rests.len()).collect::<Vec<_>>();
    let (mut steps, mut squares) = (Vec::new(), Vec::new());
    while !left.is_empty() {
        let i = match pivot(model, &matrix, &left) {
            Some(i) => i,
            None => {
                let (i, j) = coupled(model, &matrix, &left).ok_or(left[0])?;
                add(&mut model.graph, (&mut matrix, &mut rests), (j, i));
                steps.push(Step::Added(i, j));
                i
            }
        };
        left.retain(|&other| other != i);
        let square = model.graph.square(rests[i]);
        squares.push((model.graph.divide(square, matrix[i][i]), Number::ONE));
        eliminate(&mut model.graph, (&mut matrix, &mut rests), i, &left);
        steps.push(Step::Eliminated(i, left.clone()));
    }
    let values = substituted_back(&mut model.graph, &matrix, rests, steps);
    Ok(Solution { values, square: model.graph.sum(Number::ZERO, squares) })
}

/// Finds the simplest nonzero diagonal entry.
fn pivot(model: &mut Model, matrix: &[Vec<ExprId>], left: &[usize]) -> Option<usize> {
    let entries = left.iter().map(|&i| matrix[i][i]).collect::<Vec<_>>();
    let vanish = vanish(model, &entries);
    let regular = left.iter().zip(vanish).filter(|(_, vanishes)| !vanishes).map(|(&i, _)| i);
    regular.min_by_key(|&i| model.graph.reachable(&[matrix[i][i]]).len())
}

/// Finds two unknowns whose common entry is nonzero.
fn coupled(model: &mut Model, matrix: &[Vec<ExprId>], left: &[usize]) -> Option<(usize, usize)> {
    let mut pairs = left.iter().flat_map(|&i| left.iter().map(move |&j| (i, j))).filter(|(i, j)| i < j);
    pairs.find(|&(i, j)| vanish(model, &[matrix[i][j]]) != [true])
}

/// Eliminates an unknown from the remaining equations.
fn eliminate(graph: &mut Graph, (matrix, rests): Equations<'_>, i: usize, left: &[usize]) {
    for &j in left {
        let factor = graph.divide(matrix[i][j], matrix[i][i]);
        for &k in left {
            let product = graph.multiply(factor, matrix[i][k]);
            matrix[j][k] = graph.subtract(matrix[j][k], product);
        }
        let product = graph.multiply(factor, rests[i]);
        rests[j] = graph.subtract(rests[j], product);
    }
}

/// Adds a row and its column to others.
fn add(graph: &mut Graph, (matrix, rests): Equations<'_>, (from, to): (usize, usize)) {
    let row = matrix[from].clone();
    for (entry, part) in matrix[to].iter_mut().zip(row) {
        *entry = graph.add(*entry, part);
    }
    for row in matrix.iter_mut() {
        row[to] = graph.add(row[to], row[from]);
    }
    rests[to] = graph.add(rests[to], rests[from]);
}

fn substituted_back(
    graph: &mut Graph,
    matrix: &[Vec<ExprId>],
    mut values: Vec<ExprId>,
    steps: Vec<Step>,
) -> Vec<ExprId> {
    for step in steps.into_iter().rev() {
        match step {
            Step::Eliminated(i, left) => {
                for j in left {
                    let product = graph.multiply(matrix[i][j], values[j]);
                    values[i] = graph.subtract(values[i], product);
                }
                values[i] = graph.divide(values[i], matrix[i][i]);
            }
            Step::Added(i, j) => values[j] = graph.add(values[j], values[i]),
        }
    }
    values
}
