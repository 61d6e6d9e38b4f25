//! Matrices of a system at a point, and the tangent space of its constraints.

use std::vec::Vec;

use super::names::Names;
use crate::linalg::dense::DenseMatrix;
use crate::system::LinearisedSystem;

/// Entries that elimination leaves below this, relative to the largest entry of a scaled row, are
/// rounding.
const DEPENDENT: f64 = 1e-10;

/// The system matrix [A B; C D; G 0] as blocks: rows for displacements, first-order states and
/// velocities, for outputs and for constraint velocities.
pub(super) struct Blocks {
    /// [A B; C D; G 0]
    pub(super) matrix: DenseMatrix,
    /// Number of displacements.
    pub(super) freedoms: usize,
    /// Number of displacements, first-order states and velocities.
    pub(super) tangent: usize,
    /// Number of outputs.
    pub(super) outputs: usize,
}

impl Blocks {
    pub(super) fn of<M>(system: &M, t: M::Scalar, y: &M::State) -> Blocks
    where
        M: LinearisedSystem,
        M::Scalar: Into<f64>,
    {
        let names = Names::of(system);
        let freedoms = names.freedoms();
        let tangent = 2 * freedoms + names.state.first_order_states;
        let found = system.system_matrix(t, y);
        let rows = found.as_ref();
        let columns = tangent + names.beyond.inputs.len();
        let matrix = DenseMatrix::from_fn(rows.len(), columns, |i, j| rows[i].as_ref()[j].into());
        Blocks { matrix, freedoms, tangent, outputs: names.beyond.outputs.len() }
    }

    /// Returns the columns of the inputs.
    pub(super) fn inputs(&self) -> Vec<usize> {
        (self.tangent..self.matrix.columns()).collect()
    }

    /// Returns the first column of the velocities, which is also the first row of their rates.
    pub(super) fn velocities(&self) -> usize {
        self.tangent - self.freedoms
    }

    /// Returns the row of the constraint velocity at this index.
    pub(super) fn constraint_row(&self, index: usize) -> usize {
        self.tangent + self.outputs + index
    }
}

/// Returns the row and the column of the first entry that is not finite.
pub(super) fn first_undefined(matrix: &DenseMatrix) -> Option<(usize, usize)> {
    let places = (0..matrix.rows()).flat_map(|i| (0..matrix.columns()).map(move |j| (i, j)));
    { places }.find(|&place| !matrix[place].is_finite())
}

/// Directions in which a state can change on its constraints, to first order. All displacements,
/// states and velocities are `basis` times the free ones. Inputs occur in no constraint, because
/// their rates are unknown.
pub(super) struct TangentSpace {
    /// Indices of the free entries.
    pub(super) free: Vec<usize>,
    pub(super) basis: DenseMatrix,
}

impl TangentSpace {
    /// Creates the tangent. Constraints on positions restrict displacements by ∂ċ/∂v δ = 0. All
    /// constraints restrict velocities by ∂ċ/∂v ε + ∂ċ/∂q δ = 0.
    pub(super) fn new(blocks: &Blocks, are_holonomic: &[bool]) -> TangentSpace {
        let (n, tangent) = (blocks.freedoms, blocks.tangent);
        let first = blocks.velocities();
        let mut order = (0..are_holonomic.len()).filter(|&i| are_holonomic[i]).collect::<Vec<_>>();
        let holonomic = order.len();
        order.extend((0..are_holonomic.len()).filter(|&i| !are_holonomic[i]));
        let rows = order.iter().map(|&index| blocks.constraint_row(index)).collect::<Vec<_>>();
        let velocities = (first..tangent).collect::<Vec<_>>();
        let of_positions =
            Eliminated::new(blocks.matrix.part(&rows[..holonomic], &velocities), (n, holonomic));
        // The velocities first, then everything that they depend on.
        let all = velocities.into_iter().chain(0..n).collect::<Vec<_>>();
        let of_velocities = Eliminated::new(blocks.matrix.part(&rows, &all), (n, holonomic));
        let is_free = |entry: &usize| match entry.checked_sub(first) {
            Some(velocity) => !of_velocities.depends(velocity),
            None => *entry >= n || !of_positions.depends(*entry),
        };
        let free = (0..tangent).filter(is_free).collect::<Vec<_>>();
        let mut space = TangentSpace { basis: DenseMatrix::zeros(tangent, free.len()), free };
        space.fill(&of_positions, &of_velocities, n, first);
        space
    }

    fn fill(&mut self, of_positions: &Eliminated, of_velocities: &Eliminated, n: usize, first: usize) {
        for (column, &entry) in self.free.iter().enumerate() {
            self.basis[(entry, column)] = 1.0;
        }
        for &(row, pivot) in &of_positions.pivots {
            for (column, &entry) in self.free.iter().enumerate().filter(|(_, entry)| **entry < n) {
                self.basis[(pivot, column)] = -of_positions.matrix[(row, entry)];
            }
        }
        for &(row, pivot) in &of_velocities.pivots {
            for column in 0..self.free.len() {
                let entry = self.free[column];
                let direct = match entry.checked_sub(first) {
                    Some(velocity) => of_velocities.matrix[(row, velocity)],
                    None => 0.0,
                };
                let through = (0..n).fold(direct, |sum, other| {
                    sum + of_velocities.matrix[(row, n + other)] * self.basis[(other, column)]
                });
                self.basis[(first + pivot, column)] = -through;
            }
        }
    }
}

