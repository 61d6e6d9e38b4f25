//! Messages about table files, and those that apply to tables in declarations, too.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(super):

    NO_FILES = "only `lagrange::system!` and `pipeline::parse_with` read files";
    UNREADABLE_HELP =
        "give the path from the folder of your `Cargo.toml` or of the declaration's file, or list the points: `= [(0, 1), (2, 5)]`";
    FORM_HELP =
        "a file has a point on each line, such as `0.5, 1.25`; the first line may name the columns, and comments begin with `#`";
    POINT_OR_GRID_HELP =
        "a file has points `0, 0.5, 1.25`, or a grid: an empty or named corner and each `y`, then lines with `x` and its values";
    GRID_HELP =
        "the first line of a grid is a corner and each `y`; other lines are an `x` and the values there";
    DECIMAL_COMMA_HELP = "write decimals with a point: `1.5`";

    INCLUDES_ITSELF_HELP = "remove this line: the parts of the file are known anyway";
    TOO_MUCH_TEXT_HELP = "include fewer or smaller files of parts";
    UNREADABLE_PARTS_HELP = "give the path from the folder of your `Cargo.toml` or of the declaration's file";
    PARTS_ONLY = "an included file contains parts only";
    PARTS_ONLY_HELP = "move this statement into a part, or into the declaration that includes the file";
    includes_itself(path) = "`{path}` includes itself";
    too_deep(most) = "files include each other more than {most} deep";
    too_much_text(path, most) = "`{path}` cannot be included: all included files together are larger than {most} bytes";
    UNITS_HELP = "choose larger units";
    UTF_16 = "it is in UTF-16; save it as UTF-8";
    BINARY = "it contains NUL characters and is not UTF-8 text";
    file_too_large(most) = "it is larger than {most} bytes, too large for a table";
    not_utf_8(line) = "line {line} is not in UTF-8; save it as UTF-8";
    unreadable(path, reason) = "`{path}` cannot be read: {reason}";
    on_line(line, path, complaint) = "line {line} of `{path}`: {complaint}";
    wrong_columns(found, needed) = "the point has {found} numbers, not {needed}";
}

/// Help for a table with too many points.
pub const TOO_MANY_HELP: &str =
    "list fewer points, since smooth data need few, or compute it in a `function` of your crate";

/// Help for an axis with numbers out of order.
pub const AXIS_ASCENDS_HELP: &str = "list the numbers of each axis in ascending order, each once";

/// Returns the message about a table with too many points.
pub fn too_many(table: &str, count: usize, most: usize) -> String {
    format!("the table `{table}` has {count} points; at most {most} are supported")
}

/// Returns the message about values of an argument that are out of order.
pub fn not_ascending(argument: &str, before: f64, after: f64) -> String {
    format!("`{argument}` does not ascend from {before} to {after}")
}

/// Maximum number of characters of a field in a message.
const MAX_SHOWN: usize = 40;

pub(super) fn wrong_row(found: usize, needed: usize, columns: usize) -> String {
    let numbers = if found == 1 { "number" } else { "numbers" };
    format!("the row has {found} {numbers}, not {needed}, one more than the {columns} columns")
}

pub(super) fn no_number(field: &str) -> String {
    format!("`{}` is not a number", shown(field))
}

pub(super) fn too_large(field: &str) -> String {
    format!("`{}` is too large for `f64`", shown(field))
}

/// Returns the beginning of a field, with escapes for invisible characters.
fn shown(field: &str) -> String {
    field.chars().take(MAX_SHOWN).flat_map(char::escape_debug).collect()
}
