//! Rows of a file.

use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use crate::ensemble::plan::SharedSystem;
use crate::ensemble::rows::Rows;
use crate::simulate::Table;

/// The rows of consecutive motions, with the index of the motion of each row.
pub(super) struct Sheet<M: SharedSystem> {
    rows: Rows<M>,
    /// The index of the motion of each row.
    pub(super) motions: Vec<i64>,
}

impl<M: SharedSystem> Sheet<M> {
    pub(super) fn new() -> Self {
        Sheet { rows: Rows::new(), motions: Vec::new() }
    }

    /// Adds the rows of a motion.
    pub(super) fn push(&mut self, index: usize, push: impl FnOnce(&mut Rows<M>)) {
        push(&mut self.rows);
        self.motions.resize(self.rows.table.as_ref().map_or(0, Table::len), index as i64);
    }

    /// Appends the rows of the motions that follow.
    pub(super) fn merge(&mut self, later: Self) {
        self.rows.merge(later.rows);
        self.motions.extend(later.motions);
    }

    /// Returns the number of rows.
    pub(super) fn len(&self) -> usize {
        self.motions.len()
    }

    /// Returns the number of failed motions.
    pub(super) fn failed(&self) -> usize {
        self.rows.failures.len()
    }

    /// Returns the columns with their names: parameters, time under the given name, and the rest.
    pub(super) fn columns<'s>(&'s self, time: &'s str) -> Vec<(&'s str, &'s [M::Scalar])> {
        let Some(table) = &self.rows.table else { return Vec::new() };
        let named = table.names().iter().map(String::as_str).zip(table.columns());
        let mut columns: Vec<_> = named.chain([(time, table.times())]).collect();
        // The parameters, and then the time, follow the state and the observed columns.
        columns.rotate_right(self.rows.parameters + 1);
        columns
    }

    /// Returns the number of parameter columns, which come first.
    pub(super) fn parameters(&self) -> usize {
        self.rows.parameters
    }

    /// Returns the causes of failures, and for each row, true if it is the last one of a failed
    /// motion.
    pub(super) fn causes(&self) -> (Vec<String>, Vec<bool>) {
        let mut is_there = vec![false; self.len()];
        let rows = &self.rows.failures;
        for failure in rows {
            let behind = self.motions.partition_point(|motion| *motion <= failure.index as i64);
            is_there[behind - 1] = true;
        }
        (rows.iter().map(|failure| failure.why().to_string()).collect(), is_there)
    }
}
