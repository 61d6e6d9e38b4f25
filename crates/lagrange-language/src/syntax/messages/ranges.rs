//! Diagnostics for ranges and nominal values.

use super::shortened;
use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::syntax):

    RANGE_HELP =
        "write `in 0..` for at least 0, `in 0..=1` for 0 to 1, `> 0` for positive numbers, or `> 0 <= 1`";
    UNIT_BEHIND = "a unit cannot follow a range";
    UNIT_BEHIND_HELP = "the unit of a parameter stands before its range: `param m: kg > 0 = 1;`";
    NO_SIGN = "this is not a comparison";
    BOUND_FIRST_HELP = "write the name first: `param mu in 0..1 = 0.5;` or `param mu > 0 < 1 = 0.5;`";
    NO_DOTS = "a range has two dots between its bounds";
    range_or_unit(unit) = "a unit follows a colon, as in `: {unit}`; a range is `in 0..` or `in 0..=1`";
    NO_BOUND = "this range lacks a bound";
    SAME_SIDE = "a range has one lower and one upper bound";
    INTERVAL = "intervals are written with two dots";
    write_interval(lower, upper) =
        "write `in {0}..={1}`, or `> {0} < {1}` without the bounds", shortened(lower), shortened(upper);
    BEHIND_VALUE = "a range cannot follow a value";
    BEHIND_VALUE_HELP = "the range of a parameter stands before its default: `param mu in 0..=1 = 0.5;`";
    without_range(keyword) =
        "only parameters, coordinates and states have ranges, but this belongs to {}", described(&keyword.to_string());
    NO_RANGE = "a range or a nominal value is missing here";
    VALUE_BEHIND_RANGE = "a value cannot follow here: `range` states only ranges and nominal values";
    RANGE_BEHIND_NOMINAL = "a range cannot follow a nominal value";
    RANGE_BEHIND_NOMINAL_HELP = "the range stands first: `coord x in -1..=1 nominal 0.1 = 0.5;`";
    NOMINAL_BEHIND_VALUE = "a nominal value cannot follow a value";
    NOMINAL_BEHIND_VALUE_HELP = "it stands before the initial value: `coord x nominal 0.1 = 0.5;`";
    not_in_state(keyword) =
        "only coordinates, velocities and states have nominal values, but this belongs to {}", described(&keyword.to_string());
    NOT_IN_STATE_HELP = "remove it: nominal values scale the tolerances of the state";
}

fn described(keyword: &str) -> &'static str {
    match keyword {
        "input" => "an input",
        "const" => "a constant",
        _ => "a parameter",
    }
}

/// Returns advice for the range of an input or a constant.
pub(in crate::syntax) fn limit(keyword: &str, name: &str) -> String {
    match keyword {
        "input" => format!("limit it where it is used: `min(max({}, -1), 1)`", shortened(name)),
        _ => "remove the range: the value is known".to_owned(),
    }
}
