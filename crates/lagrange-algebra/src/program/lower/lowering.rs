//! Values of the expressions that have been lowered so far.

use super::sharing::Sharing;
use crate::calculus::Grades;
use crate::program::builder::Builder;
use crate::program::ir::ValueId;
use crate::program::labels::Labels;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph};

/// A value that represents an expression or its negative. Signs are propagated until an operation
/// absorbs them, which saves negations.
#[derive(Clone, Copy)]
pub(super) struct Signed {
    pub(super) value: ValueId,
    pub(super) negative: bool,
}

impl Signed {
    pub(super) fn positive(value: ValueId) -> Signed {
        Signed { value, negative: false }
    }
}

/// Expressions that are being lowered.
pub(super) struct Lowering<'a> {
    pub(super) graph: &'a Graph,
    pub(super) labels: &'a Labels,
    pub(super) opposites: HashMap<ExprId, &'a str>,
    pub(super) sharing: Sharing,
    pub(super) grades: Grades,
    pub(super) builder: Builder,
    pub(super) values: HashMap<ExprId, Signed>,
}

impl Lowering<'_> {
    /// Returns the value of an expression that has been lowered.
    pub(super) fn signed(&self, id: ExprId) -> Signed {
        *self.values.get(&id).expect("children come before parents and are merged only where expected")
    }

    /// Returns the value of an expression that has been lowered, negated if necessary.
    pub(super) fn plain(&mut self, id: ExprId) -> ValueId {
        let signed = self.signed(id);
        self.with_sign(signed)
    }

    pub(super) fn with_sign(&mut self, Signed { value, negative }: Signed) -> ValueId {
        if negative { self.builder.negate(value) } else { value }
    }
}
