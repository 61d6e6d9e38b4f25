//! Diagnostics for tables.

use super::quoted;
use crate::syntax::ast::Name;

pub(in crate::syntax) const POINTS: &str = "a list of points, rows of values or the path of a file";
pub(in crate::syntax) const POINT: &str = "a point";
pub(in crate::syntax) const ROW: &str = "a row of values in brackets";
pub(in crate::syntax) const AXIS: &str = "a list of numbers in brackets";
pub(in crate::syntax) const AXIS_HELP: &str = "write `rows: [0, 1, 2]` and `columns: [0, 1]`";
pub(in crate::syntax) const ROWS_HELP: &str =
    "write the values in rows, `[[1, 2], [3, 4]]`; points `(x, y, z)` contain their arguments";
pub(in crate::syntax) const AXES_OF_FILES_HELP: &str = "remove it: the first line of a file holds the columns, and the first number of each further line is that of a row";
pub(in crate::syntax) const MONOTONE_VOLUME: &str = "a table of three arguments cannot be monotone";
pub(in crate::syntax) const MONOTONE_VOLUME_HELP: &str =
    "write `interpolation: linear`, which does not overshoot, or `interpolation: natural`";

pub(in crate::syntax) fn too_many_arguments(most: usize) -> String {
    format!("a table has at most {most} arguments")
}

/// Describes the syntax of a point with this many components.
pub(in crate::syntax) fn point_help(components: usize) -> &'static str {
    match components {
        2 => "a point is an argument and a value, `(x, y)`",
        4 => "a point is three arguments and a value, `(x, y, z, w)`",
        _ => {
            "a point is two arguments and a value, `(x, y, z)`; values between axes are in rows, `[[1, 2], [3, 4]]`"
        }
    }
}

pub(in crate::syntax) fn component_count(found: usize) -> String {
    format!("a point of this table cannot have {}", counted(found, "number"))
}

pub(in crate::syntax) fn axis_without_rows(label: &str) -> String {
    format!("`{label}` needs values in rows")
}

pub(in crate::syntax) fn no_axis(table: &str, label: &str, argument: &str) -> String {
    format!("the values of `{argument}` at the {label} of the table `{table}` are not specified")
}

/// Describes the axes of a table with these arguments.
pub(in crate::syntax) fn axes_help(arguments: &[Name]) -> String {
    let axis = |label: &str, each: &str, argument: &Name| {
        format!("`{label}: […]`, the value of `{}` for each {each}", argument.text)
    };
    let axes = [("rows", "row"), ("columns", "number in a row")];
    let axes = axes.iter().zip(arguments).map(|((label, each), argument)| axis(label, each, argument));
    let axes = axes.collect::<Vec<_>>().join(", and ");
    format!("write {axes}; points are in parentheses, `(x, y, z)`")
}

pub(in crate::syntax) fn columns_differ(columns: usize, values: usize) -> String {
    format!("`columns` has {}, but the rows have {}", counted(columns, "number"), counted(values, "value"))
}

pub(in crate::syntax) fn row_differs(values: usize, columns: usize) -> String {
    format!("this row has {}, but `columns` has {}", counted(values, "value"), counted(columns, "number"))
}

pub(in crate::syntax) fn rows_differ(numbers: usize, rows: usize) -> String {
    format!("`rows` has {}, but there are {}", counted(numbers, "number"), counted(rows, "row"))
}

fn counted(count: usize, word: &str) -> String {
    format!("{count} {word}{}", if count == 1 { "" } else { "s" })
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
