//! Known facts about a function without a formula.

use proc_macro2::Span;

use lagrange_expr::opaque::Opaque;

/// A function that can be called.
pub(super) struct Callable {
    /// `None` for an invalid table, which has been reported.
    pub(super) function: Option<Opaque>,
    pub(super) span: Span,
    pub(super) is_called: bool,
}
