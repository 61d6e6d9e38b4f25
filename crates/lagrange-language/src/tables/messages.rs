//! Messages about table files.

/// Characters of a field that a message repeats at most.
const MAX_SHOWN: usize = 40;

pub(super) const NO_FILES: &str = "only `lagrange::system!` and `pipeline::parse_with` read files";
pub(super) const UNREADABLE_HELP: &str =
    "give the path from the folder of your `Cargo.toml`, or list the points: `= [(0, 1), (2, 5)]`";
pub(super) const FORM_HELP: &str = "a file has a point on each line, such as `0.5, 1.25`; the first line may name the columns, and comments begin with `#`";
pub(super) const DECIMAL_COMMA_HELP: &str = "write decimals with a point: `1.5`";

pub(super) const UNITS_HELP: &str = "choose larger units";
pub(super) const UTF_16: &str = "it is in UTF-16; save it as UTF-8";
pub(super) const BINARY: &str = "it contains NUL characters and is not UTF-8 text";

pub(super) fn file_too_large(most: u64) -> String {
    format!("it is larger than {most} bytes, too large for a table")
}

pub(super) fn not_utf_8(line: usize) -> String {
    format!("line {line} is not in UTF-8; save it as UTF-8")
}

pub(super) fn unreadable(path: &str, reason: &str) -> String {
    format!("`{path}` cannot be read: {reason}")
}

pub(super) fn on_line(line: usize, path: &str, complaint: &str) -> String {
    format!("line {line} of `{path}`: {complaint}")
}

pub(super) fn no_number(field: &str) -> String {
    format!("`{}` is not a number", shown(field))
}

pub(super) fn too_large(field: &str) -> String {
    format!("`{}` is too large for `f64`", shown(field))
}

/// The beginning of a field, with escapes for what cannot be seen.
fn shown(field: &str) -> String {
    field.chars().take(MAX_SHOWN).flat_map(char::escape_debug).collect()
}

pub(super) fn wrong_columns(found: usize, needed: usize) -> String {
    format!("the point has {found} numbers, not {needed}")
}
