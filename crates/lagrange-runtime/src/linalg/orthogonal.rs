//! Orthogonal factors of matrices that may lack full rank.
//!
//! Householder reflections bring the columns of a matrix to triangular form, each time starting
//! with the column that has the largest remainder. The rank is the number of columns whose
//! remainder exceeds rounding. Source: Golub, Van Loan, *Matrix Computations*, 4th ed., §5.2, §5.4.

use core::ops::Range;

use crate::scalar::Scalar;

/// The factors Q and R of a matrix with these `columns`, in pivot order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OrthogonalFactors<S, const ROWS: usize, const COLUMNS: usize> {
    /// The column taken k-th, with R above row k. If k is below the rank, the vector u of the
    /// reflection I − u uᵀ follows from row k on.
    columns: [[S; ROWS]; COLUMNS],
    /// The diagonal of R.
    diagonal: [S; COLUMNS],
    /// Index of the column taken k-th.
    order: [usize; COLUMNS],
    rank: usize,
    /// Number of nonzero rows.
    rows: usize,
}

impl<S: Scalar, const ROWS: usize, const COLUMNS: usize> OrthogonalFactors<S, ROWS, COLUMNS> {
    /// Factors finite columns. Columns whose remainder is at most `tolerance` times the largest
    /// column depend on the previous ones.
    pub(crate) fn new(columns: [[S; ROWS]; COLUMNS], tolerance: S) -> Self {
        Self::leading(columns, [ROWS, COLUMNS], tolerance)
    }

    /// Factors the given numbers of first rows and columns; all other entries are zero.
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

    /// Returns the columns in pivot order, independent ones first.
    pub(crate) fn order(&self) -> &[usize; COLUMNS] {
        &self.order
    }

    /// Returns the entry of R in row k and for the column taken l-th, with k ≤ l.
    pub(crate) fn entry(&self, k: usize, l: usize) -> S {
        if k == l { self.diagonal[k] } else { self.columns[l][k] }
    }

    /// Computes Qᵀx.
    pub(crate) fn inward(&self, mut x: [S; ROWS]) -> [S; ROWS] {
        for k in 0..self.rank {
            applied(&self.columns[k][k..self.rows], &mut x[k..self.rows]);
        }
        x
    }

    /// Computes Q x.
    pub(crate) fn outward(&self, mut x: [S; ROWS]) -> [S; ROWS] {
        for k in (0..self.rank).rev() {
            applied(&self.columns[k][k..self.rows], &mut x[k..self.rows]);
        }
        x
    }

    /// Computes the coefficients of the independent columns whose sum is as close as possible to
    /// `right`; those of the other columns are zero.
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

    /// Computes the shortest x whose products with the independent columns are the entries of
    /// `products`.
    pub(crate) fn shortest(&self, products: &[S; COLUMNS]) -> [S; ROWS] {
        let mut inner = [S::ZERO; ROWS];
        for k in 0..self.rank {
            let known = (0..k).fold(S::ZERO, |sum, i| self.columns[k][i].multiply_add(inner[i], sum));
            inner[k] = (products[self.order[k]] - known) / self.diagonal[k];
        }
        self.outward(inner)
    }

    /// Returns a combination of columns that is zero up to rounding. The column taken l-th, which
    /// depends on the others, has the coefficient one.
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

/// Relative excess with which a column's remainder takes precedence over earlier ones. Rounding
/// then does not choose between equals: the rank must not flicker near a change.
const PRECEDENCE: f64 = 0.125;

/// Returns the column, from the first row's index on, with the nearly largest remainder in these
/// rows, and the norm of the remainder.
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

/// Reflects the remainder of the first column in these rows onto the first of them; `length` is its
/// length. The reflection is also applied to the other columns. The reflection replaces the
/// remainder. Returns the diagonal entry.
fn reflect<S: Scalar, const ROWS: usize>(columns: &mut [[S; ROWS]], rows: Range<usize>, length: S) -> S {
    let Some((column, others)) = columns.split_first_mut() else { return S::ZERO };
    let diagonal = reflector(&mut column[rows.clone()], length);
    for other in others {
        applied(&column[rows.clone()], &mut other[rows.clone()]);
    }
    diagonal
}

/// Replaces a vector of this length with the reflection that maps it onto its first entry, and
/// returns this entry.
pub(crate) fn reflector<S: Scalar>(column: &mut [S], length: S) -> S {
    let diagonal = if column[0] > S::ZERO { -length } else { length };
    // For this u, half of its square is length (length + |x|). Divided by its root, u makes I − u
    // uᵀ a reflection.
    let root = (length * (length + column[0].abs())).sqrt();
    column[0] = column[0] - diagonal;
    for entry in column {
        *entry = *entry / root;
    }
    diagonal
}

/// Computes x − u (uᵀx).
pub(crate) fn applied<S: Scalar>(u: &[S], x: &mut [S]) {
    let product = u.iter().zip(&*x).fold(S::ZERO, |sum, (u, x)| u.multiply_add(*x, sum));
    for (x, u) in x.iter_mut().zip(u) {
        *x = (-product).multiply_add(*u, *x);
    }
}

/// Computes the Euclidean norm.
pub(crate) fn euclidean_norm<S: Scalar>(x: &[S]) -> S {
    x.iter().fold(S::ZERO, |sum, x| x.multiply_add(*x, sum)).sqrt()
}
