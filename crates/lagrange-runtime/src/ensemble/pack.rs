//! Messages between processes, as words of 64 bits.

use std::vec::Vec;

use super::histogram::Histogram;
use super::moments::Moments;

/// A value, such as a reduction, that can be converted to words and back with the same bits.
/// Processes can thus exchange such values.
///
/// Tuples and arrays are packed entry by entry, vectors after their length.
///
/// ```
/// use lagrange::ensemble::{Moments, Pack};
///
/// let mut moments = Moments::new();
/// [1.0, 2.0, 6.0].into_iter().for_each(|value| moments.add(value));
/// let mut words = Vec::new();
/// moments.pack(&mut words);
/// assert_eq!(Moments::unpack(&mut words.into_iter()), Some(moments));
/// ```
pub trait Pack: Sized {
    /// Appends the words of this value.
    fn pack(&self, words: &mut Vec<u64>);

    /// Reads a value from as many words as [`pack`](Self::pack) appended; `None` if they do not
    /// represent one.
    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self>;
}

impl Pack for u64 {
    fn pack(&self, words: &mut Vec<u64>) {
        words.push(*self);
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        words.next()
    }
}

impl Pack for usize {
    fn pack(&self, words: &mut Vec<u64>) {
        words.push(*self as u64);
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        words.next()?.try_into().ok()
    }
}

impl Pack for f64 {
    fn pack(&self, words: &mut Vec<u64>) {
        words.push(self.to_bits());
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        words.next().map(f64::from_bits)
    }
}

impl<T: Pack> Pack for Vec<T> {
    fn pack(&self, words: &mut Vec<u64>) {
        self.len().pack(words);
        self.iter().for_each(|entry| entry.pack(words));
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        let length = usize::unpack(words)?;
        (0..length).map(|_| T::unpack(words)).collect()
    }
}

impl<T: Pack, const N: usize> Pack for [T; N] {
    fn pack(&self, words: &mut Vec<u64>) {
        self.iter().for_each(|entry| entry.pack(words));
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        let entries: Vec<T> = (0..N).map(|_| T::unpack(words)).collect::<Option<_>>()?;
        entries.try_into().ok()
    }
}

impl<A: Pack, B: Pack> Pack for (A, B) {
    fn pack(&self, words: &mut Vec<u64>) {
        self.0.pack(words);
        self.1.pack(words);
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        Some((A::unpack(words)?, B::unpack(words)?))
    }
}

impl<A: Pack, B: Pack, C: Pack> Pack for (A, B, C) {
    fn pack(&self, words: &mut Vec<u64>) {
        self.0.pack(words);
        self.1.pack(words);
        self.2.pack(words);
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        Some((A::unpack(words)?, B::unpack(words)?, C::unpack(words)?))
    }
}

impl Pack for Moments {
    fn pack(&self, words: &mut Vec<u64>) {
        let Moments { count, mean, squares, min, max } = *self;
        (count, [mean, squares, min, max]).pack(words);
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        let (count, [mean, squares, min, max]) = Pack::unpack(words)?;
        Some(Moments { count, mean, squares, min, max })
    }
}

impl Pack for Histogram {
    fn pack(&self, words: &mut Vec<u64>) {
        words.extend([self.most as u64, i64::from(self.exponent) as u64, self.not_finite]);
        self.counts.len().pack(words);
        self.counts.iter().for_each(|(place, count)| words.extend([*place as u64, *count]));
    }

    fn unpack(words: &mut impl Iterator<Item = u64>) -> Option<Self> {
        let (most, exponent) = (usize::unpack(words)?, (words.next()? as i64).try_into().ok()?);
        let (not_finite, length) = (words.next()?, usize::unpack(words)?);
        let counts = (0..length).map(|_| Some((words.next()? as i64, words.next()?)));
        Some(Histogram { most, exponent, counts: counts.collect::<Option<_>>()?, not_finite })
    }
}
