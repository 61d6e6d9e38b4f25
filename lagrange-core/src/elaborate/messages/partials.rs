//! Diagnostics for partial derivatives.

use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::elaborate):

    NAME_NEEDED = "a derivative is taken by a name";
    NAME_HELP = "write `partial(e, x)` with the name of a coordinate, a parameter, a `let` or a velocity, `velocity u = dot(x);`, or `t`";
    NAME_NEEDED_HELP =
        "write `partial(e, x)` with a name, declared as `let u = 2 * x;` or `velocity u = dot(x);`; an argument of a function or a part is one, too";
    is_fixed(name) = "`{name}` stands for a number: nothing has a derivative with respect to it";
    scalar_needed(name, found) = "a derivative is taken by a scalar, but `{name}` is {found}";
    NESTED = "too many derivatives are nested here";
    NESTED_HELP = "at most 64 derivatives can be taken of each other";
}
