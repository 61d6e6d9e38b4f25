//! Motions that a singular mass matrix leaves undetermined, and the coordinates that take part in
//! them.
//!
//! M, with A below it if there are constraints, is evaluated at a state without symmetries. A
//! vector in the null space of both is a motion that neither inertia nor constraints determine.

use crate::model::Model;
use lagrange_algebra::calculus::gradient;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;

/// Fraction of the largest entry below which pivots and entries count as zero. Symbols have values
/// between one and two, so nonzero entries are far larger, and rounding errors of a few
/// eliminations are far smaller.
const ROUNDING: f64 = 1e-9;
/// Maximum number of states that are tried until one has no undefined entries, such as the root of
/// a negative number.
const MAX_STATES: u32 = 8;
const GOLDEN_RATIO: f64 = 0.618_033_988_749_895;

/// Returns the indices of the coordinates that take part in the first undetermined motion; none if
/// there is no such motion.
pub(super) fn undetermined(model: &mut Model) -> Vec<usize> {
    let velocities = model.velocities();
    let momenta = gradient(&mut model.graph, model.lagrangian, &velocities);
    let constrained = model.constraints.iter().map(|constraint| constraint.velocity).collect::<Vec<_>>();
    let rows = momenta.into_iter().chain(constrained);
    let rows = rows.map(|row| gradient(&mut model.graph, row, &velocities)).collect::<Vec<_>>();
    let states = (0..MAX_STATES).map(|state| numbers(&model.graph, &rows, state));
    let matrix = states.into_iter().find(|rows| rows.iter().flatten().all(|entry| entry.is_finite()));
    matrix.map_or_else(Vec::new, |matrix| first_of_kernel(matrix, velocities.len()))
}

/// Returns the matrix with a number between one and two for every symbol, all of them different.
fn numbers(graph: &Graph, rows: &[Vec<ExprId>], state: u32) -> Vec<Vec<f64>> {
    let value = |role: Role| {
        let (kind, index) = match role {
            Role::Parameter(index) => (0, index),
            Role::Input(index) => (1, index),
            Role::Coordinate(index) => (2, index),
            Role::Velocity(index) => (3, index),
            _ => (4, 0),
        };
        // Multiples of the golden ratio are spread evenly over the interval.
        1.0 + (f64::from(5 * index + kind + 7 * state + 1) * GOLDEN_RATIO).fract()
    };
    rows.iter().map(|row| evaluate(graph, row, value)).collect()
}

/// Returns the columns that take part in the first vector of the kernel, by elimination with
/// complete pivoting.
fn first_of_kernel(mut matrix: Vec<Vec<f64>>, columns: usize) -> Vec<usize> {
    let largest = matrix.iter().flatten().fold(0.0_f64, |most, entry| most.max(entry.abs()));
    let mut order = (0..columns).collect::<Vec<_>>();
    let mut rank = 0;
    while rank < columns.min(matrix.len()) {
        let entries = (rank..matrix.len()).flat_map(|row| (rank..columns).map(move |column| (row, column)));
        let magnitude = |(row, column): &(usize, usize)| matrix[*row][order[*column]].abs();
        let Some(pivot) = entries.max_by(|a, b| magnitude(a).total_cmp(&magnitude(b))) else { break };
        if magnitude(&pivot) <= ROUNDING * largest {
            break;
        }
        matrix.swap(rank, pivot.0);
        order.swap(rank, pivot.1);
        let (column, row) = (order[rank], matrix[rank].clone());
        for other in matrix.iter_mut().enumerate().filter(|(other, _)| *other != rank).map(|(_, row)| row) {
            let factor = other[column] / row[column];
            other.iter_mut().zip(&row).for_each(|(entry, pivot)| *entry -= factor * pivot);
        }
        rank += 1;
    }
    let Some(&free) = order.get(rank) else { return Vec::new() };
    let moves = |row: usize| (matrix[row][free] / matrix[row][order[row]]).abs() > ROUNDING;
    let mut moving =
        (0..rank).filter(|&row| moves(row)).map(|row| order[row]).chain([free]).collect::<Vec<_>>();
    moving.sort_unstable();
    moving
}

#[cfg(test)]
mod tests {
    use super::first_of_kernel;

    #[test]
    fn the_columns_of_a_motion_without_inertia_are_found() {
        let square = |rows: [[f64; 3]; 3]| first_of_kernel(rows.map(Vec::from).to_vec(), 3);
        assert_eq!(square([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]]), []);
        assert_eq!(square([[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 3.0]]), [1]);
        assert_eq!(square([[1.0, 0.0, 1.0], [0.0, 2.0, 0.0], [1.0, 0.0, 1.0]]), [0, 2]);
        assert_eq!(square([[0.0; 3]; 3]).len(), 1);
        // With M = diag(1, 0, 0) and the second motion constrained, the third remains.
        let rows = vec![vec![1.0, 0.0, 0.0], vec![0.0; 3], vec![0.0; 3], vec![0.0, 1.0, 0.0]];
        assert_eq!(first_of_kernel(rows, 3), [2]);
    }
}
