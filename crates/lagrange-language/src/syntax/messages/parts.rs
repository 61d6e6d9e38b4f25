//! Messages about the syntax of parts.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::syntax):

    UNIT = "arguments of parts have no units of their own";
    ARRAY_HELP = "write `leg[i in 0..4]: Leg { … }`";
    PATH = "the path of a file in quotation marks";
    unit_help(name) =
        "remove it: units are checked where `{name}` is used, and a default may have one, `{name} = 0.2 m`";
    POSITIONAL = "arguments of parts are given by name";
    POSITIONAL_HELP = "write `name: e;` for each argument, in any order";
    argument(name) = "write `{name}: e;`";
    placed_as(name, part) = "to place a part, write `{name}: {part} {{ … }}`";
    placed(part) = "write `name: {part} {{ … }}`, with its arguments between the braces";
}
