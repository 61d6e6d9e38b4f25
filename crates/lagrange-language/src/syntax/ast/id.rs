//! Identifiers of expressions.

/// Identifies an expression of one [`Expressions`](super::Expressions) arena.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct AstId(pub(super) u32);
