//! Diagnostics for ranges of parameters.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    BOUND = "a bound of a range";
    EMPTY_RANGE = "this range is empty: its upper bound is not above the lower one";
    EMPTY_RANGE_HELP = "write the smaller bound first: `in 0..=1`";
    default_outside(name, range) = "this default of `{name}` is outside of its range, `{range}`";
    DEFAULT_OUTSIDE_HELP = "change the default or the range";
}
