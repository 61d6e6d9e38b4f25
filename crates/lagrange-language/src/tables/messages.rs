//! Messages about table files.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(super):

    NO_FILES = "only `lagrange::system!` and `pipeline::parse_with` read files";
    UNREADABLE_HELP =
        "give the path from the folder of your `Cargo.toml`, or list the points: `= [(0, 1), (2, 5)]`";
    FORM_HELP =
        "a file has a point on each line, such as `0.5, 1.25`; the first line may name the columns, and comments begin with `#`";
    DECIMAL_COMMA_HELP = "write decimals with a point: `1.5`";

    INCLUDES_ITSELF_HELP = "remove this line: the parts of the file are known anyway";
    TOO_MUCH_TEXT_HELP = "include fewer or smaller files of parts";
    UNREADABLE_PARTS_HELP = "give the path from the folder of your `Cargo.toml`";
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

/// Maximum number of characters of a field in a message.
const MAX_SHOWN: usize = 40;

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
