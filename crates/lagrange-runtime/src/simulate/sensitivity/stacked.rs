//! States followed by their derivatives.

use crate::scalar::Number;
use crate::system::StateVector;

/// A state of N entries, followed by its N derivatives for each variable. There is room for R rows,
/// `count` of which are used.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stacked<S, const N: usize, const R: usize> {
    pub(super) rows: [[S; N]; R],
    count: usize,
}

impl<S: Number, const N: usize, const R: usize> Stacked<S, N, R> {
    /// Returns a state whose derivatives with respect to `variables` variables are zero.
    pub(super) fn new(state: [S; N], variables: usize) -> Self {
        let mut rows = [[S::ZERO; N]; R];
        rows[0] = state;
        Stacked { rows, count: 1 + variables }
    }

    /// Returns a state with its derivative with respect to one variable.
    pub(in crate::simulate) fn with_change(state: [S; N], change: [S; N]) -> Self {
        let mut stacked = Stacked::new(state, 1);
        stacked.rows[1] = change;
        stacked
    }

    /// Returns the state and its derivatives.
    #[inline(always)]
    pub(super) fn used(&self) -> &[[S; N]] {
        &self.rows[..self.count]
    }

    /// Returns the derivatives of the state.
    pub(in crate::simulate) fn derivatives(&self) -> &[[S; N]] {
        &self.rows[1..self.count]
    }
}

impl<S, const N: usize, const R: usize> AsRef<[S]> for Stacked<S, N, R> {
    #[inline]
    fn as_ref(&self) -> &[S] {
        self.rows[..self.count].as_flattened()
    }
}

impl<S, const N: usize, const R: usize> AsMut<[S]> for Stacked<S, N, R> {
    #[inline]
    fn as_mut(&mut self) -> &mut [S] {
        self.rows[..self.count].as_flattened_mut()
    }
}

impl<S: Number, const N: usize, const R: usize> StateVector<S> for Stacked<S, N, R> {
    type Square = StackedSquare<S, N, R>;
    type Indices = StackedIndices<N, R>;

    const ZERO: Self = Stacked { rows: [[S::ZERO; N]; R], count: R };
    const ZERO_SQUARE: StackedSquare<S, N, R> = StackedSquare { rows: [[Self::ZERO; N]; R], count: R };
    const ZERO_INDICES: StackedIndices<N, R> = StackedIndices([[0; N]; R]);

    #[inline]
    fn zeros(&self) -> Self {
        Stacked { count: self.count, ..Self::ZERO }
    }

    #[inline]
    fn zero_square(&self) -> StackedSquare<S, N, R> {
        StackedSquare { rows: [[self.zeros(); N]; R], count: self.count }
    }

    #[inline]
    fn of(entries: &[S]) -> Self {
        let mut vector = Stacked { count: entries.len().checked_div(N).unwrap_or(R), ..Self::ZERO };
        vector.as_mut().copy_from_slice(entries);
        vector
    }
}

/// A square matrix, stored by rows.
#[derive(Clone, Copy, Debug)]
pub struct StackedSquare<S, const N: usize, const R: usize> {
    rows: [[Stacked<S, N, R>; N]; R],
    count: usize,
}

impl<S, const N: usize, const R: usize> AsRef<[Stacked<S, N, R>]> for StackedSquare<S, N, R> {
    #[inline]
    fn as_ref(&self) -> &[Stacked<S, N, R>] {
        self.rows[..self.count].as_flattened()
    }
}

impl<S, const N: usize, const R: usize> AsMut<[Stacked<S, N, R>]> for StackedSquare<S, N, R> {
    #[inline]
    fn as_mut(&mut self) -> &mut [Stacked<S, N, R>] {
        self.rows[..self.count].as_flattened_mut()
    }
}

/// An index for each entry.
#[derive(Clone, Copy, Debug)]
pub struct StackedIndices<const N: usize, const R: usize>([[usize; N]; R]);

impl<const N: usize, const R: usize> AsRef<[usize]> for StackedIndices<N, R> {
    #[inline]
    fn as_ref(&self) -> &[usize] {
        self.0.as_flattened()
    }
}

impl<const N: usize, const R: usize> AsMut<[usize]> for StackedIndices<N, R> {
    #[inline]
    fn as_mut(&mut self) -> &mut [usize] {
        self.0.as_flattened_mut()
    }
}

/// Computes the rates ∂f/∂y s + c ∂f/∂p of a derivative s. ∂f/∂y is given in rows. Derivatives with
/// respect to a parameter have c and ∂f/∂p.
#[inline(always)]
pub(super) fn variational_rates<S: Number, Y: AsRef<[S]>>(
    rows: &[Y],
    changes: &[S],
    direct: Option<(S, &[S])>,
    rates: &mut [S],
) {
    for (i, (rate, row)) in rates.iter_mut().zip(rows).enumerate() {
        *rate = match direct {
            Some((scale, column)) => scale * column[i],
            None => S::ZERO,
        };
        for (slope, change) in row.as_ref().iter().zip(changes) {
            *rate = slope.multiply_add(*change, *rate);
        }
    }
}
