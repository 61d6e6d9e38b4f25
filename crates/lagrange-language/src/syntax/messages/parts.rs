//! Messages about the syntax of parts.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::syntax):

    UNIT = "arguments of parts have no units of their own";
    ARRAY_HELP = "write `leg[i in 0..4]: Leg { … }`";
    PATH = "the path of a file in quotation marks";
    unit_help(name) =
        "remove it: units are checked where `{name}` is used, and a default may have one, `{name} = 0.2 m`";
    placed(part) = "write `name: {part} {{ … }}`, with its arguments between the braces";
}
