//! Diagnostics for values that equations define.

use super::quoted;

pub(in crate::syntax) const NO_ZERO_ON_THE_LEFT: &str = "the left side of the equation is not `0`";

pub(in crate::syntax) const SEVERAL_UNKNOWNS: &str =
    "equations are solved one at a time, each for one unknown";
pub(in crate::syntax) const SEVERAL_UNKNOWNS_HELP: &str =
    "write `solve y: 0 = e;` for each; if two unknowns depend on each other, eliminate one by hand";

pub(in crate::syntax) fn zero_on_the_left(unknown: &str) -> String {
    format!("write `solve {unknown}: 0 = e;`, where e is the difference of the two sides")
}

pub(in crate::syntax) fn unknown_option(word: &str) -> String {
    format!("unknown label {} for an equation", quoted(word))
}
