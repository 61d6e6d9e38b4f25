//! Diagnostics for tables.

pub(in crate::elaborate) const TOO_FEW_HELP: &str =
    "list at least two points; with two arguments, at least two of each";
pub(in crate::elaborate) const TOO_MANY_HELP: &str =
    "list fewer points, since smooth data need few, or compute it in a `function` of your crate";
pub(in crate::elaborate) const NOT_CONSTANT: &str =
    "a table is built at compile time and cannot depend on this";
pub(in crate::elaborate) const NOT_CONSTANT_HELP: &str =
    "compute it from numbers, `pi` and `const` names; multiply the table by values known at run time";
pub(in crate::elaborate) const NOT_FINITE: &str = "this number of a table is too large for `f64`";
pub(in crate::elaborate) const NOT_FINITE_HELP: &str = "choose larger units";
pub(in crate::elaborate) const NOT_ASCENDING_HELP: &str =
    "list the points in ascending order, each argument once";
pub(in crate::elaborate) const REPEATED_POINT: &str = "this point is in the table twice";
pub(in crate::elaborate) const GRID_HELP: &str = "list each point of the grid once, in any order";
pub(in crate::elaborate) const ROUGH_HELP: &str =
    "write `interpolation: natural` in the table; forces, outputs and events may use any table";
pub(in crate::elaborate) const BENT_ENDS_HELP: &str =
    "write `outside: extend` or `outside: error` in the table";

pub(in crate::elaborate) const UNREAD: &str = "this file has not been read";
pub(in crate::elaborate) const UNREAD_HELP: &str =
    "only `lagrange::system!` and `pipeline::parse_with` read files";

pub(in crate::elaborate) const TOO_UNEVEN_HELP: &str =
    "write `interpolation: linear`, or space the points more evenly";

pub(in crate::elaborate) fn too_uneven(name: &str) -> String {
    format!(
        "the points of the table `{name}` are spaced so unevenly that the curve between them misses their values by rounding"
    )
}

pub(in crate::elaborate) fn too_few(name: &str, count: usize) -> String {
    let points = if count == 1 { "point" } else { "points" };
    format!("the table `{name}` has {count} {points}")
}

pub(in crate::elaborate) fn too_many(name: &str, count: usize, most: usize) -> String {
    format!("the table `{name}` has {count} points; at most {most} are supported")
}

pub(in crate::elaborate) fn not_ascending(argument: &str, before: f64, after: f64) -> String {
    format!("`{argument}` does not ascend from {before} to {after}")
}

pub(in crate::elaborate) fn on_line(line: usize, message: &str) -> String {
    format!("line {line} of the file: {message}")
}

pub(in crate::elaborate) fn flat_grid(name: &str, argument: &str) -> String {
    format!("all points of the table `{name}` have the same `{argument}`")
}

pub(in crate::elaborate) fn missing_point(name: &str, [x, y]: [f64; 2]) -> String {
    format!("the grid of the table `{name}` lacks the point ({x}, {y})")
}

pub(in crate::elaborate) fn rough(name: &str) -> String {
    format!(
        "accelerations or their slopes would jump at the points of the table `{name}`, whose slope bends sharply there"
    )
}

pub(in crate::elaborate) fn name_of_derivative(name: &str, table: &str) -> String {
    format!("`{name}` is the name of a derivative of the table `{table}`")
}

pub(in crate::elaborate) fn bent_ends(name: &str) -> String {
    format!("accelerations would jump at both ends of the table `{name}`, beyond which it is constant")
}

/// Help where a table is evaluated beyond its ends.
pub(in crate::elaborate) fn reaches(name: &str, axes: &[[f64; 2]]) -> String {
    let reach = axes.iter().map(|[first, last]| format!("from {first} to {last}")).collect::<Vec<_>>();
    format!("the table `{name}` reaches {}", reach.join(" and "))
}

pub(in crate::elaborate) fn too_steep(name: &str) -> String {
    format!("the polynomials between the points of the table `{name}` contain numbers too large for `f64`")
}

pub(in crate::elaborate) const TOO_STEEP_HELP: &str =
    "remove points that nearly coincide, or choose larger units for its values";
