//! What is said of files of tables.

pub(super) const NO_FILES: &str =
    "files are read where `lagrange::system!` is compiled, and by `pipeline::parse_with`";
pub(super) const UNREADABLE_HELP: &str =
    "give the path from the folder of your `Cargo.toml`, or list the points: `= [(0, 1), (2, 5)]`";
pub(super) const FORM_HELP: &str = "a file has a point on each line, such as `0.5, 1.25`; the first line may name the columns, and comments begin with `#`";
pub(super) const DECIMAL_COMMA_HELP: &str = "write decimals with a point: `1.5`";

pub(super) fn unreadable(path: &str, reason: &str) -> String {
    format!("`{path}` cannot be read: {reason}")
}

pub(super) fn on_line(line: usize, path: &str, complaint: &str) -> String {
    format!("line {line} of `{path}`: {complaint}")
}

pub(super) fn no_number(field: &str) -> String {
    let shortened = field.chars().take(40).collect::<String>();
    format!("`{shortened}` is no number")
}

pub(super) fn wrong_columns(found: usize, needed: usize) -> String {
    format!("the point has {found} numbers, not {needed}")
}
