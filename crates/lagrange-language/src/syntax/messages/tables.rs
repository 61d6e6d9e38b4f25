//! Diagnostics for tables.

use super::quoted;

pub(in crate::syntax) const POINTS: &str = "a list of points or the path of a file";
pub(in crate::syntax) const POINT: &str = "a point";
pub(in crate::syntax) const TOO_MANY_ARGUMENTS: &str = "a table has one or two arguments";
pub(in crate::syntax) const MONOTONE_SURFACE: &str = "a table of two arguments cannot be monotone";
pub(in crate::syntax) const MONOTONE_SURFACE_HELP: &str =
    "write `interpolation: natural` or `interpolation: linear`";

/// Describes the syntax of a point with this many components.
pub(in crate::syntax) fn point_help(components: usize) -> &'static str {
    match components {
        2 => "a point is an argument and a value, `(x, y)`",
        _ => "a point is two arguments and a value, `(x, y, z)`",
    }
}

pub(in crate::syntax) fn component_count(found: usize) -> String {
    let numbers = if found == 1 { "number" } else { "numbers" };
    format!("a point of this table cannot have {found} {numbers}")
}

pub(in crate::syntax) fn unsaid(label: &str, table: &str) -> String {
    match label {
        "outside" => format!("the value of `{table}` beyond its points is not specified"),
        _ => format!("the {label} of `{table}` is not specified"),
    }
}

pub(in crate::syntax) fn unknown_option(word: &str) -> String {
    format!("unknown label {} for a table", quoted(word))
}

pub(in crate::syntax) fn unknown_way(label: &str, word: &str) -> String {
    format!("unknown value {} for `{label}`", quoted(word))
}

/// Names the option that this word denotes in other tools, or all options.
pub(in crate::syntax) fn ways_beside(label: &str, names: &[&str], word: &str) -> String {
    match (label, word) {
        ("interpolation", "cubic" | "spline" | "akima" | "pchip") => "write `interpolation: natural`, a cubic spline, or `interpolation: monotone`, which does not overshoot".to_owned(),
        _ => ways(label, names),
    }
}

/// Lists the available options.
pub(in crate::syntax) fn ways(label: &str, names: &[&str]) -> String {
    let ways = names.iter().map(|name| format!("`{label}: {name}`")).collect::<Vec<_>>();
    format!("write {}", ways.join(" or "))
}
