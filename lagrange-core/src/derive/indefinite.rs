//! Regular mass matrices with pivots that may vanish.
//!
//! The mass matrix of a kinetic energy is positive definite, so no pivot vanishes in any order of
//! factorisation. A general Lagrangian may have an indefinite one. For ½ sin x ẋ² + ẋ ẏ, the matrix
//! [sin x, 1; 1, 0] is regular everywhere. Its first pivot is zero at x = 0. If a coupled diagonal
//! entry has no certain sign, pivots are tested at run time, and a second method for the
//! accelerations is provided. This only concerns systems that are declared by a Lagrangian, with or
//! without constraints. In the axes of bodies, the signs of kinetic energies hide in sums of
//! products. Source: Golub, Van Loan, *Matrix Computations*, 4th ed., §4.4 (symmetric indefinite
//! systems).

use super::elimination::solution::Solution;
use crate::model::{Model, default_values, sample_values};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::functions;

/// Maximum number of coordinates for the second method. Its matrix is stored on the stack: 13 kB of
/// `f64` at this size.
const LARGEST: usize = 40;
/// Number of points at which a mass matrix is tested.
const POINTS: usize = 4;
/// Pivots below this fraction of the original entry count as zero up to rounding.
const ROUNDING: f64 = 1e-12;

/// Returns the squared growth of rounding errors through small pivots; infinite where a pivot
/// vanishes. `None` if every coupled diagonal entry has a certain sign and the matrix is positive
/// definite at the sample points.
pub(super) fn pivot_growth(
    model: &mut Model,
    mass_matrix: &[Vec<ExprId>],
    solution: &Solution,
) -> Option<ExprId> {
    let is_indefinite = mass_matrix.len() <= LARGEST && is_indefinite(model, mass_matrix);
    let graph = &mut model.graph;
    let is_doubtful = |(i, row): (usize, &Vec<ExprId>)| {
        let is_coupled = row.iter().enumerate().any(|(j, &entry)| i != j && !graph.is_zero(entry));
        is_coupled && !graph.is_zero(row[i]) && !has_sure_sign(graph, row[i])
    };
    let has_doubts = is_indefinite || mass_matrix.iter().enumerate().any(is_doubtful);
    if mass_matrix.len() > LARGEST || !has_doubts {
        return None;
    }
    let mut growth = graph.number(1);
    for step in solution.elimination.iter().flat_map(|elimination| &elimination.eliminated) {
        let sizes = step.factors.iter().map(|(_, factor)| functions::apply(graph, Function::Abs, &[*factor]));
        let sizes = sizes.collect::<Vec<_>>();
        let size = graph.total(sizes);
        let square = graph.square(size);
        growth = largest(graph, growth, square);
    }
    Some(growth)
}

/// True if a mass matrix is not positive definite at one of the sample points, with or without
/// default parameters. Diagonal entries with certain signs may still be outweighed by others.
fn is_indefinite(model: &Model, mass_matrix: &[Vec<ExprId>]) -> bool {
    let entries = mass_matrix.concat();
    (0..POINTS).any(|point| {
        let values = [sample_values(model, &entries, point), default_values(model, &entries, point)];
        values.into_iter().any(|values| has_bad_pivot(values, mass_matrix.len()))
    })
}

/// True if a pivot of a matrix of n rows is not positive: [1, 2; 2, 1] has the pivots 1 and −3.
/// Coordinates without inertia of their own are skipped, since they are never eliminated first.
fn has_bad_pivot(mut entries: Vec<f64>, n: usize) -> bool {
    let diagonal = (0..n).map(|k| entries[k * n + k]).collect::<Vec<_>>();
    (0..n).filter(|&k| diagonal[k] != 0.0).any(|k| {
        let pivot = entries[k * n + k];
        for (i, j) in (k + 1..n).flat_map(|i| (k + 1..n).map(move |j| (i, j))) {
            entries[i * n + j] -= entries[i * n + k] / pivot * entries[k * n + j];
        }
        pivot <= ROUNDING * diagonal[k].abs()
    })
}

pub(super) fn largest(graph: &mut Graph, a: ExprId, b: ExprId) -> ExprId {
    functions::apply(graph, Function::Max, &[a, b])
}

/// True if an expression is assumed to have a fixed sign wherever the system is regular. Parameters
/// are assumed to be positive and even powers nonzero. If one term of a sum has a sign, the others
/// are assumed not to outweigh it.
fn has_sure_sign(graph: &Graph, root: ExprId) -> bool {
    let mut known: HashMap<ExprId, bool> = HashMap::default();
    for id in graph.reachable(&[root]) {
        let of = |id: &ExprId| known.get(id).copied().unwrap_or(false);
        let is_sure = match graph.node(id) {
            Node::Number(number) => !number.is_zero(),
            _ if graph.dependencies(id).is_constant_in_motion() => true,
            Node::Sum { constant, terms } => !constant.is_zero() || terms.iter().any(|(term, _)| of(term)),
            Node::Product(factors) => factors.iter().all(|(base, exponent)| exponent.is_even() || of(base)),
            Node::Choose { then, otherwise, .. } => of(then) && of(otherwise),
            Node::Pi | Node::Symbol(_) | Node::Call(..) | Node::Opaque(..) => graph.is_nonnegative(id),
        };
        known.insert(id, is_sure);
    }
    known.get(&root).copied().unwrap_or(false)
}
