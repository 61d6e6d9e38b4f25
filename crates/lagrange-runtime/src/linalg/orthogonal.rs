//! Orthogonal factors of matrices that may lack full rank.
//!
//! Householder reflections bring the columns of a matrix to triangular form, each time the column
//! with the largest remainder first. The rank is the number of columns whose remainder is more than
//! rounding. Source: Golub, Van Loan, *Matrix Computations*, 4th ed., §5.2, §5.4.

use core::ops::Range;

use crate::scalar::Scalar;

/// The factors Q and R of a matrix whose columns are `columns`, in the order in which they were
/// taken.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OrthogonalFactors<S, const ROWS: usize, const COLUMNS: usize> {
    /// Column taken k-th: R above row k and, if k is below the rank, the reflection u with I − u uᵀ
    /// from there on.
    columns: [[S; ROWS]; COLUMNS],
    /// The diagonal of R.
    diagonal: [S; COLUMNS],
    /// Index of the column taken k-th.
    order: [usize; COLUMNS],
    rank: usize,
    /// Number of rows that are not zero.
    rows: usize,
}

impl<S: Scalar, const ROWS: usize, const COLUMNS: usize> OrthogonalFactors<S, ROWS, COLUMNS> {
    /// The factors of finite columns. Columns of which no more is left than the part `tolerance` of
    /// the largest one depend on those before.
    pub(crate) fn new(columns: [[S; ROWS]; COLUMNS], tolerance: S) -> Self {
        Self::leading(columns, [ROWS, COLUMNS], tolerance)
    }

    /// The factors of so many first rows and columns; all other entries are zero.
    pub(crate) fn leading(
        mut columns: [[S; ROWS]; COLUMNS],
        [rows, count]: [usize; 2],
        tolerance: S,
    ) -> Self {
        let mut diagonal = [S::ZERO; COLUMNS];
        let mut order = core::array::from_fn(|k| k);
        let mut rank = 0;
        let mut first = S::ZERO;
        while rank < rows.min(count) {
            let k = rank;
            let (pivot, left) = largest(&columns[..count], k..rows);
            first = first.max(left);
            if left <= tolerance * first {
                break;
            }
            columns.swap(k, pivot);
            order.swap(k, pivot);
            diagonal[k] = reflect(&mut columns[k..count], k..rows, left);
            rank += 1;
        }
        OrthogonalFactors { columns, diagonal, order, rank, rows }
    }

    /// Returns the number of independent columns.
    pub(crate) fn rank(&self) -> usize {
        self.rank
    }

    /// Returns the columns in the order in which they were taken, independent ones first.
    pub(crate) fn order(&self) -> &[usize; COLUMNS] {
        &self.order
    }

    /// Entry of R in row k and for the column taken l-th, k ≤ l.
    pub(crate) fn entry(&self, k: usize, l: usize) -> S {
        if k == l { self.diagonal[k] } else { self.columns[l][k] }
    }

    /// Qᵀx
    pub(crate) fn inward(&self, mut x: [S; ROWS]) -> [S; ROWS] {
        for k in 0..self.rank {
            applied(&self.columns[k][k..self.rows], &mut x[k..self.rows]);
        }
        x
    }

    /// Q x
    pub(crate) fn outward(&self, mut x: [S; ROWS]) -> [S; ROWS] {
        for k in (0..self.rank).rev() {
            applied(&self.columns[k][k..self.rows], &mut x[k..self.rows]);
        }
        x
    }

    /// Amounts of the independent columns that add up to `right` as closely as possible; zero of
    /// the others.
    pub(crate) fn combination(&self, right: [S; ROWS]) -> [S; COLUMNS] {
        let mut inner = self.inward(right);
        let mut amounts = [S::ZERO; COLUMNS];
        for k in (0..self.rank).rev() {
            let amount = inner[k] / self.diagonal[k];
            for (inner, entry) in inner[..k].iter_mut().zip(&self.columns[k]) {
                *inner = (-amount).multiply_add(*entry, *inner);
            }
            amounts[self.order[k]] = amount;
        }
        amounts
    }

    /// The shortest x whose products with the independent columns are those entries of `products`.
    pub(crate) fn shortest(&self, products: &[S; COLUMNS]) -> [S; ROWS] {
        let mut inner = [S::ZERO; ROWS];
        for k in 0..self.rank {
            let known = (0..k).fold(S::ZERO, |sum, i| self.columns[k][i].multiply_add(inner[i], sum));
            inner[k] = (products[self.order[k]] - known) / self.diagonal[k];
        }
        self.outward(inner)
    }

    /// A combination of columns that is zero but for rounding: one of the column taken l-th, which
    /// depends on the others.
    pub(crate) fn dependence(&self, l: usize) -> [S; COLUMNS] {
        let mut amounts = [S::ZERO; COLUMNS];
        amounts[self.order[l]] = S::ONE;
        let mut left = self.columns[l];
        for k in (0..self.rank).rev() {
            let amount = -(left[k] / self.diagonal[k]);
            for (left, entry) in left[..k].iter_mut().zip(&self.columns[k]) {
                *left = amount.multiply_add(*entry, *left);
            }
            amounts[self.order[k]] = amount;
        }
        amounts
    }
}

/// Part by which the remainder of a column must be larger to be taken before others. Rounding then
/// does not choose between equals: the rank must not flicker near where it changes.
const PRECEDENCE: f64 = 0.125;

/// The column, from that of the first row on, of which most is left in these rows or nearly so, and
/// how much.
fn largest<S: Scalar, const ROWS: usize>(columns: &[[S; ROWS]], rows: Range<usize>) -> (usize, S) {
    let mut most = (rows.start, S::ZERO);
    for (index, column) in columns.iter().enumerate().skip(rows.start) {
        let length = euclidean_norm(&column[rows.clone()]);
        if length - S::from_f64(PRECEDENCE) * length > most.1 {
            most = (index, length);
        }
    }
    most
}

/// Reflects what is left of the first column in these rows, of this length, onto the first of them,
/// and the other columns with it. The reflection takes the place of what is left; returns the entry
/// on the diagonal.
fn reflect<S: Scalar, const ROWS: usize>(columns: &mut [[S; ROWS]], rows: Range<usize>, length: S) -> S {
    let Some((column, others)) = columns.split_first_mut() else { return S::ZERO };
    let diagonal = reflector(&mut column[rows.clone()], length);
    for other in others {
        applied(&column[rows.clone()], &mut other[rows.clone()]);
    }
    diagonal
}

/// Turns a vector of this length into the reflection that takes it to its first entry, and returns
/// that.
pub(crate) fn reflector<S: Scalar>(column: &mut [S], length: S) -> S {
    let diagonal = if column[0] > S::ZERO { -length } else { length };
    // With this u, half of its square is length (length + |x|). Divided by its root, u makes I − u
    // uᵀ a reflection.
    let root = (length * (length + column[0].abs())).sqrt();
    column[0] = column[0] - diagonal;
    for entry in column {
        *entry = *entry / root;
    }
    diagonal
}

/// x − u (uᵀx)
pub(crate) fn applied<S: Scalar>(u: &[S], x: &mut [S]) {
    let product = u.iter().zip(&*x).fold(S::ZERO, |sum, (u, x)| u.multiply_add(*x, sum));
    for (x, u) in x.iter_mut().zip(u) {
        *x = (-product).multiply_add(*u, *x);
    }
}

/// The Euclidean length.
pub(crate) fn euclidean_norm<S: Scalar>(x: &[S]) -> S {
    x.iter().fold(S::ZERO, |sum, x| x.multiply_add(*x, sum)).sqrt()
}
