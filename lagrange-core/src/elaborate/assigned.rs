//! Entries of the state that have been assigned values.

use crate::model::{Assignment, Bound, EntryLimits};
use lagrange_expr::diagnostics::Origin;
use lagrange_language::syntax::ast::AllowedRange;

/// Entries by their indices in [q…, v…], with the places of their assignments.
#[derive(Default)]
pub(super) struct Assigned(Vec<(usize, Origin)>);

impl Assigned {
    /// Returns the first place where an entry is assigned.
    pub(super) fn first(&self, index: usize) -> Option<Origin> {
        self.0.iter().find(|(other, _)| *other == index).map(|(_, origin)| *origin)
    }

    /// Records an assignment, and returns the first one to the same entry.
    pub(super) fn note(&mut self, index: usize, origin: Origin) -> Option<Origin> {
        let first = self.first(index);
        self.0.push((index, origin));
        first
    }
}

/// The lower and the upper bound of a parameter.
pub(super) type Bounds = [Option<Bound>; 2];

/// The range and the nominal value of an entry of the state, as declared.
#[derive(Clone, Debug)]
pub(super) struct DeclaredLimits {
    /// Index in [q…, v…].
    pub(super) index: usize,
    pub(super) origin: Origin,
    pub(super) range: AllowedRange,
    pub(super) limits: EntryLimits,
}

/// Values of entries declared so far: at the start, or before it.
#[derive(Default)]
pub(super) struct EntryValues {
    pub(super) values: Vec<Assignment>,
    pub(super) assigned: Assigned,
}
