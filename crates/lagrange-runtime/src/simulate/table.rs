//! Named columns of numbers.

use std::string::String;
use std::vec::Vec;

use crate::system::Columns;

/// Name of the time column in files.
pub(crate) const TIME: &str = "t";

/// Samples in columns: their times and, for each name, a number for each time.
#[derive(Clone, PartialEq, Debug)]
pub struct Table<S> {
    times: Vec<S>,
    names: Vec<String>,
    columns: Vec<Vec<S>>,
}

impl<S: Copy> Table<S> {
    /// Creates a table without samples.
    pub(crate) fn new(names: Vec<String>) -> Self {
        let columns = names.iter().map(|_| Vec::new()).collect();
        Table { times: Vec::new(), names, columns }
    }

    /// Adds a sample with one number for each column.
    pub(crate) fn push(&mut self, time: S, row: &[S]) {
        debug_assert_eq!(row.len(), self.columns.len());
        self.times.push(time);
        for (column, value) in self.columns.iter_mut().zip(row) {
            column.push(*value);
        }
    }

    /// Adds the samples of a table with the same columns.
    #[cfg(feature = "ensemble")]
    pub(crate) fn append(&mut self, later: Self) {
        debug_assert_eq!(self.names, later.names);
        self.times.extend(later.times);
        self.columns.iter_mut().zip(later.columns).for_each(|(column, later)| column.extend(later));
    }

    /// Adds samples of the first columns, with one number for each further column, repeated in all
    /// samples.
    #[cfg(all(feature = "ensemble", feature = "parquet"))]
    pub(crate) fn extend(&mut self, samples: &Self, further: impl Iterator<Item = S>) {
        self.times.extend_from_slice(&samples.times);
        let (own, others) = self.columns.split_at_mut(samples.columns.len());
        own.iter_mut().zip(&samples.columns).for_each(|(column, samples)| column.extend_from_slice(samples));
        others.iter_mut().zip(further).for_each(|(column, value)| column.resize(self.times.len(), value));
    }

    /// Removes the last sample.
    pub(super) fn pop(&mut self) {
        self.times.pop();
        self.columns.iter_mut().for_each(|column| {
            column.pop();
        });
    }

    /// Returns the number of samples.
    pub fn len(&self) -> usize {
        self.times.len()
    }

    /// True if there is no sample.
    pub fn is_empty(&self) -> bool {
        self.times.is_empty()
    }

    /// Returns the times of the samples, in the order of the run.
    pub fn times(&self) -> &[S] {
        &self.times
    }

    /// Returns the names of the columns, in order; time has no name.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Returns the columns in the order of their names.
    pub fn columns(&self) -> impl ExactSizeIterator<Item = &[S]> {
        self.columns.iter().map(Vec::as_slice)
    }

    /// Returns the column of this name.
    pub fn column(&self, name: &str) -> Option<&[S]> {
        let index = self.names.iter().position(|known| known == name)?;
        self.columns.get(index).map(Vec::as_slice)
    }
}

/// Returns the first name, in alphabetical order, that occurs twice in a list.
pub(super) fn repeated(names: &[String]) -> Option<&String> {
    let mut sorted: Vec<_> = names.iter().collect();
    sorted.sort_unstable();
    sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

/// Provides access by index for the named columns emitted with a system.
impl<S: Copy> Columns for Table<S> {
    type Scalar = S;

    fn column(&self, index: usize) -> &[S] {
        &self.columns[index]
    }
}
