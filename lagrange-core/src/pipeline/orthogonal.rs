//! Orthogonal factors of matrices of any size and rank: Householder reflections with column
//! exchange. `linalg::orthogonal` of `lagrange-runtime` has them for sizes known at compile time.
//! Source: Golub, Van Loan, *Matrix Computations*, 4th ed., §5.2, §5.4.

/// A column precedes later ones unless their remaining length is greater by more than this
/// fraction, so that rounding does not choose between equals.
const PRECEDENCE: f64 = 0.125;

/// The factors Q and R of a matrix, in the order in which its columns were taken.
#[derive(Debug)]
pub(super) struct OrthogonalFactors {
    /// Column taken k-th: R above row k and, if k is below the rank, the reflection u with I − u uᵀ
    /// from there on.
    columns: Vec<Vec<f64>>,
    /// The diagonal of R.
    diagonal: Vec<f64>,
    /// Index of the column taken k-th.
    order: Vec<usize>,
    /// Number of rows.
    rows: usize,
}

impl OrthogonalFactors {
    /// Factorises finite columns with `rows` entries each. Columns of which at most the fraction
    /// `tolerance` of the largest one remains depend on those before.
    pub(super) fn new(mut columns: Vec<Vec<f64>>, rows: usize, tolerance: f64) -> OrthogonalFactors {
        let (mut order, mut diagonal) = ((0..columns.len()).collect::<Vec<_>>(), Vec::new());
        let mut first = 0.0_f64;
        for k in 0..rows.min(columns.len()) {
            let (pivot, left) = largest(&columns, k);
            first = first.max(left);
            if left <= tolerance * first {
                break;
            }
            columns.swap(k, pivot);
            order.swap(k, pivot);
            diagonal.push(reflect(&mut columns[k..], k, left));
        }
        OrthogonalFactors { columns, diagonal, order, rows }
    }

    /// Returns the number of independent columns.
    pub(super) fn rank(&self) -> usize {
        self.diagonal.len()
    }

    /// Returns the indices of the columns that depend on others.
    pub(super) fn dependent(&self) -> &[usize] {
        &self.order[self.rank()..]
    }

    /// Returns Qᵀx.
    pub(super) fn inward(&self, mut x: Vec<f64>) -> Vec<f64> {
        (0..self.rank()).for_each(|k| apply(&self.columns[k], k, &mut x));
        x
    }

    /// Returns Q x.
    pub(super) fn outward(&self, mut x: Vec<f64>) -> Vec<f64> {
        (0..self.rank()).rev().for_each(|k| apply(&self.columns[k], k, &mut x));
        x
    }

    /// Returns the amounts of the independent columns that add up to `right` as closely as
    /// possible; zero for the others.
    pub(super) fn combination(&self, right: Vec<f64>) -> Vec<f64> {
        let mut inner = self.inward(right);
        let mut amounts = vec![0.0; self.columns.len()];
        for k in (0..self.rank()).rev() {
            let amount = inner[k] / self.diagonal[k];
            inner[..k].iter_mut().zip(&self.columns[k]).for_each(|(inner, entry)| *inner -= amount * entry);
            amounts[self.order[k]] = amount;
        }
        amounts
    }

    /// Returns the shortest x whose products with the independent columns are the given ones.
    pub(super) fn shortest(&self, products: &[f64]) -> Vec<f64> {
        let mut inner = vec![0.0; self.rows];
        for k in 0..self.rank() {
            let known = self.columns[k][..k].iter().zip(&inner).map(|(entry, x)| entry * x).sum::<f64>();
            inner[k] = (products[self.order[k]] - known) / self.diagonal[k];
        }
        self.outward(inner)
    }

    /// Returns the shortest x for which the columns, in the amounts x / `scales`, add up to a
    /// vector. The vector has these components in the directions of the independent columns.
    pub(super) fn shortest_amounts(&self, components: &[f64], scales: &[f64]) -> Vec<f64> {
        let row = |k: usize| {
            let mut row = vec![0.0; scales.len()];
            for (l, &column) in self.order.iter().enumerate().skip(k) {
                let entry = if k == l { self.diagonal[k] } else { self.columns[l][k] };
                row[column] = entry / scales[column];
            }
            row
        };
        let mut rows = (0..self.rank()).map(row).collect::<Vec<_>>();
        let mut products = components[..self.rank()].to_vec();
        for (row, product) in rows.iter_mut().zip(&mut products) {
            let scale = reciprocal(length(row));
            *product *= scale;
            row.iter_mut().for_each(|entry| *entry *= scale);
        }
        OrthogonalFactors::new(rows, scales.len(), 0.0).shortest(&products)
    }
}

/// Returns the column, from the k-th on, with the largest remainder from row k on, and the length
/// of this remainder.
fn largest(columns: &[Vec<f64>], k: usize) -> (usize, f64) {
    let mut most = (k, 0.0);
    for (index, column) in columns.iter().enumerate().skip(k) {
        let length = length(&column[k..]);
        if length - PRECEDENCE * length > most.1 {
            most = (index, length);
        }
    }
    most
}

/// Reflects the remainder of the first column, of this length, onto row k, and the other columns
/// with it. The reflection replaces the remainder; returns the entry on the diagonal.
fn reflect(columns: &mut [Vec<f64>], k: usize, length: f64) -> f64 {
    let Some((column, others)) = columns.split_first_mut() else { return 0.0 };
    let diagonal = if column[k] > 0.0 { -length } else { length };
    let root = (length * (length + column[k].abs())).sqrt();
    column[k] -= diagonal;
    column[k..].iter_mut().for_each(|entry| *entry /= root);
    others.iter_mut().for_each(|other| apply(column, k, other));
    diagonal
}

/// Replaces x by x − u (uᵀx) from row k on.
fn apply(u: &[f64], k: usize, x: &mut [f64]) {
    let product = u[k..].iter().zip(&x[k..]).map(|(u, x)| u * x).sum::<f64>();
    x[k..].iter_mut().zip(&u[k..]).for_each(|(x, u)| *x -= product * u);
}

/// Returns the Euclidean length.
pub(super) fn length(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Returns the reciprocal, or one if that is not finite.
pub(super) fn reciprocal(x: f64) -> f64 {
    let reciprocal = 1.0 / x;
    if reciprocal.is_finite() { reciprocal } else { 1.0 }
}
