//! Vectors of numbers, such as states, and the few operations on them.

use core::fmt::Debug;

use crate::scalar::{Number, Scalar, product_sum};

/// Length up to which a loop over a whole array, which is unrolled, is faster than one over a part.
pub(crate) const UNROLLED: usize = 24;

/// A vector of numbers, such as `[S; K]`. Its length is part of its type. For systems read at run
/// time, the type specifies only the maximum length.
pub trait StateVector<S>: Copy + Debug + AsRef<[S]> + AsMut<[S]> {
    /// A square matrix in rows, such as `[[S; K]; K]`.
    type Square: Clone + Debug + AsRef<[Self]> + AsMut<[Self]>;
    /// An array of indices with the length of the vector, such as `[usize; K]`.
    type Indices: Copy + Debug + AsRef<[usize]> + AsMut<[usize]>;

    /// The zero vector, of maximum length.
    const ZERO: Self;
    /// The zero matrix, of maximum size. Matrices of a length known at run time only may be on the
    /// heap; this one is then empty.
    const ZERO_SQUARE: Self::Square;
    /// The array of zero indices, of maximum length.
    const ZERO_INDICES: Self::Indices;

    /// Returns the zero vector with the length of this one.
    #[inline(always)]
    fn zeros(&self) -> Self {
        Self::ZERO
    }

    /// Returns the entries, possibly followed by unused ones up to a length that the type
    /// determines. Loops over these need no length at run time.
    #[inline(always)]
    fn padded(&self) -> &[S] {
        self.as_ref()
    }

    /// Returns the entries as [`padded`](Self::padded) does.
    #[inline(always)]
    fn padded_mut(&mut self) -> &mut [S] {
        self.as_mut()
    }

    /// Returns the zero matrix with as many rows and columns as this vector has entries.
    #[inline(always)]
    fn zero_square(&self) -> Self::Square {
        Self::ZERO_SQUARE
    }

    /// Creates the vector with these entries.
    ///
    /// # Panics
    /// If the type has no vector of this length.
    #[inline(always)]
    fn of(entries: &[S]) -> Self
    where
        S: Copy,
    {
        let mut vector = Self::ZERO;
        vector.as_mut().copy_from_slice(entries);
        vector
    }

    /// Creates the vector with these entries, followed by others. It stores the place of the
    /// division, unless the types of the parts determine it.
    ///
    /// # Panics
    /// If the type has no vector of this length.
    #[inline(always)]
    fn joined(first: &[S], others: &[S]) -> Self
    where
        S: Copy,
    {
        let mut vector = Self::ZERO;
        let (start, end) = vector.as_mut().split_at_mut(first.len());
        start.copy_from_slice(first);
        end.copy_from_slice(others);
        vector
    }

    /// Returns the parts from which it was joined. The type of the first part has this length.
    ///
    /// # Panics
    /// If the vector is shorter.
    #[inline(always)]
    fn parts(&self, first: usize) -> (&[S], &[S]) {
        self.as_ref().split_at(first)
    }
}

impl<S: Number, const K: usize> StateVector<S> for [S; K] {
    type Square = [[S; K]; K];
    type Indices = [usize; K];

    const ZERO: Self = [S::ZERO; K];
    const ZERO_SQUARE: [[S; K]; K] = [[S::ZERO; K]; K];
    const ZERO_INDICES: [usize; K] = [0; K];
}

/// Computes aᵀb.
#[inline]
pub(crate) fn dot<S: Scalar, Y: StateVector<S>>(a: &Y, b: &Y) -> S {
    a.as_ref().iter().zip(b.as_ref()).fold(S::ZERO, |sum, (a, b)| a.multiply_add(*b, sum))
}

/// Computes a − b.
#[inline]
pub(crate) fn difference<S: Scalar, Y: StateVector<S>>(a: &Y, b: &Y) -> Y {
    let mut difference = *a;
    for (entry, b) in difference.as_mut().iter_mut().zip(b.as_ref()) {
        *entry = *entry - *b;
    }
    difference
}

/// Adds c x to y.
#[inline]
pub(crate) fn add<S: Scalar, Y: StateVector<S>>(y: &mut Y, c: S, x: &Y) {
    for (y, x) in y.padded_mut().iter_mut().zip(x.padded()) {
        *y = x.multiply_add(c, *y);
    }
}

/// Computes aᵀb for vectors of equal length, in four partial sums. Zeros at their ends change no
/// bit.
#[inline(always)]
pub(crate) fn inner<S: Scalar>(a: &[S], b: &[S]) -> S {
    let ((a, last_of_a), (b, last_of_b)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut sums = [S::ZERO; 4];
    let mut add = |a: &[S], b: &[S]| {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum = a.multiply_add(*b, *sum);
        }
    };
    a.iter().zip(b).for_each(|(a, b)| add(a, b));
    add(last_of_a, last_of_b);
    (sums[0] + sums[2]) + (sums[1] + sums[3])
}

/// Adds c x to y, for vectors of equal length.
#[inline(always)]
pub(crate) fn add_scaled<S: Scalar>(y: &mut [S], c: S, x: &[S]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y = x.multiply_add(c, *y);
    }
}

/// Computes the sum of magnitudes, which neither overflows nor underflows if the components do not.
#[inline(always)]
pub(crate) fn l1_norm<S: Number, Y: StateVector<S>>(y: &Y) -> S {
    y.as_ref().iter().fold(S::ZERO, |sum, component| sum + component.abs())
}

/// Computes the sum of the magnitudes of differences.
#[inline(always)]
pub(crate) fn l1_distance<S: Number, Y: StateVector<S>>(a: &Y, b: &Y) -> S {
    a.as_ref().iter().zip(b.as_ref()).fold(S::ZERO, |sum, (a, b)| sum + (*a - *b).abs())
}

/// Returns the vector of this length in the direction of `y`.
pub(crate) fn scaled<S: Scalar, Y: StateVector<S>>(y: &Y, size: S) -> Y {
    combined(&y.zeros(), size / l1_norm(y), y)
}

/// Computes a + c b.
#[inline(always)]
pub(crate) fn combined<S: Number, Y: StateVector<S>>(a: &Y, c: S, b: &Y) -> Y {
    combined_if_fused::<false, S, Y>(a, c, b)
}

/// Computes a + c b, with [fused products](Number::fused_multiply_add) if FUSED.
#[inline(always)]
pub(crate) fn combined_if_fused<const FUSED: bool, S: Number, Y: StateVector<S>>(a: &Y, c: S, b: &Y) -> Y {
    let mut sum = *a;
    for (a, b) in sum.padded_mut().iter_mut().zip(b.padded()) {
        *a = product_sum::<FUSED, S>(*b, c, *a);
    }
    sum
}
