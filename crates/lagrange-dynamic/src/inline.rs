//! Vectors whose length is known at run time, with a fixed capacity. States are copied without heap
//! allocation, like those of emitted types.

use std::fmt::{self, Debug, Formatter};

use lagrange_runtime::system::StateVector;

/// Largest capacity up to which computing with unused entries takes less time than a loop of a
/// length known at run time.
const MAX_PADDED: usize = 8;

/// A vector of at most `CAPACITY` numbers. A vector joined from two parts stores the start of the
/// second part.
#[derive(Clone, Copy)]
pub struct Inline<const CAPACITY: usize> {
    /// Entries, followed by unused numbers.
    entries: [f64; CAPACITY],
    length: usize,
    /// Length of the first part.
    first: usize,
}

impl<const CAPACITY: usize> Inline<CAPACITY> {
    const ZEROS: Self = Inline { entries: [0.0; CAPACITY], length: CAPACITY, first: CAPACITY };
}

impl<const CAPACITY: usize> AsRef<[f64]> for Inline<CAPACITY> {
    #[inline]
    fn as_ref(&self) -> &[f64] {
        &self.entries[..self.length]
    }
}

impl<const CAPACITY: usize> AsMut<[f64]> for Inline<CAPACITY> {
    #[inline]
    fn as_mut(&mut self) -> &mut [f64] {
        &mut self.entries[..self.length]
    }
}

impl<const CAPACITY: usize> PartialEq for Inline<CAPACITY> {
    fn eq(&self, other: &Self) -> bool {
        self.as_ref() == other.as_ref()
    }
}

impl<const CAPACITY: usize> Debug for Inline<CAPACITY> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.as_ref().fmt(f)
    }
}

impl<const CAPACITY: usize> StateVector<f64> for Inline<CAPACITY> {
    type Square = Rows<CAPACITY>;
    type Indices = [usize; CAPACITY];

    const ZERO: Self = Self::ZEROS;
    const ZERO_SQUARE: Rows<CAPACITY> = Rows(Vec::new());
    const ZERO_INDICES: [usize; CAPACITY] = [0; CAPACITY];

    #[inline]
    fn zeros(&self) -> Self {
        Inline { entries: [0.0; CAPACITY], ..*self }
    }

    #[inline]
    fn padded(&self) -> &[f64] {
        if CAPACITY <= MAX_PADDED { &self.entries } else { self.as_ref() }
    }

    #[inline]
    fn padded_mut(&mut self) -> &mut [f64] {
        if CAPACITY <= MAX_PADDED { &mut self.entries } else { self.as_mut() }
    }

    #[inline]
    fn zero_square(&self) -> Rows<CAPACITY> {
        Rows(vec![self.zeros(); self.length])
    }

    #[inline]
    fn of(entries: &[f64]) -> Self {
        Self::joined(entries, &[])
    }

    #[inline]
    fn joined(first: &[f64], others: &[f64]) -> Self {
        let mut vector = Self::ZEROS;
        (vector.first, vector.length) = (first.len(), first.len() + others.len());
        let (start, end) = vector.as_mut().split_at_mut(first.len());
        start.copy_from_slice(first);
        end.copy_from_slice(others);
        vector
    }

    /// The stored length of the first part is used, since the type does not determine it.
    #[inline]
    fn parts(&self, _first: usize) -> (&[f64], &[f64]) {
        self.as_ref().split_at(self.first)
    }
}

/// A square matrix of at most `CAPACITY` rows. It is on the heap, since a matrix of the largest
/// capacity takes 130 KiB.
#[derive(Clone)]
pub struct Rows<const CAPACITY: usize>(Vec<Inline<CAPACITY>>);

impl<const CAPACITY: usize> Rows<CAPACITY> {
    /// Returns the matrix of these entries in row-major order, with rows of this length.
    pub(crate) fn of(entries: &[f64], length: usize) -> Self {
        let mut rows = Inline::of(&vec![0.0; length]).zero_square();
        for (row, entries) in rows.as_mut().iter_mut().zip(entries.chunks(length.max(1))) {
            row.as_mut().copy_from_slice(entries);
        }
        rows
    }
}

impl<const CAPACITY: usize> AsRef<[Inline<CAPACITY>]> for Rows<CAPACITY> {
    #[inline]
    fn as_ref(&self) -> &[Inline<CAPACITY>] {
        &self.0
    }
}

impl<const CAPACITY: usize> AsMut<[Inline<CAPACITY>]> for Rows<CAPACITY> {
    #[inline]
    fn as_mut(&mut self) -> &mut [Inline<CAPACITY>] {
        &mut self.0
    }
}

impl<const CAPACITY: usize> Debug for Rows<CAPACITY> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.as_ref().fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_remembered_and_zeros_have_the_same_length() {
        let state = Inline::<8>::joined(&[1.0, 2.0], &[3.0]);
        assert_eq!(state.parts(7), (&[1.0, 2.0][..], &[3.0][..]));
        assert_eq!(state.zeros().as_ref(), [0.0; 3]);
        assert_eq!(state.zeros().parts(7), (&[0.0; 2][..], &[0.0][..]));
        assert_eq!(state.zero_square().as_ref().len(), 3);
        assert_eq!(Rows::<4>::of(&[1.0, 2.0, 3.0, 4.0], 2).as_ref()[1].as_ref(), [3.0, 4.0]);
    }
}