/// Equations solved for some of their first unknowns, which occur in no other row (Gauss–Jordan
/// elimination).
struct Eliminated {
    matrix: DenseMatrix,
    /// A row and the unknown that it is solved for.
    pivots: Vec<(usize, usize)>,
}

impl Eliminated {
    /// Solves for unknowns among the first `unknowns`, with pivots in the first `preferred` rows as
    /// long as these have any. Among equal pivots, the last unknown is chosen, so that those
    /// declared first stay free.
    fn new(mut a: DenseMatrix, (unknowns, preferred): (usize, usize)) -> Eliminated {
        for i in 0..a.rows() {
            let largest = (0..unknowns).fold(0.0, |most: f64, j| most.max(a[(i, j)].abs()));
            if largest > 0.0 {
                (0..a.columns()).for_each(|j| a[(i, j)] /= largest);
            }
        }
        let mut pivots: Vec<(usize, usize)> = Vec::new();
        for rows in [0..preferred, 0..a.rows()] {
            while let Some((row, column)) = largest(&a, rows.clone(), unknowns, &pivots) {
                let pivot = a[(row, column)];
                (0..a.columns()).for_each(|j| a[(row, j)] /= pivot);
                for i in (0..a.rows()).filter(|&i| i != row) {
                    let multiple = a[(i, column)];
                    (0..a.columns()).for_each(|j| a[(i, j)] -= multiple * a[(row, j)]);
                }
                pivots.push((row, column));
            }
        }
        Eliminated { matrix: a, pivots }
    }

    /// True if an equation is solved for this unknown.
    fn depends(&self, unknown: usize) -> bool {
        self.pivots.iter().any(|(_, pivot)| *pivot == unknown)
    }
}

/// Returns the position of the largest entry in a row without a pivot.
fn largest(
    a: &DenseMatrix,
    rows: core::ops::Range<usize>,
    unknowns: usize,
    pivots: &[(usize, usize)],
) -> Option<(usize, usize)> {
    let open = rows.filter(|row| pivots.iter().all(|(used, _)| used != row));
    let places = open.flat_map(|row| (0..unknowns).rev().map(move |column| (row, column)));
    let larger = |best: Option<(usize, usize)>, place| match best {
        // Nearly equal pivots differ by rounding.
        Some(best) if a[place].abs() <= a[best].abs() * (1.0 + DEPENDENT) => Some(best),
        _ if a[place].abs() <= DEPENDENT => best,
        _ => Some(place),
    };
    places.fold(None, larger)
}

#[cfg(test)]
mod tests {
    use super::{Blocks, DenseMatrix, TangentSpace};

    /// A point on the circle x² + y² = 1 at (0.6, 0.8), moving with the velocity (−8, 6).
    #[test]
    fn velocities_turn_with_the_displacement() {
        let g = [[-8.0, 6.0, 0.6, 0.8]];
        let matrix = DenseMatrix::from_fn(5, 4, |i, j| if i == 4 { g[0][j] } else { 0.0 });
        let blocks = Blocks { matrix, freedoms: 2, tangent: 4, outputs: 0 };
        let space = TangentSpace::new(&blocks, &[true]);
        assert_eq!(space.free, [0, 2]);
        // δy = −0.75 δx, and 0.6 εx + 0.8 εy − 8 δx + 6 δy = 0.
        let wanted = DenseMatrix::from_rows(&[[1.0, 0.0], [-0.75, 0.0], [0.0, 1.0], [15.625, -0.75]]);
        assert!(space.basis.plus(-1.0, &wanted).largest() < 1e-14, "{:?}", space.basis);
    }

    #[test]
    fn a_rolling_wheel_keeps_its_displacements() {
        // Rolling, ẋ − r θ̇ = 0 with r = 0.5, is no constraint on positions here.
        let g = [0.0, 0.0, 1.0, -0.5];
        let matrix = DenseMatrix::from_fn(5, 4, |i, j| if i == 4 { g[j] } else { 0.0 });
        let space = TangentSpace::new(&Blocks { matrix, freedoms: 2, tangent: 4, outputs: 0 }, &[false]);
        assert_eq!(space.free, [0, 1, 3]);
        assert_eq!(space.basis.row(2), [0.0, 0.0, 0.5]);
    }

    #[test]
    fn constraints_that_repeat_others_restrict_nothing_more() {
        let g = [[0.0, 0.0, 1.0, 2.0], [0.0, 0.0, 3.0, 6.0]];
        let matrix = DenseMatrix::from_fn(6, 4, |i, j| if i < 4 { 0.0 } else { g[i - 4][j] });
        let space = TangentSpace::new(&Blocks { matrix, freedoms: 2, tangent: 4, outputs: 0 }, &[true, true]);
        assert_eq!(space.free, [0, 2]);
    }
}
