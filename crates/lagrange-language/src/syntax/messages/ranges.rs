//! Diagnostics for ranges of parameters.

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
    not_a_parameter(keyword) = "only parameters have ranges, but this belongs to {}", described(&keyword.to_string());
}

fn described(keyword: &str) -> &'static str {
    match keyword {
        "input" => "an input",
        "const" => "a constant",
        "state" | "discrete" => "a state",
        _ => "a coordinate",
    }
}

/// Returns advice for a range of something that is not a parameter.
pub(in crate::syntax) fn limit(keyword: &str, name: &str) -> String {
    let name = shortened(name);
    match keyword {
        "input" => format!("limit it where it is used: `min(max({name}, -1), 1)`"),
        "const" => "remove the range: the value is known".to_owned(),
        _ => format!(
            "stop the motion at a bound, `event end = {name} - 1, rising => stop;`, or let it bounce with `=> impact(0.5);`"
        ),
    }
}
