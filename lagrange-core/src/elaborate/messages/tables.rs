//! Diagnostics for tables.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    TOO_FEW_HELP = "list at least two points; with several arguments, at least two of each";
    NOT_CONSTANT = "a table is built at compile time and cannot depend on this";
    NOT_CONSTANT_HELP =
        "compute it from numbers, `pi` and `const` names; multiply the table by values known at run time";
    NOT_FINITE = "this number of a table is too large for `f64`";
    NOT_FINITE_HELP = "choose larger units";
    NOT_ASCENDING_HELP = "list the points in ascending order, each argument once";
    REPEATED_POINT = "this point is in the table twice";
    GRID_HELP = "list each point of the grid once, in any order";
    ROUGH_HELP = "write `interpolation: natural` in the table; forces, outputs and events may use any table";
    BENT_ENDS_HELP = "write `outside: extend` or `outside: error` in the table";

    UNREAD = "this file has not been read";
    UNREAD_HELP = "only `lagrange::system!` and `pipeline::parse_with` read files";

    TOO_UNEVEN_HELP = "write `interpolation: linear`, or space the points more evenly";
    too_uneven(name) =
        "the points of the table `{name}` are spaced so unevenly that the curve between them misses their values by rounding";
    on_line(line, message) = "line {line} of the file: {message}";
    flat_grid(name, argument) = "all points of the table `{name}` have the same `{argument}`";
    rough(name) =
        "accelerations or their rates would be discontinuous at the points of the table `{name}`, where it is not smooth enough";
    name_of_derivative(name, table) = "`{name}` is the name of a derivative of the table `{table}`";
    bent_ends(name) =
        "accelerations would jump at both ends of the table `{name}`, beyond which it is constant";
    too_steep(name) =
        "the polynomials between the points of the table `{name}` contain numbers too large for `f64`";
    TOO_STEEP_HELP = "remove points that nearly coincide, or choose larger units for its values";
}

pub(in crate::elaborate) fn too_few(name: &str, count: usize) -> String {
    let points = if count == 1 { "point" } else { "points" };
    format!("the table `{name}` has {count} {points}")
}

pub(in crate::elaborate) fn missing_point(name: &str, at: &[f64]) -> String {
    let at = at.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
    format!("the grid of the table `{name}` lacks the point ({at})")
}

/// Returns help for a table that is evaluated beyond its ends.
pub(in crate::elaborate) fn reaches(name: &str, axes: &[[f64; 2]]) -> String {
    let reach = axes.iter().map(|[first, last]| format!("from {first} to {last}")).collect::<Vec<_>>();
    format!("the table `{name}` reaches {}", reach.join(" and "))
}
