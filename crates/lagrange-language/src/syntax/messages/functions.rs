//! Diagnostics for functions of the user's crate.

use super::quoted;
use crate::syntax::ast::Name;
use lagrange_expr::diagnostics::messages;

messages! {
    pub(in crate::syntax):

    DERIVATIVE = "a derivative";
    REPEATED_DERIVATIVE = "this derivative is named twice";

    PATH_HELP = "write the name alone, and import the function: `use crate::f;` before the declaration";

    VALUE_OF_EXTERNAL = "a function of your crate is defined there, not in the declaration";
    defined_function(name) =
        "end the statement with `;`, or write `let {name}(…) = …;` for a function defined by an expression";
    no_derivative(label) = "unknown label {} for derivatives", quoted(label);
    by_which(function, arguments) =
        "`{function}` has {arguments} arguments: specify the argument to differentiate with respect to";
    no_argument(function, name) = "`{function}` has no argument {}", quoted(name);
    repeated_argument(name) = "the argument {} is repeated", quoted(name);
    of_emitted_code(name) = "{} is reserved for generated code", quoted(name);
}

/// Describes the syntax for derivatives of a function with these arguments.
pub(in crate::syntax) fn derivatives_are(parameters: &[Name]) -> String {
    match parameters {
        [_] => {
            "write `derivative: name;`, `second_derivative: name;` or `third_derivative: name;`".to_owned()
        }
        _ => {
            let names = parameters.iter().map(|name| name.text.as_str()).collect::<Vec<_>>();
            let first = names.first().copied().unwrap_or("x");
            let all = names.join(", ");
            format!(
                "write `by {first}: name;` for the derivative with respect to `{first}`, and `by {all}: name;` for a mixed one"
            )
        }
    }
}
