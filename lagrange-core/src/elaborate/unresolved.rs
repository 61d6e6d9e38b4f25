//! Names that stand for nothing where they are used, with the places where they stand.

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
    /// The number of the statement that is looked at.
    pub(super) statement: usize,
    /// Statements and places of all declared names, once one of them is missing.
    pub(super) declared: Option<HashMap<String, (usize, Span)>>,
}

/// A name that is used before it is declared. One statement that stands too early or too late is
/// one mistake.
#[derive(Clone, Copy)]
pub(super) struct Late {
    /// The number of the statement that uses it.
    pub(super) user: usize,
    /// The number of the statement that declares it.
    pub(super) declaration: usize,
    /// The number of the mistake that was reported.
    pub(super) mistake: usize,
}

/// Places of a name.
pub(super) struct Places {
    /// The number of the mistake that was reported at the first of them.
    pub(super) mistake: usize,
    /// True if the mistake names it, and not another name beside which it was reported.
    pub(super) is_named: bool,
    /// Lines and columns, the first place included.
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
