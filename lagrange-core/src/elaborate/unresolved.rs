//! Undefined names, with the places where they are used.

use std::collections::BTreeSet;

use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::diagnostics::Origin;
use proc_macro2::Span;

/// Names that were reported.
#[derive(Default)]
pub(super) struct Unresolved {
    pub(super) names: OrderedMap<String, Places>,
    /// Names that are used too early.
    pub(super) late: Vec<Late>,
    /// The index of the current statement.
    pub(super) statement: usize,
    /// Statements and places of all declared names, collected when the first undefined name is
    /// found.
    pub(super) declared: Option<HashMap<String, (usize, Span)>>,
}

/// A name that is used before its declaration. A misplaced statement is reported only once.
#[derive(Clone, Copy)]
pub(super) struct Late {
    /// The index of the statement that uses the name.
    pub(super) user: usize,
    /// The index of the statement that declares the name.
    pub(super) declaration: usize,
    /// The index of the reported error.
    pub(super) mistake: usize,
}

/// Places of a name.
pub(super) struct Places {
    /// The index of the error that was reported at the first place.
    pub(super) mistake: usize,
    /// True if the error mentions this name, and not another one that it was reported with.
    pub(super) is_named: bool,
    /// Lines and columns, including the first place.
    pub(super) all: BTreeSet<(usize, usize)>,
}

pub(super) fn place(origin: Origin) -> (usize, usize) {
    let start = origin.start.start();
    (start.line, start.column)
}

impl Places {
    pub(super) fn new(mistake: usize, origin: Origin) -> Places {
        Places { mistake, is_named: true, all: BTreeSet::from([place(origin)]) }
    }
}
