//! Diagnostics for ranges and nominal values.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    BOUND = "a bound of a range";
    EMPTY_RANGE = "this range is empty: its upper bound is not above the lower one";
    EMPTY_RANGE_HELP = "write the smaller bound first: `in 0..=1`";
    default_outside(name, range) = "this default of `{name}` is outside of its range, `{range}`";
    DEFAULT_OUTSIDE_HELP = "change the default or the range";
    NOMINAL = "a nominal value";
    not_positive(value) = "a nominal value must be positive, but this is {value}";
    NOT_POSITIVE_HELP = "write the typical magnitude, such as `nominal 1e-3`";
    two_ranges(target) = "`{target}` has two ranges";
    two_nominal_values(target) = "`{target}` has two nominal values";
    LIMITED_HERE = "the other one is here";
    LIMITED_TWICE_HELP = "remove one of them";
    ENTRY_HELP =
        "write `range x in 0..=1;` or `range dot(x) nominal 10;` with a coordinate or a state `x`";
}
